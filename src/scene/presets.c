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

bool murk_preset_fail(murk_preset_walk *walk, const murk_yaml *node,
                      const char *format, ...)
{
    char place[200], text[300];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    murk_yaml_place(node, place, sizeof place);
    walk->status = murk_fail(walk->err, MURK_BAD_FILE, place, "%s", text);
    return false;
}

bool murk_preset_no_memory(murk_preset_walk *walk)
{
    walk->status =
        murk_fail(walk->err, MURK_NO_MEMORY, "", "no memory for a preset");
    return false;
}

bool murk_preset_check_keys(murk_preset_walk *walk, const murk_yaml *map,
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
    return true;
}

const murk_yaml *murk_preset_get(murk_preset_walk *walk, const murk_yaml *map,
                                 const char *key)
{
    const murk_yaml *node = murk_yaml_get(map, key);
    if (!node) {
        murk_preset_fail(walk, map, "misses %s", key);
    }
    return node;
}

bool murk_preset_number(murk_preset_walk *walk, const murk_yaml *node,
                        double min, double max, double *out)
{
    double value;
    if (!murk_yaml_number(node, &value) || !(value >= min && value <= max)) {
        return murk_preset_fail(walk, node, "must be a number, %.6g..%.6g", min,
                                max);
    }
    *out = value;
    return true;
}

bool murk_preset_numbers(murk_preset_walk *walk, const murk_yaml *node,
                         size_t n, double *out)
{
    const bool is_list = node->kind == MURK_YAML_LIST;
    bool is_read = (is_list ? node->n : 1) == n ||
                   murk_preset_fail(walk, node, "must be %zu numbers", n);
    for (size_t i = 0; i < n && is_read; ++i) {
        is_read = murk_preset_number(walk, is_list ? node->child[i] : node,
                                     -1e300, 1e300, &out[i]);
    }
    return is_read;
}

/* ---- the file ---- */

static bool read_text(murk_preset_walk *walk, const murk_yaml *node, char **out)
{
    if (node->kind != MURK_YAML_SCALAR || node->text[0] == '\0') {
        return murk_preset_fail(walk, node, "must be a text");
    }
    *out = strdup(node->text);
    return *out || murk_preset_no_memory(walk);
}

static bool read_source(murk_preset_walk *walk, const murk_yaml *map,
                        murk_preset_source *out)
{
    static const char *const known[] = {"what", "from", "quoted_by", NULL};
    if (!murk_preset_check_keys(walk, map, known)) {
        return false;
    }
    const murk_yaml *what = murk_preset_get(walk, map, "what");
    const murk_yaml *from = murk_preset_get(walk, map, "from");
    const murk_yaml *quoted_by = murk_yaml_get(map, "quoted_by");
    return what && from && read_text(walk, what, &out->what) &&
           read_text(walk, from, &out->from) &&
           (!quoted_by || read_text(walk, quoted_by, &out->quoted_by));
}

static bool read_sources(murk_preset_walk *walk, const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    if (list->kind != MURK_YAML_LIST || list->n == 0) {
        return murk_preset_fail(walk, list, "must be a list of sources");
    }
    preset->source = calloc(list->n, sizeof *preset->source);
    preset->sources = preset->source ? list->n : 0;
    bool is_read = preset->source || murk_preset_no_memory(walk);
    for (size_t i = 0; i < list->n && is_read; ++i) {
        is_read = read_source(walk, list->child[i], &preset->source[i]);
    }
    return is_read;
}

static bool read_doubts(murk_preset_walk *walk, const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    if (list->kind != MURK_YAML_LIST) {
        return murk_preset_fail(walk, list, "must be a list of texts");
    }
    preset->doubt = calloc(list->n + 1, sizeof *preset->doubt);
    preset->doubts = preset->doubt ? list->n : 0;
    bool is_read = preset->doubt || murk_preset_no_memory(walk);
    for (size_t i = 0; i < list->n && is_read; ++i) {
        is_read = read_text(walk, list->child[i], &preset->doubt[i]);
    }
    return is_read;
}

static bool read_word(murk_preset_walk *walk, const char *name,
                      const murk_yaml *map)
{
    static const char *const known[] = {"default", "least", "most", NULL};
    const int found = murk_word_find(name);
    if (found < 0 || found == MURK_WORD_MOR) {
        return murk_preset_fail(walk, map, "%.60s is no word of presets", name);
    }
    if (!murk_preset_check_keys(walk, map, known)) {
        return false;
    }
    /* The range, and optionally a default. */
    const size_t n = (size_t)murk_word_rows[found].numbers;
    murk_preset_word *word = &walk->preset->word[found];
    const murk_yaml *preset = murk_yaml_get(map, "default");
    const murk_yaml *min = murk_preset_get(walk, map, "least");
    const murk_yaml *max = murk_preset_get(walk, map, "most");
    word->is_known = true;
    word->has_preset = preset != NULL;
    bool is_read =
        min && max && murk_preset_numbers(walk, min, n, word->min) &&
        murk_preset_numbers(walk, max, n, word->max) &&
        (!preset || murk_preset_numbers(walk, preset, n, word->preset));
    /* The default must be in the range. */
    for (size_t k = 0; k < n && is_read; ++k) {
        const bool is_within = !preset || (word->preset[k] >= word->min[k] &&
                                           word->preset[k] <= word->max[k]);
        is_read =
            (is_within && word->min[k] <= word->max[k]) ||
            murk_preset_fail(walk, map, "must rise: least, default, most");
    }
    return is_read;
}

static bool read_words(murk_preset_walk *walk, const murk_yaml *map)
{
    bool is_read = map->kind == MURK_YAML_MAP ||
                   murk_preset_fail(walk, map, "must be a map of words");
    for (size_t i = 0; i < map->n && is_read; ++i) {
        is_read = read_word(walk, map->key[i], map->child[i]);
    }
    const murk_preset_word *visibility =
        &walk->preset->word[MURK_WORD_VISIBILITY];
    return is_read && (!visibility->is_known || visibility->min[0] > 0 ||
                       murk_preset_fail(walk, map, "a visibility of 0"));
}

static bool read_parts(murk_preset_walk *walk, const murk_yaml *list)
{
    murk_preset *preset = walk->preset;
    bool is_read = (list->kind == MURK_YAML_LIST && list->n > 0 &&
                    list->n <= MURK_PRESET_PARTS_MAX) ||
                   murk_preset_fail(walk, list, "must be a list of 1..%d parts",
                                    MURK_PRESET_PARTS_MAX);
    for (size_t i = 0; i < list->n && is_read; ++i) {
        preset->parts = i + 1;
        is_read = murk_preset_read_part(walk, list->child[i], &preset->part[i]);
    }
    return is_read;
}

static bool read_wavelengths(murk_preset_walk *walk, const murk_yaml *node)
{
    double *range = walk->preset->wavelength_nm;
    return murk_preset_numbers(walk, node, 2, range) &&
           ((range[0] > 0 && range[1] >= range[0] && range[1] <= 1e9) ||
            murk_preset_fail(walk, node, "must rise and be above 0"));
}

/* Reads the keys of a preset: parts need wavelengths and words. */
static bool read_root(murk_preset_walk *walk, const murk_yaml *root)
{
    static const char *const known[] = {
        "murk_preset",   "about", "sources", "doubts",
        "wavelength_nm", "words", "parts",   NULL};
    double version;
    if (!murk_preset_check_keys(walk, root, known)) {
        return false;
    }
    /* All keys but two are required. */
    for (const char *const *key = known; *key; ++key) {
        const bool may_miss =
            strcmp(*key, "doubts") == 0 || strcmp(*key, "words") == 0;
        if (!may_miss && !murk_preset_get(walk, root, *key)) {
            return false;
        }
    }
    const murk_yaml *doubts = murk_yaml_get(root, "doubts");
    const murk_yaml *words = murk_yaml_get(root, "words");
    return murk_preset_number(walk, murk_yaml_get(root, "murk_preset"), 1, 1,
                              &version) &&
           read_text(walk, murk_yaml_get(root, "about"),
                     &walk->preset->about) &&
           read_sources(walk, murk_yaml_get(root, "sources")) &&
           read_wavelengths(walk, murk_yaml_get(root, "wavelength_nm")) &&
           (!doubts || read_doubts(walk, doubts)) &&
           (!words || read_words(walk, words)) &&
           read_parts(walk, murk_yaml_get(root, "parts"));
}

murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err)
{
    murk_yaml *root = NULL;
    char source[SOURCE_SIZE];
    snprintf(source, sizeof source, "%s" ENDING, name);
    murk_preset_walk walk = {.preset = calloc(1, sizeof(murk_preset)),
                             .err = err};
    if (!walk.preset || !(walk.preset->name = strdup(name))) {
        murk_preset_no_memory(&walk);
    } else {
        walk.status = murk_yaml_parse(&root, text, size, source, err);
    }
    if (!walk.status && read_root(&walk, root)) {
        *out = walk.preset;
        walk.preset = NULL;
    }
    murk_yaml_destroy(root);
    murk_preset_destroy(walk.preset);
    return walk.status;
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
