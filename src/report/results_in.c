/* Reads the main JSON files of a result folder, refuses those of another
 * version, and finds files that were changed after the run wrote them, by the
 * SHA-256 in the JSON files. */
#include "report/results_in.h"

#include "base/file.h"
#include "base/log.h"
#include "base/number.h"
#include "base/version.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define PATH_PART_MAX 64 /* bytes of a key; the longest has some 30 */

const murk_result_kind murk_result_kinds[MURK_RESULT_FILES] = {
    [MURK_RESULT_PLAN] = {"plan.json", "plan", "The placement"},
    [MURK_RESULT_COVERAGE] = {"coverage.json", "coverage",
                              "The sensors that were given"},
    [MURK_RESULT_STUDY] = {"study.json", "study", "The study"},
    [MURK_RESULT_FIT] = {"fit.json", "fit", "The calibration"},
    [MURK_RESULT_PREDICT] = {"predict.json", "predict", "The prediction"},
    [MURK_RESULT_FOLLOW] = {"follow.json", "follow", "The plans step by step"},
    [MURK_RESULT_LEDGER] = {"ledger.json", "ledger", "The light"}};

char *murk_results_path(const char *folder, const char *name)
{
    struct stat known;
    char *path = murk_path_join(folder, name);
    if (path && stat(path, &known) == 0 && S_ISREG(known.st_mode)) {
        return path;
    }
    free(path);
    return NULL;
}

bool murk_results_has(const char *folder, const char *name)
{
    char *path = murk_results_path(folder, name);
    free(path);
    return path != NULL;
}

bool murk_name_ends(const char *name, const char *extension)
{
    const char *dot = strrchr(name, '.');
    return dot && strcmp(dot, extension) == 0;
}

static int is_visible(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

const char *murk_results_scene(const char *folder)
{
    static const char name[] = "scene.resolved.yaml";
    return murk_results_has(folder, name) ? name : "scene.yaml";
}

murk_status murk_results_table(murk_table **out, const char *folder,
                               const char *name, murk_error *err)
{
    if (!murk_results_has(folder, name)) {
        return MURK_OK;
    }
    char *path = murk_path_join(folder, name);
    const murk_status status = path ? murk_table_read(out, path, err)
                                    : murk_no_memory(err, name, "to read it");
    free(path);
    return status;
}

const char *murk_table_text(const murk_table *table, size_t row,
                            const char *name)
{
    const long column = murk_table_column(table, name);
    return column < 0 ? "" : table->cell[row * table->columns + (size_t)column];
}

double murk_table_value(const murk_table *table, size_t row, const char *name)
{
    double value;
    return murk_number_parse(murk_table_text(table, row, name), &value) ? value
                                                                        : NAN;
}

/* ---- values ---- */

const murk_yaml *murk_result_get(const murk_yaml *root, const char *key)
{
    return root && root->kind == MURK_YAML_MAP ? murk_yaml_get(root, key)
                                               : NULL;
}

size_t murk_result_entries(const murk_yaml *root)
{
    return root && root->kind == MURK_YAML_MAP ? root->n : 0;
}

const murk_yaml *murk_result_at(const murk_yaml *root, const char *path)
{
    char part[PATH_PART_MAX];
    while (root && *path) {
        const size_t length = strcspn(path, ".");
        if (length >= sizeof part) {
            return NULL;
        }
        memcpy(part, path, length);
        part[length] = '\0';
        root = murk_result_get(root, part);
        path += length + (path[length] == '.');
    }
    return root;
}

double murk_result_number(const murk_yaml *root, const char *path)
{
    double value = NAN;
    const murk_yaml *at = murk_result_at(root, path);
    return at && murk_yaml_number(at, &value) ? value : NAN;
}

const char *murk_result_text(const murk_yaml *root, const char *path)
{
    const murk_yaml *at = murk_result_at(root, path);
    const bool is_text =
        at && at->kind == MURK_YAML_SCALAR && !murk_yaml_is_null(at);
    return is_text ? at->text : NULL;
}

size_t murk_result_count(const murk_yaml *root, const char *path)
{
    const murk_yaml *at = murk_result_at(root, path);
    return at && at->kind == MURK_YAML_LIST ? at->n : 0;
}

bool murk_result_is(const murk_yaml *root, const char *path, const char *text)
{
    const char *found = murk_result_text(root, path);
    return found && strcmp(found, text) == 0;
}

/* ---- reading ---- */

/* Length of "0.1" in "0.1.0". */
static size_t release_length(const char *version)
{
    const size_t major = strcspn(version, ".");
    return version[major] ? major + 1 + strcspn(version + major + 1, ".")
                          : major;
}

static murk_status check_version(const murk_yaml *root, const char *path,
                                 murk_error *err)
{
    const char *found = murk_result_text(root, "murk.version");
    const size_t length = release_length(MURK_VERSION);
    if (!found) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "murk.version is missing: no result of murk");
    }
    if (release_length(found) == length &&
        strncmp(found, MURK_VERSION, length) == 0) {
        return MURK_OK;
    }
    char where[320];
    murk_yaml_place(murk_result_at(root, "murk.version"), where, sizeof where);
    return murk_fail(err, MURK_BAD_VALUE, where,
                     "murk.version: %.40s, must be %.*s: results of another "
                     "version; run its command again",
                     found, (int)length, MURK_VERSION);
}

static murk_status read_json(murk_results_in *out, murk_result_file which,
                             murk_error *err)
{
    const char *name = murk_result_kinds[which].file;
    out->path[which] = murk_path_join(out->folder, name);
    if (!out->path[which]) {
        return murk_no_memory(err, name, "to read it");
    }
    if (!murk_results_has(out->folder, name)) {
        return MURK_OK;
    }
    const murk_status status =
        murk_yaml_read(&out->json[which], out->path[which], err);
    return status ? status
                  : check_version(out->json[which], out->path[which], err);
}

/* Reads the resolved scene. A failure is kept in no_scene, because the page can
 * be made without a scene. */
static murk_status read_scene(murk_results_in *out, murk_error *err)
{
    const char *name = murk_results_scene(out->folder);
    char *path = murk_path_join(out->folder, name);
    if (!path) {
        return murk_no_memory(err, name, "to read it");
    }
    const murk_warn_sink sink = murk_warn_to(NULL); /* the run has printed the
                                                       warnings */
    if (murk_results_has(out->folder, name)) {
        (void)murk_scene_desc_read(&out->scene, path, NULL, 0, &out->no_scene);
    } else {
        (void)murk_fail(&out->no_scene, MURK_BAD_FILE, "", "it is not there");
    }
    murk_warn_to(sink);
    free(path);
    return MURK_OK;
}

murk_status murk_results_read(murk_results_in *out, const char *folder,
                              murk_error *err)
{
    struct stat known;
    *out = (murk_results_in){.folder = folder};
    if (stat(folder, &known) != 0 || !S_ISDIR(known.st_mode)) {
        return murk_fail(err, MURK_BAD_FILE, folder,
                         "no such folder, must be a folder of results");
    }
    out->whole = realpath(folder, NULL);
    out->whole = out->whole ? out->whole : strdup(folder);
    if (!out->whole) {
        return murk_no_memory(err, "", "for the folder");
    }
    out->entries = scandir(folder, &out->entry, is_visible, alphasort);
    /* each main file that is there, at least one */
    bool has_any = false;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const murk_status status = read_json(out, (murk_result_file)i, err);
        if (status) {
            return status;
        }
        has_any = has_any || out->json[i];
    }
    if (!has_any) {
        return murk_fail(err, MURK_BAD_FILE, folder,
                         "no results here, must hold plan.json, coverage.json, "
                         "study.json, fit.json, predict.json, follow.json or "
                         "ledger.json");
    }
    return read_scene(out, err);
}

bool murk_results_is_main(const murk_results_in *results,
                          murk_result_file which)
{
    bool has_other = false;
    for (int i = 0; i < MURK_RESULT_LEDGER; ++i) {
        has_other = has_other || results->json[i];
    }
    return results->json[which] && !(which == MURK_RESULT_LEDGER && has_other);
}

static bool can_be_one_run(const murk_yaml *a, const murk_yaml *b)
{
    static const char *const keys[] = {"run.command", "run.folder",
                                       "scene_sha256", "seed", "identity"};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; ++k) {
        const char *x = murk_result_text(a, keys[k]);
        const char *y = murk_result_text(b, keys[k]);
        if (x && y && strcmp(x, y) != 0) {
            return false;
        }
    }
    return true;
}

bool murk_results_has_readings(const murk_results_in *results)
{
    return results->json[MURK_RESULT_FIT] || results->json[MURK_RESULT_PREDICT];
}

bool murk_results_are_one_run(const murk_results_in *results)
{
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        for (int k = 0; k < i; ++k) {
            if (!can_be_one_run(results->json[i], results->json[k])) {
                return false;
            }
        }
    }
    return true;
}

/* True if one of the JSON files lists the name with this checksum under
 * `files`. */
static bool is_known(const murk_results_in *results, const char *name,
                     const char *sum)
{
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const murk_yaml *files = murk_result_at(results->json[i], "files");
        if (murk_result_is(murk_result_get(files, name), "", sum)) {
            return true;
        }
    }
    return false;
}

static bool is_stranger(const murk_results_in *results, const char *name)
{
    char sum[65];
    char *path = murk_results_path(results->folder, name);
    const bool is_read = path && !murk_file_sha256(path, sum, NULL);
    free(path);
    return is_read && !is_known(results, name, sum);
}

/* True if ledger.json has an identity and is neither the main JSON of a trace,
 * which has `files`, nor of the same run as another JSON. If so, the run that
 * wrote ledger.json was killed before it wrote the main JSON, or the other JSON
 * files are of other runs. */
static bool has_stray_ledger(const murk_results_in *results)
{
    const murk_yaml *ledger = results->json[MURK_RESULT_LEDGER];
    const char *identity = murk_result_text(ledger, "identity");
    if (!identity || murk_result_at(ledger, "files")) {
        return false;
    }
    for (int i = 0; i < MURK_RESULT_LEDGER; ++i) {
        if (murk_result_is(results->json[i], "identity", identity)) {
            return false;
        }
    }
    return true;
}

char *murk_results_strangers(const murk_results_in *results)
{
    /* Files that the JSONs list, and files of earlier runs. */
    const murk_yaml *lists[2 * MURK_RESULT_FILES];
    for (size_t i = 0; i < MURK_RESULT_FILES; ++i) {
        lists[2 * i] = murk_result_at(results->json[i], "files");
        lists[2 * i + 1] = murk_result_at(results->json[i], "run.earlier");
    }
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return NULL;
    }
    /* Each name once: in the first list that has the name. */
    const char *ledger = murk_result_kinds[MURK_RESULT_LEDGER].file;
    const bool is_stray = has_stray_ledger(results);
    const char *between = is_stray ? ", " : "";
    fputs(is_stray ? ledger : "", to);
    for (size_t n = 0; n < 2 * MURK_RESULT_FILES; ++n) {
        for (size_t k = 0; k < murk_result_entries(lists[n]); ++k) {
            const char *name = lists[n]->key[k];
            size_t first = 0;
            while (!murk_result_get(lists[first], name)) {
                ++first;
            }
            if (first == n && !strchr(name, '/') &&
                !(is_stray && strcmp(name, ledger) == 0) &&
                is_stranger(results, name)) {
                fprintf(to, "%s%s", between, name);
                between = ", ";
            }
        }
    }
    if (fclose(to) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

void murk_results_release(murk_results_in *results)
{
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        free(results->path[i]);
        murk_yaml_destroy(results->json[i]);
    }
    for (int i = 0; i < results->entries; ++i) {
        free(results->entry[i]);
    }
    free(results->entry);
    murk_scene_desc_destroy(results->scene);
    free(results->whole);
    free(results->strangers);
    *results = (murk_results_in){0};
}
