/* Keys of the rows of a study: hashes of everything that the light, the
 * placement or the whole row depends on. Rows of equal world keys share a
 * trace; a stored row is valid as long as its key is the same. */
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
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for a row");
}

static bool sign_world(FILE *out, const murk_scene_desc *scene,
                       const murk_outputs *outputs, murk_file_sums *sums)
{
    char *row_tallies = murk_row_tallies_sign(scene, outputs);
    fputs(scene->world_key, out);
    fputs(row_tallies ? row_tallies : "", out);
    const bool is_whole = murk_file_sums_scene(out, sums, scene) && row_tallies;
    free(row_tallies);
    return is_whole;
}

static bool sign_row(FILE *out, const murk_scene_desc *scene,
                     const murk_outputs *outputs, const char *version,
                     murk_file_sums *sums)
{
    const murk_study_file *study = outputs->study;
    fprintf(out, "%s\n%d %d\n%zu %zu %zu\n", version, study->has_units,
            (int)study->units, study->fluence_size[0], study->fluence_size[1],
            study->fluence_size[2]);
    for (int k = 0; k < MURK_OUTPUTS; ++k) {
        fputc(outputs->wants[k] ? '1' : '0', out);
    }
    fputs(scene->whole_key, out);
    return murk_file_sums_put(out, sums, study->plan) &&
           murk_file_sums_scene(out, sums, scene);
}

/* The text of a stream, as its hash. */
static bool finish(FILE *out, char **text, const size_t *size, char hash[65])
{
    const bool failed = ferror(out) != 0;
    const bool is_whole = fclose(out) == 0 && !failed;
    if (is_whole) {
        murk_sha256_hex(*text, *size, hash);
    }
    free(*text);
    *text = NULL;
    return is_whole;
}

static bool is_of_placement(const char *key)
{
    return strcmp(key, "sensors") == 0 || strcmp(key, "placement") == 0;
}

/* Sensors and placement, as the scene has them resolved. */
static murk_status sign_placement(char hash[65], const murk_scene_desc *scene,
                                  murk_error *err)
{
    murk_yaml *root = NULL;
    murk_status status = murk_yaml_parse(
        &root, scene->resolved, strlen(scene->resolved), scene->path, err);
    char *text = status ? NULL : murk_print_file(root, is_of_placement);
    if (text) {
        murk_sha256_hex(text, strlen(text), hash);
    } else if (!status) {
        status = no_memory(err);
    }
    free(text);
    murk_yaml_destroy(root);
    return status;
}

murk_status murk_sweep_keys_of(murk_sweep_keys *out, murk_file_sums *sums,
                               const murk_scene_desc *scene,
                               const murk_outputs *outputs, const char *version,
                               murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_sha256_hex(scene->light_key, strlen(scene->light_key), out->light);
    /* The key of the world: shapes of the lights, keys of the world, files and
     * tallies. */
    /* The key of the row: version, outputs and the whole scene. */
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return no_memory(err);
    }
    murk_status status = murk_source_shapes_print(to, scene, err);
    bool is_whole = sign_world(to, scene, outputs, sums);
    is_whole &= finish(to, &text, &size, out->world);
    if (status || !is_whole) {
        return status ? status : no_memory(err);
    }
    to = open_memstream(&text, &size);
    if (!to) {
        return no_memory(err);
    }
    is_whole = sign_row(to, scene, outputs, version, sums);
    is_whole &= finish(to, &text, &size, out->own);
    if (!is_whole) {
        return no_memory(err);
    }
    return murk_outputs_plan_for_all(outputs)
               ? sign_placement(out->placement, scene, err)
               : MURK_OK;
}
