/* How much of a box or ball is free space, which light can reach. */
#ifndef MURK_PLAN_FREE_SHARE_H
#define MURK_PLAN_FREE_SHARE_H

#include "base/stats.h"
#include "plan/free_space.h"

typedef struct murk_part {
    bool is_ball;
    murk_box box; /* of a ball, the box around it */
    murk_vec3 center;
    double radius_m;
    uint32_t number; /* random numbers are apart by it */
} murk_part;

/* The share 0..1 of the part that lies in free space, by places drawn one in
 * each of equal cells; the error is that of independent places, which is more.
 * space NULL: nothing is in the way, so all of it. */
murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads);

#endif
