/* The files for other programs. `murk place` writes the coverage matrix, the
 * problem for an outside solver, and plan.ply. `murk trace`, `murk sense` and
 * `murk place` write fields, photons and surfaces. */
#ifndef MURK_RESULTS_EXPORTS_H
#define MURK_RESULTS_EXPORTS_H

#include "results/fields.h"
#include "results/session.h"
#include "sparse/matrix.h"

/* Adds the files of the problem that `exports` (murk_export bits) asks for:
 * matrix.csv, matrix.txt, problem.lp. If a file cannot be made (too large, or
 * not a 0/1 matrix for OR-Library), *late has the first reason, and the others
 * are added all the same, so that the plan is not lost. */
void murk_exports_add(murk_results *results, unsigned exports,
                      const murk_sparse_matrix *matrix,
                      const murk_lp_goal *goal, murk_error *late);

/* Fails with MURK_BAD_VALUE if `exports` asks for an LP file and detection is
 * by independent chances, because that problem is not linear. To be called
 * before any work is done. */
murk_status murk_exports_check(unsigned exports, murk_detection detection,
                               murk_error *err);

/* Lists the columns of candidates.csv. `of` points to a struct internal to
 * exports.c; NULL: the fields are only described (results/fields.h). */
void murk_results_list_candidate(murk_results_fields *f, const void *of,
                                 size_t i);

/* Checks --export and --voxel against the scene: the numbers of voxels and of
 * pieces of surfaces, and that no file of a tally would have the name of
 * another file. Fails with MURK_BAD_VALUE, or MURK_NO_MEMORY. To be called once
 * the world is built and before light is traced. */
murk_status murk_exports_begin(const murk_session *session, murk_error *err);

/* Adds fields, photons and surfaces if --export asks for them. sight NULL: of
 * the light alone; otherwise also of what sensor[n] see, which is computed
 * again. If files cannot be made, or on an interrupt, *late has the reason, and
 * the others are added all the same. */
void murk_exports_add_scene(murk_session *session, murk_sight *sight,
                            const murk_pose *sensor, size_t n,
                            murk_error *late);

/* Adds plan.ply and what --export asks for, of a plan for a scene. Computes the
 * sightlines of the sensors again, and for the files of the problem those of
 * all candidates. In the dark, adds only what needs no sensors. *late as in the
 * functions above. Fails if the sightlines cannot be computed or plan.ply
 * cannot be added. Does nothing without a folder for results. */
murk_status murk_exports_add_plan(murk_session *session,
                                  const murk_plan_result *plan,
                                  murk_error *late, murk_error *err);

#endif
