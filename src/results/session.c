/* Reads the names of exports, and the light from a file. Writes the files that
 * most commands have in common: the light, the ledger, the resolved scene and
 * the main JSON; and checks beforehand that none of the run's files would be
 * refused. Prints the lines about light, times and files. */
#include "results/session.h"

#include "results/json.h"
#include "results/ownership.h"
#include "results/summary.h"

#include "base/log.h"
#include "base/progress.h"
#include "world/stage_build.h"

#include <stdio.h>
#include <string.h>

#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16) /* NAME_photons.vdb */

void murk_session_end(murk_session *session)
{
    cJSON_free(session->document);
    murk_results_end(&session->results);
    murk_traced_destroy(session->traced);
    murk_stage_destroy(session->stage);
    murk_scene_desc_destroy(session->scene);
    *session = (murk_session){0};
}

murk_status murk_session_read_light(murk_session *session, murk_error *err)
{
    const char *path = session->settings.light;
    const double begun_s = murk_clock_s();
    if (murk_owned_belonging(path) == MURK_OF_ANOTHER_RUN) {
        murk_warn(path, "is of another run than the results beside it, or of "
                        "one that was killed while it wrote them");
    }
    murk_progress_begin_group("read light", 0, "");
    const murk_status status = murk_lightmap_load(
        &session->traced, session->stage, path, session->settings.threads, err);
    murk_progress_end();
    session->run.load_s += murk_clock_s() - begun_s;
    return status;
}

static murk_status expect_all(murk_results *results, const char *const *names,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    for (; *names && !status; ++names) {
        status = murk_results_expect(results, *names, NULL, err);
    }
    return status;
}

static murk_status expect_grid(murk_session *session, const char *tally,
                               murk_error *err)
{
    static const struct {
        const char *ending;
        unsigned of; /* the export that writes it; 0: always written */
    } files[] = {{".vdb", 0},
                 {"_error.vdb", 0},
                 {"_photons.vdb", MURK_EXPORT_FIELDS},
                 {".vti", MURK_EXPORT_FIELDS}};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sizeof files / sizeof *files && !status; ++i) {
        char name[FILE_SIZE];
        snprintf(name, sizeof name, "%s%s", tally, files[i].ending);
        if (!files[i].of || session->settings.exports & files[i].of) {
            status = murk_results_expect(&session->results, name, NULL, err);
        }
    }
    return status;
}

static murk_status expect_tallies(murk_session *session, murk_error *err)
{
    const murk_scene_desc *scene = session->scene;
    murk_status status =
        scene->n_tallies > 0
            ? murk_results_expect(&session->results, "tallies.csv", NULL, err)
            : MURK_OK;
    for (size_t i = 0; i < scene->n_tallies && !status; ++i) {
        if (scene->tallies[i].type == MURK_TALLY_GRID) {
            status = expect_grid(session, scene->tallies[i].name, err);
        }
    }
    return status;
}

static murk_status expect_exports(murk_session *session, murk_error *err)
{
    static const struct {
        unsigned what;
        const char *names[6];
    } files[] = {
        {MURK_EXPORT_MATRIX, {"matrix.csv", "candidates.csv"}},
        {MURK_EXPORT_OR_LIBRARY, {"matrix.txt"}},
        {MURK_EXPORT_LP, {"problem.lp"}},
        {MURK_EXPORT_FIELDS,
         {"coverage.vdb", "optical_depth.vdb", "extinction.vdb", "fields.vti"}},
        {MURK_EXPORT_PHOTONS, {"photons.ply", "photons.vtp"}},
        {MURK_EXPORT_SURFACES, {"surfaces.ply", "surfaces.vtp"}},
        {MURK_EXPORT_GEOJSON, {"sensors.geojson"}},
        {MURK_EXPORT_GEO_CSV, {"sensors_geo.csv"}}};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sizeof files / sizeof *files && !status; ++i) {
        murk_error why = {0};
        if (session->settings.exports & files[i].what &&
            expect_all(&session->results, files[i].names, &why) ==
                MURK_BAD_VALUE) { /* other failures are reported when the file
                                     is added */
            status = murk_fail(err, why.code, why.where, "%s", why.text);
        }
    }
    return status;
}

murk_status murk_session_expect(murk_session *session, const char *const *names,
                                murk_error *err)
{
    murk_status status = expect_all(&session->results, names, err);
    if (!status && session->scene) {
        status = murk_results_expect(&session->results, MURK_SCENE_NAME,
                                     session->scene->resolved, err);
    }
    return status ? status : expect_exports(session, err);
}

murk_status murk_session_expect_light(murk_session *session, murk_error *err)
{
    static const char *const names[] = {MURK_MAP_FILE_NAME, "ledger.json",
                                        NULL};
    const murk_status status = expect_all(&session->results, names, err);
    return status ? status : expect_tallies(session, err);
}

murk_status murk_session_add_scene(murk_session *session, murk_error *err)
{
    return session->scene
               ? murk_results_add_text(&session->results, MURK_SCENE_NAME,
                                       session->scene->resolved, err)
               : MURK_OK;
}

murk_status murk_session_add_light(murk_session *session, murk_error *err)
{
    if (session->settings.leaves_out_light) {
        return murk_session_add_scene(session, err);
    }
    murk_progress_begin_group("write light", 0, "");
    const murk_status status =
        murk_results_add_light(&session->results, MURK_MAP_FILE_NAME,
                               session->traced, session->stage, err);
    murk_progress_end();
    return status ? status : murk_session_add_scene(session, err);
}

murk_status murk_session_add_ledger(murk_session *session, const char *name,
                                    const murk_ledger_results *ledger,
                                    murk_error *err)
{
    session->run.total_s = murk_clock_s() - session->begun_s;
    cJSON *root = murk_results_json(murk_results_list_ledger, ledger);
    murk_json_identify(root, session->identity, NULL, NULL);
    char *text = murk_json_end(root, &session->run);
    const murk_status status =
        murk_results_add_text(&session->results, name, text, err);
    cJSON_free(text);
    return status;
}

murk_status murk_session_finish(murk_session *session, const char *name,
                                cJSON *root, murk_print_results *print,
                                const void *of, murk_error *err)
{
    cJSON *summary = print ? murk_print_collect(print, of) : NULL;
    session->run.total_s = murk_clock_s() - session->begun_s;
    murk_json_identify(root, session->identity, &session->results, name);
    murk_run_facts run = session->run;
    run.summary = summary;
    char *text = murk_json_end(root, &run);
    murk_status status =
        text ? MURK_OK : murk_no_memory(err, name, "to write it");
    if (!status && name) {
        status = murk_results_add_text(&session->results, name, text, err);
    }
    if (!status) {
        status = murk_results_show(&session->results, err);
    }
    cJSON_free(session->document);
    session->document = text;
    cJSON_Delete(summary);
    return status;
}

void murk_print_light(const murk_session *session)
{
    const murk_traced *t = session->traced;
    const double emitted_w = murk_ledger_watts(t, t->ledger->emitted);
    const double percent = emitted_w > 0 ? 100 / emitted_w : 0;
    const char *light = session->settings.light;
    if (light) {
        murk_print("light from  %s, seed %lu\n", light, (unsigned long)t->seed);
    }
    murk_print("photons     %llu emitted; stored: %zu surface, %zu volume\n",
               (unsigned long long)t->emitted,
               murk_photon_map_count(t->surface),
               murk_photon_map_count(t->volume));
    murk_print("light       %.4g W: %.1f %% absorbed by surfaces, %.1f %% by "
               "media, %.1f %% escaped, %.2g %% lost\n",
               emitted_w,
               percent * murk_ledger_watts(t, t->ledger->absorbed_surfaces),
               percent * murk_ledger_watts(t, t->ledger->absorbed_media),
               percent * murk_ledger_watts(t, t->ledger->escaped),
               percent * murk_ledger_watts(t, t->ledger->lost));
}
