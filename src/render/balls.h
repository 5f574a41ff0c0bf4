/* Balls of different sizes: which of them hold a point.
 *
 * Sixteen balls have a box, sixteen boxes another one, and so on; balls that
 * follow one another should lie near each other, as a photon map's records do.
 * Immutable after creation: any number of threads may ask. */
#ifndef MURK_RENDER_BALLS_H
#define MURK_RENDER_BALLS_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>

/* How far a ball reaches along each axis, at most radius: a smaller reach is
 * for who knows that no point beyond it will be asked for. */
typedef struct murk_ball_extent {
    float center[3], radius;
    float reach[3];
} murk_ball_extent;

typedef struct murk_balls murk_balls;

/* Copies ball[n], all finite. *out is the caller's. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_balls_create(murk_balls **out, const murk_ball_extent *ball,
                              size_t n, murk_error *err);
void murk_balls_destroy(murk_balls *balls); /* NULL is fine */

/* Bytes that n balls take. */
double murk_balls_memory_for(double n);

/* A ball that holds the point: which, and the squared distance from its center
 * as a share of the squared radius, below 1. */
typedef void (*murk_balls_told)(void *context, size_t ball, double square);

/* In increasing order. */
void murk_balls_at(const murk_balls *balls, murk_vec3 point,
                   murk_balls_told told, void *context);

#endif
