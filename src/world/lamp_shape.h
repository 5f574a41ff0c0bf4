/* How a luminaire stands in the scene: directions and size of the opening. */
#ifndef MURK_WORLD_LAMP_SHAPE_H
#define MURK_WORLD_LAMP_SHAPE_H

#include "scene/scene.h"
#include "source/source.h"

/* Sets the members of *out that only luminaires have: intensity, c0, and the
 * size of the opening, if light->has_size. The position and the aim are set
 * already. Borrows from the scene.
 *
 * Type C: the luminaire is turned from straight down, with C = 0 along x and C
 * = 90 degrees along y, to the aim by the smallest rotation (to straight up:
 * about x). Types A and B, which are made for floodlights and headlamps: V
 * rises towards z (for a vertical aim: towards x if it points down, -x if
 * up). light->c0, if given, is the direction of C = 0, or of V = 90 degrees,
 * instead, made perpendicular to the aim. Then the luminaire is rolled about
 * the aim: C = 0 turns towards C = 90 degrees by light->roll_rad. */
void murk_lamp_shape(murk_source *out, const murk_scene_light *light);

#endif
