/* Plans for a coverage matrix from a file: the member `matrix` of a murk_plan
 * (api/handles.h), which has no world then. */
#ifndef MURK_API_MATRIX_PLAN_H
#define MURK_API_MATRIX_PLAN_H

#include "api/save.h"
#include "results/matrix.h"

void murk_matrix_plan_release(murk_matrix_plan *plan); /* accepts NULL */

/* A murk_save_work that writes plan.json and the exports of the problem; of: a
 * murk_matrix_plan. */
murk_status murk_matrix_plan_save(void *of, murk_session *session,
                                  const murk_save_options *options,
                                  murk_error *late, murk_error *err);

#endif
