/* Placement with `knowledge: explore`: stations, which are poses of sensors,
 * are chosen one after the other, each inside the space that earlier stations
 * have seen (greedy next best view).
 *
 * The explorer knows the start position, and the photons and the places that
 * the stations and the fixed sensors see (sensing/outlook.h; places are the
 * usable sites and the positions of fixed sensors). A pose may be evaluated if
 * its place has been seen and is connected to the start (plan/explored.h),
 * which costs one visibility query, or none if the row of that candidate is
 * cached. Nothing is known about other places. The next station is the pose
 * that adds most coverage (with a budget: most coverage per cost) under the
 * constraints. If no pose adds coverage, the next station is the pose that sees
 * most sites that have not been seen or are not connected to its place, because
 * it may be necessary to turn a corner first. If no pose sees such a site
 * either, exploration ends. Ties go to the lowest candidate number.
 *
 * The first station is at the start. The path between two stations is the
 * shortest path over places seen so far (over a part of these places if they
 * are many, plan/explored.h), in straight unobstructed steps (plan/route.c).
 *
 * Source: C. I. Connolly, Proc. IEEE ICRA (1985) 432,
 * doi:10.1109/ROBOT.1985.1087372 (next best view). */
#ifndef MURK_PLAN_EXPLORE_H
#define MURK_PLAN_EXPLORE_H

#include "placement/place.h"
#include "plan/poses.h"
#include "sensing/candidates.h"
#include "world/stage.h"

/* Upper limit on the number of stations besides fixed sensors: exploration ends
 * even if no other limit is reached. */
#define MURK_EXPLORE_MAX 1000

typedef enum murk_explore_end {
    MURK_EXPLORE_COUNT,       /* the requested number of sensors, fixed sensors
                                 included, is reached */
    MURK_EXPLORE_TARGET,      /* the target coverage is reached */
    MURK_EXPLORE_CONSTRAINTS, /* the constraints (budget, counts, spacing,
                               * sites) admit no further pose in the space that
                               * was seen */
    MURK_EXPLORE_NOTHING, /* no pose adds coverage or brings places into view,
                           * or the plan has every pose in the space that was
                           * seen */
    MURK_EXPLORE_STATIONS /* MURK_EXPLORE_MAX stations were chosen */
} murk_explore_end;

/* The state after one station was added. */
typedef struct murk_explore_step {
    uint32_t candidate;   /* number of the pose */
    uint64_t gain, value; /* coverage in units of weight * clarity: added by
                           * this station, and of all stations so far, fixed
                           * sensors included */
    double path_m;        /* length of the path so far */
    size_t places_seen;   /* number of usable sites seen so far */
    uint64_t queries, shadow_rays; /* work so far */
    size_t stops; /* number of stops of the path up to this station; for fixed
                     sensors 1, or 0 if the scene gives start_m: the path then
                     begins with the first station */
} murk_explore_step;

typedef struct murk_explore {
    murk_explore_step *step; /* [steps]; fixed sensors first */
    size_t steps, fixed;
    murk_vec3 *stop; /* [stops]; vertices of the path, beginning with the start
                      */
    size_t stops;
    size_t places;         /* number of usable sites */
    uint64_t lines_tested; /* number of straight lines between places that were
                            * tested */
    murk_explore_end end;
} murk_explore;

/* Finds the place where the path begins: the usable site nearest to the point
 * start_m of the scene among those that an open straight segment joins to
 * start_m; without start_m, the place of the first fixed sensor. *start is the
 * number of a place, as in poses->site. Fails with MURK_BAD_VALUE at the key
 * placement of the scene if there is neither start_m nor a fixed sensor, if
 * start_m lies outside the domain, or if no usable site is joined to start_m;
 * or with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_explore_start(uint32_t *start, const murk_stage *stage,
                               const murk_candidates *sites,
                               const murk_poses *poses, murk_error *err);

/* Explores from the place `start`. Fills *out, and in *place the sensors (fixed
 * sensors included), count, value and cost of the plan that the stations form;
 * bounds are not filled. With a target or a budget, desc->count is the maximum
 * number of sensors. desc->constraints must be set. Fails with MURK_RUN_FAILED
 * if exploration ends before the target or the minimum counts of sensor types
 * are reached, with MURK_BAD_VALUE if the constraints contradict each other or
 * let no sensor stand at the start, or with MURK_NO_MEMORY or MURK_INTERRUPTED.
 * Release *out also after a failure. */
murk_status murk_explore_run(murk_explore *out, murk_place_result *place,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_problem *problem,
                             const murk_candidates *sites,
                             const murk_poses *poses, uint32_t start,
                             const murk_place_desc *desc, murk_error *err);

/* Adds to *place upper bounds on the value of plans of any candidates, seen or
 * not: upper, ceiling, the curve of the stations with upper bounds (none with a
 * budget), and in `fewest` a lower bound on the number of sensors that reach
 * the target (0 without a target or a curve, and if the bound of no number
 * reaches the target). Computes the coverage row of every candidate, and stores
 * all rows in a matrix, of which desc->row_memory bytes lie in memory. */
murk_status murk_explore_bound(murk_place_result *place,
                               const murk_explore *explore,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err);

void murk_explore_release(murk_explore *explore);

#endif
