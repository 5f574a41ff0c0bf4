/* From light to plan: candidates, what they see, which are chosen, and how
 * well the choice does on light that did not choose it. */
#ifndef MURK_PLAN_PLAN_H
#define MURK_PLAN_PLAN_H

#include "lightmap/lightmap.h"
#include "placement/place.h"
#include "plan/explore.h"
#include "plan/poses.h"
#include "plan/robust.h"
#include "plan/sites.h"
#include "plan/targets.h"
#include "sensing/sight.h"

/* Sight through a stage onto traced light, or onto the targets of its stream
 * where the scene has such. Borrows both. */
murk_status murk_plan_sight(murk_sight **out, const murk_stage *stage,
                            const murk_traced *traced, unsigned threads,
                            murk_error *err);

/* The same; also tells of the targets (points 0: none). */
murk_status murk_plan_sight_told(murk_sight **out, murk_target_facts *facts,
                                 const murk_stage *stage,
                                 const murk_traced *traced, unsigned threads,
                                 murk_error *err);

/* Sight onto points that are given as records, numbered below `numbers`, as
 * sensors of the scene would see light there: range, view, sightlines, media
 * and threshold as ever. Where light comes from is not asked, nor is what a
 * sensor takes up (arrival, detection: power), nor what counts for more
 * (weights, interest). Borrows all. */
murk_status murk_plan_sight_points(murk_sight **out, const murk_stage *stage,
                                   const murk_photon_map *surface,
                                   const murk_photon_map *volume,
                                   uint64_t numbers, unsigned threads,
                                   murk_error *err);

/* With detection: power, the radius of its estimates, as the scene has it, or
 * 10 % of the domain's diagonal, which is then the largest; else 0. */
double murk_plan_power_radius_m(const murk_stage *stage);

/* By how many neighbours places are judged; 0: by a fixed radius, or not by
 * power. */
size_t murk_plan_power_neighbours(const murk_stage *stage);

/* The least value (weight * clarity) of a plan that covers the share, 0..1, of
 * the whole; a share within rounding of a value means it. */
uint64_t murk_plan_value_of(double share, const murk_problem *problem);

/* How many sensors are to see each photon of the target; 0: not asked, or
 * without a target. */
size_t murk_plan_at_least(const murk_scene_desc *scene);

/* What can be wrong with the scene's wishes by themselves. */
murk_status murk_plan_check(const murk_stage *stage, unsigned threads,
                            murk_error *err);

/* The solver's description of them, without rules and target. */
murk_place_desc murk_plan_desc(const murk_scene_desc *scene);

/* The memory that a known matrix may take [bytes]. */
uint64_t murk_plan_matrix_bytes(void);

#define MURK_HELD_OUT_STREAM 1u
#define MURK_CONFIRM_STREAM  2u

/* Light of another stream; where targets take its place none is needed, unless
 * it decides how well they are noticed (detection: power). */
murk_status murk_plan_see_anew(murk_traced **out, const murk_stage *stage,
                               uint32_t stream, unsigned threads,
                               murk_error *err);

/* Whether another stream shows anything else than the first: a list of targets
 * is all there is. */
bool murk_plan_can_see_anew(const murk_scene_desc *scene);

typedef struct murk_plan_result {
    bool without_curve; /* asked for: the plan alone, without those of fewer
                           sensors */
    murk_candidates *candidates;
    murk_poses *poses; /* of them: what placement chooses from */
    murk_place_result place;
    uint32_t start;            /* knowledge: explore: where it begins, and */
    murk_explore explore;      /* how it went; else empty */
    murk_pose *sensor;         /* [place.count] */
    murk_target_facts targets; /* points 0: photons are seen */
    bool is_dark;              /* there was nothing to see: plan/dark.h */
    murk_coverage_result in_sample; /* on the light that chose */
    bool has_held_out;
    murk_estimate held_out;                /* on the second map */
    murk_region_coverage *held_out_region; /* [regions of interest] likewise;
                                              NULL: none held out */
    murk_estimate confirmed;               /* with a target: on a third map,
                                              of at_least the strict share */
    murk_robust robust;
    double power_radius_m;         /* of detection: power; 0: another */
    size_t power_neighbours;       /* likewise; 0: the radius is fixed */
    uint64_t queries, shadow_rays; /* spent on choosing, without those of */
    uint64_t forecast_looks, forecast_rays;            /* a forecast's sample */
    uint64_t blocked_by_interfaces, totally_reflected; /* then, sightlines */
    double trace_s, map_s, sense_s, place_s;
} murk_plan_result;

/* All that can be wrong with the scene's sensors is found here, before any
 * light is traced: fills plan->candidates and plan->poses. */
murk_status murk_plan_prepare(murk_plan_result *plan, const murk_stage *stage,
                              unsigned threads, murk_error *err);

/* The main job, from a prepared plan and traced light on; with hold_out it
 * also traces the second map. In the dark the plan is that of plan/dark.h.
 * Release the plan also after a failure. */
murk_status murk_plan_result_make(murk_plan_result *plan,
                                  const murk_stage *stage,
                                  const murk_traced *traced, unsigned threads,
                                  murk_error *err);
/* The plan of a scene in which no light source emits: the fixed sensors and no
 * others, because no candidate is better than another. */
murk_status murk_plan_result_make_dark(murk_plan_result *plan,
                                       const murk_stage *stage,
                                       murk_error *err);
void murk_plan_result_release(murk_plan_result *plan);

/* Its first part alone: fills plan->place and plan->sensor by what sight shows,
 * and measures nothing. */
murk_status murk_plan_choose(murk_plan_result *plan, const murk_stage *stage,
                             murk_sight *sight, murk_error *err);

#endif
