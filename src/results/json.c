/* Builds the JSON that commands print and write: the version of the program,
 * values that many commands share, the files of the run, so that later runs and
 * readers know which files of the folder belong to which run
 * (results/ownership.h), and `run` with its checksum. */
#include "results/json.h"

#include "base/machine.h"
#include "base/utf8.h"
#include "results/fields.h"
#include "results/ownership.h"
#include "results/version.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

void murk_json_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value)) {
        cJSON_AddNumberToObject(object, key, value);
    } else {
        cJSON_AddNullToObject(object, key);
    }
}

void murk_json_numbers(cJSON *object, const char *key, const double *value,
                       int n)
{
    cJSON_AddItemToObject(object, key, cJSON_CreateDoubleArray(value, n));
}

cJSON *murk_json_item(cJSON *list)
{
    cJSON *item = cJSON_CreateObject();
    cJSON_AddItemToArray(list, item);
    return item;
}

void murk_json_vector(cJSON *object, const char *key, murk_vec3 v)
{
    murk_json_numbers(object, key, (const double[]){v.x, v.y, v.z}, 3);
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

static void list_packages(murk_results_fields *f, const void *of)
{
    (void)of;
    for (size_t i = 0; i < murk_packages_count; ++i) {
        MURK_TEXT(f, murk_packages[i].name, "version",
                  murk_packages[i].version);
    }
}

static void list_program(murk_results_fields *f, const void *of)
{
    MURK_TEXT(f, "version", "version of murk", MURK_VERSION);
    MURK_TEXT(f, "commit", "that murk was built from", murk_version_commit());
    MURK_TEXT(f, "compiler", "with version", murk_version_compiler());
    MURK_OBJECT(f, "packages", "that murk was built with", list_packages, of);
}

void murk_results_list_murk(murk_results_fields *f, const void *of)
{
    (void)of;
    MURK_OBJECT(f, "murk", "the program that made the file", list_program,
                MURK_VERSION);
}

void murk_results_list_every(murk_results_fields *f, const void *of)
{
    const murk_scene_desc *scene = of;
    murk_results_list_murk(f, NULL);
    MURK_TEXT(f, "scene", "the scene file as named", scene->path);
    MURK_TEXT(f, "scene_sha256", "of the scene file's bytes", scene->sha256);
    MURK_COUNT(f, "seed", "of all random numbers", scene->seed);
}

void murk_results_list_head(murk_results_fields *f,
                            const murk_scene_desc *scene)
{
    if (!murk_results_describes(f)) { /* described once for all files */
        murk_results_list_every(f, scene);
    }
}

cJSON *murk_json_begin_murk(void)
{
    return murk_results_json(murk_results_list_murk, NULL);
}

cJSON *murk_json_begin(const murk_scene_desc *scene)
{
    return murk_results_json(murk_results_list_every, scene);
}

/* ---- the files of the run ---- */

/* True if this run writes a file of that name. */
static bool is_written(const murk_results *results, const char *name)
{
    for (size_t i = 0; i < results->n; ++i) {
        if (strcmp(murk_path_name(results->file[i].path), name) == 0) {
            return true;
        }
    }
    return false;
}

/* Lists files of earlier runs under run.earlier: files that are listed by a
 * JSON that this run replaces, or by the JSON of a killed run, that are still
 * in the folder with the listed checksum, and that this run does not write
 * again. Without run.earlier no JSON would list these files after this run, and
 * they would count as files of the user. */
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
            const char *file = murk_path_name(results->file[i].path);
            if (!murk_owned_is_json(file)) {
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

void murk_json_file(cJSON *root, const char *path)
{
    cJSON *files = cJSON_GetObjectItem(root, "files");
    files = files ? files : cJSON_AddObjectToObject(root, "files");
    char sum[65];
    if (path && !murk_file_sha256(path, sum, NULL)) {
        cJSON_AddStringToObject(files, murk_path_name(path), sum);
    }
}

/* ---- the end ---- */

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

/* The command as typed, and the folder that relative paths in it refer to; null
 * if that folder is not known or not printable. */
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

void murk_json_put_sum(char *text)
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
    /* Facts of the run: command, time, memory, date. */
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
    if (run->reused_photons + run->reused_sightlines > 0) {
        cJSON *reused = cJSON_AddObjectToObject(object, "reused");
        murk_json_number(reused, "photons", (double)run->reused_photons);
        murk_json_number(reused, "sightlines", (double)run->reused_sightlines);
    }
    if (run->has_watched) {
        const murk_vec3 *corner[] = {&run->watched.min, &run->watched.max};
        cJSON *box = cJSON_AddArrayToObject(object, "watched_m");
        for (int i = 0; i < 6; ++i) {
            cJSON_AddItemToArray(
                box, cJSON_CreateNumber(murk_component(*corner[i / 3], i % 3)));
        }
    }
    murk_json_number(object, "peak_memory_bytes", murk_machine_peak_bytes());
    char date[32] = "";
    const time_t now = time(NULL);
    struct tm utc;
    if (gmtime_r(&now, &utc)) {
        strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    }
    cJSON_AddStringToObject(object, "date", date);
    if (run->summary) {
        cJSON_AddItemReferenceToObject(object, "summary", run->summary);
    }
    char zeros[65];
    snprintf(zeros, sizeof zeros, "%064d", 0);
    cJSON_AddStringToObject(object, "checksum", zeros);

    /* Print, and put the checksum in the place of the zeros. */
    char *printed = cJSON_Print(root);
    cJSON_Delete(root);
    char *text = printed ? tabs_to_spaces(printed) : NULL;
    cJSON_free(printed);
    if (text) {
        murk_json_put_sum(text);
    }
    return text;
}
