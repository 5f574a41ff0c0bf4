/* From traced light to a plan: candidate sites, coverage and the chosen
 * sensors. src/cases measures the coverage of a plan, also on photons that had
 * no part in the choice, because the coverage of the photons that chose the
 * plan is biased upwards. */
#ifndef MURK_PLAN_PLAN_H
#define MURK_PLAN_PLAN_H

#include "lightmap/lightmap.h"
#include "placement/place.h"
#include "plan/earlier.h"
#include "plan/explore.h"
#include "plan/poses.h"
#include "plan/robust.h"
#include "plan/sites.h"
#include "plan/targets.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* Creates the sight (sensing/sight.h) of the sensors of a stage: onto the
 * records of the traced light, or onto targets if the scene has targets (those
 * of the random stream of the light). Borrows the stage and the light. Fails as
 * murk_targets_create() or murk_sight_create(). */
murk_status murk_plan_sight(murk_sight **out, const murk_stage *stage,
                            const murk_traced *traced, unsigned threads,
                            murk_error *err);

/* As murk_plan_sight(), without its warnings: a murk_earlier_see. */
murk_status murk_plan_sight_again(murk_sight **out, const murk_stage *stage,
                                  const murk_traced *traced, unsigned threads,
                                  murk_error *err);

/* As murk_plan_sight(); *facts receives the properties of the targets (points
 * 0: the scene has none). */
murk_status murk_plan_sight_and_targets(murk_sight **out,
                                        murk_target_facts *facts,
                                        const murk_stage *stage,
                                        const murk_traced *traced,
                                        unsigned threads, murk_error *err);

/* Creates the sight of the sensors onto given points, which are records of two
 * maps with photon numbers below `numbers`. Range, view, sightlines, media and
 * threshold apply as for photons. Arrival direction, detection by power, and
 * the weights, redundancy and regions of interest of the scene do not apply.
 * Borrows the stage and the maps. Fails as murk_sight_create(). */
murk_status murk_plan_sight_points(murk_sight **out, const murk_stage *stage,
                                   const murk_photon_map *surface,
                                   const murk_photon_map *volume,
                                   uint64_t numbers, unsigned threads,
                                   murk_error *err);

/* The radius of the density estimates of `detection: power` in metres:
 * power_radius_m of the scene, or the largest radius of estimates by k nearest
 * neighbours, which is 10 % of the diagonal of the domain, in a periodic domain
 * at most half the shorter period. 0 for other modes of detection. */
double murk_plan_power_radius_m(const murk_stage *stage);

/* The number of nearest neighbours of the estimates of `detection: power`; 0
 * for a fixed radius and for other modes of detection. */
size_t murk_plan_power_neighbours(const murk_stage *stage);

/* The smallest value (coverage in units of weight * clarity) that is at least
 * the given share, 0..1, of the whole, which is the value if every photon
 * counts fully. If share times whole is an integer up to rounding, the result
 * is that integer. */
uint64_t murk_plan_value_of(double share, const murk_problem *problem);

/* The number of sensors that must see a photon before the photon counts towards
 * the target (key at_least); 0 if the scene has no target or no such key. */
size_t murk_plan_at_least(const murk_scene_desc *scene);

/* Checks those settings of the sensors that do not depend on candidates. Fails
 * with MURK_BAD_VALUE if the scene has no sensors, if it gives neither a count
 * nor a target nor a budget, or if it stores no photon maps although sensors
 * cover photons or detect by power; and if acceptance angles, the radius of
 * `detection: power` or the targets would make a later step fail. */
murk_status murk_plan_check(const murk_stage *stage, unsigned threads,
                            murk_error *err);

/* The key of the scene that asks for a plan which a study, repeats and an
 * exported problem do not have: at_least, a rule on moves, look_ahead; NULL:
 * none. */
const char *murk_plan_single_key(const murk_scene_desc *scene);

/* The same for a scene whose plans will begin at other plans, as those of the
 * steps of a timeline. */
const char *murk_plan_single_key_of_steps(const murk_scene_desc *scene);

/* The solver settings of the scene, without constraints and target. */
murk_place_desc murk_plan_desc(const murk_scene_desc *scene);

/* Streams of random numbers (murk_trace.stream in transport/trace.h) for the
 * light, or the drawn targets, of the map that is held out and of the map that
 * confirms a target. Stream 0 is that of the map that chooses the plan. */
#define MURK_HELD_OUT_STREAM 1u
#define MURK_CONFIRM_STREAM  2u

/* Traces the light of a stream. If targets replace photons, returns light
 * without photons, unless detection depends on the light (detection: power).
 * The caller owns *out (murk_traced_destroy()). */
murk_status murk_plan_trace_stream(murk_traced **out, const murk_stage *stage,
                                   uint32_t stream, unsigned threads,
                                   murk_error *err);

/* True if coverage can be measured by photons that are not stored: without
 * targets, and as murk_coverage_can_stream(). */
bool murk_plan_can_stream(const murk_stage *stage);

/* Measures the coverage of sensor[n] by the photons of a stream, which are
 * tested while they are traced and not stored (sensing/coverage_stream.h).
 * `expected`: about so many records will come. Adds the time to *trace_s.
 * passed: unless NULL, gets the photons, which are then taken from `earlier` as
 * far as they are the same (NULL: from none); the caller releases it. Fails as
 * murk_plan_trace_stream() and murk_coverage_result_measure(). */
murk_status murk_plan_measure_streamed(murk_coverage_result *out,
                                       double *trace_s, const murk_stage *stage,
                                       uint32_t stream, const murk_pose *sensor,
                                       size_t n, size_t expected,
                                       const murk_passed_light *earlier,
                                       murk_passed_light *passed,
                                       unsigned threads, murk_error *err);

/* True if sensors cover other photons or targets in another stream; false if
 * the targets are a list, because a list is the same in all streams. */
bool murk_plan_has_streams(const murk_scene_desc *scene);

/* The best plan found for a scene, as it is at the time of the plan, without
 * the rule on moves and without other steps: coverage in sample, as shares. */
typedef struct murk_free_plan {
    bool is_there;                /* false: the plan itself is this plan */
    double coverage, upper;       /* upper: of any plan of as many sensors */
    double ceiling;               /* coverage of all candidates */
    bool is_interrupted, is_late; /* the search was ended, as in
                                   * murk_place_result: another run may give
                                   * another plan and bound */
} murk_free_plan;

typedef struct murk_plan_result {
    bool without_curve; /* set by the caller: compute the plan alone, without
                         * the curve over smaller numbers of sensors */
    const murk_pose *start_sensor; /* set by the caller: [start_sensors], at
                                    * which the search begins in place of
                                    * placement.start_plan; NULL: none */
    size_t start_sensors;
    bool keeps_matrix;        /* set by the caller: `matrix` stays */
    struct murk_ahead *ahead; /* set by the caller (cases/ahead.h): the steps
                               * that the plan is chosen for; NULL: its own time
                               */
    const murk_earlier_plan *earlier; /* set by the caller: a plan whose rows
                                       * are taken over where they are the
                                       * same; NULL: none. Its matrix is
                                       * destroyed by then */
    murk_passed_light held; /* with keeps_matrix, the held-out light, if it was
                             * not stored otherwise and takes at most an eighth
                             * of memory_mb */
    murk_matrix *matrix; /* of a known environment, with keeps_matrix, unless it
                          * takes more than half of memory_mb; else NULL */
    murk_row_counts *tested; /* [poses] sightlines of each row, with `matrix`;
                              * with `ahead` [steps of the matrix][poses] */
    murk_candidates *candidates;
    murk_poses *poses; /* poses of the candidates: the choices of placement */
    murk_place_result place;
    murk_free_plan free;
    uint32_t start;            /* with knowledge: explore, the place where the
                                * path begins */
    murk_explore explore;      /* with knowledge: explore, the steps; else empty
                                */
    murk_pose *sensor;         /* [place.count] */
    murk_target_facts targets; /* points 0: the plan covers photons, or there is
                                * nothing to see */
    bool is_dark;              /* there is nothing to see
                                * (murk_stage_has_nothing_to_see()), so all
                                * coverage is NaN (plan/dark.c) */
    murk_coverage_result in_sample; /* on the photons that chose the plan */
    bool has_held_out;
    murk_estimate held_out; /* coverage on the second map */
    /* [regions of interest]; coverage on the second map; NULL if there
     * is none */
    murk_region_coverage *held_out_region;
    murk_estimate
        confirmed; /* with a target: coverage on a third map, or with at_least
                      the share of photons there that at least so many sensors
                      see; without a target NaN */
    murk_robust robust;
    double power_radius_m;   /* of detection: power; else 0 */
    size_t power_neighbours; /* of detection: power; 0 for a fixed radius
                              */
    /* The work of choosing, without that of the forecast: rows that the method
     * asks for; those of them that were computed, because they were not
     * remembered; sightlines tested against surfaces. */
    uint64_t queries, looks, shadow_rays;
    uint64_t reused; /* sightlines among the shadow rays that were taken over
                      * from the earlier plan */
    uint64_t forecast_queries, forecast_rays;          /* work of the sample of
                                                        * a forecast */
    uint64_t blocked_by_interfaces, totally_reflected; /* number of sightlines
                                                        */
    double trace_s, map_s, sense_s, place_s;
} murk_plan_result;

/* Checks the settings of the sensors before light is traced
 * (murk_plan_check()), and fills the candidates and poses of the plan, the
 * settings of `detection: power`, and with knowledge: explore the start. Fails
 * as murk_plan_check() and as the functions that find sites, poses and the
 * start. */
murk_status murk_plan_prepare(murk_plan_result *plan, const murk_stage *stage,
                              unsigned threads, murk_error *err);

/* Completes a prepared plan of a stage that has nothing to see
 * (murk_stage_has_nothing_to_see()): the plan has the fixed sensors and no
 * others, because no candidate is better than another, and all coverage is NaN.
 */
murk_status murk_plan_result_make_dark(murk_plan_result *plan,
                                       const murk_stage *stage,
                                       murk_error *err);
void murk_plan_result_release(murk_plan_result *plan);

/* Chooses the sensors of a prepared plan by the given sight: fills plan->place
 * and plan->sensor, with knowledge: explore plan->explore, and the time and the
 * work of choosing. Measures no coverage. An error names the key sensors of the
 * scene as the place, unless a more exact place is known. */
murk_status murk_plan_choose(murk_plan_result *plan, const murk_stage *stage,
                             murk_sight *sight, murk_error *err);

/* Fills plan->free by a search with the settings `like`, but without the rule
 * on moves, over the problem and matrix of the scene at the time of the plan.
 * Nothing is done with a target. */
murk_status murk_plan_choose_free(murk_plan_result *plan,
                                  const murk_problem *problem,
                                  const murk_matrix *matrix,
                                  const murk_place_desc *like, murk_error *err);

/* Fills plan->free from the result of such a search, which it releases, unless
 * status says that the search failed; returns status. */
murk_status murk_plan_take_free(murk_plan_result *plan, murk_place_result *any,
                                murk_status status);

/* Numbers of sightlines for so many rows of a matrix that stays; NULL when out
 * of memory, and the matrix then does not stay. The caller frees it. */
murk_row_counts *murk_plan_note_sightlines(size_t candidates);

/* Destroys the matrix of plan->earlier, whose rows are not needed again. */
void murk_plan_forget_earlier(murk_plan_result *plan);

/* The memory that the matrix of an earlier plan takes of that for rows; 0
 * without a matrix. */
uint64_t murk_plan_memory_taken(const murk_matrix *earlier, uint64_t memory);

/* Fills plan->sensor from plan->place and the poses. */
murk_status murk_plan_take_sensors(murk_plan_result *plan,
                                   const murk_scene_desc *scene,
                                   murk_error *err);

/* Adds the counters of a sight to the work of choosing, looks and shadow rays
 * without those of the forecast. */
void murk_plan_add_work(murk_plan_result *plan, const murk_sight *sight);

/* Sets the queries of the work of choosing, after the counters of all sights
 * were added: the queries of an unknown environment, or 0 if each look is a
 * query. */
void murk_plan_count_queries(murk_plan_result *plan, uint64_t queries);

/* Creates a coverage result of n sensors in which all coverage is NaN. The
 * caller releases *out with murk_coverage_result_release(). Fails with
 * MURK_NO_MEMORY. */
murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err);

#endif
