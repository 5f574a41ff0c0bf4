#include "scene/scene.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "scene/override.h"
#include "scene/print.h"
#include "scene/walk.h"

/* What lives as long as the tree does. */
typedef struct reading {
    char *text;
    size_t size;
    murk_yaml *root;
    char **sources; /* [n_sources] of the options */
    size_t n_sources;
    murk_walk walk;
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
    return murk_fail(err, MURK_NO_MEMORY, path, "no memory for the scene");
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

/* Drops "//" and "/./" in place. */
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

static char *absolute(const char *path)
{
    char folder[PATH_MAX] = "";
    if (path[0] != '/' && !getcwd(folder, sizeof folder)) {
        return strdup(path); /* no such folder any more: as it was given */
    }
    const size_t size = strlen(folder) + strlen(path) + 2;
    char *out = malloc(size);
    if (out) {
        snprintf(out, size, "%s%s%s", folder, path[0] == '/' ? "" : "/", path);
        tidy(out);
    }
    return out;
}

/* The name alone: a scene may move with its files. */
static murk_status drop_folder(murk_yaml *node)
{
    const char *slash = strrchr(node->text, '/');
    char *name = strdup(slash ? slash + 1 : node->text);
    const bool is_set = name && murk_yaml_set_text(node, name);
    free(name);
    return is_set ? MURK_OK : MURK_NO_MEMORY;
}

static murk_status make_absolute(murk_yaml *node, const murk_yaml *root,
                                 const char *scene_path)
{
    char *opened = node->source == root->source
                       ? murk_path_beside(scene_path, node->text)
                       : strdup(node->text);
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

/* The texts that need the tree. Paths are rewritten on the way: first as the
 * resolved scene has them, then as the light's key does. */
static murk_status print_texts(reading *r, murk_scene *scene)
{
    for (size_t i = 0; i < r->walk.n_paths; ++i) {
        if (make_absolute(r->walk.paths[i], r->root, scene->path)) {
            return MURK_NO_MEMORY;
        }
    }
    scene->resolved = murk_print_file(r->root, NULL);
    for (size_t i = 0; i < r->walk.n_paths; ++i) {
        if (drop_folder(r->walk.paths[i])) {
            return MURK_NO_MEMORY;
        }
    }
    scene->light_key = murk_print_file(r->root, is_of_light);
    return scene->resolved && scene->light_key ? MURK_OK : MURK_NO_MEMORY;
}

murk_status murk_scene_read(murk_scene **out, const char *path,
                            const murk_override *overrides, size_t n_overrides,
                            murk_error *err)
{
    reading r = {0};
    murk_scene *scene = NULL;
    murk_status status =
        murk_file_read(&r.text, &r.size, path, MURK_YAML_MOST_BYTES, err);
    if (status ||
        (status = murk_yaml_parse(&r.root, r.text, r.size, path, err)) ||
        (status = apply_overrides(&r, path, overrides, n_overrides, err))) {
        goto done;
    }
    scene = calloc(1, sizeof *scene);
    if (!scene || !(scene->path = strdup(path))) {
        status = no_memory(path, err);
        goto done;
    }
    murk_sha256_hex(r.text, r.size, scene->sha256);
    r.walk.scene = scene;
    r.walk.root = r.root;
    r.walk.err = err;
    status = murk_walk_scene(&r.walk);
    if (status) {
        goto done;
    }
    status = print_texts(&r, scene);
    if (status) {
        no_memory(path, err);
        goto done;
    }
    *out = scene;
    scene = NULL;
done:
    murk_scene_destroy(scene);
    release(&r);
    return status;
}

void murk_scene_destroy(murk_scene *scene)
{
    if (!scene) {
        return;
    }
    for (size_t i = 0; i < scene->geometries; ++i) {
        free(scene->geometry[i].file);
    }
    for (size_t i = 0; i < scene->n_media; ++i) {
        free(scene->media[i].vdb);
        free(scene->media[i].grid);
        free(scene->media[i].albedo_vdb);
        free(scene->media[i].albedo_grid);
        free(scene->media[i].vdb_frames);
        free(scene->media[i].profile_z_m.value);
        free(scene->media[i].profile_per_m.value);
        for (size_t k = 0; k < scene->media[i].n_phases; ++k) {
            free(scene->media[i].phase[k].table);
        }
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        free(scene->regions[i].mesh);
    }
    free(scene->geometry);
    free(scene->materials);
    free(scene->media);
    free(scene->regions);
    free(scene->lights);
    free(scene->tallies);
    free(scene->resolved);
    free(scene->light_key);
    free(scene->path);
    free(scene);
}
