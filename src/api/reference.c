/* The reference of keys, the JSON Schema and the facts of the build, as fields
 * by the name of what is asked for. */
#include "api/save.h"

#include "reference/entries.h"
#include "reference/schema.h"
#include "results/version.h"

#include <stdio.h>
#include <string.h>

static cJSON *version_json(void)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "version", MURK_VERSION);
    cJSON_AddStringToObject(root, "commit", murk_version_commit());
    cJSON_AddStringToObject(root, "date", murk_version_date());
    cJSON_AddStringToObject(root, "compiler", murk_version_compiler());
    cJSON *packages = cJSON_AddObjectToObject(root, "packages");
    for (size_t i = 0; i < murk_packages_count; ++i) {
        cJSON_AddStringToObject(packages, murk_packages[i].name,
                                murk_packages[i].version);
    }
    return root;
}

/* Makes the JSON of a name. */
static murk_status make(cJSON **out, const char *name, murk_error *err)
{
    static const struct {
        const char *name;
        const murk_keys *keys;
    } files[] = {{"scene", &murk_scene_keys}, {"study", &murk_study_keys}};
    /* The keys of a file, or one of them. */
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        const size_t length = strlen(files[i].name);
        if (strncmp(name, files[i].name, length) != 0) {
            continue;
        }
        if (name[length] == '.') {
            return murk_reference_one(out, files[i].keys, name + length + 1,
                                      err);
        }
        if (name[length] == '\0') {
            murk_reference_all(out, files[i].keys);
            return MURK_OK;
        }
    }
    /* All other names. */
    *out = strcmp(name, "schema") == 0    ? murk_reference_schema()
           : strcmp(name, "version") == 0 ? version_json()
                                          : NULL;
    return *out ? MURK_OK
                : murk_call_bad_argument(err, "name",
                                         "%.80s, must be scene, scene.KEY, "
                                         "study, study.KEY, schema or version",
                                         name);
}

static murk_status take_reference(murk_fields *fields, const char *name,
                                  murk_error *err)
{
    cJSON *root = NULL;
    const murk_status status = make(&root, name, err);
    return status ? status : murk_fields_take(fields, root, err);
}

/* Says that the place of a failure is a key and no file, though the key is
 * unknown. */
static void name_key(murk_error *failure)
{
    if (failure->code == MURK_BAD_VALUE && failure->file[0]) {
        snprintf(failure->key, sizeof failure->key, "%.*s",
                 (int)sizeof failure->key - 1, failure->where);
        failure->file[0] = '\0';
        failure->line = failure->column = 0;
    }
}

murk_status murk_context_reference(murk_context *context, const char *name,
                                   const murk_fields **fields,
                                   murk_error *error)
{
    if (!context || !name || !fields) {
        return murk_save_refuse(fields, error,
                                "context, name or fields is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, NULL);
    const murk_status status = murk_call_end(
        &call, take_reference(&context->reference, name, &call.failure));
    if (status) {
        name_key(&call.failure);
        murk_call_pass(error, &call.failure);
    }
    *fields = status ? NULL : &context->reference;
    return status;
}
