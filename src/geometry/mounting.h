/* What a thing mounted on a surface stands near to, but for that surface
 * (murk_surfaces_near_mount()). Internal to the room. */
#ifndef MURK_GEOMETRY_MOUNTING_H
#define MURK_GEOMETRY_MOUNTING_H

#include "geometry/lay.h"
#include "geometry/soup.h"

typedef struct murk_mounting {
    murk_vec3 foot; /* relative to the soup's anchor */
    murk_vec3 normal;
    double above_m, slack_m;
} murk_mounting;

/* Distance from `point` to what counts of a face or sphere; INFINITY: nothing
 * does. */
double murk_mounting_from_face(const murk_mounting *mounting,
                               const murk_triangle *face, murk_vec3 point);
double murk_mounting_from_ball(const murk_mounting *mounting,
                               const murk_ball *ball, murk_vec3 point);

#endif
