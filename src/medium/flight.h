/* The state of a free flight, shared by the two methods of crossing grids:
 * marching (free_flight.c) and delta tracking (delta.c). For
 * use inside src/medium only. */
#ifndef MURK_MEDIUM_FLIGHT_H
#define MURK_MEDIUM_FLIGHT_H

#include "base/rng.h"
#include "medium/media_parts.h"

/* The random numbers of a flight by delta tracking. Each slot of the address
 * gives two pairs of numbers. */
typedef struct murk_flight_randoms {
    const murk_address *address;
    uint32_t slot; /* the slot drawn last */
    bool has_pair; /* the second pair of that slot is unused */
    double pair[2];
    uint32_t nulls; /* null collisions so far */
} murk_flight_randoms;

/* The region of a medium that is present at the collision, and the extinction
 * of that medium there. */
typedef struct murk_flight_contributor {
    const murk_place *place;
    double extinction_per_m;
} murk_flight_contributor;

typedef struct murk_flight {
    const murk_media *media;
    int band;
    murk_inside inside;
    murk_vec3 origin, direction;
    double depth,
        limit; /* optical depth so far, and that of the next collision; in
                  delta tracking both count from the last null collision */
    double u;  /* uniform number that selects the medium of the collision; in
                  delta tracking it first decides whether the collision is
                  real */
    murk_flight_randoms *stream; /* NULL: the flight marches */
    double collision_m;
    size_t n_contributors;
    murk_flight_contributor contributor[MURK_REGIONS_MAX];
} murk_flight;

static inline double murk_flight_extinction(const murk_flight *flight,
                                            const murk_place *place)
{
    return flight->media->media[place->medium]
        .extinction_per_m.band[flight->band];
}

#endif
