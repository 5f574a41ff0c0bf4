/* Readers of the values of single options: numbers, words, lists and files of
 * keys. Each checks its value and stores it. */
#include "app/option_values.h"

#include "base/file.h"
#include "results/fit.h"
#include "scene/yaml.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LOSS_WIDTH_MAX 1e6 /* standard errors: far beyond any outlier */

/* A whole number, also as 1e6; strict. */
static bool read_count(const char *text, uint64_t *out)
{
    char *end = NULL;
    if (!((*text >= '0' && *text <= '9') || *text == '.')) {
        return false;
    }
    for (const char *c = text; *c; ++c) {
        if (!strchr("0123456789.eE+", *c)) {
            return false;
        }
    }
    errno = 0;
    const double value = strtod(text, &end);
    if (*end || errno || !(value >= 0 && value < 0x1p64) ||
        value != floor(value)) {
        return false;
    }
    *out = strspn(text, "0123456789") == strlen(text) ? strtoull(text, NULL, 10)
                                                      : (uint64_t)value;
    return true;
}

murk_status murk_option_count(const char *name, const char *text, uint64_t low,
                              uint64_t high, uint64_t *out, murk_error *err)
{
    if (!read_count(text, out) || *out < low || *out > high) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be a whole number %llu..%llu", text,
                         (unsigned long long)low, (unsigned long long)high);
    }
    return MURK_OK;
}

murk_status murk_option_override(murk_options *out, const char *key,
                                 const char *value, const char *option,
                                 murk_error *err)
{
    const size_t size = strlen(key) + strlen(value) + 2;
    char *text = malloc(size);
    murk_override *overrides =
        realloc(out->overrides, (out->n_overrides + 1) * sizeof *overrides);
    if (overrides) {
        out->overrides = overrides;
    }
    char **kept = realloc(out->kept, (out->n_kept + 1) * sizeof *kept);
    if (kept) {
        out->kept = kept;
    }
    if (!text || !overrides || !kept) {
        free(text);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the options");
    }
    snprintf(text, size, "%s%s%s", key, *key ? "=" : "", value);
    out->kept[out->n_kept++] = text;
    out->overrides[out->n_overrides++] = (murk_override){text, option};
    return MURK_OK;
}

murk_status murk_option_choice(const char *name, const char *value,
                               const char *const *allowed, int *out,
                               murk_error *err)
{
    char list[96] = "";
    for (int i = 0; allowed[i]; ++i) {
        if (strcmp(allowed[i], value) == 0) {
            *out = i;
            return MURK_OK;
        }
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
                 i ? " | " : "", allowed[i]);
    }
    return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be %s", value, list);
}

murk_status murk_option_out(murk_options *out, const char *name,
                            const char *value, murk_error *err)
{
    out->out = value;
    return *value ? MURK_OK
                  : murk_fail(err, MURK_BAD_VALUE, name,
                              "\"\", must name a folder");
}

murk_status murk_option_method(murk_options *out, const char *name,
                               const char *value, murk_error *err)
{
    static const char *const methods[] = {"maps", "path", "maps-only", NULL};
    int which = 0;
    const murk_status status =
        murk_option_choice(name, value, methods, &which, err);
    out->by_path = which == 1;
    out->maps_only = which == 2;
    return status;
}

murk_status murk_option_exports(murk_options *out, const char *name,
                                const char *value, murk_error *err)
{
    static const char *const words[] = {"matrix", "or-library", "lp",
                                        "fields", "photons",    "surfaces"};
    /* Word by word between commas. */
    for (const char *word = value;;) {
        const size_t length = strcspn(word, ",");
        unsigned bit = 0;
        for (unsigned i = 0; i < sizeof words / sizeof *words; ++i) {
            if (strlen(words[i]) == length &&
                strncmp(words[i], word, length) == 0) {
                bit = 1u << i;
            }
        }
        if (!bit) {
            return murk_fail(err, MURK_BAD_VALUE, name,
                             "%s, must be of matrix, or-library, lp, fields, "
                             "photons, surfaces, with commas between",
                             value);
        }
        out->exports |= bit;
        if (!word[length]) {
            return MURK_OK;
        }
        word += length + 1;
    }
}

static murk_status take_words(murk_words_given *words, const char *value,
                              const char *name, murk_error *err)
{
    /* Word by word between commas. */
    for (const char *at = value;;) {
        const size_t length = strcspn(at, ",");
        char *word = strndup(at, length);
        char **grown = realloc(words->word, (words->n + 1) * sizeof *grown);
        if (grown) {
            words->word = grown;
        }
        if (!word || !grown) {
            free(word);
            return murk_fail(err, MURK_NO_MEMORY, name, "no memory for it");
        }
        words->word[words->n++] = word;
        if (length == 0) {
            return murk_fail(err, MURK_BAD_VALUE, name,
                             "\"%s\", must be words with commas between",
                             value);
        }
        if (!at[length]) {
            return MURK_OK;
        }
        at += length + 1;
    }
}

murk_status murk_option_free(murk_options *out, const char *name,
                             const char *value, murk_error *err)
{
    return take_words(&out->fit.free, value, name, err);
}

murk_status murk_option_bounds(murk_options *out, const char *name,
                               const char *value, murk_error *err)
{
    return take_words(&out->fit.bounds, value, name, err);
}

murk_status murk_option_loss(murk_options *out, const char *name,
                             const char *value, murk_error *err)
{
    murk_fit_options *fit = &out->fit;
    static const char *const losses[] = {"none", "huber", "cauchy"};
    /* Widths of 95 % efficiency on normal residuals (Holland and Welsch,
     * Commun. Stat. A 6 (1977) 813, doi:10.1080/03610927708827533). */
    static const double widths[] = {1, 1.345, 2.385};
    const size_t length = strcspn(value, ":");
    /* The name of the loss, then its width if one is given. */
    for (int i = 0; i < 3; ++i) {
        if (strlen(losses[i]) != length ||
            strncmp(losses[i], value, length) != 0) {
            continue;
        }
        fit->loss = (murk_loss_function)i;
        fit->loss_width = widths[i];
        if (!value[length]) {
            return MURK_OK;
        }
        char *end;
        fit->loss_width = strtod(value + length + 1, &end);
        if (i > 0 && end != value + length + 1 && !*end &&
            fit->loss_width > 0 && fit->loss_width <= LOSS_WIDTH_MAX) {
            return MURK_OK;
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, name,
                     "%s, must be none, huber or cauchy, the last two also "
                     "with a width in standard errors: huber:1.345",
                     value);
}

static murk_status add_value(murk_options *out, const murk_yaml *map, size_t i,
                             const char *file, murk_error *err)
{
    const murk_yaml *node = map->child[i];
    char where[320];
    murk_yaml_key_place(node, where, sizeof where);
    if (node->kind != MURK_YAML_SCALAR || node->is_quoted) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s: must be a number or a word: the file has one "
                         "KEY: VALUE a line",
                         map->key[i]);
    }
    /* Messages about the key name the file. */
    const size_t size = strlen(file) + 16;
    char *option = malloc(size);
    char **kept = realloc(out->kept, (out->n_kept + 1) * sizeof *kept);
    if (kept) {
        out->kept = kept;
    }
    if (!option || !kept) {
        free(option);
        return murk_fail(err, MURK_NO_MEMORY, where, "no memory for it");
    }
    snprintf(option, size, "--set @%s", file);
    out->kept[out->n_kept++] = option;
    return murk_option_override(out, map->key[i], node->text, option, err);
}

/* --set @FILE: a map of keys by their paths, such as fit's calibrated.yaml. */
static murk_status values_of(murk_options *out, const char *file,
                             murk_error *err)
{
    murk_yaml *root = NULL;
    char *text = NULL;
    size_t size = 0;
    if (!*file) {
        return murk_fail(err, MURK_BAD_VALUE, "--set @",
                         "no name, must be --set @FILE");
    }
    /* Read the map and set each key. */
    murk_status status =
        murk_file_read(&text, &size, file, MURK_YAML_MAX_BYTES, err);
    if (!status) {
        status = murk_yaml_parse(&root, text, size, file, err);
    }
    if (!status && root->kind != MURK_YAML_MAP) {
        status = murk_fail(err, MURK_BAD_FILE, file,
                           "must be a map of KEY: VALUE, as calibrated.yaml");
    }
    for (size_t i = 0; !status && i < root->n; ++i) {
        status = add_value(out, root, i, file, err);
    }
    if (!status && murk_fit_refused_values(text)) {
        murk_fit_warn_refused(file);
    }
    free(text);
    murk_yaml_destroy(root);
    return status;
}

murk_status murk_option_set(murk_options *out, const char *name,
                            const char *value, murk_error *err)
{
    if (*value == '@') {
        return values_of(out, value + 1, err);
    }
    return strchr(value, '=') && *value != '='
               ? murk_option_override(out, "", value, NULL, err)
               : murk_fail(err, MURK_BAD_VALUE, name, "%s, must be KEY=VALUE",
                           value);
}
