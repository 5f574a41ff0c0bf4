/* Feet while they are laid over surfaces. Internal to the room. */
#ifndef MURK_GEOMETRY_LAYING_H
#define MURK_GEOMETRY_LAYING_H

#include "base/cells.h"
#include "geometry/lay.h"
#include "geometry/world.h"

/* Of the spacing: between two feet of one surface, and the longest side of the
 * pieces that gaps are filled from. */
#define MURK_LAY_NEAREST 0.75
#define MURK_LAY_PIECE   0.5

typedef struct murk_laying {
    const murk_surfaces *surfaces;
    const murk_lay *lay;
    const char *where;
    murk_error *err;
    murk_status status; /* no more are taken once it is not MURK_OK */
    double first[3];    /* where the lines of the pattern begin on each axis */
    double slack_m;     /* rounding */
    double squares;     /* of the spacing, laid over */
    murk_cells *cells;
    murk_foot *foot;
    size_t n, room;
} murk_laying;

/* Takes a foot unless it is too near to another, leans as is not wanted, or is
 * out of the box by more than rounding. */
void murk_laying_offer(murk_laying *laying, murk_vec3 place, murk_vec3 normal);

/* More feet than there may be. */
murk_status murk_laying_refuse(const murk_laying *laying);

/* The spheres that are laid over: first their six poles, then what is left. */
bool murk_laying_any_ball(const murk_laying *laying);
void murk_laying_poles(murk_laying *laying);
void murk_laying_balls(murk_laying *laying);

static inline murk_vec3 murk_middle(murk_vec3 a, murk_vec3 b)
{
    return murk_scale(0.5, murk_add(a, b));
}

#endif
