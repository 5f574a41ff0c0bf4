/* Wind over water in a scene, and what a user should know of it. */
#ifndef MURK_WORLD_WINDS_H
#define MURK_WORLD_WINDS_H

#include "scene/scene.h"

/* Of the waves on a region: medium/waves.h; 0: level. */
double murk_region_mean_square_slope(const murk_scene_region *region);

/* Warns of winds that nobody measured slopes in (medium/waves.h), and of
 * sightlines through a surface that they know only as level. */
void murk_warn_of_winds(const murk_scene_desc *scene);

#endif
