/* A flight under way, shared by its two ways across grids: the march
 * (flight.c) and delta tracking (delta.c). Inside this room only. */
#ifndef MURK_MEDIUM_FLIGHT_H
#define MURK_MEDIUM_FLIGHT_H

#include "base/rng.h"
#include "medium/parts.h"

/* What a flight by delta tracking throws: pairs of numbers, slot after slot. */
typedef struct murk_dice {
    const murk_address *address;
    uint32_t slot; /* the last one drawn */
    bool has_pair; /* the second pair of that slot is left */
    double pair[2];
    uint32_t nulls; /* collisions so far that were none */
} murk_dice;

/* What is met where the flight stops. */
typedef struct murk_meeting {
    const murk_place *place;
    double extinction_per_m;
} murk_meeting;

typedef struct murk_flight {
    const murk_media *media;
    int band;
    murk_inside inside;
    murk_vec3 origin, direction;
    double depth, limit; /* optical depth so far; where to stop */
    double u;            /* draws the partner */
    murk_dice *dice;     /* NULL: the flight marches */
    double stop_m;
    size_t n_met;
    murk_meeting met[MURK_REGIONS_MAX];
} murk_flight;

static inline double murk_flight_extinction(const murk_flight *flight,
                                            const murk_place *place)
{
    return flight->media->media[place->medium]
        .extinction_per_m.band[flight->band];
}

#endif
