/* What is to be chosen of a coverage matrix and how, from the keys of a
 * scene. */
#ifndef MURK_API_MATRIX_SETTINGS_H
#define MURK_API_MATRIX_SETTINGS_H

#include "api/handles.h"
#include "results/matrix.h"

/* Reads the keys that murk_scene_set() gave into desc, detection, redundancy,
 * target and budget of *p. Fails with MURK_BAD_VALUE if the scene has a text of
 * its own, if a key has no meaning for a matrix or a wrong value, or unless the
 * keys give one goal. */
murk_status murk_matrix_settings(murk_matrix_plan *p, const murk_scene *scene,
                                 murk_error *err);

/* Holds the goal against the matrix, which is read: makes the target a value of
 * the problem, and prices the columns for a budget. The constraints of *p are
 * borrowed by p->desc. Fails with MURK_BAD_VALUE if the count is more than the
 * columns or a cost is out of range. */
murk_status murk_matrix_goal(murk_matrix_plan *p, const murk_problem *problem,
                             murk_error *err);

#endif
