/* Reads the parts of a preset file: a law or a table of coefficients, a
 * factor, and a phase function. The format is described in media/README.md. */
#include "scene/preset_walk.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "preset/law.h"

static const char *const PART_KEYS[] = {"law",    "table", "times",
                                        "scaled", "phase", NULL};

static bool is_part_key(const char *key)
{
    const char *const *known = PART_KEYS;
    while (*known && strcmp(*known, key) != 0) {
        ++known;
    }
    return *known != NULL;
}

/* Checks that the preset defines each word that the law needs, with a
 * default. */
static murk_status check_words(const murk_preset_walk *walk,
                               const murk_yaml *node, const murk_law *law)
{
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_preset_word *word = &walk->preset->word[i];
        if ((law->needs & (1u << i)) && !(word->is_known && word->has_preset)) {
            return murk_preset_fail(walk, node,
                                    "the law %s needs the word %s with a "
                                    "default",
                                    law->name, murk_word_name((murk_word_id)i));
        }
    }
    return MURK_OK;
}

static murk_status read_law(const murk_preset_walk *walk, const murk_yaml *map,
                            const murk_yaml *node, murk_preset_part *part)
{
    const murk_law *law =
        node->kind == MURK_YAML_SCALAR ? murk_law_find(node->text) : NULL;
    if (!law) {
        return murk_preset_fail(walk, node, "no law of that name");
    }
    /* The parameters of the law. */
    part->law = law;
    size_t n = 0;
    for (; law->parameter[n].name; ++n) {
        const murk_law_parameter *parameter = &law->parameter[n];
        const murk_yaml *value = murk_yaml_get(map, parameter->name);
        if (!value) {
            return murk_preset_fail(walk, map, "misses %s", parameter->name);
        }
        const murk_status status = murk_preset_number(
            walk, value, parameter->min, parameter->max, &part->parameter[n]);
        if (status) {
            return status;
        }
    }
    /* No other keys than those of a part and the parameters. */
    for (size_t i = 0; i < map->n; ++i) {
        bool is_known = is_part_key(map->key[i]);
        for (size_t k = 0; k < n; ++k) {
            is_known =
                is_known || strcmp(law->parameter[k].name, map->key[i]) == 0;
        }
        if (!is_known) {
            return murk_preset_fail(walk, map->child[i], "unknown key %.60s",
                                    map->key[i]);
        }
    }
    return check_words(walk, node, law);
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

static murk_status fail_map(const murk_preset_walk *walk, const murk_yaml *map)
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

static murk_status read_phase_map(const murk_preset_walk *walk,
                                  const murk_yaml *map, murk_preset_part *part)
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
    const murk_status status =
        murk_preset_read_angles(walk, map->child[0], &part->angles);
    phase->angles = part->angles;
    return status;
}

static murk_status read_phase(const murk_preset_walk *walk,
                              const murk_yaml *node, murk_preset_part *part)
{
    part->has_phase = true;
    if (node->kind == MURK_YAML_MAP) {
        return read_phase_map(walk, node, part);
    }
    const char *word = node->kind == MURK_YAML_SCALAR ? node->text : "";
    if (find_kind(&part->phase.kind, word, false)) {
        return MURK_OK;
    }
    part->phase.kind = MURK_PHASE_HG; /* with mean cosine 0 */
    return strcmp(word, "isotropic") == 0
               ? MURK_OK
               : murk_preset_fail(walk, node,
                                  "must be isotropic, rayleigh or a map");
}

/* ---- the part ---- */

static murk_status read_times(const murk_preset_walk *walk,
                              const murk_yaml *node, murk_preset_part *part)
{
    part->times =
        node->kind == MURK_YAML_SCALAR ? murk_word_find(node->text) : -1;
    if (part->times < 0 || !walk->preset->word[part->times].has_preset ||
        murk_word_numbers((murk_word_id)part->times) != 1) {
        return murk_preset_fail(walk, node,
                                "must be one of the preset's words that have "
                                "a default");
    }
    return MURK_OK;
}

static murk_status read_scaled(const murk_preset_walk *walk,
                               const murk_yaml *node, murk_preset_part *part)
{
    const murk_preset *preset = walk->preset;
    if (!murk_yaml_bool(node, &part->scaled)) {
        return murk_preset_fail(walk, node, "must be true or false");
    }
    return !part->scaled || (preset->word[MURK_WORD_VISIBILITY].is_known &&
                             preset->wavelength_nm[0] <= MURK_VISIBILITY_NM &&
                             preset->wavelength_nm[1] >= MURK_VISIBILITY_NM)
               ? MURK_OK
               : murk_preset_fail(walk, node,
                                  "needs the word visibility_m and 550 nm "
                                  "within wavelength_nm");
}

/* Diffuse attenuation is meaningful to some laws only; such a law and such a
 * table need each other. */
static murk_status check_table(const murk_preset_walk *walk,
                               const murk_yaml *node,
                               const murk_preset_part *part)
{
    const bool is_by_table = part->law && part->law->by_table;
    return is_by_table == (part->table.diffuse_attenuation_per_m != NULL)
               ? MURK_OK
               : murk_preset_fail(walk, node,
                                  "diffuse_attenuation_per_m and a law that "
                                  "is by it need each other");
}

murk_status murk_preset_read_part(const murk_preset_walk *walk,
                                  const murk_yaml *map, murk_preset_part *part)
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
    /* A law, a table, or both. */
    murk_status status = law ? read_law(walk, map, law, part)
                             : murk_preset_check_keys(walk, map, PART_KEYS);
    if (!status && table) {
        status = murk_preset_read_table(walk, table, &part->table);
    }
    if (!status) {
        status = check_table(walk, map, part);
    }
    if (!status && table && law && !part->law->by_table) {
        status = murk_preset_fail(walk, table, "a law that is by no table");
    }
    /* The optional keys. */
    if (!status && times) {
        status = read_times(walk, times, part);
    }
    if (!status && scaled) {
        status = read_scaled(walk, scaled, part);
    }
    return status || !phase ? status : read_phase(walk, phase, part);
}
