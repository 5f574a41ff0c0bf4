/* Reads study files (scene/study_file.h), and makes the scene of a row: a
 * variant of the base scene with one value of each axis. */
#include "scene/study_file.h"

#include "base/file.h"
#include "base/words.h"
#include "scene/keys_rows.h"
#include "scene/study_axes.h"
#include "scene/value.h"

#include <stdlib.h>
#include <string.h>

/* ---- the key table ---- */

/* Reads the names of outputs, which must be unique. Whether outputs of these
 * names exist is checked later. */
static murk_status read_outputs(murk_key_reader *walk, const murk_key *key,
                                murk_yaml *node, void *item)
{
    static const murk_key name = {.kind = MURK_KEY_OWN,
                                  .allowed = "the name of an output"};
    murk_study_file *study = item;
    murk_walk_where(node, walk->key, true, study->outputs_where);
    if (node->kind != MURK_YAML_LIST || node->n < 1 ||
        node->n > MURK_STUDY_OUTPUTS_MAX) {
        return murk_value_wrong(walk, key, node);
    }
    study->output = calloc(node->n, sizeof *study->output);
    if (!study->output) {
        return murk_walk_no_memory(walk);
    }
    /* Each name, compared with the earlier ones. */
    for (; study->outputs < node->n; ++study->outputs) {
        const murk_yaml *output = node->child[study->outputs];
        if (output->kind != MURK_YAML_SCALAR || output->text[0] == '\0') {
            return murk_value_wrong(walk, &name, output);
        }
        for (size_t k = 0; k < study->outputs; ++k) {
            if (strcmp(study->output[k], output->text) == 0) {
                char shown[MURK_SCENE_NAME_SIZE];
                murk_words_show(shown, sizeof shown, output->text);
                return murk_walk_fail(walk, output, "%s stands there twice",
                                      shown);
            }
        }
        study->output[study->outputs] = output->text;
    }
    return MURK_OK;
}

/* Largest number of cells of the grid of fluence_vdb: as many as all tallies
 * together may have (transport/tallies.h). */
#define CELLS_MAX (UINT64_C(1) << 31)

static murk_status check_cells(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const size_t *size = ((murk_study_file *)item)->fluence_size;
    if ((uint64_t)size[0] * size[1] * size[2] <= CELLS_MAX) {
        return MURK_OK;
    }
    murk_walk_enter(walk, "fluence_size");
    return murk_walk_fail(walk, murk_yaml_get(map, "fluence_size"),
                          "[%zu, %zu, %zu], must be at most 2^31 cells",
                          size[0], size[1], size[2]);
}

#define STUDY(member) AT(murk_study_file, member)

/* Axes are read after the mode, by which their rows are counted. */
static const murk_key STUDY_ROWS[] = {
    ROW("murk_study", COUNT, NEEDED, .min = 1, .max = 1),
    ROW("base", PATH, NEEDED, STUDY(base)),
    ROW("plan", PATH, STUDY(plan)),
    ROW("mode", WORD, .preset = "grid", WORDS({"grid", 0}, {"paired", 1}),
        STUDY(is_paired)),
    ROW("axes", OWN, NEEDED, .read = murk_study_axes_read,
        .allowed = "a map of axes, KEY: [values]",
        .schema = "{\"type\": \"object\", "
                  "\"additionalProperties\": {\"anyOf\": [{\"type\": "
                  "\"array\", \"minItems\": 1}, {\"type\": \"object\", "
                  "\"minProperties\": 1}]}}"),
    ROW("outputs", OWN, .read = read_outputs,
        .allowed = "a list of 1..128 names",
        .schema = "{\"type\": \"array\", \"items\": {\"type\": \"string\"}, "
                  "\"minItems\": 1, \"maxItems\": 128, \"uniqueItems\": "
                  "true}"),
    ROW("units", WORD, .words = murk_units_words, STUDY(units),
        FLAG(murk_study_file, has_units)),
    ROW("fluence_size", SIZES, .min = 1, .max = 4096, STUDY(fluence_size)),
    END,
};
_Static_assert(MURK_STUDY_OUTPUTS_MAX == 128, "the row of outputs states it");

const murk_keys murk_study_keys = {
    .noun = "study", .check = check_cells, .key = STUDY_ROWS};

/* ---- the file ---- */

murk_status murk_study_file_read(murk_study_file **out, const char *path,
                                 murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_study_file *study = calloc(1, sizeof *study);
    if (!study || !(study->path = strdup(path))) {
        murk_study_file_destroy(study);
        return murk_no_memory(err, path, "for the study");
    }
    /* Read and parse the text; the hash identifies the study. */
    murk_status status =
        murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        murk_sha256_hex(text, size, study->sha256);
        status = murk_yaml_parse(&study->root, text, size, study->path, err);
    }
    if (!status) {
        murk_key_reader walk = {.root = study->root, .err = err};
        status = murk_walk_root(&walk, &murk_study_keys, study);
        free(walk.paths);
    }
    free(text);
    /* Hand over a complete study only. */
    if (status) {
        murk_study_file_destroy(study);
        return status;
    }
    *out = study;
    return MURK_OK;
}

void murk_study_file_destroy(murk_study_file *study)
{
    if (!study) {
        return;
    }
    for (size_t a = 0; a < study->axes; ++a) {
        murk_study_axis *axis = &study->axis[a];
        for (size_t i = 0; i < axis->n; ++i) {
            murk_yaml_destroy(axis->value[i]);
            free(axis->text[i]);
        }
        free(axis->value);
        free(axis->text);
    }
    free(study->output);
    free(study->axis);
    free(study->base);
    free(study->plan);
    murk_yaml_destroy(study->root);
    free(study->path);
    free(study);
}

/* ---- rows ---- */

void murk_study_row_indices(const murk_study_file *study, size_t row,
                            size_t *index)
{
    size_t rest = row;
    for (size_t a = study->axes; a-- > 0;) {
        index[a] = study->is_paired ? row : rest % study->axis[a].n;
        rest /= study->axis[a].n;
    }
}

static void add_axis(murk_variant *variant, murk_key_change *change,
                     const murk_study_axis *axis, size_t i)
{
    const murk_yaml *value = axis->value[i];
    if (axis->kind == MURK_STUDY_AXIS_CONDITION) {
        variant->condition = value->text;
    } else if (axis->kind == MURK_STUDY_AXIS_KEY) {
        change[variant->n++] =
            (murk_key_change){axis->path, value, axis->where};
    } else {
        for (size_t k = 0; k < value->n; ++k) {
            change[variant->n++] =
                (murk_key_change){value->key[k], value->child[k], axis->where};
        }
    }
}

murk_status murk_study_row_scene(murk_scene_desc **out,
                                 const murk_study_file *study, size_t row,
                                 const murk_override *overrides,
                                 size_t n_overrides, murk_error *err)
{
    size_t index[MURK_STUDY_AXES_MAX], max = 1;
    murk_study_row_indices(study, row, index);
    for (size_t a = 0; a < study->axes; ++a) {
        max += 1 + study->axis[a].value[index[a]]->n;
    }
    murk_key_change *change = calloc(max, sizeof *change);
    if (!change) {
        return murk_no_memory(err, study->path, "for the study");
    }
    murk_variant variant = {.change = change};
    for (size_t a = 0; a < study->axes; ++a) {
        add_axis(&variant, change, &study->axis[a], index[a]);
    }
    const murk_status status = murk_scene_desc_read_variant(
        out, study->base, overrides, n_overrides, &variant, err);
    free(change);
    return status;
}
