#include "results/explore.h"

#include "results/coverage.h"
#include "results/path_ply.h"
#include "results/plan.h"
#include "results/summary.h"

#include <stdlib.h>
#include <string.h>

const char *const murk_knowledge_names[] = {[MURK_SCENE_KNOWN] = "known",
                                            [MURK_SCENE_UNKNOWN] = "unknown",
                                            [MURK_SCENE_EXPLORE] = "explore"};

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

static cJSON *step_json(const murk_plan_result *plan,
                        const murk_scene_desc *scene,
                        const murk_explore_step *step)
{
    const murk_pose *pose = &plan->poses->pose[step->candidate];
    cJSON *item = cJSON_CreateObject();
    cJSON_AddNumberToObject(item, "sensor", (double)sensor_of(plan, step));
    cJSON_AddStringToObject(item, "type", scene->sensors.type[pose->type].name);
    murk_json_vector(item, "position_m",
                     murk_scene_user(scene, pose->position));
    murk_json_heading(item, scene, pose);
    murk_json_number(item, "gain", coverage_of(plan, step->gain));
    murk_json_number(item, "coverage", coverage_of(plan, step->value));
    murk_json_number(item, "path_m", step->path_m);
    cJSON_AddNumberToObject(item, "places_seen", (double)step->places_seen);
    cJSON_AddNumberToObject(item, "queries", (double)step->queries);
    cJSON_AddNumberToObject(item, "shadow_rays", (double)step->shadow_rays);
    return item;
}

static double path_of(const murk_explore *explore)
{
    return explore->steps ? explore->step[explore->steps - 1].path_m : 0;
}

static size_t seen_of(const murk_explore *explore)
{
    return explore->steps ? explore->step[explore->steps - 1].places_seen : 0;
}

void murk_json_explore(cJSON *root, const murk_scene_desc *scene,
                       const murk_plan_result *plan)
{
    const murk_explore *explore = &plan->explore;
    if (scene->placement.knowledge != MURK_SCENE_EXPLORE) {
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(root, "explore");
    if (explore->stops) {
        murk_json_vector(object, "start_m",
                         murk_scene_user(scene, explore->stop[0]));
    } else {
        cJSON_AddNullToObject(object, "start_m");
    }
    murk_json_number(object, "path_m", path_of(explore));
    cJSON_AddNumberToObject(object, "places", (double)explore->places);
    cJSON_AddNumberToObject(object, "places_seen", (double)seen_of(explore));
    cJSON_AddNumberToObject(object, "ways_tried", (double)explore->ways);
    cJSON_AddStringToObject(object, "ended_by", END_NAMES[explore->end]);
    cJSON *steps = cJSON_AddArrayToObject(object, "steps");
    for (size_t k = 0; k < explore->steps; ++k) {
        cJSON_AddItemToArray(steps, step_json(plan, scene, &explore->step[k]));
    }
}

typedef struct told {
    const murk_plan_result *plan;
    const murk_scene_desc *scene;
} told;

static murk_status write_csv(const char *path, const void *context,
                             murk_error *err)
{
    const told *t = context;
    const murk_explore *explore = &t->plan->explore;
    murk_file *file = NULL;
    const murk_status status = murk_file_create(&file, path, err);
    if (status) {
        return status;
    }
    FILE *to = murk_file_stream(file);
    fputs("step,x_m,y_m,z_m,type,heading_deg,tilt_deg,sensor,gain,coverage,"
          "path_m,places_seen,queries,shadow_rays\n",
          to);
    for (size_t k = 0; k < explore->steps; ++k) {
        const murk_explore_step *step = &explore->step[k];
        murk_write_pose(to, k + 1, t->scene,
                        &t->plan->poses->pose[step->candidate]);
        fprintf(to, ",%zu,%.9g,%.9g,%.9g,%zu,%llu,%llu\n",
                sensor_of(t->plan, step), coverage_of(t->plan, step->gain),
                coverage_of(t->plan, step->value), step->path_m,
                step->places_seen, (unsigned long long)step->queries,
                (unsigned long long)step->shadow_rays);
    }
    return murk_file_commit(&file, err);
}

murk_status murk_add_explore(murk_results *results, const murk_stage *stage,
                             const murk_plan_result *plan, murk_error *err)
{
    if (plan->explore.steps == 0) { /* over conditions no stage is one */
        return MURK_OK;
    }
    const told t = {plan, stage->scene};
    const murk_box *box = &stage->world.domain.box;
    const double size_m = murk_length(murk_sub(box->max, box->min));
    const murk_status status =
        murk_results_add(results, "explore.csv", write_csv, &t, err);
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
