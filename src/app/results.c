#include "app/results.h"

#include "app/results_in.h"
#include "app/version.h"
#include "base/inputs.h"
#include "base/utf8.h"
#include "study/machine.h"
#include "study/units.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

murk_status murk_results_begin(murk_results *results,
                               const murk_options *options, murk_error *err)
{
    struct stat known;
    const char *folder = options->out;
    *results = (murk_results){.folder = folder,
                              .force = options->force,
                              .is_new = folder && stat(folder, &known) != 0};
    if (!folder) {
        return MURK_OK;
    }
    const murk_status status = murk_folder_make(folder, err);
    if (!status) {
        murk_staging_clean(folder, false);
    }
    return status;
}

/* ---- what may be replaced ---- */

/* Whether this run has put it there itself. */
static bool is_shown(const murk_results *results, const char *path)
{
    for (size_t i = 0; i < results->n; ++i) {
        if (!results->file[i].staged &&
            strcmp(results->file[i].path, path) == 0) {
            return true;
        }
    }
    return false;
}

/* Of what the folder holds; inputs are judged once it is known what would be
 * written over them. */
static murk_status check_owner(murk_results *results, const char *path,
                               const char *name, murk_error *err)
{
    struct stat known;
    if (lstat(path, &known) != 0) {
        return MURK_OK;
    }
    if (stat(path, &known) == 0 && !S_ISREG(known.st_mode)) {
        return murk_fail(err, MURK_RUN_FAILED, path,
                         "cannot write: not a regular file");
    }
    if (results->force || murk_inputs_has(path) || is_shown(results, path) ||
        murk_owned_has(&results->owned, results->folder, name)) {
        return MURK_OK;
    }
    (void)murk_file_not_ours(path, &results->refused);
    return murk_file_not_ours(path, err);
}

/* An input stays as it is; that is right where it has these bytes. */
static bool is_same(const char *path, const char *sum)
{
    char there[65];
    return !murk_file_sha256(path, there, NULL) && strcmp(there, sum) == 0;
}

static murk_status check_input(murk_results *results, size_t i, murk_error *err)
{
    const char *path = results->file[i].path;
    if (!murk_inputs_has(path) || is_same(path, results->file[i].sum)) {
        return MURK_OK;
    }
    (void)murk_file_check_input(path, &results->refused);
    return murk_file_check_input(path, err);
}

murk_status murk_results_expect(murk_results *results, const char *name,
                                const char *text, murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    char *path = murk_results_path(results->folder, name);
    if (!path) {
        return murk_fail(err, MURK_NO_MEMORY, name, "no memory to write it");
    }
    murk_status status = check_owner(results, path, name, err);
    if (!status && murk_inputs_has(path) && strcmp(name, MURK_LIGHT_NAME)) {
        char sum[65];
        murk_sha256_hex(text ? text : "", text ? strlen(text) : 0, sum);
        status =
            is_same(path, sum) ? MURK_OK : murk_file_check_input(path, err);
    }
    free(path);
    return status;
}

/* ---- adding ---- */

/* Drops what is in its place already under this path, which is to be written
 * anew. */
static void forget(murk_results *results, const char *path)
{
    size_t kept = 0;
    for (size_t i = 0; i < results->n; ++i) {
        const murk_result file = results->file[i];
        if (!file.staged && strcmp(file.path, path) == 0) {
            free(file.path);
        } else {
            results->file[kept++] = file;
        }
    }
    results->n = kept;
}

static murk_status check_name(murk_results *results, const char *path,
                              const char *name, murk_error *err)
{
    murk_status status = check_owner(results, path, name, err);
    if (!status) {
        forget(results, path);
    }
    for (size_t i = 0; i < results->n && !status; ++i) {
        if (strcmp(results->file[i].path, path) == 0) {
            status = murk_fail(err, MURK_RUN_FAILED, path,
                               "cannot write: two results have this name");
        }
    }
    return status;
}

/* Room for one more. */
static bool grow(murk_results *results)
{
    murk_result *grown =
        realloc(results->file, (results->n + 1) * sizeof *grown);
    if (!grown) {
        return false;
    }
    results->file = grown;
    return true;
}

/* Takes a place for one more file: path and staged name. */
static murk_status stage_name(murk_results *results, const char *name,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    if (!results->staging.folder) {
        status = murk_staging_begin(&results->staging, results->folder, err);
    }
    murk_result file = {0};
    if (!status) {
        file.path = murk_results_path(results->folder, name);
        file.staged = murk_results_path(results->staging.folder, name);
    }
    if (!status && (!file.path || !file.staged || !grow(results))) {
        status = murk_fail(err, MURK_NO_MEMORY, name, "no memory to write it");
    }
    if (!status) {
        status = check_name(results, file.path, name, err);
    }
    if (status) {
        free(file.path);
        free(file.staged);
        return status;
    }
    results->file[results->n++] = file;
    return MURK_OK;
}

static void drop_last(murk_results *results)
{
    --results->n;
    unlink(results->file[results->n].staged);
    free(results->file[results->n].staged);
    free(results->file[results->n].path);
}

murk_status murk_results_add(murk_results *results, const char *name,
                             murk_results_writer write, const void *context,
                             murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    murk_error told = {0};
    murk_status status = stage_name(results, name, err);
    if (status) {
        return status;
    }
    const size_t i = results->n - 1;
    status = write(results->file[i].staged, context, &told);
    if (!status) {
        status = murk_file_sha256(results->file[i].staged, results->file[i].sum,
                                  &told);
    }
    if (status) { /* under the staged name; told of the final one */
        status = murk_fail(err, status, results->file[i].path, "%s", told.text);
    } else {
        status = check_input(results, i, err);
    }
    if (status) {
        drop_last(results);
    }
    return status;
}

static murk_status write_text(const char *path, const void *text,
                              murk_error *err)
{
    return murk_file_write(path, text, strlen(text), err);
}

murk_status murk_results_add_text(murk_results *results, const char *name,
                                  const char *text, murk_error *err)
{
    if (results->folder && !text) {
        return murk_fail(err, MURK_NO_MEMORY, name, "no memory to write it");
    }
    return murk_results_add(results, name, write_text, text, err);
}

typedef struct light_parts {
    const murk_traced *traced;
    const murk_stage *stage;
} light_parts;

static murk_status write_light(const char *path, const void *context,
                               murk_error *err)
{
    const light_parts *parts = context;
    return murk_light_save(parts->traced, parts->stage, path, err);
}

murk_status murk_results_add_light(murk_results *results, const char *name,
                                   const murk_traced *traced,
                                   const murk_stage *stage, murk_error *err)
{
    const light_parts parts = {traced, stage};
    return murk_results_add(results, name, write_light, &parts, err);
}

murk_status murk_results_note(murk_results *results, const char *name,
                              murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    murk_result file = {.path = murk_results_path(results->folder, name)};
    murk_status status = MURK_OK;
    if (!file.path || !grow(results)) {
        status = murk_fail(err, MURK_NO_MEMORY, name, "no memory to list it");
    }
    if (!status) {
        status = murk_file_sha256(file.path, file.sum, err);
    }
    if (status) {
        free(file.path);
        return status;
    }
    results->file[results->n++] = file;
    return MURK_OK;
}

/* ---- showing ---- */

/* Refuses to replace files that this run has read: checked again here, because
 * the run may have read more files since they were added. */
static murk_status check_all(murk_results *results, murk_error *err)
{
    for (size_t i = 0; i < results->n && !results->refused.status; ++i) {
        if (results->file[i].staged) {
            (void)check_input(results, i, &results->refused);
        }
    }
    const murk_error *refused = &results->refused;
    return refused->status ? murk_fail(err, refused->status, refused->where,
                                       "%s", refused->text)
                           : MURK_OK;
}

murk_status murk_results_show(murk_results *results, murk_error *err)
{
    if (!results->folder || !results->staging.folder) {
        return MURK_OK;
    }
    const murk_status status = check_all(results, err);
    if (status) {
        return status;
    }
    murk_staging_moving(&results->staging);
    for (size_t i = 0; i < results->n; ++i) {
        if (!results->file[i].staged) {
            continue; /* shown before */
        }
        if (murk_inputs_has(results->file[i].path)) {
            (void)unlink(results->file[i].staged); /* the same bytes: stays */
        } else if (rename(results->file[i].staged, results->file[i].path) !=
                   0) {
            return murk_fail(err, MURK_RUN_FAILED, results->file[i].path,
                             "cannot write: %s", strerror(errno));
        }
        free(results->file[i].staged);
        results->file[i].staged = NULL;
    }
    murk_folder_sync(results->folder);
    murk_staging_end(&results->staging);
    murk_staging_clean(results->folder, true);
    return MURK_OK;
}

void murk_results_end(murk_results *results)
{
    murk_staging_end(&results->staging);
    for (size_t i = 0; i < results->n; ++i) {
        free(results->file[i].staged);
        free(results->file[i].path);
    }
    if (results->is_new) {
        (void)rmdir(results->folder); /* if it is empty: made for nothing */
    }
    free(results->file);
    murk_owned_release(&results->owned);
    *results = (murk_results){0};
}

void murk_json_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value)) {
        cJSON_AddNumberToObject(object, key, value);
    } else {
        cJSON_AddNullToObject(object, key);
    }
}

void murk_json_vector(cJSON *object, const char *key, murk_vec3 v)
{
    const double xyz[3] = {v.x, v.y, v.z};
    cJSON_AddItemToObject(object, key, cJSON_CreateDoubleArray(xyz, 3));
}

void murk_json_box(cJSON *object, const char *key, const murk_box *box)
{
    if (!(box->min.x <= box->max.x)) {
        cJSON_AddNullToObject(object, key);
        return;
    }
    cJSON *item = cJSON_AddObjectToObject(object, key);
    murk_json_vector(item, "min_m", box->min);
    murk_json_vector(item, "max_m", box->max);
}

void murk_json_spectrum(cJSON *object, const char *key,
                        const murk_spectrum *spectrum, int bands)
{
    cJSON_AddItemToObject(object, key,
                          cJSON_CreateDoubleArray(spectrum->band, bands));
}

cJSON *murk_json_begin_murk(void)
{
    cJSON *root = cJSON_CreateObject();
    cJSON *murk = cJSON_AddObjectToObject(root, "murk");
    cJSON_AddStringToObject(murk, "version", MURK_VERSION);
    cJSON_AddStringToObject(murk, "commit", murk_version_commit());
    cJSON_AddStringToObject(murk, "compiler", murk_version_compiler());
    cJSON *packages = cJSON_AddObjectToObject(murk, "packages");
    for (size_t i = 0; i < murk_packages_count; ++i) {
        cJSON_AddStringToObject(packages, murk_packages[i].name,
                                murk_packages[i].version);
    }
    return root;
}

cJSON *murk_json_begin(const murk_scene *scene)
{
    cJSON *root = murk_json_begin_murk();
    cJSON_AddStringToObject(root, "scene", scene->path);
    cJSON_AddStringToObject(root, "scene_sha256", scene->sha256);
    cJSON_AddNumberToObject(root, "seed", scene->seed);
    return root;
}

/* cJSON indents with tabs, which YAML readers refuse; inside texts a tab is
 * written \t, so every tab byte here is indentation or follows a colon. */
static char *tabs_to_spaces(const char *text)
{
    size_t tabs = 0;
    for (const char *c = text; *c; ++c) {
        tabs += *c == '\t';
    }
    char *out = cJSON_malloc(strlen(text) + tabs + 2);
    if (!out) {
        return NULL;
    }
    char *to = out;
    for (const char *c = text; *c; ++c) {
        if (*c == '\t') {
            *to++ = ' ';
            if (c[-1] != ':') {
                *to++ = ' ';
            }
        } else {
            *to++ = *c;
        }
    }
    *to++ = '\n';
    *to = '\0';
    return out;
}

/* What was typed, and where: paths in it are as seen from there. */
static void add_command(cJSON *object, const char *command)
{
    char folder[4096];
    cJSON_AddStringToObject(object, "command", command);
    if (getcwd(folder, sizeof folder) &&
        murk_utf8_is_printable(folder, sizeof folder)) {
        cJSON_AddStringToObject(object, "folder", folder);
    } else {
        cJSON_AddNullToObject(object, "folder");
    }
}

static bool is_json(const char *name)
{
    const size_t length = strlen(name);
    return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

/* True if this run writes a file of that name. */
static bool is_written(const murk_results *results, const char *name)
{
    for (size_t i = 0; i < results->n; ++i) {
        if (strcmp(strrchr(results->file[i].path, '/') + 1, name) == 0) {
            return true;
        }
    }
    return false;
}

/* Lists the files of earlier runs that would otherwise be listed by no JSON any
 * more, and so be taken for the user's: those that the JSONs that this run
 * replaces list, that lie in the folder as they were written, and that this run
 * does not write again. */
static void add_earlier(cJSON *root, murk_results *results, const char *name)
{
    cJSON *earlier = cJSON_CreateObject();
    murk_owned_read(&results->owned, results->folder);
    for (size_t i = 0; i < results->owned.n; ++i) {
        const murk_owned_file *file = &results->owned.file[i];
        const char *by = file->json < 0 ? name : murk_main_jsons[file->json];
        const bool is_replaced =
            strcmp(by, name) == 0 || is_written(results, by);
        if (is_replaced && !is_written(results, file->name) &&
            !cJSON_GetObjectItemCaseSensitive(earlier, file->name) &&
            murk_owned_is_there(results->folder, file)) {
            cJSON_AddStringToObject(earlier, file->name, file->sum);
        }
    }
    if (cJSON_GetArraySize(earlier) == 0) {
        cJSON_Delete(earlier);
        return;
    }
    cJSON *run = cJSON_GetObjectItem(root, "run");
    run = run ? run : cJSON_AddObjectToObject(root, "run");
    cJSON_AddItemToObject(run, "earlier", earlier);
}

void murk_json_identify(cJSON *root, const char *identity,
                        murk_results *results, const char *name)
{
    cJSON *run = cJSON_DetachItemFromObject(root, "run"); /* stays the last */
    cJSON_AddStringToObject(root, "identity", identity);
    if (results && !cJSON_GetObjectItem(root, "files")) {
        cJSON *files = cJSON_AddObjectToObject(root, "files");
        for (size_t i = 0; i < results->n; ++i) {
            const char *file = strrchr(results->file[i].path, '/') + 1;
            if (!is_json(file)) {
                cJSON_AddStringToObject(files, file, results->file[i].sum);
            }
        }
    }
    if (run) {
        cJSON_AddItemToObject(root, "run", run);
    }
    if (results && results->folder && name) {
        add_earlier(root, results, name);
    }
}

/* A text in JSON holds no line end, so the line is the map's own. */
void murk_json_sum(char out[65], const char *text)
{
    const char *run = strstr(text, "\n  \"run\": {");
    murk_sha256_hex(text, run ? (size_t)(run - text) : strlen(text), out);
}

/* Fills in run.checksum, for which 64 zeros stand. */
static void put_sum(char *text)
{
    static const char key[] = "\n    \"checksum\": \"";
    char sum[65];
    char *run = strstr(text, "\n  \"run\": {");
    char *at = run ? strstr(run, key) : NULL;
    murk_json_sum(sum, text);
    if (at) {
        memcpy(at + sizeof key - 1, sum, 64);
    }
}

char *murk_json_end(cJSON *root, const murk_run_facts *run)
{
    cJSON *object = cJSON_GetObjectItem(root, "run");
    if (!object) {
        object = cJSON_AddObjectToObject(root, "run");
    }
    if (run->command) {
        add_command(object, run->command);
    }
    cJSON_AddNumberToObject(object, "threads", run->threads);
    cJSON *seconds = cJSON_AddObjectToObject(object, "seconds");
    cJSON_AddNumberToObject(seconds, "load", run->load_s);
    cJSON_AddNumberToObject(seconds, "trace", run->trace_s);
    cJSON_AddNumberToObject(seconds, "map", run->map_s);
    cJSON_AddNumberToObject(seconds, "sense", run->sense_s);
    cJSON_AddNumberToObject(seconds, "place", run->place_s);
    cJSON_AddNumberToObject(seconds, "total", run->total_s);
    murk_json_number(object, "peak_memory_bytes", murk_machine_peak_bytes());
    char date[32] = "";
    const time_t now = time(NULL);
    struct tm utc;
    if (gmtime_r(&now, &utc)) {
        strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    }
    cJSON_AddStringToObject(object, "date", date);
    char zeros[65];
    snprintf(zeros, sizeof zeros, "%064d", 0);
    cJSON_AddStringToObject(object, "checksum", zeros);

    char *printed = cJSON_Print(root);
    cJSON_Delete(root);
    char *text = printed ? tabs_to_spaces(printed) : NULL;
    cJSON_free(printed);
    if (text) {
        put_sum(text);
    }
    return text;
}

/* Of quanta whose packet is worth that much. */
static double worth(int64_t quanta, double packet)
{
    return (double)quanta / (double)MURK_PACKET * packet;
}

double murk_ledger_watts(const murk_traced *traced, const murk_tally *column)
{
    double sum = 0;
    for (size_t c = 0; c < traced->channels; ++c) {
        sum += worth(murk_tally_read(&column[c]), traced->packet_w[c]);
    }
    return sum;
}

/* {"total": .., "bands": [..]} of quanta[channels], each of which is worth
 * packet[channel] a packet. */
static void add_worth(cJSON *object, const char *key, const double *packet,
                      size_t channels, const int64_t *quanta, int bands)
{
    double total = 0, band[MURK_BANDS_MAX] = {0};
    for (size_t c = 0; c < channels; ++c) {
        const double value = worth(quanta[c], packet[c]);
        total += value;
        band[c % (size_t)bands] += value;
    }
    cJSON *both = cJSON_AddObjectToObject(object, key);
    murk_json_number(both, "total", total);
    cJSON_AddItemToObject(both, "bands", cJSON_CreateDoubleArray(band, bands));
}

static void add_watts(cJSON *object, const char *key, const murk_traced *traced,
                      const int64_t *quanta, int bands)
{
    add_worth(object, key, traced->packet_w, traced->channels, quanta, bands);
}

static void add_column(cJSON *object, const char *key,
                       const murk_traced *traced, const murk_tally *column,
                       int bands)
{
    int64_t quanta[MURK_LIGHTS_MAX * MURK_BANDS_MAX];
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = murk_tally_read(&column[c]);
    }
    add_watts(object, key, traced, quanta, bands);
}

/* What one material or medium took. */
static void
add_absorber(cJSON *object, const char *name, const murk_traced *traced,
             int64_t (*absorbed)(const murk_ledger *, size_t, size_t),
             size_t number, int bands)
{
    int64_t quanta[MURK_LIGHTS_MAX * MURK_BANDS_MAX];
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = absorbed(traced->ledger, c, number);
    }
    add_watts(object, name, traced, quanta, bands);
}

static void add_absorbers(cJSON *object, const murk_traced *traced,
                          const murk_scene *scene)
{
    cJSON *surfaces = cJSON_AddObjectToObject(object, "absorbed_by_material_w");
    for (size_t i = 0; i < scene->n_materials; ++i) {
        add_absorber(surfaces, scene->materials[i].name, traced,
                     murk_ledger_by_material, i, scene->bands);
    }
    cJSON *media = cJSON_AddObjectToObject(object, "absorbed_by_medium_w");
    for (size_t i = 0; i < scene->n_media; ++i) {
        add_absorber(media, scene->media[i].name, traced, murk_ledger_by_medium,
                     i, scene->bands);
    }
}

/* What left the lights as users read it: "emitted_lm". Nothing for watts. */
static void add_emitted(cJSON *object, const murk_traced *traced,
                        const murk_stage *stage)
{
    const murk_scene *scene = stage->scene;
    if (scene->units == MURK_RADIOMETRIC) {
        return;
    }
    const murk_units units = murk_units_of(scene->units);
    char key[40];
    double packet[MURK_LIGHTS_MAX * MURK_BANDS_MAX];
    int64_t quanta[MURK_LIGHTS_MAX * MURK_BANDS_MAX];
    murk_units_packets(packet, scene->units, stage, traced->packet_w);
    for (size_t c = 0; c < traced->channels; ++c) {
        quanta[c] = murk_tally_read(&traced->ledger->emitted[c]);
    }
    snprintf(key, sizeof key, "emitted_%s", units.suffix);
    add_worth(object, key, packet, traced->channels, quanta, scene->bands);
}

void murk_json_ledger(cJSON *object, const murk_traced *traced,
                      const murk_stage *stage)
{
    const murk_ledger *ledger = traced->ledger;
    const int bands = stage->scene->bands;
    add_column(object, "emitted_w", traced, ledger->emitted, bands);
    add_emitted(object, traced, stage);
    add_column(object, "absorbed_surfaces_w", traced, ledger->absorbed_surfaces,
               bands);
    add_column(object, "absorbed_media_w", traced, ledger->absorbed_media,
               bands);
    add_column(object, "escaped_w", traced, ledger->escaped, bands);
    add_column(object, "lost_w", traced, ledger->lost, bands);
    add_absorbers(object, traced, stage->scene);
    cJSON_AddNumberToObject(object, "photons_emitted",
                            (double)murk_tally_read(&ledger->photons));
    cJSON_AddNumberToObject(object, "collisions",
                            (double)murk_tally_read(&ledger->collisions));
    static const char *const cause[MURK_LOSSES] = {
        [MURK_LOSS_EVENTS] = "events",
        [MURK_LOSS_WRAPS] = "wraps",
        [MURK_LOSS_NUMERICAL] = "numerical"};
    cJSON *lost = cJSON_AddObjectToObject(object, "lost");
    for (int i = 0; i < MURK_LOSSES; ++i) {
        cJSON_AddNumberToObject(
            lost, cause[i], (double)murk_tally_read(&ledger->lost_photons[i]));
    }
    cJSON_AddNumberToObject(object, "imbalance_quanta",
                            (double)murk_ledger_imbalance(ledger));
}
