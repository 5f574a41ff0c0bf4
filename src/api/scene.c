/* Scenes: a text, the keys that the caller sets, and arrays in memory. Text,
 * keys and arrays are read anew by each call that needs the scene, so a scene
 * may be changed at any time. */
#include "api/scene.h"

#include "base/file.h"
#include "base/log.h"
#include "lightmap/lightmap.h"
#include "scene/key_path.h"
#include "scene/yaml.h"
#include "world/units.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- making ---- */

/* Takes ownership of the text. */
static murk_status make(murk_scene **out, murk_context *context, char *text,
                        const char *name, murk_error *err)
{
    murk_scene *scene = calloc(1, sizeof *scene);
    char *copy = strdup(name);
    if (!scene || !copy || !text) {
        free(scene);
        free(copy);
        free(text);
        return murk_no_memory(err, name, "for the scene");
    }
    scene->references = 1;
    scene->context = context;
    ++context->references;
    scene->name = copy;
    scene->text = text;
    *out = scene;
    return MURK_OK;
}

/* Takes ownership of the text, which is checked as YAML. */
static murk_status make_checked(murk_scene **out, murk_context *context,
                                char *text, size_t size, const char *name,
                                murk_error *err)
{
    murk_yaml *root = NULL;
    murk_status status = murk_yaml_parse(&root, text, size, name, err);
    murk_yaml_destroy(root);
    if (status) {
        free(text);
        return status;
    }
    return make(out, context, text, name, err);
}

murk_status murk_scene_create(murk_scene **out, murk_context *context,
                              murk_error *error)
{
    return murk_scene_parse(out, context, MURK_EMPTY_SCENE, "scene", error);
}

murk_status murk_scene_parse(murk_scene **out, murk_context *context,
                             const char *text, const char *name,
                             murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !context || !text) {
        return murk_call_refuse(error, "out, context or text is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, error);
    char *copy = strdup(text);
    return murk_call_end(
        &call, copy ? make_checked(out, context, copy, strlen(copy),
                                   name ? name : "scene", &call.failure)
                    : MURK_NO_MEMORY);
}

murk_status murk_scene_read(murk_scene **out, murk_context *context,
                            const char *path, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !context || !path) {
        return murk_call_refuse(error, "out, context or path is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, error);
    char *text = NULL;
    size_t size = 0;
    murk_status status =
        murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, &call.failure);
    if (!status) {
        status = make_checked(out, context, text, size, path, &call.failure);
    }
    if (!status) {
        (*out)->is_file = true;
    }
    return murk_call_end(&call, status);
}

void murk_scene_release(murk_scene *scene)
{
    if (!scene || --scene->references > 0) {
        return;
    }
    for (size_t i = 0; i < scene->n; ++i) {
        murk_override_release(&scene->set[i]);
    }
    free(scene->set);
    murk_memory_release(&scene->files);
    free(scene->resolved);
    cJSON_free(scene->value);
    free(scene->text);
    free(scene->name);
    murk_context_release(scene->context);
    free(scene);
}

void murk_scene_destroy(murk_scene *scene)
{
    murk_scene_release(scene);
}

/* ---- keys ---- */

static murk_status add_key(murk_scene *scene, const char *key,
                           const char *value, murk_error *err)
{
    murk_override *grown =
        realloc(scene->set, (scene->n + 1) * sizeof *scene->set);
    if (!grown) {
        return murk_no_memory(err, key, "for the key");
    }
    scene->set = grown;
    murk_status status =
        murk_override_make(&scene->set[scene->n], key, value, err);
    if (status) {
        return status;
    }
    /* Apply all keys to the tree, which finds errors of path and value. */
    murk_yaml *root = NULL;
    status = murk_yaml_parse(&root, scene->text, strlen(scene->text),
                             scene->name, err);
    for (size_t i = 0; !status && i <= scene->n; ++i) {
        status = murk_override_apply(root, &scene->set[i], scene->set[i].option,
                                     err);
    }
    murk_yaml_destroy(root);
    if (status) {
        murk_override_release(&scene->set[scene->n]);
        return status;
    }
    ++scene->n;
    return MURK_OK;
}

murk_status murk_scene_set(murk_scene *scene, const char *key,
                           const char *value, murk_error *error)
{
    if (!scene || !key || !value) {
        return murk_call_refuse(error, "scene, key or value is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return murk_call_end(&call, add_key(scene, key, value, &call.failure));
}

/* True if the caller has set this key, or a map that contains the key. */
static bool is_set(const murk_scene *scene, const char *key)
{
    for (size_t i = 0; i < scene->n; ++i) {
        const char *text = scene->set[i].text;
        const size_t length = strcspn(text, "=");
        if (strncmp(text, key, length) == 0 &&
            (key[length] == '\0' || key[length] == '.')) {
            return true;
        }
    }
    return false;
}

static murk_status use_light(murk_scene *scene, const char *path,
                             murk_error *err)
{
    murk_lightmap_counts counts;
    char number[32];
    murk_status status = murk_lightmap_read_counts(&counts, path, err);
    const bool has_number = !status && (counts.emit || counts.store) &&
                            !is_set(scene, "photons.emit") &&
                            !is_set(scene, "photons.store");
    if (!status && !is_set(scene, "seed")) {
        snprintf(number, sizeof number, "%lu", (unsigned long)counts.seed);
        status = add_key(scene, "seed", number, err);
    }
    if (!status && has_number) {
        snprintf(
            number, sizeof number, "%llu",
            (unsigned long long)(counts.emit ? counts.emit : counts.store));
        status = add_key(scene, counts.emit ? "photons.emit" : "photons.store",
                         number, err);
    }
    return status;
}

murk_status murk_scene_use_light(murk_scene *scene, const char *path,
                                 murk_error *error)
{
    if (!scene || !path) {
        return murk_call_refuse(error, "scene or path is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return murk_call_end(&call, use_light(scene, path, &call.failure));
}

murk_status murk_scene_describe(murk_scene_desc **out, const murk_scene *scene,
                                murk_error *err)
{
    return murk_scene_desc_parse(out, scene->text, scene->name, scene->set,
                                 scene->n, err);
}

void murk_scene_tell(const murk_scene_desc *scene)
{
    murk_units_note(scene);
    for (size_t i = 0; i < scene->idles; ++i) {
        murk_warn(scene->idle[i].where, "%s", scene->idle[i].text);
    }
}

murk_status murk_scene_check(murk_scene *scene, murk_error *error)
{
    const char *text = NULL;
    return murk_scene_resolved(scene, &text, error);
}

murk_status murk_scene_resolved(murk_scene *scene, const char **text,
                                murk_error *error)
{
    if (!scene || !text) {
        return murk_call_refuse(error, "scene or text is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    murk_scene_desc *desc = NULL;
    const murk_status status = murk_scene_describe(&desc, scene, &call.failure);
    free(scene->resolved);
    scene->resolved = NULL;
    if (desc) { /* the text is taken over */
        scene->resolved = desc->resolved;
        desc->resolved = NULL;
    }
    murk_scene_desc_destroy(desc);
    *text = scene->resolved;
    return murk_call_end(&call, status);
}

/* ---- values ---- */

/* A scalar as JSON: null, true, false or a number if the scalar has the form of
 * one (scene/yaml.h), else a string. */
static cJSON *json_of_scalar(const murk_yaml *node)
{
    double number = 0;
    bool is_true = false;
    return murk_yaml_is_null(node)           ? cJSON_CreateNull()
           : murk_yaml_bool(node, &is_true)  ? cJSON_CreateBool(is_true)
           : murk_yaml_number(node, &number) ? cJSON_CreateNumber(number)
                                             : cJSON_CreateString(node->text);
}

static cJSON *json_of(const murk_yaml *node)
{
    if (node->kind == MURK_YAML_SCALAR) {
        return json_of_scalar(node);
    }
    const bool is_map = node->kind == MURK_YAML_MAP;
    cJSON *all = is_map ? cJSON_CreateObject() : cJSON_CreateArray();
    for (size_t i = 0; i < node->n; ++i) {
        if (is_map) {
            cJSON_AddItemToObject(all, node->key[i], json_of(node->child[i]));
        } else {
            cJSON_AddItemToArray(all, json_of(node->child[i]));
        }
    }
    return all;
}

static murk_status get(murk_scene *scene, const char *key, const char **json,
                       murk_error *err)
{
    murk_scene_desc *desc = NULL;
    murk_yaml *root = NULL;
    murk_status status = murk_scene_describe(&desc, scene, err);
    if (!status) {
        status = murk_yaml_parse(&root, desc->resolved, strlen(desc->resolved),
                                 scene->name, err);
    }
    const murk_yaml *node = status ? NULL : murk_key_path_find(root, key).node;
    if (!status && !node) {
        char where[sizeof err->where];
        snprintf(where, sizeof where, "%s: %s", scene->name, key);
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "the resolved scene has no such key");
    }
    /* Keep the text for the caller until the next murk_scene_get(). */
    cJSON *value = node ? json_of(node) : NULL;
    cJSON_free(scene->value);
    scene->value = value ? cJSON_PrintUnformatted(value) : NULL;
    cJSON_Delete(value);
    if (!status && !scene->value) {
        status = murk_no_memory(err, key, "for the value");
    }
    *json = scene->value;
    murk_yaml_destroy(root);
    murk_scene_desc_destroy(desc);
    return status;
}

murk_status murk_scene_get(murk_scene *scene, const char *key,
                           const char **json, murk_error *error)
{
    if (!scene || !key || !json) {
        return murk_call_refuse(error, "scene, key or json is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return murk_call_end(&call, get(scene, key, json, &call.failure));
}
