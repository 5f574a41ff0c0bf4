/* Wind over water surfaces in a scene, and warnings about it. */
#ifndef MURK_WORLD_WINDS_H
#define MURK_WORLD_WINDS_H

#include "scene/scene.h"

/* Mean square slope of the waves on the surface of a region (medium/waves.h); 0
 * without wind. */
double murk_region_mean_square_slope(const murk_scene_region *region);

/* Warns of wind speeds outside the range of the measured slopes
 * (medium/waves.h), and of refracted sightlines, which take the surface as
 * level. */
void murk_warn_of_winds(const murk_scene_desc *scene);

#endif
