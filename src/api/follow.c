/* Following a scene through the steps of its timeline: each step is the scene
 * at that time, with a plan that is improved from the plan of the step before,
 * as murk place --at T --start PLAN makes it. A step whose plan lies in the
 * folder already, with the same identity, is not made again. */
#include "api/follow.h"
#include "api/scene.h"

#include "base/file.h"
#include "base/log.h"
#include "base/number.h"
#include "base/progress.h"
#include "base/scalar.h"
#include "results/follow.h"
#include "results/plan.h"
#include "scene/override.h"
#include "scene/timeline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define START_IN_MEMORY "murk-follow-start.csv"

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

murk_status murk_follow_scene_at(murk_scene **out, const murk_follow *follow,
                                 double t_s, const char *start, murk_error *err)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, t_s);
    murk_status status = copy_scene(out, follow->scene, err);
    if (!status) {
        (*out)->is_step = true;
        status = murk_scene_set(*out, "timeline.at_s", text, err);
    }
    if (status || !start) {
        return status;
    }
    /* Any path, which may look like a number or a list. */
    char *scalar = murk_scalar(start);
    status = scalar ? murk_scene_set(*out, "placement.start_plan", scalar, err)
                    : murk_no_memory(err, "", "for the start of a step");
    free(scalar);
    return status;
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
    /* Keys without effect are those of the whole: the plan of a step has
     * another start, and not all media. */
    if (!status) {
        murk_scene_tell(desc);
        follow->steps = follow->end = murk_timeline_steps(&desc->timeline);
        murk_sequence_init(&follow->sequence, desc->sensors.fixed_listed);
        status = murk_follow_read_start(follow, desc, &call.failure);
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

/* Refuses the export lp together with a key that the problem in that file
 * cannot state at the steps, most of which begin at a plan. */
static murk_status check_lp(const murk_session *session, murk_error *err)
{
    const char *key = murk_plan_single_key_of_steps(session->scene);
    return session->settings.exports & MURK_EXPORT_LP && key
               ? murk_fail(err, MURK_BAD_VALUE, session->scene->placement.where,
                           "%s is given, which the export lp does not take: "
                           "use the export matrix or or-library",
                           key)
               : MURK_OK;
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
        status = check_lp(&session, &call.failure);
    }
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

/* Releases what the steps have made so far. */
static void release_made(murk_follow *follow)
{
    murk_plan_destroy(follow->before);
    murk_sequence_release(&follow->sequence);
    murk_fields_release(&follow->row);
    murk_fields_release(&follow->fields);
    murk_fields_release(&follow->saved);
}

void murk_follow_part_begin(murk_follow *out, const murk_follow *follow)
{
    *out = *follow;
    out->is_part = true;
    /* All that release_made() releases, and the numbers of steps. */
    out->before = NULL;
    murk_sequence_init(&out->sequence, 0);
    out->row = out->fields = out->saved = (murk_fields){0};
    out->next = out->reused = out->last_reused = 0;
    out->has_plan = false;
}

void murk_follow_part_end(murk_follow *part)
{
    release_made(part);
}

void murk_follow_destroy(murk_follow *follow)
{
    if (!follow) {
        return;
    }
    release_made(follow);
    if (follow->ranks) {
        follow->scene->context->host->ranks = follow->ranks;
    }
    murk_follow_release_parts(follow);
    free(follow->start);
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
                                 follow->steps, follow->reused - follow->dealt};
}

/* ---- the plan at which the search of a step begins ---- */

/* The time of the step before a step; -INFINITY before the first one. */
static double step_before_s(const murk_follow *follow, size_t step)
{
    return step == 0 ? -INFINITY
                     : murk_timeline_time_s(&follow->session.scene->timeline,
                                            step - 1);
}

/* The sensors of the scene's own start plan as they are at a step, in *out,
 * which the caller releases. */
static murk_status own_start(murk_sequence *out, const murk_follow *follow,
                             size_t step, murk_error *err)
{
    const size_t n = follow->starts;
    murk_sequence_init(out, 0);
    out->sensor = calloc(n + 1, sizeof *out->sensor);
    if (!out->sensor) {
        return murk_no_memory(err, "", "for the start of a step");
    }
    memcpy(out->sensor, follow->start, n * sizeof *out->sensor);
    out->sensors = n;
    /* Sensors drift from step to step, as those of the sequence do: a camera
     * that has reached straight down turns up from there. */
    murk_status status = MURK_OK;
    for (size_t i = 0; i <= step && !status; ++i) {
        status = murk_sequence_advance(out, follow->session.scene,
                                       step_before_s(follow, i), i, false, err);
    }
    return status;
}

/* The sensors at which the search of a step begins, as the text of a table:
 * those of the sequence, or those of the scene's own start plan that are left.
 * The caller frees *text. */
static murk_status start_text(char **text, const murk_follow *follow,
                              size_t step, murk_error *err)
{
    murk_follow_results results = results_of(follow);
    murk_sequence own = {0};
    murk_status status = MURK_OK;
    size_t size;
    *text = NULL;
    /* The sensors, then their lines. */
    if (follow->has_start) {
        status = own_start(&own, follow, step, err);
        results.sequence = &own;
    }
    FILE *to = status ? NULL : open_memstream(text, &size);
    if (to) {
        murk_results_csv_heading(to, murk_results_list_start);
        for (size_t i = 0; i < results.sequence->sensors; ++i) {
            murk_results_csv_line(to, murk_results_list_start, &results, i);
        }
    }
    if (to && fclose(to)) {
        free(*text);
        *text = NULL;
    }
    murk_sequence_release(&own);
    return status || *text ? status
                           : murk_no_memory(err, "", "for the start of a step");
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
    char *folder = murk_follow_step_path(follow, step, NULL);
    murk_results results = {0};
    murk_status status =
        folder ? MURK_OK : murk_no_memory(err, "", "for the start of a step");
    if (status || has_text(path, text)) {
        free(folder);
        return status;
    }
    status = murk_results_begin(&results, folder, follow->save.replaces, err);
    if (!status) {
        status = murk_results_add_text(&results, MURK_STEP_START, text, err);
    }
    if (!status) {
        status = murk_results_show(&results, err);
    }
    murk_results_end(&results);
    free(folder);
    return status;
}

/* True if the search of the next step begins at sensors of an earlier plan. */
static bool has_start(const murk_follow *follow)
{
    const murk_scene_desc *scene = follow->session.scene;
    return scene->placement.method != MURK_PLACE_GREEDY &&
           (scene->timeline.from_start_plan ? follow->has_start
                                            : follow->has_plan);
}

murk_status murk_follow_part_start(char **start, const murk_follow *follow,
                                   const char *part, size_t step,
                                   murk_error *err)
{
    *start = NULL;
    if (!has_start(follow)) {
        return MURK_OK;
    }
    /* The file of the part must have the sensors of this run. */
    char *text = NULL, *path = murk_follow_file(part, step, MURK_STEP_START);
    murk_status status =
        path ? start_text(&text, follow, step, err)
             : murk_no_memory(err, "", "for the start of a step");
    if (!status && !has_text(path, text)) {
        status = murk_fail(err, MURK_BAD_VALUE, path,
                           "has other sensors than those at which this step "
                           "begins");
    }
    free(text);
    if (status) {
        free(path);
        return status;
    }
    *start = path;
    return MURK_OK;
}

/* Makes the file at which the search of a step begins: start.csv in the folder
 * of the step, or without a folder that of the part that has the step, or a
 * file in memory. *path, which the caller frees, is its name; NULL: the step
 * has no start. */
static murk_status make_start(murk_follow *follow, size_t step, char **path,
                              murk_error *err)
{
    *path = NULL;
    if (!has_start(follow)) {
        return MURK_OK;
    }
    if (!follow->folder && follow->part_of && follow->part_of[step] > 0) {
        const char *part = follow->part[follow->part_of[step] - 1];
        return murk_follow_part_start(path, follow, part, step, err);
    }
    /* The name, and the text. */
    char *text;
    murk_call call = murk_call_begin(follow->scene->context, NULL, err);
    const murk_status status =
        murk_call_end(&call, start_text(&text, follow, step, &call.failure));
    if (status) {
        return status;
    }
    *path = follow->folder
                ? murk_follow_step_path(follow, step, MURK_STEP_START)
                : strdup(MURK_MEMORY_PREFIX START_IN_MEMORY);
    if (!*path) {
        free(text);
        return murk_no_memory(err, "", "for the start of a step");
    }
    if (follow->folder) {
        const murk_status written = write_start(follow, step, *path, text, err);
        free(text);
        return written;
    }
    const size_t size = strlen(text);
    murk_memory_file file = {
        .kind = MURK_MEMORY_TABLE, .data = text, .release = free};
    murk_checksum(text, size, file.checksum);
    return murk_memory_add(&follow->scene->files, START_IN_MEMORY, file, err);
}

/* ---- a step ---- */

/* True for failures that are due to the scene at one time. Others end the
 * run. */
static bool is_of_step(murk_status status)
{
    return status == MURK_BAD_VALUE || status == MURK_BAD_FILE ||
           status == MURK_RUN_FAILED || status == MURK_UNSUPPORTED;
}

static void note_failure(murk_follow_step *step, const murk_error *why)
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
static murk_status save_step(murk_follow *follow, murk_follow_step *step,
                             murk_plan *plan, murk_error *err)
{
    char *folder = murk_follow_step_path(follow, step->number, NULL),
         *path = murk_follow_step_path(follow, step->number, "plan.json");
    const murk_fields *saved = NULL;
    /* start.csv belongs to the results; the light only if it is asked for. */
    plan->session.settings.own_input =
        folder && step->start ? MURK_STEP_START : NULL;
    plan->session.settings.leaves_out_light =
        !(follow->session.settings.exports & MURK_EXPORT_LIGHT);
    murk_status status =
        follow->folder && (!folder || !path)
            ? murk_no_memory(err, "", "for the step")
            : murk_plan_save(plan, folder, &follow->save, &saved, err);
    if (!status) {
        murk_traced *traced = plan->session.traced;
        murk_follow_fill_row(step, saved->root);
        const uint64_t photons =
            plan->plan.ahead ? plan->ahead.photons
            : traced && traced->ledger
                ? (uint64_t)murk_tally_read(&traced->ledger->photons)
                : step->row.photons_kept;
        step->row.photons_traced = photons - step->row.photons_kept;
        status = path ? murk_follow_read_sensors(step, path, err)
                      : murk_follow_fill_sensors(step, plan->plan.sensor,
                                                 plan->plan.place.count, err);
    }
    free(folder);
    free(path);
    return status;
}

/* Warns of a plan of an earlier run in the folder of a step that has none. */
static void warn_of_earlier(const murk_follow *follow,
                            const murk_follow_step *step)
{
    char *path = murk_follow_step_path(follow, step->number, "plan.json");
    struct stat found;
    if (path && stat(path, &found) == 0) {
        murk_call call = murk_call_begin(follow->scene->context, NULL, NULL);
        murk_warn(path, "is of an earlier run: this step has failed now");
        (void)murk_call_end(&call, MURK_OK);
    }
    free(path);
}

void murk_follow_remember(murk_follow *follow, murk_plan *plan)
{
    if (plan && !plan->plan.is_dark) {
        murk_plan_destroy(follow->before);
        follow->before = plan;
        return;
    }
    murk_plan_destroy(plan);
}

/* Makes the plan of a step, or takes that of an earlier run. A failure that is
 * due to the scene at this time is noted in the row. */
static murk_status make_step(murk_follow *follow, murk_follow_step *step,
                             murk_scene *scene, murk_error *err)
{
    murk_plan *plan = NULL;
    murk_error why = {.size = sizeof why};
    /* What an earlier run or a part has made is not made again. */
    murk_status status = murk_world_create_after(
        &step->world, scene, follow->before ? follow->before->world : NULL,
        &why);
    bool is_taken =
        !status && murk_follow_take_earlier(follow, follow->folder, step);
    if (!status && !is_taken) {
        const murk_status copied =
            murk_follow_take_part(&is_taken, follow, step, err);
        if (copied) {
            return copied;
        }
    }
    if (is_taken) {
        ++follow->reused;
        follow->last_reused =
            step->is_dark ? follow->last_reused : step->number + 1;
        return MURK_OK;
    }
    if (!status && follow->last_reused > 0) {
        status = murk_follow_recall(follow, &why);
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
    murk_follow_remember(follow, plan);
    return status;
}

/* Lets the sensors of the plan before, or of the plan in force before the first
 * step, drift and fail until the step. A part of the steps does not know which
 * sensors there are, so the merge warns of those that are missing. */
static murk_status advance(murk_follow *follow, const murk_follow_step *step,
                           murk_error *err)
{
    const double from_s = step_before_s(follow, step->number);
    const bool warns = !follow->is_part && follow->shard.count == 0;
    murk_call call = murk_call_begin(follow->scene->context, NULL, err);
    return murk_call_end(&call, murk_sequence_advance(&follow->sequence,
                                                      follow->session.scene,
                                                      from_s, step->number,
                                                      warns, &call.failure));
}

/* Makes the step, and adds its row and what moved to the sequence. */
static murk_status do_step(murk_follow *follow, murk_follow_step *step,
                           murk_error *err)
{
    murk_scene *scene = NULL;
    /* The scene at the time, with the sensors that are left as the start. */
    murk_status status = advance(follow, step, err);
    if (!status) {
        status = make_start(follow, step->number, &step->start, err);
    }
    if (!status) {
        status =
            murk_follow_scene_at(&scene, follow, step->t_s, step->start, err);
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
    if (!follow->has_begun) {
        const murk_status status = murk_follow_begin_ranks(follow, error);
        if (status) {
            return status;
        }
    }
    if (follow->next == follow->end) {
        return MURK_OK;
    }
    /* Make the step; its row holds the figures. */
    const murk_scene_timeline *timeline = &follow->session.scene->timeline;
    murk_follow_step step = {.number = follow->next,
                             .t_s =
                                 murk_timeline_time_s(timeline, follow->next)};
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
                        "file=\"" MURK_STEP_NAME "/%s\"/>\n",
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
    char *path = murk_follow_step_path(follow, follow->steps, "plan.json");
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
        status = murk_save_identify(session, "follow", options, "", err);
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
    if (follow->shard.count > 0) { /* the tables are made of all parts */
        if (fields) {
            *fields = NULL;
        }
        return murk_call_end(&call,
                             murk_follow_part_write(follow, &call.failure));
    }
    return murk_save_results(&call, &follow->session, &follow->saved,
                             follow->folder, &follow->save, fields, save,
                             follow);
}
