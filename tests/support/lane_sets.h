/* The sets of vector instructions (base/lanes.h) in tests that compare them. */
#ifndef MURK_TESTS_LANE_SETS_H
#define MURK_TESTS_LANE_SETS_H

#include <stdio.h>
#include <stdlib.h>

#include "base/lanes.h"

/* Forces a set by MURK_LANES until the next call. If the processor lacks the
 * set, returns false and says so once. */
static inline bool test_lane_set_forced(murk_lane_set set)
{
    static bool is_logged[MURK_LANE_SETS];
    murk_lane_set chosen;
    setenv("MURK_LANES", murk_lane_set_name(set), 1);
    const bool is_there = murk_lane_set_chosen(&chosen) && chosen == set;
    if (!is_there && !is_logged[set]) {
        is_logged[set] = true;
        fprintf(stderr, "this processor has no %s: not compared\n",
                murk_lane_set_name(set));
    }
    return is_there;
}

#endif
