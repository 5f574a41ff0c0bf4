/* Searches for plans: greedy, SPOQ and certified relocation, all made of scans
 * (placement/scan.h). The sources stand in placement/place.h. */
#ifndef MURK_PLACEMENT_SEARCH_H
#define MURK_PLACEMENT_SEARCH_H

#include "placement/scan.h"

/* All functions but murk_search_begin(), murk_search_draw() and
 * murk_search_begin_at() return the value of the plan that they leave in
 * plan[], which has distinct candidates. If the run is interrupted these
 * functions return early, and the plan has no meaning.
 *
 * Under constraints the fixed sensors come first in a plan and never move,
 * every plan tried is feasible, and s->size is the number of sensors
 * afterwards: greedy may stop before n, and with a budget a plan has as many
 * sensors as the budget pays for, n at most. */

/* With constraints: begins a plan of n sensors (with a budget: of at most the
 * set's max_sensors) by emptying s->partial. plan[given] must begin with the
 * fixed sensors, as far as it reaches; the function appends the fixed sensors
 * that are missing. Returns the number of sensors in the plan; without
 * constraints `given`. */
size_t murk_search_begin(murk_gain_scan *s, uint32_t *plan, size_t given,
                         size_t n);

/* Extends a plan of `given` sensors to n sensors, or until the value reaches
 * `enough`, no candidate can be added, or, with a budget, the minimum counts
 * are met and no candidate has a gain. Each step adds the candidate with the
 * largest gain, the lowest index on ties. value_after[k] receives the value of
 * the first k + 1 sensors, for k + 1 >= given; NULL is allowed. Lowers the
 * upper bounds s->greedy_bound, if they are recorded, at each step. */
uint64_t murk_search_greedy(murk_gain_scan *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after);

/* Draws start number `restart` at random: n sensors, or under a budget as many
 * as the budget pays for. If the sensors drawn under constraints make no
 * complete plan, the start is s->fallback (placement/scan.h). Returns the
 * number of sensors in plan[]. */
size_t murk_search_draw(murk_gain_scan *s, uint32_t *plan, size_t n,
                        uint32_t seed, uint64_t restart);

/* Makes a plan of n sensors from a given list of distinct candidates,
 * list[given]: adds those that keep the constraints, in the order of the list,
 * until the plan is full, then completes the plan by greedy. If greedy cannot
 * complete the plan, the result is s->fallback. *taken receives the number of
 * candidates of the list that are in the plan by way of the list, fixed sensors
 * included; 0 for the fallback plan. Returns the number of sensors in plan[].
 */
size_t murk_search_begin_at(murk_gain_scan *s, uint32_t *plan, size_t n,
                            const uint32_t *list, size_t given, size_t *taken);

/* The published SPOQ algorithm (placement/place.h) from start number `restart`,
 * with two differences. With a budget, each sweep is followed by
 * murk_search_budget_greedy(). And two sensors never share a candidate; in the
 * published problem, in which only the largest entry of a photon counts, a
 * second sensor at a candidate adds nothing, so this matters only if no
 * candidate has a gain. Ends early beyond s->rows_max, as
 * murk_search_relocate() does. */
uint64_t murk_search_spoq(murk_gain_scan *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart);

/* The same from the given plan[n], with the random numbers of start 0. Under a
 * rule on moves each sensor goes to the best place by the objective of
 * placement/moves.h, which is also what is returned. */
uint64_t murk_search_spoq_from(murk_gain_scan *s, uint32_t *plan, size_t n,
                               uint32_t seed);

/* Certified relocation: moves single sensors that are not fixed to other
 * candidates while a move increases the value; a sensor stays where it is if no
 * other candidate gives more. With a budget: when no move increases the value
 * any more, sensors that the rest of the budget pays for are added, and the
 * moves begin again until none can be added with a gain. At the end no feasible
 * move of a single sensor increases the value, unless the limit s->rows_max on
 * work (placement/scan.h) ended the search, which then sets s->is_cut. */
uint64_t murk_search_relocate(murk_gain_scan *s, uint32_t *plan, size_t n);

/* The same two searches step by step: a climb alternates between
 * murk_climb_prepare() and murk_climb_move(), so that several climbs can share
 * a pass over the rows (placement/lanes.h). */
typedef struct murk_climb {
    uint32_t *plan;
    size_t n, fixed; /* sensors of the plan; those that never move come first */
    bool is_spoq;    /* else relocation */
    uint64_t value;  /* of the plan */
    uint64_t others; /* of the plan without the mover */
    size_t mover;    /* sensor under consideration */
    size_t at;       /* SPOQ: steps made in the sweep; relocation: the next
                        sensor */
    uint32_t seed, sweep, step; /* SPOQ only, as the next two */
    uint64_t restart;
    uint64_t before; /* value at the beginning of the sweep */
    size_t still;    /* relocation: sensors in a row that did not move */
} murk_climb;

/* Borrow plan[], which has space for a plan. The same scan must take part in
 * all steps of a climb. */
void murk_climb_begin_spoq(murk_climb *climb, murk_gain_scan *s, uint32_t *plan,
                           size_t n, uint32_t seed, uint64_t restart);
void murk_climb_begin_relocation(murk_climb *climb, murk_gain_scan *s,
                                 uint32_t *plan, size_t n);

/* Makes the partial plan of the next step. False at the end of the climb;
 * climb->value and s->size then describe the plan. */
bool murk_climb_prepare(murk_climb *climb, murk_gain_scan *s);

/* Scans the candidates and moves the sensor. */
void murk_climb_move(murk_climb *climb, murk_gain_scan *s);

/* With a budget: extends plan[given]. Each step adds, of the candidates that
 * can be added, the one with the largest gain per cost. If none has a gain, the
 * step adds the cheapest candidate of the first class whose minimum count is
 * not reached. Ends when there is no such candidate either. */
uint64_t murk_search_budget_greedy(murk_gain_scan *s, uint32_t *plan,
                                   size_t given);

#endif
