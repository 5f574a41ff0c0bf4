/* Positions in binary result files, in the user's coordinates: three floats, as
 * viewers expect; for a scene with a local origin (scene/origin.h) three
 * doubles, since floats would round surveyed coordinates to half a metre. A
 * scene of NULL has no local origin. */
#ifndef MURK_SCENE_PLACES_H
#define MURK_SCENE_PLACES_H

#include "scene/scene.h"

#include <stddef.h>

/* Three doubles. */
#define MURK_PLACE_BYTES_MAX 24

size_t murk_place_bytes(const murk_scene_desc *scene); /* 12 or 24 */

/* The three properties of a PLY header; the type of a VTK array. */
const char *murk_place_ply(const murk_scene_desc *scene);
const char *murk_place_vtk(const murk_scene_desc *scene);

/* Writes a position, given relative to the local origin: murk_place_bytes()
 * bytes. */
void murk_place_put(const murk_scene_desc *scene, murk_vec3 local, void *to);

/* Reads a position and returns it relative to the local origin. */
murk_vec3 murk_place_take(const murk_scene_desc *scene, const void *from);

/* Number of significant digits for printing a coordinate: `asked`, or 12 for a
 * scene with a local origin, which resolve millimetres below 1e9 m. */
int murk_coordinate_digits(const murk_scene_desc *scene, int asked);

#endif
