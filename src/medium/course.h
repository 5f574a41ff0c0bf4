/* A region's density along a ray, whatever gives it: even, a grid by nearest
 * voxels or trilinear, or layers. One segment after the other, on each of
 * which the density is a cubic. Inside this room only. */
#ifndef MURK_MEDIUM_COURSE_H
#define MURK_MEDIUM_COURSE_H

#include "medium/cubic.h"
#include "medium/layers.h"
#include "medium/linear.h"
#include "medium/march.h"
#include "medium/place.h"

#include <stdbool.h>

/* Not to be copied once begun. */
typedef struct murk_flight_state {
    murk_filling filling;
    union {
        murk_march march;
        murk_linear linear;
        murk_layers layers;
    } in;
} murk_flight_state;

/* Sets out through a place that is not filled evenly, for t0 and t1 from
 * murk_place_clip_filling(). */
void murk_course_begin(murk_flight_state *course, const murk_place *place,
                       int band, murk_vec3 origin, murk_vec3 direction,
                       double t0, double t1);

/* The next segment; false at the end. Some may have no length. */
bool murk_course_next(murk_flight_state *course);

/* Where the present segment ends. */
double murk_course_to(const murk_flight_state *course);

/* The density over the part [t0, t1] of the present segment. */
murk_cubic murk_course_cubic(const murk_flight_state *course, double t0,
                             double t1);

/* Adds the integral of (scale * density + offset) over what is left of the
 * course to *sum. True when it reaches the limit on the way: then *sum is the
 * limit, *stop is where and *density the density there, above 0 where offset
 * is 0. */
bool murk_course_integrate(murk_flight_state *course, double scale,
                           double offset, double limit, double *sum,
                           double *stop, double *density);

#endif
