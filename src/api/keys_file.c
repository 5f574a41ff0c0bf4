/* Reads a file of lines KEY: VALUE, such as calibrated.yaml of a fit, and lists
 * its keys as fields. The file is YAML whose values are numbers or words. */
#include "api/save.h"

#include "base/file.h"
#include "base/log.h"
#include "results/fit.h"
#include "scene/yaml.h"

#include <stdlib.h>

static murk_status add_key(cJSON *keys, const murk_yaml *map, size_t i,
                           murk_error *err)
{
    const murk_yaml *node = map->child[i];
    if (node->kind != MURK_YAML_SCALAR || node->is_quoted) {
        char where[320];
        murk_yaml_key_place(node, where, sizeof where);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s: must be a number or a word: the file has one "
                         "KEY: VALUE a line",
                         map->key[i]);
    }
    cJSON *item = murk_json_item(keys);
    return cJSON_AddStringToObject(item, "key", map->key[i]) &&
                   cJSON_AddStringToObject(item, "value", node->text)
               ? MURK_OK
               : murk_no_memory(err, "", "for the keys of a file");
}

/* Adds the list `keys` to the object `root`. */
static murk_status list_keys(cJSON *root, const char *path, const char *text,
                             size_t size, murk_error *err)
{
    murk_yaml *map = NULL;
    murk_status status = murk_yaml_parse(&map, text, size, path, err);
    if (!status && map->kind != MURK_YAML_MAP) {
        status = murk_fail(err, MURK_BAD_FILE, path,
                           "must be a map of KEY: VALUE, as calibrated.yaml");
    }
    cJSON *keys = cJSON_AddArrayToObject(root, "keys");
    if (!status && !keys) {
        status = murk_no_memory(err, path, "for its keys");
    }
    for (size_t i = 0; !status && i < map->n; ++i) {
        status = add_key(keys, map, i, err);
    }
    murk_yaml_destroy(map);
    return status;
}

static murk_status read_keys(murk_fields *fields, const char *path,
                             murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    cJSON *root = cJSON_CreateObject();
    murk_status status =
        murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        status = list_keys(root, path, text, size, err);
    }
    if (!status && murk_fit_refused_values(text)) {
        murk_warn(path, "%s", MURK_REFUSED_VALUES);
    }
    free(text);
    if (status) {
        cJSON_Delete(root);
        return status;
    }
    return murk_fields_take(fields, root, err);
}

murk_status murk_context_read_keys(murk_context *context, const char *path,
                                   const murk_fields **fields,
                                   murk_error *error)
{
    if (!context || !path || !fields) {
        return murk_save_refuse(fields, error,
                                "context, path or fields is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, error);
    const murk_status status =
        murk_call_end(&call, read_keys(&context->keys, path, &call.failure));
    *fields = status ? NULL : &context->keys;
    return status;
}
