/* All of a scene's lights but their power, as text: scenes of equal texts have
 * lights that differ in power alone. */
#ifndef MURK_WORLD_SOURCE_SHAPES_H
#define MURK_WORLD_SOURCE_SHAPES_H

#include "scene/scene.h"

#include <stdio.h>

/* Fails as murk_sky_light(). */
murk_status murk_source_shapes_print(FILE *out, const murk_scene_desc *scene,
                                     murk_error *err);

#endif
