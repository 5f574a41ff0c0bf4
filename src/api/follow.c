/* Following a scene through the steps of its timeline: each step is the scene
 * at that time, with a plan that is improved from the plan of the step before,
 * as murk place --at T --start PLAN makes it. A step whose plan lies in the
 * folder already, with the same identity, is not made again. */
#include "api/save.h"
#include "api/scene.h"

#include "base/file.h"
#include "base/log.h"
#include "base/number.h"
#include "base/progress.h"
#include "cases/sequence.h"
#include "plan/placement_in.h"
#include "results/follow.h"
#include "results/plan.h"
#include "scene/override.h"
#include "scene/timeline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define STEP_NAME       "steps/%04zu"
#define START_FILE      "start.csv"
#define START_IN_MEMORY "murk-follow-start.csv"

struct murk_follow {
    murk_scene *scene; /* a copy of the caller's */
    char *folder;      /* NULL: none */
    murk_save_options save;
    char *command, *asked, *exports, *voxel_m; /* of `save` */
    size_t steps, next, reused; /* of the timeline; done; not made again */
    murk_sequence sequence;
    bool has_plan;      /* the sequence has the sensors of an earlier step */
    size_t last_reused; /* number from 1 of the last step that was not made
                         * again, if no step was made after it; else 0 */
    murk_plan *before;  /* the last plan that was made; NULL: none. The next one
                         * takes over what is the same */
    murk_session session;
    murk_fields row, fields, saved; /* row: of the last step */
};

/* ---- making ---- */

/* Makes *out a scene of the same text, keys and files in memory. */
static murk_status copy_scene(murk_scene **out, const murk_scene *scene,
                              murk_error *err)
{
    murk_scene *copy = NULL;
    murk_status status =
        murk_scene_parse(&copy, scene->context, scene->text, scene->name, err);
    if (!status) {
        /* Keys and files in memory. */
        copy->is_file = scene->is_file;
        copy->set = calloc(scene->n + 1, sizeof *copy->set);
        status = copy->set && murk_memory_copy(&copy->files, &scene->files)
                     ? MURK_OK
                     : murk_no_memory(err, scene->name, "for the scene");
    }
    for (size_t i = 0; i < scene->n && !status; ++i) {
        const char *text = scene->set[i].text;
        char *key = strndup(text, strcspn(text, "="));
        status = key ? murk_override_make(&copy->set[copy->n], key,
                                          text + strlen(key) + 1, err)
                     : murk_no_memory(err, scene->name, "for the scene");
        copy->n += !status;
        free(key);
    }
    if (status) {
        murk_scene_destroy(copy);
        return status;
    }
    *out = copy;
    return MURK_OK;
}

static bool copy_text(char **to, const char **member, const char *text)
{
    *to = text ? strdup(text) : NULL;
    *member = *to;
    return !text || *to;
}

static murk_status take_options(murk_follow *follow, const char *folder,
                                const murk_save_options *options,
                                murk_error *err)
{
    const murk_status status = murk_save_check_options(options, err);
    if (status) {
        return status;
    }
    const murk_save_options known = murk_save_known(options);
    follow->save = known;
    follow->save.size = sizeof follow->save;
    const bool is_whole =
        copy_text(&follow->command, &follow->save.command, known.command) &&
        copy_text(&follow->asked, &follow->save.asked, known.asked) &&
        copy_text(&follow->exports, &follow->save.exports, known.exports) &&
        copy_text(&follow->voxel_m, &follow->save.voxel_m, known.voxel_m);
    follow->folder = folder ? strdup(folder) : NULL;
    return is_whole && (follow->folder || !folder)
               ? MURK_OK
               : murk_no_memory(err, "", "for the steps");
}

/* Makes the scene at a time; `start`: the file of the plan at which the search
 * begins, or NULL. */
static murk_status scene_at(murk_scene **out, const murk_follow *follow,
                            double t_s, const char *start, murk_error *err)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, t_s);
    murk_status status = copy_scene(out, follow->scene, err);
    if (!status) {
        status = murk_scene_set(*out, "timeline.at_s", text, err);
    }
    return status || !start
               ? status
               : murk_scene_set(*out, "placement.start_plan", start, err);
}

static murk_status read_timeline(murk_follow *follow, murk_error *err)
{
    murk_scene_desc *desc = NULL;
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, err);
    murk_status status =
        murk_scene_describe(&desc, follow->scene, &call.failure);
    if (!status && !desc->timeline.given) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE, desc->path,
                           "has no timeline, which says the times of the "
                           "steps");
    }
    /* Conditions have plans of their own. */
    if (!status && desc->placement.over != MURK_SCENE_OBJECTIVE_NONE) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE, desc->placement.where,
                           "over: a plan for several conditions does not "
                           "follow a timeline; must be null");
    }
    if (!status && desc->placement.knowledge == MURK_SCENE_EXPLORE) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE, desc->placement.where,
                           "knowledge: explore does not follow a timeline; "
                           "must be known or unknown");
    }
    if (!status) {
        follow->steps = murk_timeline_steps(&desc->timeline);
        murk_sequence_init(&follow->sequence, desc->sensors.fixed_listed);
    }
    follow->session =
        (murk_session){.settings.threads = follow->scene->context->threads,
                       .run.threads = follow->scene->context->threads,
                       .begun_s = murk_clock_s(),
                       .scene = desc};
    return murk_call_end(&call, status);
}

/* Makes the exports of the steps, other than the light, a part of their
 * identity, so that steps without them, or with those of another run, are made
 * again. */
static murk_status identify_exports(murk_follow *follow, murk_error *err)
{
    const char *old = follow->asked ? follow->asked : "",
               *exports = follow->exports ? follow->exports : "",
               *voxel_m = follow->voxel_m ? follow->voxel_m : "";
    if (!(follow->session.settings.exports & ~(unsigned)MURK_EXPORT_LIGHT)) {
        return MURK_OK;
    }
    const size_t size =
        strlen(old) + strlen(exports) + strlen(voxel_m) + sizeof "exports  \n";
    char *asked = malloc(size);
    if (!asked) {
        return murk_no_memory(err, "", "for the exports");
    }
    snprintf(asked, size, "%sexports %s %s\n", old, exports, voxel_m);
    free(follow->asked);
    follow->save.asked = follow->asked = asked;
    return MURK_OK;
}

/* Begins the folder, and checks the files that the run writes into it. */
static murk_status begin_files(murk_session *session, murk_error *err)
{
    static const char *const names[] = {"follow.json", "follow.csv",
                                        "moves.csv", NULL};
    const murk_status status =
        murk_results_begin(&session->results, session->settings.folder,
                           session->settings.force, err);
    return status ? status : murk_session_expect(session, names, err);
}

/* Checks the exports and that the results may be written, before any step. */
static murk_status check_files(murk_follow *follow, murk_error *err)
{
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, err);
    murk_session session = follow->session;
    murk_status status =
        murk_save_set(&session, follow->folder, &follow->save, &call.failure);
    follow->session.settings.exports = session.settings.exports;
    if (!status) {
        status = identify_exports(follow, &call.failure);
    }
    if (!status) {
        status = begin_files(&session, &call.failure);
    }
    murk_results_end(&session.results);
    return murk_call_end(&call, status);
}

murk_status murk_follow_create(murk_follow **out, murk_scene *scene,
                               const char *folder,
                               const murk_save_options *options,
                               murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !scene) {
        return murk_call_refuse(error, "out or scene is NULL");
    }
    /* Copy what the caller gives, then judge it. */
    murk_follow *follow = calloc(1, sizeof *follow);
    murk_status status =
        follow ? copy_scene(&follow->scene, scene, error)
               : murk_call_refuse(error, "out of memory for the steps");
    if (!status) {
        status = take_options(follow, folder, options, error);
    }
    if (!status) {
        status = read_timeline(follow, error);
    }
    if (!status) {
        status = check_files(follow, error);
    }
    if (status) {
        murk_follow_destroy(follow);
        return status;
    }
    *out = follow;
    return MURK_OK;
}

void murk_follow_destroy(murk_follow *follow)
{
    if (!follow) {
        return;
    }
    murk_plan_destroy(follow->before);
    murk_sequence_release(&follow->sequence);
    murk_fields_release(&follow->row);
    murk_fields_release(&follow->fields);
    murk_fields_release(&follow->saved);
    murk_scene_desc_destroy(follow->session.scene);
    murk_scene_destroy(follow->scene);
    free(follow->command);
    free(follow->asked);
    free(follow->exports);
    free(follow->voxel_m);
    free(follow->folder);
    free(follow);
}

static murk_follow_results results_of(const murk_follow *follow)
{
    return (murk_follow_results){follow->session.scene, &follow->sequence,
                                 follow->steps, follow->reused};
}

/* ---- the plan at which the search of a step begins ---- */

/* The path of a file of a step. The caller frees it; NULL when out of memory or
 * without a folder. */
static char *step_path(const murk_follow *follow, size_t step, const char *name)
{
    char part[64];
    snprintf(part, sizeof part, STEP_NAME "%s%s", step, name ? "/" : "",
             name ? name : "");
    return follow->folder ? murk_path_join(follow->folder, part) : NULL;
}

/* The sensors of the sequence as the text of a table, as sensors.csv has them;
 * the caller frees it. NULL when out of memory. */
static char *start_text(const murk_follow *follow)
{
    const murk_follow_results results = results_of(follow);
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    if (to) {
        murk_results_csv_heading(to, murk_results_list_start);
        for (size_t i = 0; i < follow->sequence.sensors; ++i) {
            murk_results_csv_line(to, murk_results_list_start, &results, i);
        }
    }
    if (to && fclose(to)) {
        free(text);
        text = NULL;
    }
    return text;
}

/* True if the file has this text. */
static bool has_text(const char *path, const char *text)
{
    char *found = NULL;
    size_t size = 0;
    const bool has =
        !murk_file_read_own(&found, &size, path, MURK_YAML_MAX_BYTES, NULL) &&
        strcmp(found, text) == 0;
    free(found);
    return has;
}

/* Writes the text to start.csv in the folder of a step, unless a run that was
 * stopped there has left it. */
static murk_status write_start(const murk_follow *follow, size_t step,
                               const char *path, const char *text,
                               murk_error *err)
{
    char *folder = step_path(follow, step, NULL);
    murk_results results = {0};
    murk_status status =
        folder ? MURK_OK : murk_no_memory(err, "", "for the start of a step");
    if (status || has_text(path, text)) {
        free(folder);
        return status;
    }
    status = murk_results_begin(&results, folder, follow->save.replaces, err);
    if (!status) {
        status = murk_results_add_text(&results, START_FILE, text, err);
    }
    if (!status) {
        status = murk_results_show(&results, err);
    }
    murk_results_end(&results);
    free(folder);
    return status;
}

/* Makes the file at which the search of a step begins: start.csv in the folder
 * of the step, or without a folder a file in memory. *path, which the caller
 * frees, is its name; NULL: the step has no start. */
static murk_status make_start(murk_follow *follow, size_t step, char **path,
                              murk_error *err)
{
    *path = NULL;
    if (!follow->has_plan ||
        follow->session.scene->placement.method == MURK_PLACE_GREEDY) {
        return MURK_OK;
    }
    /* The name, and the text. */
    char *text = start_text(follow);
    *path = follow->folder ? step_path(follow, step, START_FILE)
                           : strdup(MURK_MEMORY_PREFIX START_IN_MEMORY);
    if (!text || !*path) {
        free(text);
        return murk_no_memory(err, "", "for the start of a step");
    }
    if (follow->folder) {
        const murk_status status = write_start(follow, step, *path, text, err);
        free(text);
        return status;
    }
    const size_t size = strlen(text);
    murk_memory_file file = {
        .kind = MURK_MEMORY_TABLE, .data = text, .release = free};
    murk_checksum(text, size, file.checksum);
    return murk_memory_add(&follow->scene->files, START_IN_MEMORY, file, err);
}

/* ---- a step ---- */

/* A step that is made. */
typedef struct step_work {
    size_t number;
    double t_s;
    murk_world *world;
    murk_sequence_row row;
    char *start;     /* the file at which its search begins; NULL: none */
    bool is_dark;    /* there is nothing to see, so no sensor has a reason to
                      * move */
    murk_pose *pose; /* [poses] sensors of the plan, without the fixed ones */
    size_t poses;
} step_work;

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

/* The JSON in a file that murk has written; NULL if there is none. The caller
 * deletes it. */
static cJSON *read_json(const murk_follow *follow, size_t step,
                        const char *name)
{
    char *path = step_path(follow, step, name), *text = NULL;
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

/* Fills the row from the main JSON of a plan. */
static void fill_row(step_work *step, const cJSON *plan)
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

/* Copies the sensors of a plan, of which the fixed ones come last, and adds up
 * their costs. */
static murk_status fill_sensors(step_work *step, const murk_pose *pose,
                                size_t n, murk_error *err)
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

/* Takes the sensors from the file of a plan. */
static murk_status read_sensors(step_work *step, const char *path,
                                murk_error *err)
{
    murk_pose *pose = NULL;
    size_t n = 0;
    murk_status status =
        murk_placement_read(&pose, &n, path, 0, step->world->desc,
                            &step->world->stage->world.domain, err);
    if (!status) {
        status = fill_sensors(step, pose, n, err);
    }
    free(pose);
    return status;
}

/* True if the light of a step lies in its folder, as its plan says, or is not
 * asked for. */
static bool has_light(const murk_follow *follow, size_t step, const cJSON *plan)
{
    char *path = step_path(follow, step, MURK_MAP_FILE_NAME);
    struct stat found;
    const bool has = path && at(plan, "files", MURK_MAP_FILE_NAME) &&
                     stat(path, &found) == 0;
    free(path);
    return has || !(follow->session.settings.exports & MURK_EXPORT_LIGHT);
}

/* Takes a step from the plan that an earlier run has left in its folder. False
 * if there is none, or if it is of another scene, version or start, or was cut
 * short. */
static bool take_earlier(const murk_follow *follow, step_work *step)
{
    char *path = step_path(follow, step->number, "plan.json");
    murk_session session = murk_world_session(step->world);
    cJSON *plan = read_json(follow, step->number, "plan.json"),
          *ledger = read_json(follow, step->number, "ledger.json");
    /* It must follow from the same input, be whole, and have its light. */
    const char *identity =
        cJSON_GetStringValue(cJSON_GetObjectItem(plan, "identity"));
    const char *cut = cJSON_GetStringValue(at(plan, "placement", "cut_by"));
    const bool is_it =
        path && identity && ledger &&
        !murk_save_identify(&session, "place", &follow->save, NULL) &&
        strcmp(identity, session.identity) == 0 &&
        !(cut && strcmp(cut, "interrupt") == 0) &&
        has_light(follow, step->number, plan) &&
        !read_sensors(step, path, NULL);
    if (is_it) {
        const cJSON *all = at(plan, "look_ahead", "photons"),
                    *traced =
                        all ? all
                            : cJSON_GetObjectItem(ledger, "photons_emitted");
        fill_row(step, plan);
        step->row.photons_traced =
            (uint64_t)cJSON_GetNumberValue(traced) - step->row.photons_kept;
    }
    cJSON_Delete(ledger);
    cJSON_Delete(plan);
    free(path);
    return is_it;
}

/* True for failures that are due to the scene at one time. Others end the
 * run. */
static bool is_of_step(murk_status status)
{
    return status == MURK_BAD_VALUE || status == MURK_BAD_FILE ||
           status == MURK_RUN_FAILED || status == MURK_UNSUPPORTED;
}

static void note_failure(step_work *step, const murk_error *why)
{
    murk_sequence_row *row = &step->row;
    row->coverage = (murk_estimate){NAN, NAN};
    row->upper = row->cost = row->in_sample = row->upper_free = NAN;
    row->moves = row->move_cost = NAN;
    snprintf(row->failed, sizeof row->failed, "%s%s%s", why->where,
             why->where[0] ? ": " : "", why->text);
}

/* Saves a plan, with the light if that is asked for, and takes its figures. Its
 * sensors are taken from the file, so that a run that goes on has the same. */
static murk_status save_step(murk_follow *follow, step_work *step,
                             murk_plan *plan, murk_error *err)
{
    char *folder = step_path(follow, step->number, NULL),
         *path = step_path(follow, step->number, "plan.json");
    const murk_fields *saved = NULL;
    /* start.csv belongs to the results; the light only if it is asked for. */
    plan->session.settings.own_input =
        folder && step->start ? START_FILE : NULL;
    plan->session.settings.leaves_out_light =
        !(follow->session.settings.exports & MURK_EXPORT_LIGHT);
    murk_status status =
        follow->folder && (!folder || !path)
            ? murk_no_memory(err, "", "for the step")
            : murk_plan_save(plan, folder, &follow->save, &saved, err);
    if (!status) {
        murk_traced *traced = plan->session.traced;
        fill_row(step, saved->root);
        const uint64_t photons =
            plan->plan.ahead ? plan->ahead.photons
            : traced && traced->ledger
                ? (uint64_t)murk_tally_read(&traced->ledger->photons)
                : step->row.photons_kept;
        step->row.photons_traced = photons - step->row.photons_kept;
        status = path ? read_sensors(step, path, err)
                      : fill_sensors(step, plan->plan.sensor,
                                     plan->plan.place.count, err);
    }
    free(folder);
    free(path);
    return status;
}

/* Warns of a plan of an earlier run in the folder of a step that has none. */
static void warn_of_earlier(const murk_follow *follow, const step_work *step)
{
    char *path = step_path(follow, step->number, "plan.json");
    struct stat found;
    if (path && stat(path, &found) == 0) {
        murk_call call = murk_call_begin(follow->scene->context, NULL, NULL);
        murk_warn(path, "is of an earlier run: this step has failed now");
        (void)murk_call_end(&call, MURK_OK);
    }
    free(path);
}

/* Remembers the plan of a step for the next one, which takes over what is the
 * same. A dark step leaves the plan before it. */
static void remember(murk_follow *follow, murk_plan *plan)
{
    if (plan && !plan->plan.is_dark) {
        murk_plan_destroy(follow->before);
        follow->before = plan;
        return;
    }
    murk_plan_destroy(plan);
}

/* The box whose cells the light of a step has noted; false if it noted none. */
static bool read_watched(const murk_follow *follow, size_t step, murk_box *out)
{
    cJSON *plan = read_json(follow, step, "plan.json");
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

/* After steps of an earlier run: makes the plan of the last of them once more,
 * without saving it, so that the next step takes over, and counts, what it
 * would have taken over without the stop. The results of the step do not depend
 * on it, so without such a plan nothing is taken over. Fails if the call is
 * cancelled or memory is short. */
static murk_status recall_before(murk_follow *follow, murk_error *err)
{
    const size_t number = follow->last_reused - 1;
    const double t_s =
        murk_timeline_time_s(&follow->session.scene->timeline, number);
    char *start = step_path(follow, number, START_FILE);
    struct stat found;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *plan = NULL;
    murk_box watched;
    follow->last_reused = 0;
    /* The same scene, start and cells. */
    const char *given = start && stat(start, &found) == 0 ? start : NULL;
    murk_status status = start ? scene_at(&scene, follow, t_s, given, err)
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
        remember(follow, plan);
    }
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    free(start);
    return status == MURK_INTERRUPTED || status == MURK_NO_MEMORY ? status
                                                                  : MURK_OK;
}

/* Makes the plan of a step, or takes that of an earlier run. A failure that is
 * due to the scene at this time is noted in the row. */
static murk_status make_step(murk_follow *follow, step_work *step,
                             murk_scene *scene, murk_error *err)
{
    murk_plan *plan = NULL;
    murk_error why = {.size = sizeof why};
    /* What an earlier run has made is not made again. */
    murk_status status = murk_world_create_after(
        &step->world, scene, follow->before ? follow->before->world : NULL,
        &why);
    if (!status && take_earlier(follow, step)) {
        ++follow->reused;
        follow->last_reused =
            step->is_dark ? follow->last_reused : step->number + 1;
        return MURK_OK;
    }
    if (!status && follow->last_reused > 0) {
        status = recall_before(follow, &why);
    }
    if (!status) {
        status =
            murk_plan_make_step(&plan, step->world, follow->before, NULL, &why);
    }
    if (!status) {
        status = save_step(follow, step, plan, err);
    } else if (is_of_step(status)) {
        note_failure(step, &why);
        warn_of_earlier(follow, step);
        status = MURK_OK;
    } else {
        murk_call_pass(err, &why);
    }
    remember(follow, plan);
    return status;
}

/* Lets the sensors of the plan before drift and fail until the step. */
static murk_status advance(murk_follow *follow, const step_work *step,
                           murk_error *err)
{
    if (step->number == 0) {
        return MURK_OK;
    }
    murk_call call = murk_call_begin(follow->scene->context, NULL, err);
    return murk_call_end(
        &call, murk_sequence_advance(&follow->sequence, follow->session.scene,
                                     step->number, &call.failure));
}

/* Makes the step, and adds its row and what moved to the sequence. */
static murk_status do_step(murk_follow *follow, step_work *step,
                           murk_error *err)
{
    murk_scene *scene = NULL;
    /* The scene at the time, with the sensors that are left as the start. */
    murk_status status = advance(follow, step, err);
    if (!status) {
        status = make_start(follow, step->number, &step->start, err);
    }
    if (!status) {
        status = scene_at(&scene, follow, step->t_s, step->start, err);
    }
    if (!status) {
        status = make_step(follow, step, scene, err);
    }
    if (!status && !step->row.failed[0] && !step->is_dark) {
        status =
            murk_sequence_take(&follow->sequence, step->number, step->t_s,
                               step->pose, step->poses, &step->row.moved, err);
        follow->has_plan = true;
    }
    murk_scene_destroy(scene);
    return status ? status
                  : murk_sequence_add(&follow->sequence, &step->row, err);
}

static void list_last(murk_results_fields *f, const void *of)
{
    const murk_sequence *sequence = of;
    murk_results_list_follow_row(f, of, sequence->rows - 1);
}

murk_status murk_follow_next(murk_follow *follow, const murk_fields **row,
                             murk_error *error)
{
    if (!follow || !row) {
        return murk_call_refuse(error, "follow or row is NULL");
    }
    *row = NULL;
    if (follow->next == follow->steps) {
        return MURK_OK;
    }
    /* Make the step; its row holds the figures. */
    const murk_scene_timeline *timeline = &follow->session.scene->timeline;
    step_work step = {.number = follow->next,
                      .t_s = murk_timeline_time_s(timeline, follow->next)};
    step.row.step = step.number;
    step.row.t_s = step.t_s;
    murk_fields_release(&follow->row);
    murk_fields_release(&follow->fields);
    murk_status status = do_step(follow, &step, error);
    follow->next += !status;
    if (!status) {
        status =
            murk_fields_make(&follow->row, list_last, &follow->sequence, error);
        *row = status ? NULL : &follow->row;
    }
    free(step.pose);
    free(step.start);
    murk_world_destroy(step.world);
    return status;
}

/* ---- results ---- */

murk_status murk_follow_fields(murk_follow *follow, const murk_fields **fields,
                               murk_error *error)
{
    if (!follow || !fields) {
        return murk_call_refuse(error, "follow or fields is NULL");
    }
    const murk_follow_results results = results_of(follow);
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, error);
    *fields = &follow->fields;
    return murk_call_end(&call, murk_fields_make(&follow->fields,
                                                 murk_results_list_follow,
                                                 &results, &call.failure));
}

/* The list of the files of all steps that ParaView shows in time. */
static murk_status write_pvd(FILE *to, const void *context, murk_error *err)
{
    static const struct {
        murk_export export;
        const char *name;
    } shown[] = {{MURK_EXPORT_SURFACES, "surfaces.vtp"},
                 {MURK_EXPORT_PHOTONS, "photons.vtp"},
                 {MURK_EXPORT_FIELDS, "fields.vti"}};
    const murk_follow *follow = context;
    (void)err;
    fprintf(to, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
                "version=\"0.1\">\n<Collection>\n");
    /* Each file of each step that has a plan. */
    for (size_t i = 0; i < follow->sequence.rows; ++i) {
        const murk_sequence_row *row = &follow->sequence.row[i];
        for (size_t k = 0; k < sizeof shown / sizeof *shown; ++k) {
            if (!row->failed[0] &&
                follow->session.settings.exports & shown[k].export) {
                fprintf(to,
                        "<DataSet timestep=\"%.17g\" part=\"%zu\" "
                        "file=\"" STEP_NAME "/%s\"/>\n",
                        row->t_s, k, row->step, shown[k].name);
            }
        }
    }
    fprintf(to, "</Collection>\n</VTKFile>\n");
    return MURK_OK;
}

#define VIEWED (MURK_EXPORT_SURFACES | MURK_EXPORT_PHOTONS | MURK_EXPORT_FIELDS)

/* Tells of steps of an earlier run with more steps, which stay in the folder.
 */
static void note_longer(const murk_follow *follow)
{
    char *path = step_path(follow, follow->steps, "plan.json");
    struct stat found;
    if (path && stat(path, &found) == 0) {
        murk_note(path,
                  "is of an earlier run, as are later steps: this "
                  "timeline has %zu",
                  follow->steps);
    }
    free(path);
}

/* A murk_save_work (api/save.h). */
static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    murk_follow *follow = of;
    const murk_follow_results results = results_of(follow);
    (void)late; /* of exports, which the steps have */
    note_longer(follow);
    murk_status status = begin_files(session, err);
    if (!status) {
        status = murk_save_identify(session, "follow", options, err);
    }
    if (!status) {
        status = murk_results_add_csv(
            &session->results, "follow.csv", murk_results_list_follow_row,
            &follow->sequence, follow->sequence.rows, err);
    }
    if (!status) {
        status = murk_results_add_csv(&session->results, "moves.csv",
                                      murk_results_list_move, &results,
                                      follow->sequence.moves, err);
    }
    if (!status && follow->session.settings.exports & VIEWED) {
        status = murk_results_add_stream(&session->results, "follow.pvd",
                                         write_pvd, follow, err);
    }
    if (!status) {
        status = murk_session_add_scene(session, err);
    }
    return status ? status
                  : murk_session_finish(
                        session, "follow.json",
                        murk_results_json(murk_results_list_follow, &results),
                        murk_print_follow, &results, err);
}

murk_status murk_follow_save(murk_follow *follow, const murk_fields **fields,
                             murk_error *error)
{
    if (!follow) {
        return murk_save_refuse(fields, error, "follow is NULL");
    }
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, error);
    return murk_save_results(&call, &follow->session, &follow->saved,
                             follow->folder, &follow->save, fields, save,
                             follow);
}
