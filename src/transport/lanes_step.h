/* The arithmetic of a collision for several photons side by side, compiled for
 * several vector instruction sets. Each photon has a lane: the same index of
 * all arrays. For use inside src/transport only. */
#ifndef MURK_TRANSPORT_LANES_STEP_H
#define MURK_TRANSPORT_LANES_STEP_H

#include "base/lanes.h"
#include "medium/lane_regions.h"
#include "path/sides.h"

/* The rays of the photons and their packets. */
typedef struct murk_lane_rays {
    murk_lane_number x, y, z, dx, dy, dz; /* position [m], direction */
    murk_lane_number quanta;
} murk_lane_rays;

typedef struct murk_photon_lanes {
    /* The photon. */
    murk_lane_rays ray;
    murk_lane_number absorbed; /* quanta that the medium met last has absorbed
                                * and that are not yet in the ledger */
    murk_lane_word photon_low, photon_high;
    murk_lane_word number; /* of the event */
    murk_lane_number
        is_new; /* no collision since the walker of the lane moved */

    /* The random words of this event. The first gives the optical depth tau to
     * the collision. */
    murk_lane_word word_depth, word_medium, word_roulette, word_cosine;
    murk_lane_number tau;
    murk_lane_word surface_word[4]; /* for an event at a surface */

    /* The free flight: if it ends in a medium (meets), the length and the
     * properties of the medium. */
    murk_lane_number meets, distance_m;
    murk_lane_number extinction_per_m; /* of a single even medium */
    murk_lane_number albedo, g;

    /* Several regions: the properties of their media in the band of the photon
     * (at the density 1), the part of the ray inside each of them (from below
     * to; none if not), the interval between ends of these parts that the
     * flight has reached, and the region with the collision. */
    murk_lane_number region_extinction[MURK_LANE_REGIONS_MAX];
    murk_lane_number region_albedo[MURK_LANE_REGIONS_MAX];
    murk_lane_number region_g[MURK_LANE_REGIONS_MAX];
    murk_lane_number span_from[MURK_LANE_REGIONS_MAX];
    murk_lane_number span_to[MURK_LANE_REGIONS_MAX];
    murk_lane_number piece_from, piece_to, piece_extinction, depth, flies;
    murk_lane_number first_region; /* the last of the regions of the interval
                                    * that replaces those before */
    murk_lane_number is_ahead;     /* some end lies beyond piece_from */
    murk_lane_number left;         /* of the drawn share of the extinction */
    murk_lane_number region, scattering_per_m;

    /* Walks through the grid among the regions. The extinction of that region
     * is 0 but at a collision; grid.scale is that of density 1. */
    murk_grid_lanes grid;

    /* The outcome of a collision. */
    murk_lane_number scatters, cosine, azimuth;
    murk_lane_number is_split; /* else roulette has decided */
} murk_photon_lanes;

/* The facts that all lanes share. */
typedef struct murk_lane_facts {
    uint32_t seed, purpose;   /* of the random numbers of a flight */
    uint32_t surface_purpose; /* of those of an event at a surface */
    bool any_media, any_surfaces;
    int64_t events_max;
    double min_quanta;
    murk_path_sides sides;
    bool has_regions; /* else flights are of another kind */
    murk_lane_regions regions;
    const murk_grid_lane_steps *grid; /* NULL: no grid among the regions */
} murk_lane_facts;

/* The steps of a collision for the first n lanes, n a multiple of
 * MURK_LANE_GROUP. */
typedef struct murk_lane_steps {
    murk_lane_set set;
    /* Draws the random numbers of the next event, for media and surfaces if
     * there are any. */
    void (*draw)(murk_photon_lanes *lanes, const murk_lane_facts *facts,
                 size_t n);
    /* The free flight in a single even medium. */
    void (*fly)(murk_photon_lanes *lanes, size_t n);
    /* The free flight in several regions. */
    void (*fly_regions)(murk_photon_lanes *lanes, const murk_lane_facts *facts,
                        size_t n);
    /* Moves to the collision, splits the packet or decides by roulette, and
     * draws the cosine by Henyey and Greenstein. A photon with too many events
     * does not meet: it is the walker's. */
    void (*collide)(murk_photon_lanes *lanes, const murk_lane_facts *facts,
                    size_t n);
    /* Turns the direction of each lane that scatters. */
    void (*turn)(murk_photon_lanes *lanes, size_t n);
    /* A bit for each lane that is not scattered in a medium, or whose
     * is_scored is 0. */
    uint64_t (*unfinished)(const murk_photon_lanes *lanes,
                           const int64_t *is_scored, size_t n);
} murk_lane_steps;

/* The steps for the set of vector instructions that murk_lane_set_chosen()
 * gives; NULL if photons are traced one by one. */
const murk_lane_steps *murk_lane_steps_chosen(void);

#endif
