/* What `murk place` writes for other programs: the coverage matrix, the problem
 * for an outside solver, the plan as a mesh of points. */
#ifndef MURK_APP_EXPORTS_H
#define MURK_APP_EXPORTS_H

#include "app/session.h"
#include "study/sparse_matrix.h"

/* Adds what `exports` (murk_export bits) asks for. A file that cannot be had
 * (too large, or no 0/1 matrix for OR-Library) is told in *late, and the others
 * are added all the same: no plan is lost for it. */
void murk_exports_add(murk_results *results, unsigned exports,
                      const murk_sparse_matrix *matrix,
                      const murk_lp_goal *goal, murk_error *late);

/* Whether views so combined allow `exports`: of independent chances there is no
 * LP file. To be asked before any work is done. */
murk_status murk_exports_check(unsigned exports, murk_combining combining,
                               murk_error *err);

/* Adds plan.ply, and what --export asks for, of a scene's plan. Looks again
 * from its sensors, and for --export from all candidates. In the dark there is
 * nothing to add. */
murk_status murk_exports_add_plan(murk_session *session, const murk_plan *plan,
                                  murk_error *late, murk_error *err);

#endif
