/* Ownership of result files: reads the lists of files in the main JSONs of a
 * folder, and compares the listed SHA-256 with that of the file. */
#include "results/ownership.h"

#include "base/file.h"
#include "base/staging.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Limit on the size of a main JSON, far above that of large studies. A larger
 * file is not read and counts as the user's. */
#define JSON_BYTES_MAX 1000000000

const char *const murk_main_jsons[] = {
    "plan.json", "coverage.json", "ledger.json", "study.json",
    "fit.json",  "predict.json",  "follow.json", NULL};

/* ---- one JSON ---- */

/* Reads a JSON. NULL if it is not there or is not a JSON of murk. The caller
 * frees *text in any case. */
static cJSON *read_json(const char *path, char **text)
{
    size_t size = 0;
    *text = NULL;
    if (murk_file_read_own(text, &size, path, JSON_BYTES_MAX, NULL)) {
        return NULL;
    }
    cJSON *root = cJSON_ParseWithLength(*text, size);
    const cJSON *murk = cJSON_GetObjectItem(root, "murk");
    if (!cJSON_IsString(cJSON_GetObjectItem(murk, "version"))) {
        cJSON_Delete(root);
        root = NULL;
    }
    return root;
}

/* Strings of a JSON have no line feeds, so the line that is found is that of
 * the key. */
void murk_json_sum(char out[65], const char *text)
{
    const char *run = strstr(text, "\n  \"run\": {");
    murk_sha256_hex(text, run ? (size_t)(run - text) : strlen(text), out);
}

/* True if the text before `run` has the checksum that `run` states, or if `run`
 * states none. */
static bool is_unchanged(const cJSON *root, const char *text)
{
    const cJSON *sum =
        cJSON_GetObjectItem(cJSON_GetObjectItem(root, "run"), "checksum");
    char found[65];
    murk_json_sum(found, text);
    return !cJSON_IsString(sum) || strcmp(sum->valuestring, found) == 0;
}

static bool is_own_json(const char *path)
{
    char *text = NULL;
    cJSON *root = read_json(path, &text);
    const bool is_own = root && is_unchanged(root, text);
    cJSON_Delete(root);
    free(text);
    return is_own;
}

/* ---- the folder ---- */

static void add_file(murk_owned *owned, const char *name, const char *sum,
                     int json, bool is_earlier)
{
    murk_owned_file *grown =
        realloc(owned->file, (owned->n + 1) * sizeof *grown);
    if (!grown) {
        return; /* not known to be murk's, so it is not replaced */
    }
    owned->file = grown;
    murk_owned_file *file = &owned->file[owned->n];
    *file = (murk_owned_file){
        .name = strdup(name), .json = json, .is_earlier = is_earlier};
    if (file->name) {
        snprintf(file->sum, sizeof file->sum, "%s", sum);
        ++owned->n;
    }
}

/* Adds the files of one list of a main JSON; json and is_earlier as in
 * murk_owned_file. */
static void add_files(murk_owned *owned, const cJSON *list, int json,
                      bool is_earlier)
{
    const cJSON *file;
    cJSON_ArrayForEach(file, list)
    {
        if (cJSON_IsString(file)) {
            add_file(owned, file->string, file->valuestring, json, is_earlier);
        }
    }
}

static void add_json(murk_owned *owned, const char *folder, int json,
                     bool is_left)
{
    char *text = NULL;
    char *path = murk_path_join(folder, murk_main_jsons[json]);
    cJSON *root = path ? read_json(path, &text) : NULL;
    if (root && cJSON_GetObjectItem(root, "identity")) {
        owned->is_newer = true;
    } else if (root) {
        owned->is_older = true;
    }
    const int by = is_left ? -1 : json;
    const cJSON *run = cJSON_GetObjectItem(root, "run");
    add_files(owned, cJSON_GetObjectItem(root, "files"), by, false);
    add_files(owned, cJSON_GetObjectItem(run, "earlier"), by, true);
    cJSON_Delete(root);
    free(text);
    free(path);
}

static void add_leftover(void *context, const char *folder)
{
    for (int i = 0; murk_main_jsons[i]; ++i) {
        add_json(context, folder, i, true);
    }
}

void murk_owned_read(murk_owned *owned, const char *folder)
{
    if (owned->is_read) {
        return;
    }
    for (int i = 0; murk_main_jsons[i]; ++i) {
        add_json(owned, folder, i, false);
    }
    murk_staging_visit(folder, add_leftover, owned);
    owned->is_read = true;
}

static bool is_listed(const murk_owned *owned, const char *name,
                      const char *sum)
{
    for (size_t i = 0; i < owned->n; ++i) {
        if (strcmp(owned->file[i].name, name) == 0 &&
            strcmp(owned->file[i].sum, sum) == 0) {
            return true;
        }
    }
    return false;
}

bool murk_owned_is_json(const char *name)
{
    const size_t length = strlen(name);
    return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

bool murk_owned_has(murk_owned *owned, const char *folder, const char *name)
{
    murk_owned_read(owned, folder);
    char sum[65];
    char *path = murk_path_join(folder, name);
    const bool has = path && (owned->is_older && !owned->is_newer ? true
                              : murk_owned_is_json(name)
                                  ? is_own_json(path)
                                  : !murk_file_sha256(path, sum, NULL) &&
                                        is_listed(owned, name, sum));
    free(path);
    return has;
}

bool murk_owned_is_there(const char *folder, const murk_owned_file *file)
{
    char sum[65];
    char *path = murk_path_join(folder, file->name);
    const bool is_there = path && !murk_file_sha256(path, sum, NULL) &&
                          strcmp(sum, file->sum) == 0;
    free(path);
    return is_there;
}

murk_belonging murk_owned_belonging(const char *path)
{
    murk_owned owned = {0};
    murk_belonging found = MURK_UNLISTED;
    const char *name = murk_path_name(path);
    char *folder = murk_path_beside(path, ".");
    for (int i = 0; folder && murk_main_jsons[i]; ++i) {
        add_json(&owned, folder, i, false);
    }
    char sum[65] = "";
    for (size_t i = 0; i < owned.n && found != MURK_LISTED; ++i) {
        if (strcmp(owned.file[i].name, name) != 0 ||
            (!sum[0] && murk_file_sha256(path, sum, NULL))) {
            continue;
        }
        const bool is_same = strcmp(owned.file[i].sum, sum) == 0;
        found = is_same && !owned.file[i].is_earlier ? MURK_LISTED
                                                     : MURK_OF_ANOTHER_RUN;
    }
    free(folder);
    murk_owned_release(&owned);
    return found;
}

void murk_owned_release(murk_owned *owned)
{
    for (size_t i = 0; i < owned->n; ++i) {
        free(owned->file[i].name);
    }
    free(owned->file);
    *owned = (murk_owned){0};
}
