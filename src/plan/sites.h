/* Candidate sites of a scene: a grid of points, listed points, and points on
 * mounting surfaces, as far as they lie in free space, in the permitted zones,
 * and not too close to surfaces (sensing/candidates.h). If the scene gives no
 * grid, murk chooses one over the domain. If the scene gives points or mounts
 * but no grid, the points of the chosen grid are no candidates and serve only
 * to find the space that light reaches. */
#ifndef MURK_PLAN_SITES_H
#define MURK_PLAN_SITES_H

#include "scene/scene.h"
#include "sensing/candidates.h"
#include "world/stage.h"

/* The caller owns *out (murk_candidates_destroy()). An error names the place in
 * the scene, or in the file that the scene names. */
murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err);

/* The candidates that are usable in all n stages, n >= 1; candidates with the
 * same coordinates are the same candidate. Rejected candidates are counted as
 * in the first stage, and those that only a later stage rejects are added to
 * the count of unreached candidates. Fails as murk_sites_find() does for any of
 * the stages; and with MURK_BAD_VALUE at where[i] if stage i >= 1 has usable
 * candidates, but none that all earlier stages have. */
murk_status murk_sites_find_common(murk_candidates **out,
                                   const murk_stage *const *stage,
                                   const char *const *where, size_t n,
                                   unsigned threads, murk_error *err);

/* Reads the CSV files that the scene names, in their order, with places as
 * in scene/table_places.h (other columns are ignored), then the points listed
 * in the scene. The caller owns (*out)[*n]: free(). Fails with MURK_BAD_VALUE
 * or MURK_BAD_FILE, at the place in the file or at the list of the scene, if a
 * file cannot be read, lacks a column or has no points, if a value is not a
 * number, if a point lies outside the domain, or if there are more than `max`
 * points; or with MURK_NO_MEMORY. */
murk_status murk_site_points_read(murk_vec3 **out, size_t *n,
                                  const murk_stage *stage, size_t max,
                                  murk_error *err);

#endif
