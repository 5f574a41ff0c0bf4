/* Coverage of groups of sensors from re-weighted records.
 *
 * C = sum w D / sum w, map by map as the scene weighs them; D' of the clearest
 * sightline (weighted) or of independent chances. How clear a sightline is at
 * other parameters follows from the density path along it, kept by medium. */
#ifndef MURK_CALIBRATE_COVERED_H
#define MURK_CALIBRATE_COVERED_H

#include "calibrate/measurements.h"
#include "calibrate/reweigh.h"

typedef struct murk_covered murk_covered;

typedef struct murk_covered_desc {
    const murk_stage *stage;       /* that was traced */
    const murk_followed *followed; /* with records */
    const murk_pose *pose;         /* [poses] of all groups */
    const size_t *group;           /* [poses] rising, 0..groups-1 */
    size_t poses, groups;
    unsigned threads;
} murk_covered_desc;

/* Refuses detection: threshold and power, and through: refract. Borrows what
 * desc points to. */
murk_status murk_covered_create(murk_covered **out,
                                const murk_covered_desc *desc, murk_error *err);
void murk_covered_destroy(murk_covered *covered); /* NULL is fine */

/* value[groups], slope[groups][keys]; batch[batches][groups]: the linearised
 * parts of batches of photons, whose total over batches is the value and whose
 * covariance is the values'. */
murk_status murk_covered_read(double *value, double *slope, double *batch,
                              size_t batches, const murk_covered *covered,
                              const murk_reweighed *reweighed,
                              const murk_optics *traced, const murk_optics *at,
                              const murk_optics_sides *sides, size_t keys,
                              murk_error *err);

#endif
