/* The shares that light sources have of all light in the course of a timeline.
 * A photon keeps its bits from one time to another only if it starts from the
 * same light source, so photons are dealt by shares that are the same at all
 * times. */
#ifndef MURK_WORLD_LIGHT_SHARES_H
#define MURK_WORLD_LIGHT_SHARES_H

#include "scene/scene.h"
#include "source/sources.h"

/* *share[channels]: the largest share of the total power that each channel of
 * `lights`, those of the scene, has at any of the steps and keyframes; of more
 * than MURK_LIGHT_SHARES_MAX of these times, so many are taken. A channel that
 * has power now, but at none of these times, has its share of now. Times at
 * which the scene is wrong, or has another number of lights, do not count. The
 * caller frees the array. NULL if the power of no light source changes, or if
 * all lights are dark. Fails with MURK_NO_MEMORY. */
#define MURK_LIGHT_SHARES_MAX 64
murk_status murk_light_shares(double **share, const murk_scene_desc *scene,
                              const murk_sources *lights,
                              const murk_domain *domain, murk_error *err);

#endif
