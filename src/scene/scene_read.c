/* Reads a scene: parses the text, applies overrides and a variant, checks and
 * resolves the tree by the key table, resolves each condition in the same way,
 * prints the resolved scene and the texts by which results are recognised
 * (light_key, rules_key, world_key, whole_key), and moves the scene to the
 * local origin. */
#include "scene/scene.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/log.h"
#include "base/memory_files.h"
#include "base/number.h"
#include "scene/conditions.h"
#include "scene/ground.h"
#include "scene/idle.h"
#include "scene/light_source.h"
#include "scene/medium_preset.h"
#include "scene/origin.h"
#include "scene/override.h"
#include "scene/print.h"
#include "scene/timeline.h"
#include "scene/value.h"
#include "scene/variant.h"
#include "scene/walk.h"
#include "scene/weather.h"

/* The data that live as long as the tree. */
typedef struct reading {
    char *text;
    size_t size;
    murk_yaml *root;
    char **sources; /* [n_sources] texts of the options */
    size_t n_sources;
    murk_key_reader walk;
} reading;

static void release(reading *r)
{
    murk_yaml_destroy(r->root);
    for (size_t i = 0; i < r->n_sources; ++i) {
        free(r->sources[i]);
    }
    free(r->sources);
    free(r->walk.paths);
    free(r->text);
}

static murk_status no_memory(const char *path, murk_error *err)
{
    return murk_no_memory(err, path, "for the scene");
}

static murk_status apply_overrides(reading *r, const char *path,
                                   const murk_override *overrides,
                                   size_t n_overrides, murk_error *err)
{
    if (n_overrides == 0) {
        return MURK_OK;
    }
    r->sources = calloc(n_overrides, sizeof *r->sources);
    if (!r->sources) {
        return no_memory(path, err);
    }
    for (size_t i = 0; i < n_overrides; ++i) {
        r->sources[i] = murk_override_source(&overrides[i]);
        if (!r->sources[i]) {
            return no_memory(path, err);
        }
        ++r->n_sources;
        const murk_status status =
            murk_override_apply(r->root, &overrides[i], r->sources[i], err);
        if (status) {
            return status;
        }
    }
    return MURK_OK;
}

/* ---- files of the scene ---- */

/* Replaces "//" and "/./" in a path by "/", in place. */
static void tidy(char *path)
{
    char *to = path;
    for (const char *from = path; *from; ++from) {
        if (from[0] == '/' && from[1] == '/') {
            continue;
        }
        if (from[0] == '/' && from[1] == '.' && from[2] == '/') {
            ++from;
            continue;
        }
        *to++ = *from;
    }
    *to = '\0';
}

/* The absolute path without "//" and "/./". A relative path stays relative if
 * it is that of a file in memory, or if the working folder is unknown. The
 * caller frees the path; NULL when out of memory. */
static char *absolute(const char *path)
{
    char folder[PATH_MAX];
    const bool is_whole = path[0] == '/' || murk_memory_is(path) ||
                          !getcwd(folder, sizeof folder);
    char *out = is_whole ? strdup(path) : murk_path_join(folder, path);
    if (out) {
        tidy(out);
    }
    return out;
}

static murk_status make_absolute(murk_yaml *node)
{
    char *opened = murk_value_opened(node);
    char *full = opened ? absolute(opened) : NULL;
    const bool is_set = full && murk_yaml_set_text(node, full);
    free(opened);
    free(full);
    return is_set ? MURK_OK : MURK_NO_MEMORY;
}

static bool is_of_light(const char *key)
{
    const murk_key *row = murk_keys_find(&murk_scene_keys, key);
    return row && row->lights;
}

static bool is_of_world(const char *key)
{
    return is_of_light(key) && strcmp(key, "lights") != 0 &&
           strcmp(key, "site") != 0 && strcmp(key, "weather") != 0;
}

static bool is_of_rules(const char *key)
{
    static const char *const others[] = {
        "lights",     "site",    "weather",  "geometry", "materials",
        "media",      "regions", "timeline", "sensors",  "placement",
        "conditions", "cameras", "units"};
    bool is_other = false;
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i) {
        is_other = is_other || strcmp(key, others[i]) == 0;
    }
    return !is_other;
}

/* Prints the resolved scene with absolute paths, and lists the files. The paths
 * in the tree stay absolute until print_keys() replaces them by names of files.
 */
static murk_status print_resolved(const murk_key_reader *walk,
                                  murk_scene_desc *scene)
{
    scene->file = calloc(walk->n_paths + 1, sizeof *scene->file);
    if (!scene->file) {
        return MURK_NO_MEMORY;
    }
    for (size_t i = 0; i < walk->n_paths; ++i) {
        if (make_absolute(walk->paths[i]) ||
            !(scene->file[i] = strdup(walk->paths[i]->text))) {
            return MURK_NO_MEMORY;
        }
        ++scene->files;
    }
    scene->resolved = murk_print_file(walk->root, NULL);
    return scene->resolved ? MURK_OK : MURK_NO_MEMORY;
}

/* True for all top-level keys but `conditions`: print_key() adds the whole_key
 * of each condition instead. */
static bool is_of_base(const char *key)
{
    return strcmp(key, "conditions") != 0;
}

/* Prints the top-level keys of the tree for which is_wanted() is true, the
 * properties computed from presets, the time if clocks are read at another time
 * than the site has, and with has_conditions the whole_key of each condition.
 * Returns the text; NULL when out of memory. */
static char *print_key(const murk_key_reader *walk,
                       const murk_scene_desc *scene,
                       bool (*is_wanted)(const char *key), bool has_conditions)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    murk_print_map(out, walk->root, is_wanted);
    if (is_wanted("media")) {
        murk_medium_preset_sign(out, scene);
    }
    if (is_wanted("lights")) {
        murk_light_source_sign(out, scene);
        murk_weather_sign(out, scene);
    }
    if (is_wanted("geometry") && scene->timeline.given) {
        fprintf(out, "rounding of the domain\n"); /* world/stage_build.c */
    }
    if (is_wanted("geometry") && murk_scene_has_ground(scene)) {
        /* The site is the middle of the map. */
        fprintf(out, "ground about %.17g %.17g at %.17g m\n",
                scene->site.latitude_deg, scene->site.longitude_deg,
                scene->site.altitude_m);
    }
    if (is_wanted("site") && scene->timeline.given &&
        murk_idle_asks_time(scene)) {
        fprintf(out, "at %.17g s\n", scene->timeline.at_s);
    }
    for (size_t i = 0; i < scene->n_conditions && has_conditions; ++i) {
        const murk_scene_condition *condition = &scene->conditions[i];
        fprintf(out, "condition %s\n%s", condition->name,
                condition->scene->whole_key);
    }
    return murk_print_finish(out, &text);
}

/* Sets light_key, rules_key, world_key and whole_key of the scene, the texts by
 * which results are recognised. Paths are replaced by names of files, so that a
 * scene that moves with its files keeps these texts. */
static murk_status print_keys(const murk_key_reader *walk,
                              murk_scene_desc *scene)
{
    for (size_t i = 0; i < walk->n_paths; ++i) {
        murk_yaml *node = walk->paths[i];
        if (!murk_yaml_set_text(node, murk_path_name(node->text))) {
            return MURK_NO_MEMORY;
        }
    }
    scene->light_key = print_key(walk, scene, is_of_light, false);
    scene->rules_key = print_key(walk, scene, is_of_rules, false);
    scene->world_key = print_key(walk, scene, is_of_world, false);
    scene->whole_key = print_key(walk, scene, is_of_base, true);
    return scene->light_key && scene->rules_key && scene->world_key &&
                   scene->whole_key
               ? MURK_OK
               : MURK_NO_MEMORY;
}

/* ---- scenes ---- */

static murk_scene_desc *scene_make(const char *path, const char sha256[65])
{
    murk_scene_desc *scene = calloc(1, sizeof *scene);
    if (scene) {
        memcpy(scene->sha256, sha256, sizeof scene->sha256);
        scene->path = strdup(path);
    }
    if (scene && !scene->path) {
        free(scene);
        scene = NULL;
    }
    return scene;
}

/* Reads the scene of a condition from the tree as the user gave it. The
 * values of the condition are replaced by the resolved ones in the tree
 * `root` of the base scene. */
static murk_status read_condition(murk_scene_condition *condition,
                                  const murk_scene_desc *base, murk_yaml *root,
                                  const murk_yaml *given, murk_error *err)
{
    murk_condition_values values = {0};
    murk_yaml *tree = murk_yaml_copy(given);
    condition->scene = scene_make(base->path, base->sha256);
    murk_key_reader walk = {
        .scene = condition->scene, .root = tree, .err = err};
    murk_status status =
        tree && condition->scene
            ? murk_condition_apply(&values, tree, condition->name, err)
            : no_memory(base->path, err);
    if (!status) {
        status = murk_timeline_apply(
            tree,
            murk_yaml_get(murk_yaml_get(given, "conditions"), condition->name),
            err);
    }
    if (status) {
        goto done;
    }
    /* Resolve the tree of the condition; keys in messages begin with
     * conditions.NAME. */
    memcpy(condition->scene->where, condition->where, sizeof condition->where);
    murk_walk_enter(&walk, "conditions");
    murk_walk_enter(&walk, condition->name);
    status = murk_walk_root(&walk, &murk_scene_keys, condition->scene);
    /* Print, and write the resolved values back before paths are shortened. */
    if (!status && (print_resolved(&walk, condition->scene) ||
                    !murk_condition_put_back(root, condition->name, &values) ||
                    print_keys(&walk, condition->scene))) {
        status = no_memory(base->path, err);
    }
done:
    free(values.value);
    free(walk.paths);
    murk_yaml_destroy(tree);
    return status;
}

/* Resolves the tree, and the tree of each condition. */
static murk_status read_tree(reading *r, murk_scene_desc *scene,
                             murk_error *err)
{
    murk_status status = MURK_OK;
    murk_yaml *given =
        NULL; /* the tree before it is resolved, if there are conditions */
    if (murk_yaml_get(r->root, "murk_study")) {
        return murk_fail(err, MURK_BAD_FILE, scene->path,
                         "is a study, must be a scene; murk study runs it");
    }
    status = murk_timeline_add_conditions(&scene->are_conditions_steps, r->root,
                                          err);
    if (status) {
        return status;
    }
    if (murk_yaml_get(r->root, "conditions")) {
        given = murk_yaml_copy(r->root);
        if (!given) {
            return no_memory(scene->path, err);
        }
    }
    r->walk = (murk_key_reader){.scene = scene, .root = r->root, .err = err};
    status = murk_timeline_apply(r->root, NULL, err);
    if (!status) {
        status = murk_walk_root(&r->walk, &murk_scene_keys, scene);
    }
    for (size_t i = 0; !status && i < scene->n_conditions; ++i) {
        status =
            read_condition(&scene->conditions[i], scene, r->root, given, err);
    }
    murk_yaml_destroy(given);
    if (!status && !murk_idle_find(scene, r->root)) {
        status = no_memory(scene->path, err);
    }
    if (!status &&
        (print_resolved(&r->walk, scene) || print_keys(&r->walk, scene))) {
        status = no_memory(scene->path, err);
    }
    return status;
}

/* Applies a variant to the tree: the condition, then the changes. */
static murk_status apply_variant(reading *r, const murk_variant *variant,
                                 murk_error *err)
{
    murk_status status = murk_condition_leave(r->root, variant->condition, err);
    murk_yaml **own = calloc(variant->n + 1, sizeof *own);
    if (!status && !own) {
        status = no_memory(r->root->source, err);
    }
    for (size_t i = 0; !status && i < variant->n; ++i) {
        const murk_key_change *change = &variant->change[i];
        own[i] = murk_yaml_copy(change->value);
        status = own[i] ? murk_override_put(r->root, change->path, own[i],
                                            change->where, own, i, err)
                        : no_memory(r->root->source, err);
    }
    free(own);
    return status;
}

/* Takes the site from the ground of the scene before it is changed: variants,
 * conditions and steps with other files have the same x and y. */
static murk_status complete_site(reading *r, murk_error *err)
{
    r->walk = (murk_key_reader){.root = r->root, .err = err};
    return murk_ground_complete(&r->walk, r->root);
}

/* Reads the scene from r->text; variant NULL: the scene as it stands. */
static murk_status read_text(reading *r, murk_scene_desc **out,
                             const char *path, const murk_override *overrides,
                             size_t n_overrides, const murk_variant *variant,
                             murk_error *err)
{
    murk_scene_desc *scene = NULL;
    char sha256[65];
    murk_status status = murk_yaml_parse(&r->root, r->text, r->size, path, err);
    if (status ||
        (status = apply_overrides(r, path, overrides, n_overrides, err)) ||
        (status = complete_site(r, err)) ||
        (variant && (status = apply_variant(r, variant, err)))) {
        goto done;
    }
    /* Check and resolve the tree, then move the scene to the local origin. */
    murk_sha256_hex(r->text, r->size, sha256);
    scene = scene_make(path, sha256);
    status = scene ? read_tree(r, scene, err) : no_memory(path, err);
    if (status) {
        goto done;
    }
    murk_origin_move(scene);
    murk_timeline_finish(scene);
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        murk_timeline_finish(scene->conditions[i].scene);
    }
    *out = scene;
    scene = NULL;
done:
    murk_scene_desc_destroy(scene);
    return status;
}

murk_status
murk_scene_desc_read_variant(murk_scene_desc **out, const char *path,
                             const murk_override *overrides, size_t n_overrides,
                             const murk_variant *variant, murk_error *err)
{
    reading r = {0};
    murk_status status =
        murk_file_read(&r.text, &r.size, path, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        status = read_text(&r, out, path, overrides, n_overrides, variant, err);
    }
    release(&r);
    return status;
}

murk_status murk_scene_desc_read(murk_scene_desc **out, const char *path,
                                 const murk_override *overrides,
                                 size_t n_overrides, murk_error *err)
{
    return murk_scene_desc_read_variant(out, path, overrides, n_overrides, NULL,
                                        err);
}

murk_status murk_scene_desc_parse_variant(murk_scene_desc **out,
                                          const char *text, const char *path,
                                          const murk_override *overrides,
                                          size_t n_overrides,
                                          const murk_variant *variant,
                                          murk_error *err)
{
    reading r = {.text = strdup(text), .size = strlen(text)};
    const murk_status status =
        r.text ? read_text(&r, out, path, overrides, n_overrides, variant, err)
               : no_memory(path, err);
    release(&r);
    return status;
}

murk_status murk_scene_desc_parse(murk_scene_desc **out, const char *text,
                                  const char *path,
                                  const murk_override *overrides,
                                  size_t n_overrides, murk_error *err)
{
    return murk_scene_desc_parse_variant(out, text, path, overrides,
                                         n_overrides, NULL, err);
}

murk_status murk_scene_desc_read_at(murk_scene_desc **out,
                                    const murk_scene_desc *scene, double t_s,
                                    murk_error *err)
{
    static const murk_variant alone = {.condition = NULL};
    char text[64] = "timeline.at_s=";
    murk_number_print(text + strlen(text), t_s);
    const murk_override at = {text, NULL};
    const bool was_silent = murk_warn_quiet(true);
    const murk_status status = murk_scene_desc_parse_variant(
        out, scene->resolved, scene->path, &at, 1, &alone, err);
    murk_warn_quiet(was_silent);
    return status;
}
