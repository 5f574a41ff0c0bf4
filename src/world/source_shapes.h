/* A text that describes the light sources of a scene except their power. If two
 * scenes have the same text, their light sources differ in power alone, except
 * for distant light that is dark in both scenes. */
#ifndef MURK_WORLD_SOURCE_SHAPES_H
#define MURK_WORLD_SOURCE_SHAPES_H

#include "scene/scene.h"

#include <stdio.h>

/* Prints the text to out. Fails as murk_sky_lights() does. */
murk_status murk_source_shapes_print(FILE *out, const murk_scene_desc *scene,
                                     murk_error *err);

#endif
