/* The key table of preset files: sources, doubts, wavelengths, words with
 * their ranges, and parts. A part is a law or a table of coefficients, a
 * factor, and a phase function; the parameters of the law are keys of the
 * part. The format is described in media/README.md. */
#include "scene/keys_preset.h"

#include <string.h>

#include "preset/law.h"
#include "scene/keys_rows.h"
#include "scene/value.h"

/* The largest number of bytes of a text: no text of a preset is that long. */
#define LONG_TEXT .max = 4096

/* ---- sources and words ---- */

#define SOURCE(member) LONG_TEXT, AT(murk_preset_source, member)

static const murk_key SOURCE_ROWS[] = {
    ROW("what", TEXT, NEEDED, SOURCE(what)),
    ROW("from", TEXT, NEEDED, SOURCE(from)),
    ROW("quoted_by", TEXT, SOURCE(quoted_by)),
    END,
};

static const murk_keys SOURCE_KEYS = {
    .noun = "source",
    ITEMS(murk_preset, source, sources),
    .max_items = 64,
    .needs_item = true,
    .key = SOURCE_ROWS,
};

static murk_status check_word(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    const murk_preset_word *word = item;
    for (size_t k = 0; k < MURK_WORD_NUMBERS_MAX; ++k) {
        const double preset = word->has_preset ? word->preset[k] : word->min[k];
        if (!(word->min[k] <= preset && preset <= word->max[k])) {
            return murk_walk_fail(walk, map, "must rise: least, default, most");
        }
    }
    return MURK_OK;
}

/* The rows of a word of one number, and of a word of three. */
#define WORD_MEMBER(member) AT(murk_preset_word, member)
#define RANGE_ROWS(...)                                      \
    ROW("default", __VA_ARGS__, WORD_MEMBER(preset),         \
        FLAG(murk_preset_word, has_preset)),                 \
        ROW("least", __VA_ARGS__, NEEDED, WORD_MEMBER(min)), \
        ROW("most", __VA_ARGS__, NEEDED, WORD_MEMBER(max)), END
/* A number of a list. The row has no member of its own: the row of the list
 * states where the numbers go. */
#define BARE_NUMBER(name_)                      \
    {                                           \
        .name = name_, .kind = MURK_KEY_NUMBER, \
    }
#define THREE_NUMBERS \
    LIST_ITEMS(BARE_NUMBER("a"), BARE_NUMBER("b"), BARE_NUMBER("c"))

static const murk_key WORD_ROWS_1[] = {RANGE_ROWS(NUMBER)};
static const murk_key WORD_ROWS_3[] = {RANGE_ROWS(NUMBERS, THREE_NUMBERS)};
static const murk_keys WORD_KEYS_1 = {
    .noun = "word", .check = check_word, .key = WORD_ROWS_1};
static const murk_keys WORD_KEYS_3 = {
    .noun = "word", .check = check_word, .key = WORD_ROWS_3};

#define X(id, name, unit, numbers, is_amount)      \
    ROW(name, MAP, .keys = &WORD_KEYS_##numbers,   \
        INSIDE(murk_preset, word[MURK_WORD_##id]), \
        FLAG(murk_preset, word[MURK_WORD_##id].is_known)),
static const murk_key WORDS_ROWS[] = {MURK_WORD_ROWS(X) END};
#undef X

static murk_status check_words(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_preset_word *word = ((murk_preset *)item)->word;
    const murk_preset_word *visibility = &word[MURK_WORD_VISIBILITY];
    return !word[MURK_WORD_MOR].is_known &&
                   (!visibility->is_known || visibility->min[0] > 0)
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "has mor_m or a visibility of 0, must have "
                                "visibility_m above 0");
}

static const murk_keys WORDS_KEYS = {
    .noun = "preset", .check = check_words, .key = WORDS_ROWS};

/* ---- coefficients ---- */

typedef struct columns {
    murk_scene_numbers nm, absorption, scattering, cosine, diffuse;
} columns;

#define COLUMN(member) AT(columns, member)

static const murk_key TABLE_ROWS[] = {
    ROW("wavelength_nm", NUMBER_LIST, NEEDED, .above = true, .max = 1e9,
        COLUMN(nm)),
    ROW("absorption_per_m", NUMBER_LIST, .max = 1e9, COLUMN(absorption)),
    ROW("scattering_per_m", NUMBER_LIST, .max = 1e9, COLUMN(scattering)),
    ROW("mean_cosine", NUMBER_LIST, COSINE, COLUMN(cosine)),
    ROW("diffuse_attenuation_per_m", NUMBER_LIST, .max = 1e9, COLUMN(diffuse)),
    END,
};

static murk_status check_table(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const columns *in = item;
    const size_t n = in->nm.n;
    for (size_t i = 0; i < map->n; ++i) {
        if (map->child[i]->n != n) {
            return murk_walk_fail(walk, map, "lists of %zu and %zu numbers", n,
                                  map->child[i]->n);
        }
    }
    return map->n > 1 ? MURK_OK
                      : murk_walk_fail(walk, map, "has no coefficients");
}

static const murk_keys TABLE_KEYS = {
    .noun = "table", .check = check_table, .key = TABLE_ROWS};

static murk_status read_table(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *member)
{
    columns in = {0};
    if (node->kind != MURK_YAML_MAP) {
        return murk_value_wrong(walk, key, node);
    }
    const murk_status status = murk_walk_map(walk, &TABLE_KEYS, node, &in);
    /* The preset owns the columns, even if they are refused. */
    *(murk_preset_table *)member =
        (murk_preset_table){.n = in.nm.n,
                            .wavelength_nm = in.nm.value,
                            .absorption_per_m = in.absorption.value,
                            .scattering_per_m = in.scattering.value,
                            .mean_cosine = in.cosine.value,
                            .diffuse_attenuation_per_m = in.diffuse.value};
    return status;
}

/* ---- parts ---- */

#define PART(member) AT(murk_preset_part, member)

static const murk_key PHASE_ROWS[] = {
    ROW("hg", NUMBER, .group = 1, NEEDED, COSINE, PART(phase.value)),
    TWO_HG_ROW(PART(phase.value)),
    FOURNIER_FORAND_ROW(PART(phase.value)),
    ROW("table", OWN, .group = 1, NEEDED, .read = murk_preset_read_angles,
        .allowed = "the name of a csv file in media", PART(angles)),
    END,
};

static const murk_keys PHASE_KEYS = {
    .noun = "phase",
    .by_key = true,
    .variant_names = murk_phase_variants,
    VARIANT(murk_preset_part, phase.kind),
    .key = PHASE_ROWS,
};

static murk_status read_law(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *member)
{
    const murk_law *law =
        node->kind == MURK_YAML_SCALAR ? murk_law_find(node->text) : NULL;
    memcpy(member, &law, sizeof law);
    return law ? MURK_OK : murk_value_wrong(walk, key, node);
}

#define X(id, name, unit, numbers, is_amount) {name, MURK_WORD_##id},
static const murk_word WORD_NAMES[] = {MURK_WORD_ROWS(X) WORDS_END};
#undef X

/* The keys of every part. */
static const murk_key PART_ROWS[] = {
    ROW("law", OWN, .read = read_law, .allowed = "the name of a law",
        PART(law)),
    ROW("table", OWN, .read = read_table, .allowed = "a map of lists",
        PART(table)),
    ROW("times", WORD, .words = WORD_NAMES, PART(times)),
    ROW("scaled", BOOL, PART(scaled)),
    ROW("phase", MAP, .keys = &PHASE_KEYS, .words = murk_phase_words,
        PART(phase.kind), FLAG(murk_preset_part, has_phase)),
};

#define ROWS_OF_PARTS (sizeof PART_ROWS / sizeof *PART_ROWS)

/* Checks that the preset defines each word that the law needs, with a
 * default. */
static murk_status check_law(murk_key_reader *walk, const murk_yaml *map,
                             const murk_preset *preset, const murk_law *law)
{
    for (int i = 0; i < MURK_WORDS; ++i) {
        if ((law->needs & (1u << i)) && !preset->word[i].has_preset) {
            return murk_walk_fail(walk, murk_yaml_get(map, "law"),
                                  "the law %s needs the word %s with a default",
                                  law->name, murk_word_rows[i].name);
        }
    }
    return MURK_OK;
}

/* Checks that wavelengths rise and span those of the preset. */
static murk_status check_wavelengths(murk_key_reader *walk,
                                     const murk_yaml *node,
                                     const murk_preset *preset,
                                     const double *nm, size_t n)
{
    const double *range = preset->wavelength_nm;
    for (size_t i = 1; i < n; ++i) {
        if (!(nm[i] > nm[i - 1])) {
            return murk_walk_fail(walk, node, "%.9g nm after %.9g, must rise",
                                  nm[i], nm[i - 1]);
        }
    }
    return n == 0 || (nm[0] <= range[0] && nm[n - 1] >= range[1])
               ? MURK_OK
               : murk_walk_fail(walk, node,
                                "spans %.9g..%.9g nm, less than wavelength_nm",
                                nm[0], nm[n - 1]);
}

/* Checks a part: tables span the wavelengths of the preset; the part has a law
 * or a table, or both if the law uses the column of diffuse attenuation; the
 * words that `times`, `scaled` and the law use are words of the preset. */
static murk_status check_part(murk_key_reader *walk, const murk_yaml *map,
                              const murk_preset *preset,
                              const murk_preset_part *part)
{
    const murk_preset_table *table = &part->table;
    const double *range = preset->wavelength_nm;
    const bool is_by_table = part->law && part->law->by_table;
    const murk_preset_angles *angles = part->angles;
    /* Tables span the wavelengths of the preset. */
    murk_status status =
        check_wavelengths(walk, murk_yaml_get(map, "table"), preset,
                          table->wavelength_nm, table->n);
    if (!status && angles && angles->wavelength_nm) {
        status = check_wavelengths(walk, murk_yaml_get(map, "phase"), preset,
                                   angles->wavelength_nm, angles->columns);
    }
    if (status) {
        return status;
    }
    /* Law and table, then the optional keys. */
    if (is_by_table != (table->diffuse_attenuation_per_m != NULL) ||
        (part->law && !is_by_table) == (table->n > 0)) {
        return murk_walk_fail(walk, map,
                              "must have a law, or a table, or both if the "
                              "law is by diffuse_attenuation_per_m");
    }
    if (part->times >= 0 && (!preset->word[part->times].has_preset ||
                             murk_word_rows[part->times].numbers > 1)) {
        return murk_walk_fail(
            walk, murk_yaml_get(map, "times"),
            "must be one of the preset's words that have a default");
    }
    if (part->scaled &&
        !(preset->word[MURK_WORD_VISIBILITY].is_known &&
          range[0] <= MURK_VISIBILITY_NM && range[1] >= MURK_VISIBILITY_NM)) {
        return murk_walk_fail(
            walk, murk_yaml_get(map, "scaled"),
            "needs the word visibility_m and 550 nm within wavelength_nm");
    }
    return part->law ? check_law(walk, map, preset, part->law) : MURK_OK;
}

/* Reads a part by the rows of all parts and one row for each parameter of the
 * law. */
static murk_status read_part(murk_key_reader *walk, murk_yaml *map,
                             const murk_preset *preset, murk_preset_part *part)
{
    murk_key row[ROWS_OF_PARTS + MURK_PRESET_PARAMETERS_MAX + 1] = {{0}};
    const murk_yaml *name = murk_yaml_get(map, "law");
    const murk_law *law = name && name->text ? murk_law_find(name->text) : NULL;
    memcpy(row, PART_ROWS, sizeof PART_ROWS);
    for (size_t i = 0; law && law->parameter[i].name; ++i) {
        row[ROWS_OF_PARTS + i] = (murk_key){
            .name = law->parameter[i].name,
            .kind = MURK_KEY_NUMBER,
            .required = true,
            .min = law->parameter[i].min,
            .max = law->parameter[i].max,
            .at = offsetof(murk_preset_part, parameter) + i * sizeof(double),
            .size = sizeof(double)};
    }
    const murk_keys keys = {.noun = "part", .key = row};
    const murk_key one = {.kind = MURK_KEY_MAP, .keys = &keys};
    part->times = -1;
    const murk_status status = murk_walk_value(walk, &one, map, part);
    return status ? status : check_part(walk, map, preset, part);
}

static murk_status read_parts(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *list, void *member)
{
    murk_preset *preset = member;
    murk_status status = MURK_OK;
    if (list->kind != MURK_YAML_LIST || list->n == 0 ||
        list->n > MURK_PRESET_PARTS_MAX) {
        return murk_value_wrong(walk, key, list);
    }
    while (preset->parts < list->n && !status) {
        const size_t i = preset->parts++;
        const size_t back = murk_walk_enter_item(walk, i);
        status = read_part(walk, list->child[i], preset, &preset->part[i]);
        murk_walk_leave(walk, back);
    }
    return status;
}

/* ---- the file ---- */

#define PRESET(member) AT(murk_preset, member)
/* Larger wavelengths are mistakes. */
#define NANOMETRES .above = true, .max = 1e9, .unit = "nm"

/* Parts are read after the wavelengths and words, which they need. */
static const murk_key PRESET_ROWS[] = {
    ROW("murk_preset", COUNT, NEEDED, .min = 1, .max = 1),
    ROW("about", TEXT, NEEDED, LONG_TEXT, PRESET(about)),
    ROW("sources", LIST, NEEDED, .keys = &SOURCE_KEYS),
    ROW("doubts", TEXT_LIST, LONG_TEXT, PRESET(doubts)),
    ROW("wavelength_nm", NUMBERS, NEEDED,
        LIST_ITEMS(ROW("least", NUMBER, NANOMETRES),
                   ROW("most", NUMBER, NANOMETRES)),
        PRESET(wavelength_nm)),
    ROW("words", MAP, .keys = &WORDS_KEYS),
    ROW("scaled_may_vanish", BOOL, PRESET(scaled_may_vanish)),
    ROW("parts", OWN, NEEDED, .read = read_parts,
        .allowed = "a list of 1..8 parts"),
    END,
};
_Static_assert(MURK_PRESET_PARTS_MAX == 8, "the row of parts states it");

static murk_status check_preset(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    const double *range = ((murk_preset *)item)->wavelength_nm;
    return range[0] <= range[1]
               ? MURK_OK
               : murk_walk_fail(walk, murk_yaml_get(map, "wavelength_nm"),
                                "wavelength_nm must rise");
}

const murk_keys murk_preset_keys = {
    .noun = "preset", .check = check_preset, .key = PRESET_ROWS};
