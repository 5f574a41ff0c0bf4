/* The points that a scene lists as candidates, from its files and its own
 * list. */
#ifndef MURK_PLAN_SITE_POINTS_H
#define MURK_PLAN_SITE_POINTS_H

#include "scene/scene.h"

/* CSV files with columns x_m, y_m, z_m (others are not read), in their order,
 * then those listed in the scene. (*out)[*n] is the caller's: free(). Fails
 * with MURK_BAD_VALUE or MURK_BAD_FILE, naming file, line and column, or the
 * item of the list: what is no number, outside the domain, or more than `most`
 * points. */
murk_status murk_site_points_read(murk_vec3 **out, size_t *n,
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, size_t max,
                                  murk_error *err);

#endif
