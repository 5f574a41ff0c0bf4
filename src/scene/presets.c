/* Reads preset files (YAML, built into the program) into murk_preset:
 * sources, doubts, words with ranges, wavelengths and parts. Finds presets
 * by name. */
#include "scene/presets.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "preset/files.h"
#include "scene/preset_walk.h"
#include "scene/words.h"

#define SOURCE_SIZE (MURK_PRESET_NAME_SIZE + sizeof ENDING)

#define ENDING ".yaml"

/* ---- shared checks ---- */

murk_status murk_preset_fail(const murk_preset_walk *walk,
                             const murk_yaml *node, const char *format, ...)
{
    char place[200], text[300];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    murk_yaml_place(node, place, sizeof place);
    return murk_fail(walk->err, MURK_BAD_FILE, place, "%s", text);
}

murk_status murk_preset_no_memory(const murk_preset_walk *walk)
{
    return murk_fail(walk->err, MURK_NO_MEMORY, "", "no memory for a preset");
}

murk_status murk_preset_check_keys(const murk_preset_walk *walk,
                                   const murk_yaml *map,
                                   const char *const *known)
{
    if (map->kind != MURK_YAML_MAP) {
        return murk_preset_fail(walk, map, "must be a map of keys");
    }
    for (size_t i = 0; i < map->n; ++i) {
        const char *const *key = known;
        while (*key && strcmp(*key, map->key[i]) != 0) {
            ++key;
        }
        if (!*key) {
            return murk_preset_fail(walk, map->child[i], "unknown key %.60s",
                                    map->key[i]);
        }
    }
    return MURK_OK;
}

murk_status murk_preset_number(const murk_preset_walk *walk,
                               const murk_yaml *node, double min, double max,
                               double *out)
{
    double value;
    if (!node || !murk_yaml_number(node, &value) ||
        !(value >= min && value <= max)) {
        return murk_preset_fail(walk, node ? node : &(murk_yaml){.source = ""},
                                "must be a number, %.6g..%.6g", min, max);
    }
    *out = value;
    return MURK_OK;
}

murk_status murk_preset_numbers(const murk_preset_walk *walk,
                                const murk_yaml *node, size_t n, double *out)
{
    const bool is_list = node->kind == MURK_YAML_LIST;
    if ((is_list ? node->n : 1) != n) {
        return murk_preset_fail(walk, node, "must be %zu numbers", n);
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        status = murk_preset_number(walk, is_list ? node->child[i] : node,
                                    -1e300, 1e300, &out[i]);
    }
    return status;
}

/* ---- the file ---- */

static murk_status read_text(const murk_preset_walk *walk,
                             const murk_yaml *node, char **out)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        return murk_preset_fail(walk, node, "must be a text");
    }
    *out = strdup(node->text);
    return *out ? MURK_OK : murk_preset_no_memory(walk);
}

static murk_status read_source(const murk_preset_walk *walk,
                               const murk_yaml *map, murk_preset_source *out)
{
    static const char *const known[] = {"what", "from", "quoted_by", NULL};
    murk_status status = murk_preset_check_keys(walk, map, known);
    if (status) {
        return status;
    }
    const murk_yaml *what = murk_yaml_get(map, "what");
    const murk_yaml *from = murk_yaml_get(map, "from");
    const murk_yaml *quoted_by = murk_yaml_get(map, "quoted_by");
    if (!what || !from) {
        return murk_preset_fail(walk, map, "misses what, from");
    }
    status = read_text(walk, what, &out->what);
    if (!status) {
        status = read_text(walk, from, &out->from);
    }
    return status || !quoted_by ? status
                                : read_text(walk, quoted_by, &out->quoted_by);
}

static murk_status read_sources(const murk_preset_walk *walk,
                                const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    if (list->kind != MURK_YAML_LIST || list->n == 0) {
        return murk_preset_fail(walk, list, "must be a list of sources");
    }
    preset->source = calloc(list->n, sizeof *preset->source);
    if (!preset->source) {
        return murk_preset_no_memory(walk);
    }
    preset->sources = list->n;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < list->n && !status; ++i) {
        status = read_source(walk, list->child[i], &preset->source[i]);
    }
    return status;
}

static murk_status read_doubts(const murk_preset_walk *walk,
                               const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    if (list->kind != MURK_YAML_LIST) {
        return murk_preset_fail(walk, list, "must be a list of texts");
    }
    preset->doubt = calloc(list->n + 1, sizeof *preset->doubt);
    if (!preset->doubt) {
        return murk_preset_no_memory(walk);
    }
    preset->doubts = list->n;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < list->n && !status; ++i) {
        status = read_text(walk, list->child[i], &preset->doubt[i]);
    }
    return status;
}

static murk_status read_word(const murk_preset_walk *walk, const char *name,
                             const murk_yaml *map)
{
    static const char *const known[] = {"default", "least", "most", NULL};
    const int found = murk_word_find(name);
    if (found < 0 || found == MURK_WORD_MOR) {
        return murk_preset_fail(walk, map, "%.60s is no word of presets", name);
    }
    const size_t n = (size_t)murk_word_numbers((murk_word_id)found);
    murk_preset_word *word = &walk->preset->word[found];
    murk_status status = murk_preset_check_keys(walk, map, known);
    if (status) {
        return status;
    }
    /* The range, and optionally a default. */
    const murk_yaml *preset = murk_yaml_get(map, "default");
    const murk_yaml *min = murk_yaml_get(map, "least");
    const murk_yaml *max = murk_yaml_get(map, "most");
    if (!min || !max) {
        return murk_preset_fail(walk, map, "misses least, most");
    }
    status = murk_preset_numbers(walk, min, n, word->min);
    if (!status) {
        status = murk_preset_numbers(walk, max, n, word->max);
    }
    if (!status && preset) {
        status = murk_preset_numbers(walk, preset, n, word->preset);
    }
    /* The default must be in the range. */
    for (size_t k = 0; k < n && !status; ++k) {
        const bool is_within = !preset || (word->preset[k] >= word->min[k] &&
                                           word->preset[k] <= word->max[k]);
        if (!is_within || !(word->min[k] <= word->max[k])) {
            status = murk_preset_fail(walk, map,
                                      "must rise: least, default, "
                                      "most");
        }
    }
    word->is_known = true;
    word->has_preset = preset != NULL;
    return status;
}

static murk_status read_words(const murk_preset_walk *walk,
                              const murk_yaml *map)
{
    if (map->kind != MURK_YAML_MAP) {
        return murk_preset_fail(walk, map, "must be a map of words");
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < map->n && !status; ++i) {
        status = read_word(walk, map->key[i], map->child[i]);
    }
    murk_preset_word *word = walk->preset->word;
    if (!status && word[MURK_WORD_VISIBILITY].is_known &&
        !(word[MURK_WORD_VISIBILITY].min[0] > 0)) {
        status = murk_preset_fail(walk, map, "a visibility of 0");
    }
    return status;
}

static murk_status read_parts(const murk_preset_walk *walk,
                              const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    if (list->kind != MURK_YAML_LIST || list->n == 0 ||
        list->n > MURK_PRESET_PARTS_MAX) {
        return murk_preset_fail(walk, list, "must be a list of 1..%d parts",
                                MURK_PRESET_PARTS_MAX);
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i < list->n && !status; ++i) {
        preset->parts = i + 1;
        status = murk_preset_read_part(walk, list->child[i], &preset->part[i]);
    }
    return status;
}

static murk_status read_root(const murk_preset_walk *walk,
                             const murk_yaml *root)
{
    static const char *const known[] = {
        "murk_preset",   "about", "sources", "doubts",
        "wavelength_nm", "words", "parts",   NULL};
    murk_preset *preset = walk->preset;
    double version, *range = preset->wavelength_nm;
    murk_status status = murk_preset_check_keys(walk, root, known);
    /* Required keys. */
    for (const char *const *key = known; !status && *key; ++key) {
        const bool may_miss =
            strcmp(*key, "doubts") == 0 || strcmp(*key, "words") == 0;
        if (!may_miss && !murk_yaml_get(root, *key)) {
            return murk_preset_fail(walk, root, "misses %s", *key);
        }
    }
    if (status ||
        (status = murk_preset_number(walk, murk_yaml_get(root, "murk_preset"),
                                     1, 1, &version)) ||
        (status =
             read_text(walk, murk_yaml_get(root, "about"), &preset->about)) ||
        (status = read_sources(walk, murk_yaml_get(root, "sources")))) {
        return status;
    }
    /* Wavelengths, then the optional keys, then the parts, which need both. */
    const murk_yaml *nm = murk_yaml_get(root, "wavelength_nm");
    if ((status = murk_preset_numbers(walk, nm, 2, range))) {
        return status;
    }
    if (!(range[0] > 0 && range[1] >= range[0] && range[1] <= 1e9)) {
        return murk_preset_fail(walk, nm, "must rise and be above 0");
    }
    const murk_yaml *doubts = murk_yaml_get(root, "doubts");
    const murk_yaml *words = murk_yaml_get(root, "words");
    if ((doubts && (status = read_doubts(walk, doubts))) ||
        (words && (status = read_words(walk, words)))) {
        return status;
    }
    return read_parts(walk, murk_yaml_get(root, "parts"));
}

murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err)
{
    murk_yaml *root = NULL;
    char source[SOURCE_SIZE];
    snprintf(source, sizeof source, "%s" ENDING, name);
    murk_preset_walk walk = {.preset = calloc(1, sizeof(murk_preset)),
                             .err = err};
    murk_status status = MURK_OK;
    if (!walk.preset || !(walk.preset->name = strdup(name))) {
        status = murk_preset_no_memory(&walk);
        goto done;
    }
    /* Parse the text and read the tree. */
    status = murk_yaml_parse(&root, text, size, source, err);
    if (!status) {
        status = read_root(&walk, root);
    }
    if (!status) {
        *out = walk.preset;
        walk.preset = NULL;
    }
done:
    murk_yaml_destroy(root);
    murk_preset_destroy(walk.preset);
    return status;
}

/* ---- built-in presets ---- */

/* The name of a preset file without the ending: "fog/kruse" for
 * "fog/kruse.yaml"; false for tables. */
static bool name_of(const murk_media_file *file,
                    char out[MURK_PRESET_NAME_SIZE])
{
    const size_t length = strlen(file->name), end = strlen(ENDING);
    if (length <= end || strcmp(file->name + length - end, ENDING) != 0 ||
        length - end >= MURK_PRESET_NAME_SIZE) {
        return false;
    }
    memcpy(out, file->name, length - end);
    out[length - end] = '\0';
    return true;
}

size_t murk_presets_count(void)
{
    char name[MURK_PRESET_NAME_SIZE];
    size_t n = 0;
    for (size_t i = 0; i < murk_media_files_count; ++i) {
        n += name_of(&murk_media_files[i], name);
    }
    return n;
}

void murk_presets_name(size_t index, char out[MURK_PRESET_NAME_SIZE])
{
    size_t n = 0;
    out[0] = '\0';
    for (size_t i = 0; i < murk_media_files_count; ++i) {
        if (name_of(&murk_media_files[i], out) && n++ == index) {
            return;
        }
    }
}

static murk_status fail_unknown(const char *name, const char *where,
                                murk_error *err)
{
    const size_t n = murk_presets_count();
    char shown[MURK_PRESET_NAME_SIZE];
    char(*names)[MURK_PRESET_NAME_SIZE] = calloc(n + 1, sizeof *names);
    const char **known = calloc(n + 1, sizeof *known);
    const char *meant = NULL;
    /* Compare with the names of all presets. */
    for (size_t i = 0; names && known && i < n; ++i) {
        murk_presets_name(i, names[i]);
        known[i] = names[i];
    }
    if (names && known) {
        meant = murk_words_meant(name, known, n);
    }
    murk_words_show(shown, sizeof shown, name);
    const murk_status status =
        meant ? murk_fail(err, MURK_BAD_VALUE, where,
                          "no preset %s, did you mean %s?", shown, meant)
              : murk_fail(err, MURK_BAD_VALUE, where,
                          "no preset %s, must be one of those that `murk "
                          "media` lists",
                          shown);
    free(names);
    free(known);
    return status;
}

murk_status murk_presets_read(murk_preset **out, const char *name,
                              const char *where, murk_error *err)
{
    char own[MURK_PRESET_NAME_SIZE];
    for (size_t i = 0; i < murk_media_files_count; ++i) {
        const murk_media_file *file = &murk_media_files[i];
        if (name_of(file, own) && strcmp(own, name) == 0) {
            return murk_preset_parse(out, name, file->text, file->size, err);
        }
    }
    return fail_unknown(name, where, err);
}
