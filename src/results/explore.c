/* How an exploration went: rows of JSON and CSV, and lines of the summary. */
#include "results/explore.h"

#include "results/coverage.h"
#include "results/path_ply.h"
#include "results/plan.h"
#include "results/summary.h"

#include <stdlib.h>
#include <string.h>

#define DIGITS 9 /* of shares and lengths in explore.csv */

static const char *const END_NAMES[] = {[MURK_EXPLORE_COUNT] = "count",
                                        [MURK_EXPLORE_TARGET] = "target",
                                        [MURK_EXPLORE_CONSTRAINTS] = "rules",
                                        [MURK_EXPLORE_NOTHING] =
                                            "nothing_to_gain",
                                        [MURK_EXPLORE_STATIONS] = "stations"};

/* The number of a step's sensor in the plan, whose candidates rise. */
static size_t sensor_of(const murk_plan_result *plan,
                        const murk_explore_step *step)
{
    size_t low = 0, high = plan->place.count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (plan->place.sensor[middle] <= step->candidate) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low + 1;
}

static double coverage_of(const murk_plan_result *plan, uint64_t value)
{
    return murk_share(value, plan->place.whole);
}

static double path_of(const murk_explore *explore)
{
    return explore->steps ? explore->step[explore->steps - 1].path_m : 0;
}

static size_t seen_of(const murk_explore *explore)
{
    return explore->steps ? explore->step[explore->steps - 1].places_seen : 0;
}

typedef struct explored {
    const murk_plan_result *plan;
    const murk_scene_desc *scene;
} explored;

/* steps[] of plan.json, and explore.csv. */
void murk_results_list_step(murk_results_fields *f, const void *of, size_t i)
{
    const explored *e = of;
    const murk_explore_step *step = e ? &e->plan->explore.step[i] : NULL;
    const murk_posed p =
        e ? (murk_posed){e->scene, &e->plan->poses->pose[step->candidate]}
          : (murk_posed){NULL, NULL};
    if (murk_results_is_csv(f)) {
        MURK_COUNT(f, "step", "number, from 1", i + 1);
        murk_results_list_position(f, p);
        murk_results_list_type(f, p);
        murk_results_list_heading(f, p);
    }
    MURK_COUNT(f, "sensor", "number among the plan's, from 1",
               sensor_of(e->plan, step));
    if (!murk_results_is_csv(f)) {
        murk_results_list_type(f, p);
        murk_results_list_position(f, p);
        murk_results_list_heading(f, p);
    }
    MURK_ROUNDED(f, "gain", "1", "coverage that the station adds",
                 coverage_of(e->plan, step->gain), DIGITS);
    MURK_ROUNDED(f, "coverage", "1", "coverage so far",
                 coverage_of(e->plan, step->value), DIGITS);
    MURK_ROUNDED(f, "path_m", "m", "length of the path so far", step->path_m,
                 DIGITS);
    MURK_COUNT(f, "places_seen", "candidates known so far", step->places_seen);
    MURK_COUNT(f, "queries", "queries of the maps so far", step->queries);
    MURK_COUNT(f, "shadow_rays", "sightlines followed so far",
               step->shadow_rays);
}

static void list_explore(murk_results_fields *f, const void *of)
{
    const explored *e = of;
    const murk_explore *explore = e ? &e->plan->explore : NULL;
    MURK_VECTOR(f, "start_m", "m", "the first station",
                explore->stops ? murk_scene_user(e->scene, explore->stop[0])
                               : murk_vec(NAN, NAN, NAN));
    MURK_NUMBER(f, "path_m", "m", "length of the path", path_of(explore));
    MURK_COUNT(f, "places", "candidates", explore->places);
    MURK_COUNT(f, "places_seen", "candidates that became known",
               seen_of(explore));
    MURK_COUNT(f, "ways_tried", "segments that were tried", explore->ways);
    MURK_TEXT(f, "ended_by",
              "count, target, rules, nothing_to_gain or stations",
              END_NAMES[explore->end]);
    MURK_LIST(f, "steps", "the stations, in order", murk_results_list_step, e,
              explore->steps);
}

void murk_results_list_explore(murk_results_fields *f,
                               const murk_scene_desc *scene,
                               const murk_plan_result *plan)
{
    const explored e = {plan, scene};
    if (MURK_LISTED_IF(f, scene->placement.knowledge == MURK_SCENE_EXPLORE)) {
        MURK_OBJECT(f, "explore", "with knowledge: explore", list_explore, &e);
    }
}

murk_status murk_add_explore(murk_results *results, const murk_stage *stage,
                             const murk_plan_result *plan, murk_error *err)
{
    if (plan->explore.steps == 0) { /* over conditions no stage is one */
        return MURK_OK;
    }
    const explored e = {plan, stage->scene};
    const murk_box *box = &stage->world.domain.box;
    const double size_m = murk_length(murk_sub(box->max, box->min));
    const murk_status status =
        murk_results_add_csv(results, "explore.csv", murk_results_list_step, &e,
                             plan->explore.steps, err);
    return status ? status
                  : murk_add_path_ply(results, stage->scene, &plan->explore,
                                      size_m, err);
}

void murk_print_explore(const murk_plan_result *plan, const char *folder)
{
    const murk_explore *explore = &plan->explore;
    if (explore->steps == 0) {
        return;
    }
    murk_print("explore     %.4g m gone; %zu of %zu places seen; ended by %s\n",
               path_of(explore), seen_of(explore), explore->places,
               END_NAMES[explore->end]);
    murk_print(
        "            step  sensor     gain  coverage    path m   places    "
        "queries\n");
    for (size_t k = 0; k < explore->steps && k < MURK_PRINTED_ROWS; ++k) {
        const murk_explore_step *step = &explore->step[k];
        murk_print("            %4zu  %6zu  %7.4f  %8.4f  %8.2f  %7zu  %9llu\n",
                   k + 1, sensor_of(plan, step), coverage_of(plan, step->gain),
                   coverage_of(plan, step->value), step->path_m,
                   step->places_seen, (unsigned long long)step->queries);
    }
    murk_print_more(explore->steps, folder, "explore.csv");
}
