/* Reads study files (scene/study_file.h), and makes the scene of a row: a
 * variant of the base scene with one value of each axis. */
#include "scene/study_file.h"

#include "base/file.h"
#include "scene/study_axes.h"
#include "scene/study_range.h"
#include "scene/value.h"
#include "scene/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The keys of a study. */
static const char *const KEYS[] = {"murk_study",   "base", "axes",
                                   "mode",         "plan", "outputs",
                                   "fluence_size", "units"};
/* The number of these keys. */
#define N_KEYS (sizeof KEYS / sizeof *KEYS)

/* The state of reading. */
typedef struct reading {
    murk_study_file *study;
    const murk_yaml *root;
    murk_error *err;
} reading;

static murk_status wrong(const reading *r, const murk_yaml *node,
                         const char *key, const char *allowed)
{
    char found[MURK_FOUND_SIZE] = "nothing";
    if (node) {
        murk_value_found(node, found);
    }
    return murk_study_fail(node ? node : r->root, key,
                           !node || node->kind != MURK_YAML_SCALAR, r->err,
                           "%s, must be %s", found, allowed);
}

static murk_status check_keys(const reading *r)
{
    for (size_t i = 0; i < r->root->n; ++i) {
        const char *key = r->root->key[i];
        size_t k = 0;
        while (k < N_KEYS && strcmp(KEYS[k], key) != 0) {
            ++k;
        }
        if (k == N_KEYS) {
            char shown[MURK_SCENE_NAME_SIZE];
            const char *meant = murk_words_meant(key, KEYS, N_KEYS);
            murk_words_show(shown, sizeof shown, key);
            return murk_study_fail(r->root->child[i], shown, true, r->err,
                                   "unknown key of a study%s%s%s",
                                   meant ? ", did you mean " : "",
                                   meant ? meant : "", meant ? "?" : "");
        }
    }
    return MURK_OK;
}

static murk_status read_version(const reading *r)
{
    const murk_yaml *node = murk_yaml_get(r->root, "murk_study");
    uint64_t version = 0;
    return node && murk_yaml_count(node, &version) && version == 1
               ? MURK_OK
               : wrong(r, node, "murk_study", "1, the format's version");
}

static murk_status read_file_name(const reading *r, const char *key,
                                  bool is_needed, char **out)
{
    const murk_yaml *node = murk_yaml_get(r->root, key);
    if (!node && !is_needed) {
        return MURK_OK;
    }
    if (!node || node->kind != MURK_YAML_SCALAR || node->text[0] == '\0' ||
        murk_yaml_is_null(node)) {
        return wrong(r, node, key, "the name of a file");
    }
    *out = murk_path_beside(r->study->path, node->text);
    return *out ? MURK_OK : murk_study_no_memory(r->study->path, r->err);
}

static murk_status read_mode(const reading *r)
{
    const murk_yaml *node = murk_yaml_get(r->root, "mode");
    const char *word = !node                            ? "grid"
                       : node->kind == MURK_YAML_SCALAR ? node->text
                                                        : "";
    r->study->is_paired = strcmp(word, "paired") == 0;
    return r->study->is_paired || strcmp(word, "grid") == 0
               ? MURK_OK
               : wrong(r, node, "mode", "grid or paired");
}

static murk_status read_outputs(const reading *r)
{
    const murk_yaml *node = murk_yaml_get(r->root, "outputs");
    murk_study_file *study = r->study;
    if (!node) {
        return MURK_OK;
    }
    murk_walk_where(node, "outputs", true, study->outputs_where);
    if (node->kind != MURK_YAML_LIST || node->n < 1 ||
        node->n > MURK_STUDY_OUTPUTS_MAX) {
        return wrong(r, node, "outputs", "a list of 1..128 names");
    }
    /* Names of outputs must be unique; whether they exist is checked later. */
    study->output = calloc(node->n, sizeof *study->output);
    if (!study->output) {
        return murk_study_no_memory(study->path, r->err);
    }
    for (size_t i = 0; i < node->n; ++i) {
        const murk_yaml *item = node->child[i];
        if (item->kind != MURK_YAML_SCALAR || item->text[0] == '\0') {
            return wrong(r, item, "outputs", "the name of an output");
        }
        for (size_t k = 0; k < i; ++k) {
            if (strcmp(study->output[k], item->text) == 0) {
                char shown[MURK_SCENE_NAME_SIZE];
                murk_words_show(shown, sizeof shown, item->text);
                return murk_study_fail(item, "outputs", false, r->err,
                                       "%s stands there twice", shown);
            }
        }
        study->output[i] = item->text;
        study->outputs = i + 1;
    }
    return MURK_OK;
}

static murk_status read_fluence_size(const reading *r)
{
    const murk_yaml *node = murk_yaml_get(r->root, "fluence_size");
    const char *allowed = "[nx, ny, nz], each 1..4096, at most 2^31 cells";
    uint64_t cells = 1;
    if (!node) {
        return MURK_OK;
    }
    if (node->kind != MURK_YAML_LIST || node->n != 3) {
        return wrong(r, node, "fluence_size", allowed);
    }
    for (int i = 0; i < 3; ++i) {
        uint64_t n;
        if (!murk_yaml_count(node->child[i], &n) || n < 1 || n > 4096) {
            return wrong(r, node->child[i], "fluence_size", allowed);
        }
        r->study->fluence_size[i] = (size_t)n;
        cells *= n;
    }
    return cells <= UINT64_C(1) << 31 ? MURK_OK
                                      : wrong(r, node, "fluence_size", allowed);
}

static murk_status read_units(const reading *r)
{
    const murk_yaml *node = murk_yaml_get(r->root, "units");
    int value = 0;
    if (node && node->kind == MURK_YAML_SCALAR &&
        murk_scene_word_find("units", node->text, &value)) {
        r->study->has_units = true;
        r->study->units = (murk_quantity)value;
    }
    return !node || r->study->has_units
               ? MURK_OK
               : wrong(r, node, "units",
                       "radiometric, photometric, photons or par");
}

/* Reads all keys, in the order in which messages are most useful. */
static murk_status read_all(const reading *r)
{
    murk_study_file *study = r->study;
    const murk_yaml *axes = murk_yaml_get(r->root, "axes");
    murk_status status = check_keys(r);
    if (status || (status = read_version(r)) ||
        (status = read_file_name(r, "base", true, &study->base)) ||
        (status = read_file_name(r, "plan", false, &study->plan)) ||
        (status = read_mode(r)) ||
        (status = murk_study_axes_read(study, axes, r->err)) ||
        (status = read_outputs(r)) || (status = read_units(r))) {
        return status;
    }
    return read_fluence_size(r);
}

murk_status murk_study_file_read(murk_study_file **out, const char *path,
                                 murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_study_file *study = calloc(1, sizeof *study);
    if (!study || !(study->path = strdup(path))) {
        murk_study_file_destroy(study);
        return murk_study_no_memory(path, err);
    }
    /* Read and parse the text; the hash identifies the study. */
    murk_status status =
        murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        murk_sha256_hex(text, size, study->sha256);
        status = murk_yaml_parse(&study->root, text, size, study->path, err);
    }
    if (!status && study->root->kind != MURK_YAML_MAP) {
        status = murk_fail(err, MURK_BAD_FILE, path, "must be a map of keys");
    }
    if (!status) {
        const reading r = {study, study->root, err};
        status = read_all(&r);
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
        return murk_study_no_memory(study->path, err);
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
