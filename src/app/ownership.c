#include "app/ownership.h"

#include "app/results.h"
#include "app/results_in.h"
#include "base/staging.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The largest main JSON is a study's; a larger file is not read, and is then
 * the user's. */
#define JSON_BYTES_MAX 1000000000

const char *const murk_main_jsons[] = {
    "plan.json", "coverage.json", "ledger.json", "study.json",
    "fit.json",  "predict.json",  NULL};

/* ---- one JSON ---- */

/* NULL: not there, or no result of murk. */
static cJSON *read_json(const char *path, char **text)
{
    size_t size = 0;
    *text = NULL;
    if (murk_file_read_own(text, &size, path, JSON_BYTES_MAX, NULL)) {
        return NULL;
    }
    cJSON *root = cJSON_ParseWithLength(*text, size);
    if (!cJSON_IsObject(cJSON_GetObjectItem(root, "murk"))) {
        cJSON_Delete(root);
        root = NULL;
    }
    return root;
}

/* Whether it is as murk wrote it, as far as it says. */
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
                     bool is_left)
{
    murk_owned_file *grown =
        realloc(owned->file, (owned->n + 1) * sizeof *grown);
    if (!grown) {
        return; /* not known to be murk's: it stays */
    }
    owned->file = grown;
    murk_owned_file *file = &owned->file[owned->n];
    *file = (murk_owned_file){.name = strdup(name), .is_left = is_left};
    if (file->name) {
        snprintf(file->sum, sizeof file->sum, "%s", sum);
        ++owned->n;
    }
}

static void add_json(murk_owned *owned, const char *folder, const char *name,
                     bool is_left)
{
    char *path = murk_results_path(folder, name), *text = NULL;
    cJSON *root = path ? read_json(path, &text) : NULL;
    if (root && !cJSON_GetObjectItem(root, "identity")) {
        owned->is_older = true;
    }
    const cJSON *file;
    cJSON_ArrayForEach(file, cJSON_GetObjectItem(root, "files"))
    {
        if (cJSON_IsString(file)) {
            add_file(owned, file->string, file->valuestring, is_left);
        }
    }
    cJSON_Delete(root);
    free(text);
    free(path);
}

static void add_leftover(void *context, const char *folder)
{
    for (size_t i = 0; murk_main_jsons[i]; ++i) {
        add_json(context, folder, murk_main_jsons[i], true);
    }
}

static void read_folder(murk_owned *owned, const char *folder)
{
    for (size_t i = 0; murk_main_jsons[i]; ++i) {
        add_json(owned, folder, murk_main_jsons[i], false);
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

static bool ends_in_json(const char *name)
{
    const size_t length = strlen(name);
    return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

bool murk_owned_has(murk_owned *owned, const char *folder, const char *name)
{
    if (!owned->is_read) {
        read_folder(owned, folder);
    }
    char sum[65];
    char *path = murk_results_path(folder, name);
    const bool has =
        path && (owned->is_older      ? true
                 : ends_in_json(name) ? is_own_json(path)
                                      : !murk_file_sha256(path, sum, NULL) &&
                                            is_listed(owned, name, sum));
    free(path);
    return has;
}

murk_belonging murk_owned_look(const char *path)
{
    murk_owned owned = {0};
    murk_belonging found = MURK_UNLISTED;
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    char *folder = murk_path_beside(path, ".");
    for (size_t i = 0; folder && murk_main_jsons[i]; ++i) {
        add_json(&owned, folder, murk_main_jsons[i], false);
    }
    char sum[65] = "";
    for (size_t i = 0; i < owned.n && found != MURK_LISTED; ++i) {
        if (strcmp(owned.file[i].name, name) != 0 ||
            (!sum[0] && murk_file_sha256(path, sum, NULL))) {
            continue;
        }
        found = strcmp(owned.file[i].sum, sum) == 0 ? MURK_LISTED
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
