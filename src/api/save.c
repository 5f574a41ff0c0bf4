/* Writes the results of a handle to a folder: takes over the options of the
 * caller, refuses beforehand what would be refused afterwards, identifies the
 * results, and makes the main JSON the fields that the caller reads. */
#include "api/save.h"

#include "base/file.h"
#include "plan/plan.h"
#include "results/exports.h"
#include "results/identity.h"

#include <stdio.h>
#include <string.h>

/* Bytes of the name of a result file of a condition, "scene-NAME.yaml". */
#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16)

/* The largest number of names in the list of files of a plan, with the NULL at
 * the end. */
#define NAMES_MAX 10

murk_session murk_world_session(const murk_world *world)
{
    return (murk_session){.settings.threads = world->context->threads,
                          .run.threads = world->context->threads,
                          .run.load_s = world->load_s,
                          .scene = world->desc,
                          .stage = world->stage,
                          .begun_s = world->begun_s};
}

static murk_status copy_options(murk_save_options *all,
                                const murk_save_options *options,
                                murk_error *err)
{
    *all = (murk_save_options){0};
    return murk_options_copy(all, sizeof *all, options, "options",
                             "murk_save_options", err);
}

murk_save_options murk_save_known(const murk_save_options *options)
{
    murk_save_options all;
    (void)copy_options(&all, options, NULL);
    return all;
}

murk_status murk_save_check_options(const murk_save_options *options,
                                    murk_error *err)
{
    murk_save_options all;
    return copy_options(&all, options, err);
}

murk_status murk_save_set(murk_session *session, const char *folder,
                          const murk_save_options *options, murk_error *err)
{
    murk_save_options all;
    const murk_status status = copy_options(&all, options, err);
    if (status) {
        return status;
    }
    session->settings.folder = folder;
    session->settings.force = all.replaces;
    session->settings.voxel = all.voxel_m;
    session->run.command = all.command;
    return all.exports ? murk_exports_read(&session->settings.exports,
                                           all.exports, "exports", err)
                       : MURK_OK;
}

/* ---- what would be refused ---- */

murk_status murk_save_without_exports(const murk_session *session,
                                      const char *of, murk_error *err)
{
    return session->settings.exports || session->settings.voxel
               ? murk_fail(err, MURK_BAD_VALUE,
                           session->settings.exports ? "exports" : "voxel_m",
                           "%s has no exports; leave it out", of)
               : MURK_OK;
}

/* Refuses more than MURK_REPEATS_MAX repeats; seeds of repeats beyond 32 bits;
 * the keys of murk_plan_single_key() together with repeats or with the export
 * lp; and, for
 * repeats with placement.over, a condition whose seed differs from that of the
 * scene. `runs` 0: no repeats. */
static murk_status check_repeat(const murk_session *session, uint64_t runs,
                                murk_error *err)
{
    const murk_scene_desc *scene = session->scene;
    if (runs > MURK_REPEATS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "runs", "%llu, must be 1..%d",
                         (unsigned long long)runs, MURK_REPEATS_MAX);
    }
    if (runs > 0 && scene->seed + (runs - 1) > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, "runs",
                         "%llu seeds from %lu on, must end at 4294967295 at "
                         "most",
                         (unsigned long long)runs, (unsigned long)scene->seed);
    }
    /* Goals that repeats or the exported problem cannot state. */
    const char *key = murk_plan_single_key(scene);
    if ((runs > 0 || session->settings.exports & MURK_EXPORT_LP) && key) {
        return murk_fail(err, MURK_BAD_VALUE, scene->placement.where,
                         "%s is given, which %s: %s%s", key,
                         runs > 0 ? "repeats do not take"
                                  : "the export lp does not take",
                         runs > 0 ? "place once for each seed"
                                  : "use the export matrix or or-library",
                         runs > 0 && murk_plan_at_least(scene) > 0
                             ? ", or use placement.redundancy"
                             : "");
    }
    /* A seed fixed by a condition would be the same in all runs. */
    const bool has_conditions =
        scene->placement.over != MURK_SCENE_OBJECTIVE_NONE;
    for (size_t c = 0; runs > 0 && has_conditions && c < scene->n_conditions;
         ++c) {
        if (scene->conditions[c].scene->seed != scene->seed) {
            return murk_fail(err, MURK_BAD_VALUE, scene->conditions[c].where,
                             "seed: one of its own, which all repeats would "
                             "share; leave it out");
        }
    }
    return MURK_OK;
}

/* Announces the result files that are written for each condition. */
static murk_status expect_conditions(murk_session *session, murk_error *err)
{
    static const char *const begin[] = {"light", "ledger", "plan", "scene"};
    static const char *const end[] = {".murk", ".json", ".ply", ".yaml"};
    const murk_scene_desc *scene = session->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < 4 * scene->n_conditions && !status; ++i) {
        const murk_scene_condition *condition = &scene->conditions[i / 4];
        const size_t k = i % 4;
        char name[FILE_SIZE];
        snprintf(name, sizeof name, "%s-%s%s", begin[k], condition->name,
                 end[k]);
        status = murk_results_expect(&session->results, name,
                                     k == 3 ? condition->scene->resolved : NULL,
                                     err);
    }
    return status;
}

static murk_status expect_plan(murk_session *session, uint64_t runs,
                               murk_error *err)
{
    const murk_scene_placement *asked = &session->scene->placement;
    const bool explores = asked->knowledge == MURK_SCENE_EXPLORE;
    const bool has_conditions = asked->over != MURK_SCENE_OBJECTIVE_NONE;
    /* The files of every plan, and those of exploring and of repeats. */
    const char *names[NAMES_MAX] = {"plan.json", "sensors.csv", "coverage.csv"};
    size_t n = 3;
    if (explores) {
        names[n++] = "explore.csv";
        names[n++] = "path.ply";
    }
    if (runs > 0) {
        names[n++] = "repeat.csv";
    }
    names[n++] = has_conditions ? "regret.csv" : "plan.ply";
    const murk_status status = murk_session_expect(session, names, err);
    return status           ? status
           : has_conditions ? expect_conditions(session, err)
                            : murk_session_expect_light(session, err);
}

static murk_status check_plan(murk_session *session, uint64_t runs,
                              murk_error *err)
{
    const murk_scene_placement *asked = &session->scene->placement;
    const bool has_conditions = asked->over != MURK_SCENE_OBJECTIVE_NONE;
    murk_status status = check_repeat(session, runs, err);
    if (!status) {
        status = murk_exports_check(session->settings.exports, asked->detection,
                                    err);
    }
    if (!status && has_conditions && session->settings.exports) {
        return murk_fail(err, MURK_BAD_VALUE, "exports",
                         "not over conditions: each condition has its own "
                         "light; placement.over must be null");
    }
    if (!status && !has_conditions) {
        status = murk_exports_begin(session, err);
    }
    return status ? status : expect_plan(session, runs, err);
}

static murk_status check_light(murk_session *session, const char *const *names,
                               murk_error *err)
{
    murk_status status = murk_exports_begin(session, err);
    if (!status) {
        status = murk_session_expect(session, names, err);
    }
    return status ? status : murk_session_expect_light(session, err);
}

murk_status murk_save_check(murk_session *session, const char *command,
                            uint64_t runs, murk_error *err)
{
    static const char *const of_light[] = {NULL};
    static const char *const of_coverage[] = {"coverage.json", "coverage.csv",
                                              "coverage.ply", NULL};
    const murk_scene_placement *asked = &session->scene->placement;
    const bool is_sense = strcmp(command, "sense") == 0;
    /* Begin the folder, then check what the command would write. */
    const murk_status status =
        murk_results_begin(&session->results, session->settings.folder,
                           session->settings.force, err);
    if (status) {
        return status;
    }
    if (is_sense && asked->over != MURK_SCENE_OBJECTIVE_NONE) {
        return murk_fail(err, MURK_BAD_VALUE, asked->where,
                         "over: sense measures one scene; must be null, or "
                         "give it a scene-NAME.yaml of place");
    }
    if (strcmp(command, "trace") == 0 &&
        session->settings.exports & MURK_EXPORTS_OF_SENSORS) {
        return murk_fail(err, MURK_BAD_VALUE, "exports",
                         "geojson and geo-csv are of sensors, which trace does "
                         "not have");
    }
    return is_sense ? check_light(session, of_coverage, err)
           : strcmp(command, "trace") == 0 ? check_light(session, of_light, err)
           : strcmp(command, "place") == 0
               ? check_plan(session, runs, err)
               : murk_fail(err, MURK_BAD_VALUE, "command",
                           "%s, must be trace, sense or place", command);
}

murk_status murk_world_check_save(murk_world *world, const char *command,
                                  uint64_t runs, const char *folder,
                                  const murk_save_options *options,
                                  murk_error *error)
{
    if (!world || !command) {
        return murk_call_refuse(error, "world or command is NULL");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status = strcmp(command, "place") == 0
                             ? MURK_OK
                             : murk_world_build(world, &call.failure);
    murk_session session = murk_world_session(world);
    if (!status) {
        status = murk_save_set(&session, folder, options, &call.failure);
    }
    if (!status) {
        status = murk_save_check(&session, command, runs, &call.failure);
    }
    murk_results_end(&session.results);
    return murk_call_end(&call, status);
}

/* ---- identity and fields ---- */

murk_status murk_save_identify(murk_session *session, const char *command,
                               const murk_save_options *options, const char *of,
                               murk_error *err)
{
    const murk_save_options all = murk_save_known(options);
    return murk_identity_of(session->identity, command,
                            all.asked ? all.asked : "", session->scene, of,
                            session->scene->seed, err);
}

murk_status murk_save_alone(murk_fields *fields, cJSON *root,
                            const char *command,
                            const murk_save_options *options, const char *of,
                            const char *file, murk_error *err)
{
    const murk_save_options all = murk_save_known(options);
    char identity[65];
    const murk_status status = murk_identity_of(
        identity, command, all.asked ? all.asked : "", NULL, of, 0, err);
    if (status) {
        cJSON_Delete(root);
        return status;
    }
    cJSON_AddStringToObject(root, "identity", identity);
    murk_json_file(root, file);
    return murk_fields_take(fields, root, err);
}

/* Adds `saved`: the folder, and the names of the files in the order written. */
static bool add_saved(cJSON *root, const murk_results *results)
{
    cJSON *saved = cJSON_AddObjectToObject(root, "saved");
    if (results->folder) {
        cJSON_AddStringToObject(saved, "folder", results->folder);
    } else {
        cJSON_AddNullToObject(saved, "folder");
    }
    cJSON *files = cJSON_AddArrayToObject(saved, "files");
    for (size_t i = 0; i < results->n; ++i) {
        cJSON_AddItemToArray(
            files, cJSON_CreateString(murk_path_name(results->file[i].path)));
    }
    return files != NULL;
}

/* Ends the folder and the call, which failed if status is not MURK_OK, and
 * makes the main JSON the fields. */
static murk_status end_save(murk_call *call, murk_session *session,
                            murk_fields *saved, const murk_fields **fields,
                            murk_status status, const murk_error *late)
{
    /* Make the main JSON the fields. */
    murk_fields_release(saved);
    if (!status && session->document) {
        saved->root = cJSON_Parse(session->document);
        saved->json = session->document;
        session->document = NULL;
        if (!saved->root || !add_saved(saved->root, &session->results)) {
            murk_fields_release(saved);
            status = murk_no_memory(&call->failure, "", "for the results");
        }
    }
    /* End the folder and the call. */
    cJSON_free(session->document);
    session->document = NULL;
    murk_results_end(&session->results);
    if (fields) {
        *fields = saved->root ? saved : NULL;
    }
    if (!status) {
        status = murk_fail(&call->failure, late->code, late->where, "%s",
                           late->text);
    }
    return murk_call_end_long(call, status);
}

murk_status murk_save_refuse(const murk_fields **fields, murk_error *error,
                             const char *text)
{
    if (fields) {
        *fields = NULL;
    }
    return murk_call_refuse(error, text);
}

murk_status murk_save_results(murk_call *call, const murk_session *from,
                              murk_fields *saved, const char *folder,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_save_work *save,
                              void *of)
{
    murk_session session = *from;
    murk_error late = {0};
    murk_status status =
        murk_save_set(&session, folder, options, &call->failure);
    if (!status) {
        status = save(of, &session, options, &late, &call->failure);
    }
    if (!status && folder) {
        murk_context_note_folder(call->context, folder, session.scene);
    }
    return end_save(call, &session, saved, fields, status, &late);
}
