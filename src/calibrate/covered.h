/* Coverage of groups of sensors from re-weighted records.
 *
 * C = sum w D / sum w, map by map as the scene weighs them, w the records'
 * power times regions of interest times murk_reweighed.ratio, and
 *     dC = [sum (w' D + w D') - C sum w'] / sum w.
 * D is of the clearest sightlines, as many as the scene's redundancy
 * (detection: weighted), or of independent chances. How clear a sightline is at
 * other parameters follows from the density path along it, kept by medium, and
 * from extinctions as a sensor of such acceptance sees them
 * (medium/acceptance.h). What murk_coverage_result_measure() finds of the same
 * records differs by rounding to 1/65535 alone. */
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

/* What murk_covered_create() refuses of a scene, before light is traced. */
murk_status murk_covered_check(const murk_scene_desc *scene, murk_error *err);

/* Refuses detection: threshold and power, through: refract, targets, poses
 * outside the domain, sensors with acceptance where an albedo is a grid, and
 * sightlines beyond what the machine holds: 4 bytes and 4 for each kept medium,
 * sheets and other media 4 more. MURK_RUN_FAILED where no record has weight.
 * Borrows stage and followed. */
murk_status murk_covered_create(murk_covered **out,
                                const murk_covered_desc *desc, murk_error *err);
void murk_covered_destroy(murk_covered *covered); /* NULL is fine */

/* Bytes that it holds by what is seen, so in proportion to the photons. */
double murk_covered_bytes(const murk_covered *covered);

/* value[groups], slope[groups][keys]; batch[batches][groups], or NULL with 0:
 * the linearised parts of batches of photons, whose total over batches is the
 * value and whose covariance is the values' (calibrate/coverage_ratio.h);
 * photon p is in batch p * batches / emitted, rounded down. slope_batch
 * [runs][groups][keys], or NULL: likewise of the slopes, runs dividing batches.
 * Where several sightlines are equally the clearest, the slope is the first's.
 * Fails with MURK_BAD_VALUE (a medium that followed does not keep is another),
 * MURK_RUN_FAILED (no weight is left), MURK_INTERRUPTED or MURK_NO_MEMORY. */
murk_status murk_covered_read(double *value, double *slope, double *batch,
                              size_t batches, double *slope_batch, size_t runs,
                              const murk_covered *covered,
                              const murk_reweighed *reweighed,
                              const murk_optics *traced, const murk_optics *at,
                              const murk_optics_sides *sides, size_t keys,
                              murk_error *err);

#endif
