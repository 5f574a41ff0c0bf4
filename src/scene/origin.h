/* The local origin: the point that a scene's world is computed about.
 *
 * Ray queries and photon records are in single precision, whose step at the
 * 5.5e6 m of surveyed coordinates is .5 m. So a scene that lies far from the
 * origin of its coordinates is moved, once, where it is read: every position
 * of its structs is given from scene->origin, and all rooms beyond compute
 * there, in the same small numbers as if the scene had been drawn about 0.
 * Files that name positions (tables of sensors, points and readings) are moved
 * where they are read, and results are moved back where they are written
 * (murk_scene_user, murk_scene_local in scene.h).
 *
 * The rule: the box is the domain's, or without a domain that of the shapes,
 * finite regions, lamps and sites that the scene states. Where its middle is
 * further from 0 than MURK_ORIGIN_FAR times half of its longest edge, the
 * origin is the middle, rounded on each axis to a multiple of twice the power
 * of two at or above that edge; else it is 0. So near scenes keep their
 * numbers, moving a scene by a multiple of that grid changes no bit of its
 * local coordinates, and subtracting the origin rounds nothing that double
 * precision had kept. */
#ifndef MURK_SCENE_ORIGIN_H
#define MURK_SCENE_ORIGIN_H

#include "scene/scene.h"

/* A room of 10 m is moved from 160 m on: there a single-precision step is
 * 1.5e-5 m, 1e-6 of the room, as fine as rays are told apart anyway. */
#define MURK_ORIGIN_FAR 32

/* Chooses the origin of a scene as read, and moves it and the scenes of its
 * conditions there. */
void murk_origin_move(murk_scene_desc *scene);

#endif
