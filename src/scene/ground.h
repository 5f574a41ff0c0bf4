/* Scenes on the earth: the site as the middle of a file of elevations, the
 * local frame of a scene, and the ground that a scene asks a file for. */
#ifndef MURK_SCENE_GROUND_H
#define MURK_SCENE_GROUND_H

#include "scene/scene.h"
#include "scene/walk.h"

/* Gives a tree of a scene whose site has neither latitude nor longitude those
 * of the middle of the first GeoTIFF file of the geometry, if there is one.
 * Fails as murk_geotiff_facts(). */
murk_status murk_ground_complete(murk_key_reader *walk, murk_yaml *root);

/* True if a tree of a scene has the ground of a GeoTIFF file. */
bool murk_ground_is_in(const murk_yaml *root);

/* True if the site of the scene has a latitude and a longitude; then *out is
 * the frame about it, in the coordinates of the scene file. z = 0 is at
 * site.altitude_m. */
bool murk_scene_frame(const murk_scene_desc *scene, murk_local_frame *out);

/* The request for the item `i` of the geometry, which is a GeoTIFF file. */
murk_geotiff_asked murk_scene_ground_asked(const murk_scene_desc *scene,
                                           size_t i);

#endif
