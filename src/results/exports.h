/* What commands write for other programs: of `murk place` the coverage matrix,
 * the problem for an outside solver and the plan as a mesh of points; of any
 * scene fields, photons and surfaces. */
#ifndef MURK_RESULTS_EXPORTS_H
#define MURK_RESULTS_EXPORTS_H

#include "results/fields.h"
#include "results/session.h"
#include "sparse/matrix.h"

/* Of the problem, by murk place alone; the others are of a scene. */
#define MURK_EXPORTS_OF_PROBLEM \
    (MURK_EXPORT_MATRIX | MURK_EXPORT_OR_LIBRARY | MURK_EXPORT_LP)

/* Adds what `exports` (murk_export bits) asks for. A file that cannot be had
 * (too large, or no 0/1 matrix for OR-Library) is told in *late, and the others
 * are added all the same: no plan is lost for it. */
void murk_exports_add(murk_results *results, unsigned exports,
                      const murk_sparse_matrix *matrix,
                      const murk_lp_goal *goal, murk_error *late);

/* Whether views so combined allow `exports`: of independent chances there is no
 * LP file. To be asked before any work is done. */
murk_status murk_exports_check(unsigned exports, murk_detection detection,
                               murk_error *err);

/* Columns of candidates.csv; of: a candidate list. */
void murk_results_list_candidate(murk_results_fields *f, const void *of,
                                 size_t i);

/* What --export and --voxel ask of a scene, once its world is built and before
 * any light is traced: sizes, and names that two files would have. */
murk_status murk_exports_begin(const murk_session *session, murk_error *err);

/* Adds fields, photons and surfaces, where --export asks for them. sight NULL:
 * of light alone; else of sensors sensor[n] too, which look again. Files that
 * cannot be had, and an interrupt, are told in *late. */
void murk_exports_add_scene(murk_session *session, murk_sight *sight,
                            const murk_pose *sensor, size_t n,
                            murk_error *late);

/* Adds plan.ply, and what --export asks for, of a scene's plan. Looks again
 * from its sensors, and for its problem from all candidates. In the dark there
 * is only light to add. */
murk_status murk_exports_add_plan(murk_session *session,
                                  const murk_plan_result *plan,
                                  murk_error *late, murk_error *err);

#endif
