/* The walls of a box that photons fly in: how far the next is, and what lies
 * between them. In a header because every leg asks. Private to this room. */
#ifndef MURK_TRANSPORT_WALLS_H
#define MURK_TRANSPORT_WALLS_H

#include "base/vector.h"

/* A box, by axis: the lower wall, the upper. */
typedef struct murk_walls {
    double x[2], y[2], z[2];
} murk_walls;

/* The walls of a box, moved out by `grow`. */
static inline murk_walls murk_walls_of(const murk_box *box, double grow)
{
    return (murk_walls){{box->min.x - grow, box->max.x + grow},
                        {box->min.y - grow, box->max.y + grow},
                        {box->min.z - grow, box->max.z + grow}};
}

/* Distance to the wall ahead along one axis; INFINITY or NaN where there is no
 * motion along it (+ 0.0 makes -0 a 0). Free of branches: which way a photon
 * flies cannot be foretold. */
static inline double murk_wall_ahead(double p, double d, const double wall[2])
{
    return (wall[!(d < 0)] - p) / (d + 0.0);
}

static inline double murk_wall_nearer(double a, double b)
{
    return a < b ? a : b; /* b where a is NaN */
}

/* Distance [m] to the side ahead, not below 0; INFINITY where the direction
 * has no length. */
static inline double murk_walls_ahead(const murk_walls *walls, murk_vec3 p,
                                      murk_vec3 d)
{
    const double x = murk_wall_ahead(p.x, d.x, walls->x);
    const double y = murk_wall_ahead(p.y, d.y, walls->y);
    const double z = murk_wall_ahead(p.z, d.z, walls->z);
    const double distance =
        murk_wall_nearer(x, murk_wall_nearer(y, murk_wall_nearer(z, INFINITY)));
    return distance > 0 ? distance : 0;
}

/* The axis that the side ahead lies across. */
static inline int murk_walls_axis(const murk_walls *walls, murk_vec3 p,
                                  murk_vec3 d)
{
    const double x = murk_wall_ahead(p.x, d.x, walls->x);
    const double y = murk_wall_ahead(p.y, d.y, walls->y);
    const double z = murk_wall_ahead(p.z, d.z, walls->z);
    const double distance =
        murk_wall_nearer(x, murk_wall_nearer(y, murk_wall_nearer(z, INFINITY)));
    return z == distance ? 2 : y == distance ? 1 : 0;
}

static inline double murk_wall_held(double x, const double wall[2])
{
    return x < wall[0] ? wall[0] : x > wall[1] ? wall[1] : x;
}

/* p, or the nearest place between the walls. */
static inline murk_vec3 murk_walls_hold(const murk_walls *walls, murk_vec3 p)
{
    return murk_vec(murk_wall_held(p.x, walls->x),
                    murk_wall_held(p.y, walls->y),
                    murk_wall_held(p.z, walls->z));
}

/* Walls included; false for what is not a number. */
static inline bool murk_walls_contain(const murk_walls *walls, murk_vec3 p)
{
    return p.x >= walls->x[0] && p.x <= walls->x[1] && p.y >= walls->y[0] &&
           p.y <= walls->y[1] && p.z >= walls->z[0] && p.z <= walls->z[1];
}

/* Puts p onto the lower or the upper wall across the axis. */
static inline void murk_walls_put(const murk_walls *walls, int axis, bool upper,
                                  murk_vec3 *p)
{
    if (axis == 0) {
        p->x = walls->x[upper];
    } else if (axis == 1) {
        p->y = walls->y[upper];
    } else {
        p->z = walls->z[upper];
    }
}

#endif
