#include "app/session.h"

#include "app/identity.h"
#include "app/ledger_out.h"
#include "app/run_files.h"
#include "app/summary.h"

#include "base/log.h"
#include "base/progress.h"
#include "world/stage_build.h"
#include "world/units.h"

#include <stdlib.h>
#include <string.h>

#define FILE_SIZE (MURK_SCENE_NAME_SIZE + 16)

/* Keys that are given in vain. */
static void warn_of_idle(const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->idles; ++i) {
        murk_warn(scene->idle[i].where, "%s", scene->idle[i].text);
    }
}

/* True if an option or --set gives this key or the map that it is in. */
static bool is_given(const murk_options *options, const char *key)
{
    for (size_t i = 0; i < options->n_overrides; ++i) {
        const char *text = options->overrides[i].text;
        const size_t length = strcspn(text, "=");
        if (strncmp(text, key, length) == 0 &&
            (key[length] == '\0' || key[length] == '.')) {
            return true;
        }
    }
    return false;
}

/* Reads the scene. With --light, the seed and the number of photons are the
 * file's unless the command line gives them: light of another seed or number is
 * refused later (murk_lightmap_load), and nobody should have to repeat them. */
static murk_status read_scene(murk_scene_desc **out,
                              const murk_options *options, murk_error *err)
{
    murk_lightmap_counts counts;
    murk_status status = MURK_OK;
    if (!options->light) {
        return murk_scene_desc_read(out, options->input, options->overrides,
                                    options->n_overrides, err);
    }
    murk_error unread = {0};
    if (murk_lightmap_read_counts(&counts, options->light, &unread)) {
        /* placement over conditions takes no file of light, whatever the file
         * holds, and says so itself */
        status = murk_scene_desc_read(out, options->input, options->overrides,
                                      options->n_overrides, err);
        if (status || (*out)->placement.over != MURK_SCENE_OVER_NONE) {
            return status;
        }
        *err = unread;
        return unread.status;
    }
    murk_override *all = calloc(options->n_overrides + 2, sizeof *all);
    char seed[32], number[64];
    size_t n = 0;
    if (!all) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the options");
    }
    if (!is_given(options, "seed")) {
        snprintf(seed, sizeof seed, "seed=%lu", (unsigned long)counts.seed);
        all[n++] = (murk_override){seed, "--light"};
    }
    if ((counts.emit || counts.store) && !is_given(options, "photons.emit") &&
        !is_given(options, "photons.store")) {
        snprintf(
            number, sizeof number, "photons.%s=%llu",
            counts.emit ? "emit" : "store",
            (unsigned long long)(counts.emit ? counts.emit : counts.store));
        all[n++] = (murk_override){number, "--light"};
    }
    for (size_t i = 0; i < options->n_overrides; ++i) {
        all[n++] = options->overrides[i];
    }
    status = murk_scene_desc_read(out, options->input, all, n, err);
    free(all);
    return status;
}

murk_status murk_session_begin(murk_session *session,
                               const murk_options *options, murk_error *err)
{
    const murk_status status = murk_session_read(session, options, err);
    return status ? status : murk_session_build(session, err);
}

murk_status murk_session_scene(murk_session *session,
                               const murk_options *options, murk_error *err)
{
    *session = (murk_session){.options = options,
                              .run.threads = options->threads,
                              .run.command = options->typed,
                              .begun_s = murk_clock_s()};
    if (options->quiet) {
        murk_warn_to(NULL);
    }
    murk_progress_set(options->quiet ? MURK_PROGRESS_NEVER : options->progress);
    murk_progress_begin_over("read", 0, "");
    const murk_status status = read_scene(&session->scene, options, err);
    murk_progress_end();
    if (status) {
        return status;
    }
    murk_units_note(session->scene);
    warn_of_idle(session->scene);
    return murk_identity_scene(session->identity, options, session->scene, err);
}

murk_status murk_session_read(murk_session *session,
                              const murk_options *options, murk_error *err)
{
    const murk_status status = murk_session_scene(session, options, err);
    return status ? status
                  : murk_results_begin(&session->results, options, err);
}

murk_status murk_session_build(murk_session *session, murk_error *err)
{
    murk_progress_begin_over("build", 0, "");
    const murk_status status =
        murk_stage_create(&session->stage, session->scene, err);
    murk_progress_end();
    session->run.load_s = murk_clock_s() - session->begun_s;
    return status;
}

murk_status murk_session_light(murk_session *session, murk_error *err)
{
    const unsigned threads = session->options->threads;
    const double begun_s = murk_clock_s();
    murk_status status;
    if (session->options->light) {
        if (murk_owned_look(session->options->light) == MURK_OF_ANOTHER_RUN) {
            murk_warn(session->options->light,
                      "is of another run than the results beside it, or of "
                      "one that was killed while it wrote them");
        }
        murk_progress_begin_over("read light", 0, "");
        status = murk_lightmap_load(&session->traced, session->stage,
                                    session->options->light, threads, err);
        murk_progress_end();
        session->run.load_s += murk_clock_s() - begun_s;
    } else {
        status = murk_lightmap_trace(&session->traced, session->stage, 0,
                                     threads, err);
    }
    if (!status) {
        session->run.trace_s = session->traced->trace_s;
        session->run.map_s = session->traced->map_s;
    }
    return status;
}

void murk_session_end(murk_session *session)
{
    murk_results_end(&session->results);
    murk_traced_destroy(session->traced);
    murk_stage_destroy(session->stage);
    murk_scene_desc_destroy(session->scene);
    *session = (murk_session){0};
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
        if (!files[i].of || session->options->exports & files[i].of) {
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
        if (scene->tallies[i].type == MURK_SCENE_TALLY_GRID) {
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
        {MURK_EXPORT_SURFACES, {"surfaces.ply", "surfaces.vtp"}}};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sizeof files / sizeof *files && !status; ++i) {
        murk_error why = {0};
        if (session->options->exports & files[i].what &&
            expect_all(&session->results, files[i].names, &why) ==
                MURK_BAD_VALUE) { /* what fails else is told late */
            status = murk_fail(err, why.status, why.where, "%s", why.text);
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

murk_status murk_session_add_light(murk_session *session, murk_error *err)
{
    murk_progress_begin_over("write light", 0, "");
    const murk_status status =
        murk_results_add_light(&session->results, MURK_MAP_FILE_NAME,
                               session->traced, session->stage, err);
    murk_progress_end();
    return status ? status
                  : murk_results_add_text(&session->results, MURK_SCENE_NAME,
                                          session->scene->resolved, err);
}

cJSON *murk_session_ledger(const murk_session *session)
{
    cJSON *root = murk_json_begin(session->scene);
    murk_json_ledger(root, session->traced, session->stage);
    return root;
}

murk_status murk_session_add_ledger(murk_session *session, murk_error *err)
{
    session->run.total_s = murk_clock_s() - session->begun_s;
    cJSON *root = murk_session_ledger(session);
    murk_json_identify(root, session->identity, NULL, NULL);
    char *text = murk_json_end(root, &session->run);
    const murk_status status =
        murk_results_add_text(&session->results, "ledger.json", text, err);
    cJSON_free(text);
    return status;
}

static murk_status show(murk_session *session, const char *name, cJSON *root,
                        bool prints, murk_error *err)
{
    session->run.total_s = murk_clock_s() - session->begun_s;
    murk_json_identify(root, session->identity, &session->results, name);
    char *text = murk_json_end(root, &session->run);
    murk_status status =
        text ? MURK_OK
             : murk_fail(err, MURK_NO_MEMORY, name, "no memory to write it");
    if (!status && name) {
        status = murk_results_add_text(&session->results, name, text, err);
    }
    if (!status) {
        status = murk_results_show(&session->results, err);
    }
    if (!status && prints) {
        murk_print_json(text);
    }
    cJSON_free(text);
    return status;
}

murk_status murk_session_finish(murk_session *session, const char *name,
                                cJSON *root, murk_error *err)
{
    return show(session, name, root, session->options->json, err);
}

murk_status murk_session_keep(murk_session *session, const char *name,
                              cJSON *root, murk_error *err)
{
    return show(session, name, root, false, err);
}

bool murk_session_speaks(const murk_session *session)
{
    return !session->options->json && !session->options->quiet;
}

void murk_print_light(const murk_session *session)
{
    const murk_traced *t = session->traced;
    const double emitted_w = murk_ledger_watts(t, t->ledger->emitted);
    const double percent = emitted_w > 0 ? 100 / emitted_w : 0;
    const char *light = session->options->light;
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

void murk_print_files(const murk_session *session)
{
    const murk_results *r = &session->results;
    if (!r->folder) {
        murk_print("files       none: -o DIR writes them\n");
        return;
    }
    murk_print("files       %s:", r->folder);
    for (size_t i = r->n; i > 0; --i) {
        const char *path = r->file[i - 1].path;
        const char *name = path;
        for (const char *c = path; *c; ++c) {
            name = *c == '/' ? c + 1 : name;
        }
        murk_print(" %s", name);
    }
    murk_print("\n");
}
