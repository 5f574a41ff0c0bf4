/* A text that describes the light sources of a scene, as the photon tracer uses
 * them, except their power. If two scenes have the same text, each light source
 * of one scene emits photons of the same distribution as that of the other
 * scene and differs in power alone, or is distant light without power in both
 * scenes. */
#ifndef MURK_WORLD_SOURCE_SHAPES_H
#define MURK_WORLD_SOURCE_SHAPES_H

#include "scene/scene.h"

#include <stdio.h>

/* Prints the text to out. Fails as murk_sky_lights() does. */
murk_status murk_source_shapes_print(FILE *out, const murk_scene_desc *scene,
                                     murk_error *err);

#endif
