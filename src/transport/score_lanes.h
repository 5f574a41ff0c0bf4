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
    const murk_lane_rays *from;             /* starts, directions and quanta */
    murk_lane_number length_m;              /* 0 in lanes without a segment */
    murk_score_path *path[MURK_LANE_COUNT]; /* NULL in lanes without a
                                             * segment, and from n on */
} murk_lane_segments;

/* Scores the segments in a grid. Each list must have room for the cells of the
 * longest segment. */
typedef void (*murk_lane_scoring)(const murk_lattice *lattice,
                                  const murk_lane_segments *segments);

/* The compiled form for a set of vector instructions. */
murk_lane_scoring murk_lane_scoring_for(murk_lane_set set);

#endif
