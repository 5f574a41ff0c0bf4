/* Coverage of groups of sensors from re-weighted records.
 *
 * C = sum(w D) / sum(w), map by map with the weights of the scene; w is the
 * power of a record times the factors of regions of interest times
 * murk_reweighed.ratio, D is the combined clarity (visibility times
 * transmittance) of a record, and, with ' for derivatives with respect to a
 * parameter, the derivative of C is
 *
 * C' = [sum(w' D + w D') - C sum(w')] / sum(w).
 *
 * D is the mean of the clearest sightlines, as many as the redundancy of the
 * scene (detection: weighted), or the probability of at least one of
 * independent detections. The transmittance of a sightline at other parameters
 * follows from the density path along it, stored by medium, and from the
 * extinctions for the acceptance angle of the sensor (medium/rescaled.h). At
 * the traced parameters, the result differs from murk_coverage_result_measure()
 * of the same records by about 1/65535, because that function rounds clarities
 * to this unit. */
#ifndef MURK_CALIBRATE_COVERED_H
#define MURK_CALIBRATE_COVERED_H

#include "calibrate/reweigh.h"
#include "calibrate/visible.h"

typedef struct murk_covered murk_covered;

/* Fails with MURK_BAD_VALUE as murk_covered_create() does for settings of the
 * sensors: `detection`, `through` and targets. To be called before light is
 * traced. */
murk_status murk_covered_check(const murk_scene_desc *scene, murk_error *err);

/* Finds the sightlines of all groups. Fails with MURK_BAD_VALUE for scenes with
 * `detection: threshold`, `detection: power`, `through: refract` or targets,
 * for acceptance angles together with a grid of albedo, and if the sightlines
 * exceed the memory: each takes 4 bytes, 4 more for each re-weighted medium, 4
 * more if there are sheets or media that are not re-weighted, and 2 more if the
 * acceptance angles of a group differ. Also MURK_NO_MEMORY, MURK_INTERRUPTED,
 * or MURK_RUN_FAILED if all records have weight 0. Stage and histories must
 * outlive *out. */
murk_status murk_covered_create(murk_covered **out,
                                const murk_visible_desc *desc, murk_error *err);
void murk_covered_destroy(murk_covered *covered); /* NULL is fine */

/* Memory of the sightlines and of the weights of all contributions, in bytes;
 * it grows in proportion to the photons. */
double murk_covered_bytes(const murk_covered *covered);

/* Evaluates the groups at other optics, into the rows from `first` on. The
 * covariance of the contributions of batches is that of the values
 * (calibrate/coverage_ratio.h). If several sightlines are equally clear, the
 * slope is that of the first. Fails with MURK_BAD_VALUE (a medium without
 * stored paths differs), MURK_RUN_FAILED (no weight is left), MURK_INTERRUPTED
 * or MURK_NO_MEMORY. */
murk_status murk_covered_read(const murk_row_sums *out, size_t first,
                              const murk_covered *covered,
                              const murk_reweighed *reweighed,
                              const murk_optics *traced, const murk_optics *at,
                              const murk_optics_sides *sides, murk_error *err);

#endif
