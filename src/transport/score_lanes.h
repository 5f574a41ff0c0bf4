/* Scores the segments of photons that are traced side by side
 * (transport/lanes.h) in a grid. The lists of the photons become those of
 * murk_score_lattice(), to the bit. For use inside src/transport only. */
#ifndef MURK_TRANSPORT_SCORE_LANES_H
#define MURK_TRANSPORT_SCORE_LANES_H

#include "transport/lanes_step.h"
#include "transport/score.h"

/* A segment of each of the first n lanes. */
typedef struct murk_lane_segments {
    size_t n;
    const murk_lane_rays *from; /* starts, directions and quanta */
    murk_lane_number length_m;  /* 0 in lanes without a segment, also in those
                                 * that fill the last register */
    int64_t is_scored[MURK_LANE_COUNT]; /* -1 in lanes with a segment, else 0;
                                         * -1 if there are no tallies */
} murk_lane_segments;

/* The lists of the photons of all lanes. While the list of a lane is open, the
 * end of the list is kept here, side by side with those of other lanes, and the
 * `last` of the path is out of date. Offsets are in bytes from `entries`. */
typedef struct murk_lane_lists {
    murk_score_entry *entries; /* of the scorer */
    size_t entries_max;        /* that the segments of a step may add to a list
                                */
    int64_t spare;             /* offset of the list that is written in lanes
                                * without a segment */
    murk_score_path *path[MURK_LANE_COUNT];
    int64_t last[MURK_LANE_COUNT];  /* offset of the last entry; `spare` if the
                                     * list is closed */
    int64_t limit[MURK_LANE_COUNT]; /* `last` is below this if the list is open
                                     * and has room for entries_max more */
} murk_lane_lists;

/* All lists closed, for photons of a scorer. */
void murk_lane_lists_create(murk_lane_lists *lists, murk_scorer *scorer);

/* Opens and closes the list of a lane: open while the segments of the lane are
 * scored side by side, closed while others use the path. */
void murk_lane_lists_open(murk_lane_lists *lists, size_t i,
                          murk_score_path *path);
void murk_lane_lists_close(murk_lane_lists *lists, size_t i);

typedef struct murk_lane_scoring {
    /* Selects the lanes whose photon meets something (`meets` is not 0) at a
     * distance, and whose list is open and has room for a step. */
    void (*select)(murk_lane_segments *segments, const murk_lane_lists *lists,
                   const double *meets, const double *distance_m);
    /* Scores the segments in a grid. */
    void (*score)(const murk_lattice *lattice,
                  const murk_lane_segments *segments, murk_lane_lists *lists);
    /* Adds the entries of a list to the tallies. */
    murk_score_adder *add;
} murk_lane_scoring;

/* The functions for a set of vector instructions. */
const murk_lane_scoring *murk_lane_scoring_for(murk_lane_set set);

#endif
