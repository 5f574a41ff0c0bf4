/* Keys of the rows of a study: hashes of everything that the light, the
 * placement or the whole row depends on. Rows of equal world keys are a group:
 * their light differs at most in the power of the light sources, so it is
 * traced once (lightmap/scaled_light.h). A stored row is valid as long as the
 * key of the row is the same. */
#include "cases/sweep_keys.h"

#include "base/file.h"
#include "cases/row_tallies.h"
#include "scene/print.h"
#include "scene/yaml.h"
#include "world/source_shapes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for a row");
}

/* What the keys of a row are made from. */
typedef struct signing {
    const murk_scene_desc *scene;
    const murk_outputs *outputs;
    const char *version;
    murk_file_sums *sums;
} signing;

typedef murk_status (*printer)(FILE *to, const signing *s, murk_error *err);

/* Prints what the world key is a hash of: the shapes of the light sources, the
 * keys of the world, the settings of the tallies, and checksums of the
 * files. */
static murk_status print_world(FILE *to, const signing *s, murk_error *err)
{
    const murk_status status = murk_source_shapes_print(to, s->scene, err);
    fputs(s->scene->world_key, to);
    murk_row_tallies_sign(to, s->scene, s->outputs);
    return status || murk_file_sums_scene(to, s->sums, s->scene)
               ? status
               : no_memory(err);
}

/* Prints what the own key is a hash of: version, units, size of the grid of the
 * fluence rate, outputs, the whole scene, and checksums of the file of the
 * given placement and of the files of the scene. */
static murk_status print_row(FILE *to, const signing *s, murk_error *err)
{
    const murk_study_file *study = s->outputs->study;
    fprintf(to, "%s\n%d %d\n%zu %zu %zu\n", s->version, study->has_units,
            (int)study->units, study->fluence_size[0], study->fluence_size[1],
            study->fluence_size[2]);
    for (int k = 0; k < MURK_OUTPUTS; ++k) {
        fputc(s->outputs->wants[k] ? '1' : '0', to);
    }
    fputs(s->scene->whole_key, to);
    return murk_file_sums_put(to, s->sums, study->plan) &&
                   murk_file_sums_scene(to, s->sums, s->scene)
               ? MURK_OK
               : no_memory(err);
}

static bool is_of_placement(const char *key)
{
    return strcmp(key, "sensors") == 0 || strcmp(key, "placement") == 0;
}

/* Prints what the placement key is a hash of: the keys `sensors` and
 * `placement` of the resolved scene. */
static murk_status print_placement(FILE *to, const signing *s, murk_error *err)
{
    const char *resolved = s->scene->resolved;
    murk_yaml *root = NULL;
    const murk_status status =
        murk_yaml_parse(&root, resolved, strlen(resolved), s->scene->path, err);
    char *text = status ? NULL : murk_print_file(root, is_of_placement);
    fputs(text ? text : "", to);
    murk_yaml_destroy(root);
    const bool is_whole = text != NULL;
    free(text);
    return status || is_whole ? status : no_memory(err);
}

/* The hash of what a function prints. */
static murk_status hash(char out[65], printer print, const signing *s,
                        murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return no_memory(err);
    }
    murk_status status = print(to, s, err);
    char *whole = murk_print_finish(to, &text);
    if (!status && !whole) {
        status = no_memory(err);
    }
    if (!status) {
        murk_sha256_hex(whole, size, out);
    }
    free(whole);
    return status;
}

murk_status murk_sweep_keys_of(murk_sweep_keys *out, murk_file_sums *sums,
                               const murk_scene_desc *scene,
                               const murk_outputs *outputs, const char *version,
                               murk_error *err)
{
    const signing s = {scene, outputs, version, sums};
    murk_sha256_hex(scene->light_key, strlen(scene->light_key), out->light);
    murk_status status = hash(out->world, print_world, &s, err);
    if (!status) {
        status = hash(out->own, print_row, &s, err);
    }
    return !status && murk_outputs_plan_for_all(outputs)
               ? hash(out->placement, print_placement, &s, err)
               : status;
}

/* ---- groups ---- */

static murk_status group_rows(murk_sweep *sweep, const murk_sweep_keys *keys,
                              murk_error *err)
{
    const size_t rows = sweep->desc.study->rows;
    sweep->group = calloc(rows + 1, sizeof *sweep->group);
    if (!sweep->group) {
        return no_memory(err);
    }
    for (size_t i = 0; i < rows; ++i) {
        size_t g = 0;
        if (sweep->row[i].is_done) { /* the scene of the row cannot be read */
            sweep->row[i].group = SIZE_MAX;
            continue;
        }
        while (g < sweep->groups &&
               strcmp(keys[sweep->group[g].row[0]].world, keys[i].world) != 0) {
            ++g;
        }
        murk_sweep_group *group = &sweep->group[g];
        size_t *grown = realloc(group->row, (group->n + 1) * sizeof *grown);
        if (!grown) {
            return no_memory(err);
        }
        group->row = grown;
        group->row[group->n++] = i;
        sweep->groups += g == sweep->groups;
        sweep->row[i].group = g;
    }
    return MURK_OK;
}

/* Makes the key of each row from the own key of the row and the light keys of
 * all rows of the group, because the number of photons of the shared trace
 * depends on all lights of the group. */
static murk_status sign_rows(murk_sweep *sweep, const murk_sweep_keys *keys,
                             murk_error *err)
{
    for (size_t g = 0; g < sweep->groups; ++g) {
        murk_sweep_group *group = &sweep->group[g];
        char *lights = malloc(group->n * 64 + 1);
        if (!lights) {
            return no_memory(err);
        }
        /* Collect the different lights of the group. */
        for (size_t k = 0; k < group->n; ++k) {
            const char *own = keys[group->row[k]].light;
            bool is_new = true;
            for (size_t j = 0; j < group->lights && is_new; ++j) {
                is_new = memcmp(lights + 64 * j, own, 64) != 0;
            }
            if (is_new) {
                memcpy(lights + 64 * group->lights++, own, 64);
            }
        }
        /* The key of a row holds its own key and all lights of the group. */
        for (size_t k = 0; k < group->n; ++k) {
            char text[130], all[65];
            murk_sha256_hex(lights, 64 * group->lights, all);
            snprintf(text, sizeof text, "%s\n%s", keys[group->row[k]].own, all);
            murk_sha256_hex(text, strlen(text), sweep->row[group->row[k]].key);
        }
        free(lights);
    }
    return MURK_OK;
}

murk_status murk_sweep_group_rows(murk_sweep *sweep,
                                  const murk_sweep_keys *keys, murk_error *err)
{
    const murk_status status = group_rows(sweep, keys, err);
    return status ? status : sign_rows(sweep, keys, err);
}
