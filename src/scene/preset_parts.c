/* Reads the parts of a preset file: a law or a table of coefficients, a
 * factor, and a phase function. The format is described in media/README.md. */
#include "scene/preset_walk.h"

#include <stdio.h>
#include <string.h>

#include "preset/law.h"

static const char *const PART_KEYS[] = {"law",    "table", "times",
                                        "scaled", "phase", NULL};

/* The largest number of entries in the list of the known keys of a part:
 * parameters of the law, and PART_KEYS with the NULL at the end. */
#define KEYS_MAX \
    (sizeof PART_KEYS / sizeof *PART_KEYS + MURK_PRESET_PARAMETERS_MAX)

/* Checks that the preset defines each word that the law needs, with a
 * default. */
static bool check_words(murk_preset_walk *walk, const murk_yaml *node,
                        const murk_law *law)
{
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_preset_word *word = &walk->preset->word[i];
        if ((law->needs & (1u << i)) && !(word->is_known && word->has_preset)) {
            return murk_preset_fail(
                walk, node, "the law %s needs the word %s with a default",
                law->name, murk_word_rows[i].name);
        }
    }
    return true;
}

/* Reads a law, and the parameters of the law, which are keys of the part. */
static bool read_law(murk_preset_walk *walk, const murk_yaml *map,
                     const murk_yaml *node, murk_preset_part *part)
{
    const murk_law *law =
        node->kind == MURK_YAML_SCALAR ? murk_law_find(node->text) : NULL;
    if (!law) {
        return murk_preset_fail(walk, node, "no law of that name");
    }
    part->law = law;
    const char *known[KEYS_MAX] = {NULL};
    size_t n = 0;
    for (; law->parameter[n].name; ++n) {
        const murk_law_parameter *parameter = &law->parameter[n];
        const murk_yaml *value = murk_preset_get(walk, map, parameter->name);
        if (!value ||
            !murk_preset_number(walk, value, parameter->min, parameter->max,
                                &part->parameter[n])) {
            return false;
        }
        known[n] = parameter->name;
    }
    memcpy(known + n, PART_KEYS, sizeof PART_KEYS);
    return murk_preset_check_keys(walk, map, known) &&
           check_words(walk, node, law);
}

/* ---- phase functions ---- */

/* True for a kind that is written as a map, {hg: .8}; others are words. */
static bool is_map_key(murk_phase_kind kind)
{
    return murk_phase_kinds[kind].numbers > 0 || kind == MURK_PHASE_TABLE;
}

/* The kind of that name among the maps or among the words, or false. */
static bool find_kind(murk_phase_kind *kind, const char *name, bool by_map)
{
    for (int i = 0; murk_phase_kinds[i].name; ++i) {
        *kind = (murk_phase_kind)i;
        if (is_map_key(*kind) == by_map &&
            strcmp(murk_phase_kinds[i].name, name) == 0) {
            return true;
        }
    }
    return false;
}

static bool fail_map(murk_preset_walk *walk, const murk_yaml *map)
{
    char names[256] = "";
    size_t length = 0;
    for (int i = 0; murk_phase_kinds[i].name; ++i) {
        if (is_map_key((murk_phase_kind)i)) {
            length +=
                (size_t)snprintf(names + length, sizeof names - length, "%s%s",
                                 length ? ", " : "", murk_phase_kinds[i].name);
        }
    }
    return murk_preset_fail(walk, map, "must have one of %s", names);
}

static bool read_phase_map(murk_preset_walk *walk, const murk_yaml *map,
                           murk_preset_part *part)
{
    murk_preset_phase *phase = &part->phase;
    for (size_t i = 0; i < map->n; ++i) {
        if (!find_kind(&phase->kind, map->key[i], true)) {
            return murk_preset_fail(walk, map->child[i], "unknown key %.60s",
                                    map->key[i]);
        }
    }
    if (map->n != 1) {
        return fail_map(walk, map);
    }
    if (phase->kind != MURK_PHASE_TABLE) {
        return murk_preset_numbers(
            walk, map->child[0], (size_t)murk_phase_kinds[phase->kind].numbers,
            phase->value);
    }
    const bool is_read =
        murk_preset_read_angles(walk, map->child[0], &part->angles);
    phase->angles = part->angles;
    return is_read;
}

static bool read_phase(murk_preset_walk *walk, const murk_yaml *node,
                       murk_preset_part *part)
{
    part->has_phase = true;
    if (node->kind == MURK_YAML_MAP) {
        return read_phase_map(walk, node, part);
    }
    const char *word = node->kind == MURK_YAML_SCALAR ? node->text : "";
    if (find_kind(&part->phase.kind, word, false)) {
        return true;
    }
    part->phase.kind = MURK_PHASE_HG; /* with mean cosine 0 */
    return strcmp(word, "isotropic") == 0 ||
           murk_preset_fail(walk, node, "must be isotropic, rayleigh or a map");
}

/* ---- the part ---- */

static bool read_times(murk_preset_walk *walk, const murk_yaml *node,
                       murk_preset_part *part)
{
    part->times =
        node->kind == MURK_YAML_SCALAR ? murk_word_find(node->text) : -1;
    return (part->times >= 0 && walk->preset->word[part->times].has_preset &&
            murk_word_rows[part->times].numbers == 1) ||
           murk_preset_fail(
               walk, node,
               "must be one of the preset's words that have a default");
}

static bool read_scaled(murk_preset_walk *walk, const murk_yaml *node,
                        murk_preset_part *part)
{
    const murk_preset *preset = walk->preset;
    if (!murk_yaml_bool(node, &part->scaled)) {
        return murk_preset_fail(walk, node, "must be true or false");
    }
    return !part->scaled ||
           (preset->word[MURK_WORD_VISIBILITY].is_known &&
            preset->wavelength_nm[0] <= MURK_VISIBILITY_NM &&
            preset->wavelength_nm[1] >= MURK_VISIBILITY_NM) ||
           murk_preset_fail(
               walk, node,
               "needs the word visibility_m and 550 nm within wavelength_nm");
}

/* Diffuse attenuation is meaningful to some laws only; such a law and such a
 * table need each other. */
static bool check_table(murk_preset_walk *walk, const murk_yaml *map,
                        const murk_preset_part *part)
{
    const bool is_by_table = part->law && part->law->by_table;
    if (is_by_table != (part->table.diffuse_attenuation_per_m != NULL)) {
        return murk_preset_fail(walk, map,
                                "diffuse_attenuation_per_m and a law that is "
                                "by it need each other");
    }
    return !part->law || is_by_table || part->table.n == 0 ||
           murk_preset_fail(walk, murk_yaml_get(map, "table"),
                            "a law that is by no table");
}

bool murk_preset_read_part(murk_preset_walk *walk, const murk_yaml *map,
                           murk_preset_part *part)
{
    part->times = -1;
    const murk_yaml *law = murk_yaml_get(map, "law");
    const murk_yaml *table = murk_yaml_get(map, "table");
    const murk_yaml *times = murk_yaml_get(map, "times");
    const murk_yaml *scaled = murk_yaml_get(map, "scaled");
    const murk_yaml *phase = murk_yaml_get(map, "phase");
    if (map->kind != MURK_YAML_MAP || (!law && !table)) {
        return murk_preset_fail(walk, map, "must be a map with law or table");
    }
    /* A law, a table, or both; then the optional keys. */
    return (law ? read_law(walk, map, law, part)
                : murk_preset_check_keys(walk, map, PART_KEYS)) &&
           (!table || murk_preset_read_table(walk, table, &part->table)) &&
           check_table(walk, map, part) &&
           (!times || read_times(walk, times, part)) &&
           (!scaled || read_scaled(walk, scaled, part)) &&
           (!phase || read_phase(walk, phase, part));
}
