/* Clipping of a ray to the shape of a region: the ray parameters [*t0, *t1] are
 * cut to those inside the shape. Inline and without branches, so that a
 * compiler can clip several rays at once (transport/lanes_step.c). */
#ifndef MURK_MEDIUM_CLIP_H
#define MURK_MEDIUM_CLIP_H

#include "base/lanes.h"
#include "base/vector.h"

/* Clips to the part at which one coordinate is between low and high. If the ray
 * does not change that coordinate and is outside of [low, high), *t1 becomes
 * -infinity. */
static inline void murk_clip_coordinate(double low, double high, double origin,
                                        double direction, double *t0,
                                        double *t1)
{
    const double inverse = 1 / direction;
    const double a = (low - origin) * inverse, b = (high - origin) * inverse;
    const double enter = inverse > 0 ? a : b, leave = inverse > 0 ? b : a;
    const double from = *t0 > enter ? *t0 : enter;
    const double to = *t1 < leave ? *t1 : leave;
    const bool is_between = (origin >= low) & (origin < high);
    const double level_to = is_between ? *t1 : -INFINITY;
    *t0 = direction == 0 ? *t0 : from;
    *t1 = direction == 0 ? level_to : to;
}

/* Clips to a box. Nothing is left unless *t0 < *t1. */
static inline void murk_clip_box(const murk_box *box, murk_vec3 o, murk_vec3 d,
                                 double *t0, double *t1)
{
    murk_clip_coordinate(box->min.x, box->max.x, o.x, d.x, t0, t1);
    murk_clip_coordinate(box->min.y, box->max.y, o.y, d.y, t0, t1);
    murk_clip_coordinate(box->min.z, box->max.z, o.z, d.z, t0, t1);
}

/* Clips to a sphere, measured from the point of the line nearest to the
 * centre, so that far origins cost no digits. If the ray misses the sphere, *t1
 * becomes -infinity; nothing is left unless *t0 < *t1. */
static inline void murk_clip_sphere(murk_vec3 center, double radius,
                                    murk_vec3 o, murk_vec3 d, double *t0,
                                    double *t1)
{
    const double square = murk_dot(d, d);
    const double nearest = murk_dot(murk_sub(center, o), d) / square;
    const murk_vec3 off = murk_sub(murk_along(o, nearest, d), center);
    const double left = radius * radius - murk_dot(off, off);
    /* By bits: the compiler would divide and take the root twice, once for 0.
     */
    const double half = sqrt(murk_choose(left > 0, left, 0) / square);
    const double enter = nearest - half, leave = nearest + half;
    const double to = *t1 < leave ? *t1 : leave;
    *t0 = *t0 > enter ? *t0 : enter;
    *t1 = left > 0 ? to : -INFINITY;
}

#endif
