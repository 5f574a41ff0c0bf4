/* knowledge: explore. Stations are taken up one after the other, each inside
 * space already seen from those before it: greedy next best view.
 *
 * What the explorer knows: the start, what its stations and the fixed sensors
 * see, and which places (sensing/outlook.h) they see. A place that is seen may
 * be tried, which costs a query for each pose there (one, where the problem
 * remembers its looks); nothing is known of the others. Next comes the pose
 * there that adds most coverage (with a budget: most per cost) under the rules;
 * where none adds any, the one that brings most unseen places into view, since
 * a corner may have to be turned first; where none does, it ends. Ties go to
 * the lowest number.
 *
 * The first station is at the start. Between stations the way is the shortest
 * over places seen by then, in straight open steps (plan/route.h).
 *
 * Source: Connolly, Proc. IEEE ICRA (1985) 432,
 * doi:10.1109/ROBOT.1985.1087372 (next best view). */
#ifndef MURK_PLAN_EXPLORE_H
#define MURK_PLAN_EXPLORE_H

#include "placement/place.h"
#include "plan/poses.h"
#include "sensing/candidates.h"
#include "world/stage.h"

/* Stations at most. */
#define MURK_EXPLORE_MAX 1000

typedef enum murk_explore_end {
    MURK_EXPLORE_COUNT,       /* as many as were asked for */
    MURK_EXPLORE_TARGET,      /* reached */
    MURK_EXPLORE_CONSTRAINTS, /* nobody in seen space may join: budget, counts,
                           spacing, sites */
    MURK_EXPLORE_NOTHING, /* none adds coverage or brings places into view */
    MURK_EXPLORE_STATIONS /* MURK_EXPLORE_MAX */
} murk_explore_end;

/* What holds once the station stands. */
typedef struct murk_explore_step {
    uint32_t candidate;   /* of the poses */
    uint64_t gain, value; /* weight * clarity: added, and of all by then */
    double path_m;        /* gone */
    size_t places_seen;   /* of the usable sites */
    uint64_t queries, shadow_rays; /* spent */
    size_t
        stops; /* of the path, up to the station; 0: before the path begins */
} murk_explore_step;

typedef struct murk_explore {
    murk_explore_step *step; /* [steps], fixed sensors first */
    size_t steps, fixed;
    murk_vec3 *stop; /* [stops] the path, the start first */
    size_t stops;
    size_t places; /* usable sites */
    uint64_t ways; /* straight ways tried between places */
    murk_explore_end end;
} murk_explore;

/* The place where the path begins: that of the usable candidates nearest to
 * start_m which a straight open way leads to, or without start_m that of the
 * first fixed sensor. A number as of poses->site. Fails with MURK_BAD_VALUE at
 * the scene's placement. */
murk_status murk_explore_start(uint32_t *start, const murk_stage *stage,
                               const murk_candidates *sites,
                               const murk_poses *poses, murk_error *err);

/* Fills *out, and the plan that the stations are: sensor, count, value, cost.
 * desc->count is the most, with a target or budget; desc->rules is needed.
 * Fails with MURK_RUN_FAILED where it ends before the target, or before least
 * counts are met. Release *out also after a failure. */
murk_status murk_explore_run(murk_explore *out, murk_place_result *place,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_problem *problem,
                             const murk_candidates *sites,
                             const murk_poses *poses, uint32_t start,
                             const murk_place_desc *desc, murk_error *err);

/* Adds to that plan what holds of all candidates, seen or not: upper, ceiling,
 * the curve of its stations with upper bounds, the fewest sensors that may
 * reach the target. Looks at every candidate, within most_bytes where it can.
 */
murk_status murk_explore_bound(murk_place_result *place,
                               const murk_explore *explore,
                               const murk_problem *problem,
                               const murk_place_desc *desc, uint64_t max_bytes,
                               murk_error *err);

void murk_explore_release(murk_explore *explore);

#endif
