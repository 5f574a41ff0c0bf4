/* The steps of a timeline that an earlier run has left in the folder: a step
 * whose plan has the identity of this run is taken from its files and not made
 * again. After the last of them its plan is made once more, for the step that
 * follows. */
#include "api/follow.h"

#include "base/file.h"
#include "plan/placement_in.h"
#include "scene/timeline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

char *murk_follow_file(const char *folder, size_t step, const char *name)
{
    char part[64];
    snprintf(part, sizeof part, MURK_STEP_NAME, step);
    char *path = folder ? murk_path_join(folder, part) : NULL;
    if (path && name) {
        char *file = murk_path_join(path, name);
        free(path);
        path = file;
    }
    return path;
}

bool murk_follow_has_file(const char *folder, size_t step, const char *name)
{
    char *path = murk_follow_file(folder, step, name);
    struct stat found;
    const bool has = path && stat(path, &found) == 0;
    free(path);
    return has;
}

char *murk_follow_step_path(const murk_follow *follow, size_t step,
                            const char *name)
{
    return murk_follow_file(follow->folder, step, name);
}

static const cJSON *at(const cJSON *root, const char *map, const char *key)
{
    return cJSON_GetObjectItem(cJSON_GetObjectItem(root, map), key);
}

static double number_at(const cJSON *root, const char *map, const char *key)
{
    const cJSON *item = at(root, map, key);
    return cJSON_IsNumber(item) ? item->valuedouble : NAN;
}

/* A number that is 0 where it is not listed. */
static uint64_t count_at(const cJSON *map, const char *key)
{
    const cJSON *item = cJSON_GetObjectItem(map, key);
    return cJSON_IsNumber(item) ? (uint64_t)item->valuedouble : 0;
}

cJSON *murk_follow_read_json(const char *folder, size_t step, const char *name)
{
    char *path = murk_follow_file(folder, step, name), *text = NULL;
    size_t size = 0;
    cJSON *root = NULL;
    if (path &&
        !murk_file_read_own(&text, &size, path, MURK_YAML_MAX_BYTES, NULL)) {
        root = cJSON_Parse(text);
    }
    free(text);
    free(path);
    return root;
}

void murk_follow_fill_row(murk_follow_step *step, const cJSON *plan)
{
    murk_sequence_row *row = &step->row;
    const murk_estimate held_out = {
        number_at(plan, "coverage", "held_out"),
        number_at(plan, "coverage", "held_out_standard_error")};
    const murk_estimate in_sample = {
        number_at(plan, "coverage", "in_sample"),
        number_at(plan, "coverage", "in_sample_standard_error")};
    const double rays = number_at(plan, "placement", "shadow_rays");
    step->is_dark = !isfinite(in_sample.value);
    row->coverage = isfinite(held_out.value) ? held_out : in_sample;
    /* The bound, and the rule on moves. */
    row->upper = number_at(plan, "bound", "upper");
    const double free_upper = number_at(plan, "free", "upper");
    row->in_sample = in_sample.value;
    row->upper_free = isfinite(free_upper) ? free_upper : row->upper;
    row->moves = number_at(plan, "moves", "count");
    row->move_cost = number_at(plan, "moves", "cost");
    const cJSON *reused = at(plan, "run", "reused");
    row->photons_kept = count_at(reused, "photons");
    row->pairs_kept = count_at(reused, "sightlines");
    row->pairs_looked = rays > 0 ? (uint64_t)rays - row->pairs_kept : 0;
    /* What ended the search, and how many sensors it placed. */
    const char *cut = cJSON_GetStringValue(at(plan, "placement", "cut_by"));
    snprintf(row->cut_by, sizeof row->cut_by, "%s", cut ? cut : "");
    row->sensors =
        (size_t)cJSON_GetArraySize(cJSON_GetObjectItem(plan, "sensors"));
    const cJSON *seconds = at(plan, "run", "seconds");
    row->seconds =
        seconds ? cJSON_GetNumberValue(cJSON_GetObjectItem(seconds, "total"))
                : NAN;
}

murk_status murk_follow_fill_sensors(murk_follow_step *step,
                                     const murk_pose *pose, size_t n,
                                     murk_error *err)
{
    const murk_scene_sensors *sensors = &step->world->desc->sensors;
    step->poses = n > sensors->n_fixed ? n - sensors->n_fixed : 0;
    step->pose = calloc(step->poses + 1, sizeof *step->pose);
    if (!step->pose) {
        return murk_no_memory(err, "", "for the sensors of a step");
    }
    memcpy(step->pose, pose, step->poses * sizeof *pose);
    step->row.cost = 0;
    for (size_t i = 0; i < n; ++i) {
        step->row.cost += sensors->type[pose[i].type].cost;
    }
    return MURK_OK;
}

murk_status murk_follow_read_sensors(murk_follow_step *step, const char *path,
                                     murk_error *err)
{
    murk_pose *pose = NULL;
    size_t n = 0;
    murk_status status =
        murk_placement_read(&pose, &n, path, 0, step->world->desc,
                            &step->world->stage->world.domain, err);
    if (!status) {
        status = murk_follow_fill_sensors(step, pose, n, err);
    }
    free(pose);
    return status;
}

/* True if the light of a step lies in its folder, as its plan says, or is not
 * asked for. */
static bool has_light(const murk_follow *follow, const char *folder,
                      size_t step, const cJSON *plan)
{
    return !(follow->session.settings.exports & MURK_EXPORT_LIGHT) ||
           (at(plan, "files", MURK_MAP_FILE_NAME) &&
            murk_follow_has_file(folder, step, MURK_MAP_FILE_NAME));
}

bool murk_follow_is_whole(murk_owned *owned, const char *folder)
{
    bool is = murk_owned_has(owned, folder, "plan.json") &&
              murk_owned_has(owned, folder, "ledger.json");
    for (size_t i = 0; i < owned->n && is; ++i) {
        const murk_owned_file *file = &owned->file[i];
        is = file->is_earlier ||
             (!strchr(file->name, '/') && murk_owned_is_there(folder, file));
    }
    return is;
}

/* True if the step has all its files. */
static bool step_is_whole(const char *folder, size_t step)
{
    murk_owned owned = {0};
    char *path = murk_follow_file(folder, step, NULL);
    const bool is = path && murk_follow_is_whole(&owned, path);
    murk_owned_release(&owned);
    free(path);
    return is;
}

bool murk_follow_take_earlier(const murk_follow *follow, const char *folder,
                              murk_follow_step *step)
{
    char *path = murk_follow_file(folder, step->number, "plan.json");
    murk_session session = murk_world_session(step->world);
    cJSON *plan = murk_follow_read_json(folder, step->number, "plan.json"),
          *ledger = murk_follow_read_json(folder, step->number, "ledger.json");
    /* It must follow from the same input, be whole, and have its light. */
    const char *identity =
        cJSON_GetStringValue(cJSON_GetObjectItem(plan, "identity"));
    const char *cut = cJSON_GetStringValue(at(plan, "placement", "cut_by"));
    const bool is_it =
        path && identity && ledger &&
        !murk_save_identify(&session, "place", &follow->save, "", NULL) &&
        strcmp(identity, session.identity) == 0 &&
        !(cut && strcmp(cut, "interrupt") == 0) &&
        has_light(follow, folder, step->number, plan) &&
        step_is_whole(folder, step->number) &&
        !murk_follow_read_sensors(step, path, NULL);
    if (is_it) {
        const cJSON *all = at(plan, "look_ahead", "photons"),
                    *traced =
                        all ? all
                            : cJSON_GetObjectItem(ledger, "photons_emitted");
        murk_follow_fill_row(step, plan);
        step->row.photons_traced =
            (uint64_t)cJSON_GetNumberValue(traced) - step->row.photons_kept;
    }
    cJSON_Delete(ledger);
    cJSON_Delete(plan);
    free(path);
    return is_it;
}

/* The box whose cells the light of a step has noted; false if it noted none. */
static bool read_watched(const murk_follow *follow, size_t step, murk_box *out)
{
    cJSON *plan = murk_follow_read_json(follow->folder, step, "plan.json");
    const cJSON *list = at(plan, "run", "watched_m");
    double corner[6] = {0};
    int n = 0;
    for (; n < 6 && cJSON_IsNumber(cJSON_GetArrayItem(list, n)); ++n) {
        corner[n] = cJSON_GetArrayItem(list, n)->valuedouble;
    }
    *out = (murk_box){{corner[0], corner[1], corner[2]},
                      {corner[3], corner[4], corner[5]}};
    const bool is_box = n == 6 && out->min.x < out->max.x &&
                        out->min.y < out->max.y && out->min.z < out->max.z;
    cJSON_Delete(plan);
    return is_box;
}

murk_status murk_follow_recall(murk_follow *follow, murk_error *err)
{
    const size_t number = follow->last_reused - 1;
    const double t_s =
        murk_timeline_time_s(&follow->session.scene->timeline, number);
    char *start = NULL;
    struct stat found;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *plan = NULL;
    murk_box watched;
    follow->last_reused = 0;
    if (!follow->folder) { /* steps of parts: none has cells of this run */
        return MURK_OK;
    }
    /* The same scene, start and cells. */
    start = murk_follow_step_path(follow, number, MURK_STEP_START);
    const char *given = start && stat(start, &found) == 0 ? start : NULL;
    murk_status status =
        start ? murk_follow_scene_at(&scene, follow, t_s, given, err)
              : murk_no_memory(err, "", "for the step before");
    if (!status) {
        status = murk_world_create(&world, scene, err);
    }
    if (!status) {
        const bool is_known = read_watched(follow, number, &watched);
        status = murk_plan_make_step(&plan, world, NULL,
                                     is_known ? &watched : NULL, err);
    }
    if (!status) {
        murk_follow_remember(follow, plan);
    }
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    free(start);
    return status == MURK_INTERRUPTED || status == MURK_NO_MEMORY ? status
                                                                  : MURK_OK;
}
