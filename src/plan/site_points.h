/* Reads the points that a scene lists as candidate sites, from files and from
 * the scene itself. */
#ifndef MURK_PLAN_SITE_POINTS_H
#define MURK_PLAN_SITE_POINTS_H

#include "scene/scene.h"

/* Reads CSV files with the columns x_m, y_m, z_m (other columns are ignored) in
 * their order, then the points listed in the scene. The caller owns (*out)[*n]:
 * free(). Fails with MURK_BAD_VALUE or MURK_BAD_FILE at file, line and column,
 * or at the item of the list, if a value is not a number, if a point lies
 * outside the domain, or if there are more than `max` points. */
murk_status murk_site_points_read(murk_vec3 **out, size_t *n,
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, size_t max,
                                  murk_error *err);

#endif
