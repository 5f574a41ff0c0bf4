/* Writes calibrated.yaml: the values that a fit found, as keys for --set @FILE.
 * If the value of the scene would not reach a condition, because the condition
 * overrides the key, the key is also written under this condition. */
#include "results/fit.h"

#include "base/log.h"
#include "calibrate/key_place.h"
#include "calibrate/verdict.h"
#include "results/coverage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Begins the line of the file that states the verdict. By this line
 * murk_fit_refused_values() recognises the values of a refused fit. */
#define VERDICT "# Does it fit? "

/* Two numbers of resolved scenes that differ by at most this share are the same
 * value. */
#define SAME 1e-9

/* Where each value has to be written: at the scene, at conditions, or both. */
typedef struct places {
    bool *is_in_scene; /* [keys]; the scene without a condition has the key */
    bool *is_own;      /* [keys][conditions]; the value of the scene does not
                          reach the condition, so it is written there */
} places;

static void release(places *p)
{
    free(p->is_in_scene);
    free(p->is_own);
}

static murk_yaml *tree_of(const murk_scene_desc *scene)
{
    murk_yaml *root = NULL;
    (void)murk_yaml_parse(&root, scene->resolved, strlen(scene->resolved), "",
                          NULL);
    return root;
}

static bool find(double *value, murk_yaml *root, const char *path, int bands)
{
    murk_key_place place;
    const bool is_there = root && murk_key_place_find(&place, root, bands, path,
                                                      "", NULL) == MURK_OK;
    *value = is_there ? place.value : NAN;
    return is_there;
}

static bool is_shared(const murk_free_key *key)
{
    return key->kind != MURK_FREE_GAIN && key->condition == SIZE_MAX;
}

/* Reads the scene again, with the found values in place of those keys that hold
 * for the scene and not for one condition alone, and that the scene without a
 * condition has. NULL if the scene cannot be read with these values, or when
 * out of memory. */
static murk_scene_desc *scene_with(const murk_fit_facts *f, const places *p)
{
    const murk_free_keys *keys = f->keys;
    const murk_free_desc *desc = &keys->desc;
    /* The overrides of the command line come first. */
    const size_t capacity = sizeof keys->key->path + 40;
    murk_override *overrides =
        calloc(desc->n_overrides + keys->n + 1, sizeof *overrides);
    char *text = calloc(keys->n + 1, capacity);
    size_t n = desc->n_overrides;
    murk_scene_desc *scene = NULL;
    for (size_t i = 0; overrides && i < n; ++i) {
        overrides[i] = desc->overrides[i];
    }
    /* The values that were found override the keys of the scene. */
    for (size_t k = 0; overrides && text && k < keys->n; ++k) {
        if (is_shared(&keys->key[k]) && p->is_in_scene[k]) {
            char number[32];
            murk_number_text(number, f->found->value[k]);
            snprintf(text + k * capacity, capacity, "%s=%s", keys->key[k].path,
                     number);
            overrides[n++] = (murk_override){text + k * capacity, "--set"};
        }
    }
    if (overrides && text) {
        const bool was_silent = murk_warn_quiet(true);
        (void)murk_scene_desc_read(&scene, desc->scene_path, overrides, n,
                                   NULL);
        murk_warn_quiet(was_silent);
    }
    free(overrides);
    free(text);
    return scene;
}

static bool find_places(places *out, const murk_fit_facts *f)
{
    const murk_free_keys *keys = f->keys;
    const size_t n = keys->n, conditions = keys->conditions;
    double value;
    *out = (places){calloc(n + 1, sizeof(bool)),
                    calloc(n * conditions + 1, sizeof(bool))};
    if (!out->is_in_scene || !out->is_own) {
        return false;
    }
    /* Find out which keys the scene without a condition has. */
    murk_yaml *base = tree_of(f->scene);
    for (size_t k = 0; k < n; ++k) {
        out->is_in_scene[k] =
            find(&value, base, keys->key[k].path, keys->bands);
    }
    murk_yaml_destroy(base);
    /* Find out for which conditions a key has to be written once more, because
     * the value of the scene does not reach the condition. */
    murk_scene_desc *scene = scene_with(f, out);
    for (size_t c = 0; c < conditions; ++c) {
        if (keys->condition[c] == SIZE_MAX) {
            continue;
        }
        murk_yaml *root =
            scene ? tree_of(scene->conditions[keys->condition[c]].scene) : NULL;
        for (size_t k = 0; k < n; ++k) {
            const double wanted = f->found->value[k];
            const bool is_same =
                find(&value, root, keys->key[k].path, keys->bands) &&
                fabs(value - wanted) <= SAME * fabs(wanted);
            out->is_own[k * conditions + c] =
                is_shared(&keys->key[k]) && keys->key[k].is_in[c] && !is_same;
        }
        murk_yaml_destroy(root);
    }
    murk_scene_desc_destroy(scene);
    return true;
}

static void write_in(FILE *file, const murk_free_keys *keys, size_t c,
                     const char *path, const char *value)
{
    const bool is_condition = keys->condition[c] != SIZE_MAX;
    fprintf(file, "%s%s%s%s: %s\n", is_condition ? "conditions." : "",
            is_condition ? keys->condition_name[c] : "",
            is_condition ? "." : "", path, value);
}

static void write_value(FILE *file, const murk_fit_facts *f, size_t k,
                        const places *p)
{
    const murk_free_keys *keys = f->keys;
    const murk_free_key *key = &keys->key[k];
    char text[32];
    murk_number_text(text, f->found->value[k]);
    if (key->kind == MURK_FREE_GAIN) {
        fprintf(file, "# %s: %s (a factor of readings, no key)\n", key->name,
                text);
        return;
    }
    /* If the data do not determine the value, a comment line before the value
     * states so. */
    if (!murk_calibration_determines(f->found, k)) {
        fprintf(file, "# %s: %s\n", key->name,
                murk_calibration_status(f->found, k));
    }
    if (key->condition != SIZE_MAX) {
        write_in(file, keys, key->condition, key->path, text);
        return;
    }
    if (p->is_in_scene[k]) {
        fprintf(file, "%s: %s\n", key->path, text);
    }
    for (size_t c = 0; c < keys->conditions; ++c) {
        if (p->is_own[k * keys->conditions + c]) {
            write_in(file, keys, c, key->path, text);
        }
    }
}

static murk_status write_calibrated(FILE *file, const void *context,
                                    murk_error *err)
{
    const murk_fit_facts *f = context;
    places p;
    if (!find_places(&p, f)) {
        release(&p);
        return murk_no_memory(err, "calibrated.yaml", "for it");
    }
    bool has_keys = false;
    fprintf(file, "# values found by murk fit; for --set @FILE\n");
    fprintf(file, VERDICT "%s\n", f->found->verdict);
    for (size_t k = 0; k < f->keys->n; ++k) {
        write_value(file, f, k, &p);
        has_keys = has_keys || f->keys->key[k].kind != MURK_FREE_GAIN;
    }
    /* Without a key, an empty map: YAML of comments alone would be empty. */
    fputs(has_keys ? "" : "{}\n", file);
    release(&p);
    return MURK_OK;
}

murk_status murk_add_calibrated(murk_results *results,
                                const murk_fit_facts *facts, murk_error *err)
{
    return murk_results_add_stream(results, "calibrated.yaml", write_calibrated,
                                   facts, err);
}

bool murk_fit_refused_values(const char *text)
{
    static const char refusal[] = VERDICT MURK_VERDICT_REFUSED;
    const size_t length = sizeof refusal - 1;
    const char *line = text;
    while (line && strncmp(line, refusal, length) != 0) {
        line = strchr(line, '\n');
        line = line ? line + 1 : NULL;
    }
    return line != NULL;
}
