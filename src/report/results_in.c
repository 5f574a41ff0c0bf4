/* Reads the main JSON files of a result folder, refuses those of another
 * version, and finds files that are not as a run of the folder wrote them, by
 * the SHA-256 that the JSON files list. */
#include "report/results_in.h"

#include "base/file.h"
#include "base/version.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define PATH_PART_MAX 64 /* bytes of a key: the longest has some 30 */

static const char *const names[MURK_RESULT_FILES] = {
    [MURK_RESULT_PLAN] = "plan.json",
    [MURK_RESULT_COVERAGE] = "coverage.json",
    [MURK_RESULT_STUDY] = "study.json",
    [MURK_RESULT_FIT] = "fit.json",
    [MURK_RESULT_LEDGER] = "ledger.json"};

bool murk_results_has(const char *folder, const char *name)
{
    struct stat known;
    char *path = murk_path_join(folder, name);
    const bool has = path && stat(path, &known) == 0 && S_ISREG(known.st_mode);
    free(path);
    return has;
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
    const murk_status status =
        path ? murk_table_read(out, path, err)
             : murk_fail(err, MURK_NO_MEMORY, name, "no memory to read it");
    free(path);
    return status;
}

/* ---- values ---- */

const murk_yaml *murk_result_at(const murk_yaml *root, const char *path)
{
    char part[PATH_PART_MAX];
    while (root && *path) {
        const size_t length = strcspn(path, ".");
        if (length >= sizeof part || root->kind != MURK_YAML_MAP) {
            return NULL;
        }
        memcpy(part, path, length);
        part[length] = '\0';
        root = murk_yaml_get(root, part);
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

double *murk_result_column(const murk_yaml *list, size_t n, const char *key)
{
    double *values = malloc((n + 1) * sizeof *values);
    for (size_t i = 0; values && i < n; ++i) {
        values[i] = murk_result_number(list->child[i], key);
    }
    return values;
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
    out->path[which] = murk_path_join(out->folder, names[which]);
    if (!out->path[which]) {
        return murk_fail(err, MURK_NO_MEMORY, names[which],
                         "no memory to read it");
    }
    if (!murk_results_has(out->folder, names[which])) {
        return MURK_OK;
    }
    const murk_status status =
        murk_yaml_read(&out->json[which], out->path[which], err);
    return status ? status
                  : check_version(out->json[which], out->path[which], err);
}

murk_status murk_results_read(murk_results_in *out, const char *folder,
                              murk_error *err)
{
    struct stat known;
    *out = (murk_results_in){.folder = folder};
    if (stat(folder, &known) != 0 || !S_ISDIR(known.st_mode)) {
        return murk_fail(err, MURK_BAD_FILE, folder,
                         "no such folder, must be one of results (-o DIR)");
    }
    out->whole = realpath(folder, NULL);
    out->whole = out->whole ? out->whole : strdup(folder);
    if (!out->whole) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the folder");
    }
    /* each main file that is there; one is enough */
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
                         "study.json, fit.json or ledger.json");
    }
    return MURK_OK;
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

/* Whether one of the JSONs lists the name with this sum. */
static bool is_known(const murk_results_in *results, const char *name,
                     const char *sum)
{
    bool is_known = false;
    for (int i = 0; i < MURK_RESULT_FILES && !is_known; ++i) {
        const murk_yaml *files = murk_result_at(results->json[i], "files");
        const murk_yaml *known = files && files->kind == MURK_YAML_MAP
                                     ? murk_yaml_get(files, name)
                                     : NULL;
        is_known = known && murk_result_is(known, "", sum);
    }
    return is_known;
}

static bool is_stranger(const murk_results_in *results, const char *name)
{
    char sum[65];
    char *path = murk_results_has(results->folder, name)
                     ? murk_path_join(results->folder, name)
                     : NULL;
    const bool is_read = path && !murk_file_sha256(path, sum, NULL);
    free(path);
    return is_read && !is_known(results, name, sum);
}

/* Whether a name stands in a list of names. */
static bool is_in(const char *list, const char *name)
{
    const size_t length = strlen(name);
    for (const char *at = strstr(list, name); at; at = strstr(at + 1, name)) {
        if ((at == list || at[-1] == ' ') &&
            (!at[length] || at[length] == ',')) {
            return true;
        }
    }
    return false;
}

static bool add_strangers(FILE *to, const murk_results_in *results,
                          const murk_yaml *files, char *const *so_far)
{
    for (size_t k = 0; k < files->n; ++k) {
        const char *name = files->key[k];
        fflush(to);
        if (!strchr(name, '/') && !is_in(*so_far, name) &&
            is_stranger(results, name)) {
            fprintf(to, "%s%s", **so_far ? ", " : "", name);
        }
    }
    return fflush(to) == 0;
}

/* Whether ledger.json is neither a trace's, which lists files, nor of the run
 * of one of the other JSONs: those of another run lie beside it, or none, since
 * the main JSON of a run comes last. */
static bool has_stray_ledger(const murk_results_in *results)
{
    const murk_yaml *ledger = results->json[MURK_RESULT_LEDGER];
    const char *identity = murk_result_text(ledger, "identity");
    if (!identity || murk_result_at(ledger, "files")) {
        return false;
    }
    bool is_known = false;
    for (int i = 0; i < MURK_RESULT_LEDGER; ++i) {
        is_known =
            is_known || murk_result_is(results->json[i], "identity", identity);
    }
    return !is_known;
}

char *murk_results_strangers(const murk_results_in *results)
{
    char *list = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&list, &size);
    if (to && has_stray_ledger(results)) {
        fputs(names[MURK_RESULT_LEDGER], to);
    }
    bool is_whole = to && fflush(to) == 0;
    for (int i = 0; i < MURK_RESULT_FILES && is_whole; ++i) {
        /* files listed that have other checksums, and files of earlier runs */
        const murk_yaml *const lists[] = {
            murk_result_at(results->json[i], "files"),
            murk_result_at(results->json[i], "run.earlier")};
        for (int k = 0; k < 2 && is_whole; ++k) {
            if (lists[k] && lists[k]->kind == MURK_YAML_MAP) {
                is_whole = add_strangers(to, results, lists[k], &list);
            }
        }
    }
    is_whole = to && fclose(to) == 0 && is_whole;
    if (!is_whole) {
        free(list);
        list = NULL;
    }
    return list;
}

void murk_results_release(murk_results_in *results)
{
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        free(results->path[i]);
        murk_yaml_destroy(results->json[i]);
    }
    free(results->whole);
    free(results->strangers);
    *results = (murk_results_in){0};
}
