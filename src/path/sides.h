/* The six sides of a box around rays: the distance to the side ahead, and
 * whether a point lies between the sides. All functions are inline, because the
 * distance to the side is computed for each part of a photon's path. */
#ifndef MURK_PATH_SIDES_H
#define MURK_PATH_SIDES_H

#include "base/vector.h"

/* Coordinates of the sides by axis: the lower side, the upper. */
typedef struct murk_path_sides {
    double x[2], y[2], z[2];
} murk_path_sides;

/* The sides of `box`, each moved outwards by `grow_m`. */
static inline murk_path_sides murk_path_sides_of(const murk_box *box,
                                                 double grow_m)
{
    return (murk_path_sides){{box->min.x - grow_m, box->max.x + grow_m},
                             {box->min.y - grow_m, box->max.y + grow_m},
                             {box->min.z - grow_m, box->max.z + grow_m}};
}

/* Distance along a ray to the side ahead across one axis, for the coordinate p
 * of the ray's start and the component d of its unit direction. If d is 0 or
 * -0 (which + 0.0 makes a 0), the result is INFINITY below the upper side, NaN
 * on it and -INFINITY above it. There is no branch, because the sign of a
 * photon's direction cannot be predicted. */
static inline double murk_path_side_ahead(double p, double d,
                                          const double side[2])
{
    return (side[!(d < 0)] - p) / (d + 0.0);
}

/* The smaller number; b if a is NaN. */
static inline double murk_path_side_nearer(double a, double b)
{
    return a < b ? a : b;
}

/* Distance [m] from p along d to the side ahead, not below 0. If d has no
 * length, INFINITY for a point between the sides. */
static inline double murk_path_sides_ahead(const murk_path_sides *sides,
                                           murk_vec3 p, murk_vec3 d)
{
    const double x = murk_path_side_ahead(p.x, d.x, sides->x);
    const double y = murk_path_side_ahead(p.y, d.y, sides->y);
    const double z = murk_path_side_ahead(p.z, d.z, sides->z);
    const double distance = murk_path_side_nearer(
        x, murk_path_side_nearer(y, murk_path_side_nearer(z, INFINITY)));
    return distance > 0 ? distance : 0;
}

/* The axis (0 x, 1 y, 2 z) across which the side ahead lies. Of sides at the
 * same distance z counts before y, and y before x. */
static inline int murk_path_sides_axis(const murk_path_sides *sides,
                                       murk_vec3 p, murk_vec3 d)
{
    const double x = murk_path_side_ahead(p.x, d.x, sides->x);
    const double y = murk_path_side_ahead(p.y, d.y, sides->y);
    const double z = murk_path_side_ahead(p.z, d.z, sides->z);
    const double distance = murk_path_side_nearer(
        x, murk_path_side_nearer(y, murk_path_side_nearer(z, INFINITY)));
    return z == distance ? 2 : y == distance ? 1 : 0;
}

static inline double murk_path_side_hold(double x, const double side[2])
{
    return x < side[0] ? side[0] : x > side[1] ? side[1] : x;
}

/* A coordinate moved by whole periods to between two periodic sides. */
static inline double murk_path_side_wrap(double x, const double side[2])
{
    const double period = side[1] - side[0];
    return murk_path_side_hold(x - period * floor((x - side[0]) / period),
                               side);
}

/* p if it lies between the sides, otherwise the nearest point of the box. */
static inline murk_vec3 murk_path_sides_hold(const murk_path_sides *sides,
                                             murk_vec3 p)
{
    return murk_vec(murk_path_side_hold(p.x, sides->x),
                    murk_path_side_hold(p.y, sides->y),
                    murk_path_side_hold(p.z, sides->z));
}

/* True also on a side; false for numbers that are NaN. */
static inline bool murk_path_sides_contain(const murk_path_sides *sides,
                                           murk_vec3 p)
{
    return p.x >= sides->x[0] && p.x <= sides->x[1] && p.y >= sides->y[0] &&
           p.y <= sides->y[1] && p.z >= sides->z[0] && p.z <= sides->z[1];
}

/* Puts p onto the lower or the upper side across the axis. */
static inline void murk_path_sides_put(const murk_path_sides *sides, int axis,
                                       bool upper, murk_vec3 *p)
{
    const double *side = axis == 0 ? sides->x : axis == 1 ? sides->y : sides->z;
    murk_component_set(p, axis, side[upper]);
}

#endif
