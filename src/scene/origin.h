/* The local origin: the point relative to which all positions of a scene are
 * stored.
 *
 * Ray queries and photon records are in single precision, whose step is 0.5 m
 * at surveyed coordinates of 5.5e6 m. A scene that lies far from the origin of
 * its coordinates is therefore moved once, when it is read: every position in
 * the structs is relative to scene->origin. All other code then computes with
 * small numbers, as if the scene had been drawn around 0. Files that contain
 * positions (tables of sensors, points and readings) are moved when they are
 * read, and results are moved back when they are written (murk_scene_user,
 * murk_scene_local in scene.h).
 *
 * The rule: take the box of the domain, or without a domain the box of the
 * geometry and the regions (only boxes, spheres and rectangles: files are not
 * open yet), of the positions of lamps with their radius, of the grid of
 * candidate sites and of the fixed sensors. If a coordinate of the middle of
 * the box exceeds MURK_ORIGIN_FAR times half of the longest edge, the origin
 * is the middle, rounded on each axis to a multiple of twice the smallest
 * power of two that is not below that edge; otherwise the origin is 0. (In z
 * the origin is 0 if a mesh bounds a medium with a profile.) So scenes near 0
 * keep their numbers, moving a scene by a multiple of that grid changes no bit
 * of the local coordinates, and subtracting the origin rounds nothing that
 * double precision had kept. */
#ifndef MURK_SCENE_ORIGIN_H
#define MURK_SCENE_ORIGIN_H

#include "scene/scene.h"

/* A room of 10 m is moved if it is more than 160 m from 0 on some axis. There a
 * step of single precision is 1.5e-5 m, 1.5e-6 of the room, as fine as rays
 * tell surfaces apart. */
#define MURK_ORIGIN_FAR 32

/* Chooses the origin of a scene that has been read, and moves the scene and the
 * scenes of all conditions to that origin. */
void murk_origin_move(murk_scene_desc *scene);

#endif
