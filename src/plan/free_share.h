/* The share of a box or a ball that is free space, which light can reach. */
#ifndef MURK_PLAN_FREE_SHARE_H
#define MURK_PLAN_FREE_SHARE_H

#include "base/stats.h"
#include "plan/free_space.h"

typedef struct murk_part {
    bool is_ball;
    murk_box box; /* of a ball: the bounding box */
    murk_vec3 center;
    double radius_m;
    uint32_t number; /* addresses the random numbers of this part */
} murk_part;

/* The share (0..1) of the part that lies in free space, by stratified sampling:
 * one random point in each of equal cells. The stated error is that of
 * independent points, an upper bound. space NULL means that nothing obstructs
 * the part: the share is 1. */
murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads);

#endif
