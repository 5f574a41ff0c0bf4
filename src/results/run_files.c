/* Lists the files of a run in its main JSON, so that later runs and readers
 * know which files of the folder belong to which run (results/ownership.h). */
#include "results/run_files.h"

#include "base/file.h"
#include "results/ownership.h"

#include <string.h>

static bool is_json(const char *name)
{
    const size_t length = strlen(name);
    return length > 5 && strcmp(name + length - 5, ".json") == 0;
}

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
            const char *file = murk_path_name(results->file[i].path);
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

void murk_json_file(cJSON *root, const char *path)
{
    cJSON *files = cJSON_GetObjectItem(root, "files");
    files = files ? files : cJSON_AddObjectToObject(root, "files");
    char sum[65];
    if (path && !murk_file_sha256(path, sum, NULL)) {
        cJSON_AddStringToObject(files, murk_path_name(path), sum);
    }
}
