/* A bounding volume hierarchy over balls of different sizes, for finding the
 * balls that contain a point.
 *
 * Sixteen balls have a bounding box, sixteen boxes another one, and so on.
 * Queries are fast only if balls with consecutive numbers are close to each
 * other, as the records of a photon map are. Immutable after creation: any
 * number of threads may query. */
#ifndef MURK_RENDER_BALLS_H
#define MURK_RENDER_BALLS_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

/* A ball and its reach along each axis, at most the radius. A reach below the
 * radius is for a caller that never asks for points beyond it. */
typedef struct murk_ball_extent {
    float center[3], radius;
    float reach[3];
} murk_ball_extent;

typedef struct murk_balls murk_balls;

/* Copies ball[n], with finite values. The caller destroys *out. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_balls_create(murk_balls **out, const murk_ball_extent *ball,
                              size_t n, murk_error *err);
void murk_balls_destroy(murk_balls *balls); /* NULL is fine */

/* The memory of n balls in bytes. */
double murk_balls_memory_for(double n);

/* Called for each ball that holds the point: the number of the ball, and the
 * squared distance of the point from the center of the ball as a share of the
 * squared radius, below 1. */
typedef void (*murk_balls_visit)(void *context, size_t ball, double square);

/* Calls `visit` for each ball that holds the point, by increasing number. A
 * point beyond the reach of a ball may be missed. */
void murk_balls_at(const murk_balls *balls, murk_vec3 point,
                   murk_balls_visit visit, void *context);

#endif
