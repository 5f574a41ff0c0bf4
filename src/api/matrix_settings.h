/* How many columns of a coverage matrix are to be chosen, and by which method,
 * from the keys of a scene. */
#ifndef MURK_API_MATRIX_SETTINGS_H
#define MURK_API_MATRIX_SETTINGS_H

#include "api/handles.h"
#include "results/matrix.h"

/* Reads the keys that murk_scene_set() gave into desc, detection, redundancy,
 * target and budget of *p. Fails with MURK_BAD_VALUE if the scene has another
 * text than that of murk_scene_create(), if a key has no meaning for a matrix
 * or a wrong value, or unless the keys give exactly one of the goals
 * sensors.count, sensors.target and sensors.budget. */
murk_status murk_matrix_settings(murk_matrix_plan *p, const murk_scene *scene,
                                 murk_error *err);

/* Completes the goal in p->desc by the matrix, which has been read: converts a
 * target to a value of the problem, with all columns as the limit of the count;
 * for a budget makes p->constraints, which p->desc borrows, of the costs of the
 * columns. Fails with MURK_BAD_VALUE if the count is more than the columns or a
 * cost is out of range, and with MURK_NO_MEMORY. */
murk_status murk_matrix_goal(murk_matrix_plan *p, const murk_problem *problem,
                             murk_error *err);

#endif
