/* Media from presets: completes the words of a preset in the scene's tree,
 * evaluates the preset (preset/preset.h), and fills the properties that the
 * scene does not give. */
#include "scene/medium_preset.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/number.h"
#include "preset/check_words.h"
#include "scene/presets.h"
#include "scene/weather.h"

/* The preset of droplets of any size. */
#define DROPLETS "cloud/droplets"

/* ---- words ---- */

/* The place of a key of the medium, for messages; if the key is missing, the
 * place of the map. */
static void where_of(murk_key_reader *walk, const murk_yaml *map,
                     const char *key, bool at_key, murk_scene_where out)
{
    const murk_yaml *node = murk_yaml_get(map, key);
    const size_t back = murk_walk_enter(walk, key);
    murk_walk_where(node ? node : map, walk->key, at_key, out);
    murk_walk_leave(walk, back);
}

static bool is_by_weather(const murk_yaml *map)
{
    const murk_yaml *name = murk_yaml_get(map, "preset");
    return name->kind == MURK_YAML_SCALAR &&
           strcmp(name->text, MURK_SCENE_BY_WEATHER) == 0;
}

/* Reads the preset that the map names, or that the weather chooses. */
static murk_status open_preset(murk_key_reader *walk, const murk_yaml *map,
                               murk_preset **out)
{
    murk_scene_where where;
    const murk_yaml *node = murk_yaml_get(map, "preset");
    const char *name = node->kind == MURK_YAML_SCALAR ? node->text : "";
    where_of(walk, map, "preset", false, where);
    if (is_by_weather(map)) {
        const murk_status status = murk_weather_choose(walk, node);
        if (status) {
            return status;
        }
        name = murk_weather_preset(&walk->scene->weather.seen);
    }
    return murk_presets_read(out, name, where, walk->err);
}

/* Adds the default of a word to the map: a number, or a list of numbers. */
static murk_status put_default(murk_key_reader *walk, murk_yaml *map,
                               const char *name, const double *value,
                               int numbers)
{
    char text[MURK_WORD_NUMBERS_MAX * (MURK_NUMBER_SIZE + 2)] = "";
    for (int k = 0; k < numbers; ++k) {
        char number[MURK_NUMBER_SIZE];
        const size_t length = strlen(text);
        murk_number_print(number, value[k]);
        snprintf(text + length, sizeof text - length, "%s%s%s",
                 numbers == 1 ? ""
                 : k          ? ", "
                              : "[",
                 number, numbers > 1 && k == numbers - 1 ? "]" : "");
    }
    return murk_walk_put_preset(walk, map, name, text);
}

static murk_status complete_word(murk_key_reader *walk, murk_yaml *map,
                                 const murk_preset *preset, murk_word_id word)
{
    const char *name = murk_word_rows[word].name;
    const murk_preset_word range = murk_preset_word_of(preset, word);
    if (murk_yaml_get(map, name)) {
        if (range.is_known) {
            return MURK_OK; /* check_ranges() checks the numbers after they are
                             * read */
        }
        murk_scene_where where;
        const double none[MURK_WORD_NUMBERS_MAX] = {0};
        where_of(walk, map, name, true, where);
        return murk_preset_check_word(preset, word, none, where, walk->err);
    }
    bool is_said_otherwise = false;
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_word_id other = (murk_word_id)i;
        is_said_otherwise = is_said_otherwise ||
                            (murk_word_rows[word].is_amount &&
                             murk_word_rows[other].is_amount && other != word &&
                             murk_yaml_get(map, murk_word_rows[other].name));
    }
    if (!range.is_known || !range.has_preset || is_said_otherwise) {
        return MURK_OK;
    }
    return put_default(walk, map, name, range.preset,
                       murk_word_rows[word].numbers);
}

murk_status murk_medium_preset_complete(murk_key_reader *walk, murk_yaml *map)
{
    if (!murk_yaml_get(map, "preset")) {
        return MURK_OK;
    }
    murk_preset *preset = NULL;
    murk_status status = open_preset(walk, map, &preset);
    /* Words of the weather stay out of the tree, so that a resolved scene
     * follows the weather at another time. */
    for (int i = 0; i < MURK_WORDS && !status && !is_by_weather(map); ++i) {
        status = complete_word(walk, map, preset, (murk_word_id)i);
    }
    murk_preset_destroy(preset);
    return status;
}

/* ---- numbers ---- */

static murk_preset_bands bands_of(const murk_scene_desc *scene)
{
    return (murk_preset_bands){.n = scene->bands,
                               .line_nm = scene->band_nm,
                               .edge_nm = scene->has_edges ? scene->band_edge_nm
                                                           : NULL};
}

static murk_status check_ranges(murk_key_reader *walk, const murk_yaml *map,
                                const murk_preset *preset,
                                const murk_words *words)
{
    murk_status status = MURK_OK;
    for (int i = 0; i < MURK_WORDS && !status; ++i) {
        if (words->given[i]) {
            murk_scene_where where;
            const murk_word_id word = (murk_word_id)i;
            where_of(walk, map, murk_word_rows[word].name, false, where);
            status = murk_preset_check_word(preset, word, words->value[i],
                                            where, walk->err);
        }
    }
    return status;
}

static murk_spectrum same_in_all(double g)
{
    return murk_spectrum_flat(g, MURK_BANDS_MAX);
}

/* Stores a mixture in the plainest form that describes the same function: a
 * single kind (not a table), or two terms of Henyey-Greenstein. For a mixture
 * that has no such form, the phase function becomes the owner, and *mixture
 * becomes NULL. */
static void fill_phase(murk_scene_phase *out, murk_mixture **mixture)
{
    const murk_mixture_part *part = (*mixture)->part;
    const size_t n = (*mixture)->n;
    out->kind = part[0].kind;
    if (n == 2 && out->kind == MURK_PHASE_HG && part[1].kind == MURK_PHASE_HG) {
        out->kind = MURK_PHASE_TWO_HG;
        out->value[0] = part[0].value[0];
        out->value[1] = part[1].value[0];
        out->value[2] = part[0].share;
    } else if (n > 1 || out->kind == MURK_PHASE_TABLE) {
        out->kind = MURK_PHASE_TABLE;
        out->mixture = *mixture;
        *mixture = NULL;
    } else if (out->kind == MURK_PHASE_HG) {
        out->mean_cosine = same_in_all(part[0].value[0]);
    } else {
        memcpy(out->value, part[0].value, sizeof out->value);
    }
}

/* Gives the medium the phase functions of the result, which loses the mixtures
 * that the medium then owns. */
static void fill_phases(murk_scene_medium *medium, murk_preset_result *result,
                        int bands)
{
    medium->n_phases = (size_t)bands;
    for (int band = 0; band < bands; ++band) {
        murk_scene_phase *phase = &medium->phase[band];
        memcpy(phase->where, medium->where, sizeof phase->where);
        fill_phase(phase, &result->mixture[band]);
    }
}

static void fill(murk_scene_medium *medium, const murk_yaml *map,
                 murk_preset_result *result, int bands)
{
    if (!murk_yaml_get(map, "extinction_per_m")) {
        medium->extinction_per_m = result->extinction_per_m;
    }
    if (!murk_yaml_get(map, "albedo")) {
        medium->albedo = result->albedo;
    }
    if (!murk_yaml_get(map, "phase")) {
        fill_phases(medium, result, bands);
    }
}

/* ---- a field of a word ---- */

/* Points of the law between the ends of the range of the word, by equal
 * factors: extinctions are powers of amounts or nearly so, and 13 points a
 * decade leave a curve within 1e-3. */
#define PER_DECADE 13
/* The smallest value above 0, relative to the largest: less is as good as 0. */
#define SMALLEST 1e-6

/* The mean over the bands of the extinction over that of `reference`. */
static double relative_extinction(const murk_preset_result *result,
                                  const murk_preset_result *reference,
                                  int bands)
{
    double sum = 0;
    for (int b = 0; b < bands; ++b) {
        sum += result->extinction_per_m.band[b] /
               reference->extinction_per_m.band[b];
    }
    return sum / bands;
}

static bool has_extinction(const murk_preset_result *reference, int bands)
{
    bool has = true;
    for (int b = 0; b < bands; ++b) {
        has = has && reference->extinction_per_m.band[b] > 0;
    }
    return has;
}

/* The values of the law: the least of the range, then by equal factors up to
 * the largest. Returns the number of values. */
static size_t choose_values(double *value, size_t max, double from, double to)
{
    const double first = fmax(from, SMALLEST * to);
    const size_t steps =
        (size_t)fmin((double)max - 2, ceil(PER_DECADE * log10(to / first)));
    size_t n = 0;
    if (from < first) {
        value[n++] = from;
    }
    for (size_t i = 0; i <= steps; ++i) {
        value[n++] = i == steps
                         ? to
                         : first * pow(to / first, (double)i / (double)steps);
    }
    return n;
}

/* Tabulates the density over the range of the word, relative to the extinction
 * that the medium has with its words as they are, `reference`. */
static murk_status make_law(murk_key_reader *walk, const murk_yaml *map,
                            murk_scene_medium *medium,
                            const murk_preset *preset,
                            const murk_preset_result *reference,
                            const murk_preset_bands *bands, const char *where)
{
    enum { POINTS_MAX = 128 };
    const murk_word_id word = (murk_word_id)medium->word;
    const murk_preset_word range = murk_preset_word_of(preset, word);
    murk_words words = medium->words;
    murk_status status = MURK_OK;
    /* The law needs a variable, and something to compare with. */
    if (!medium->variable || !range.is_known) {
        return murk_walk_fail(walk, map,
                              !medium->variable
                                  ? "word: misses variable, must be the name "
                                    "of a variable of the file"
                                  : "word: is no word of this preset");
    }
    if (!has_extinction(reference, bands->n) || !(range.max[0] > 0)) {
        return murk_walk_fail(walk, map,
                              "word: the preset has no extinction with its "
                              "words as they are, must have some to compare "
                              "with");
    }
    medium->law.value = malloc(POINTS_MAX * sizeof *medium->law.value);
    medium->law.density = malloc(POINTS_MAX * sizeof *medium->law.density);
    if (!medium->law.value || !medium->law.density) {
        return murk_walk_no_memory(walk);
    }
    medium->law.n = choose_values(medium->law.value, POINTS_MAX, range.min[0],
                                  range.max[0]);
    words.given[word] = true;
    for (size_t i = 0; i < medium->law.n && !status; ++i) {
        murk_preset_result result = {0};
        words.value[word][0] = medium->law.value[i];
        status = murk_preset_evaluate(&result, preset, &words, bands, where,
                                      walk->err);
        medium->law.density[i] =
            status ? 0 : relative_extinction(&result, reference, bands->n);
        murk_preset_result_release(&result);
    }
    return status;
}

murk_status murk_medium_preset_fill(murk_key_reader *walk, const murk_yaml *map,
                                    murk_scene_medium *medium)
{
    const murk_scene_desc *scene = walk->scene;
    const murk_preset_bands bands = bands_of(scene);
    /* Read the preset, check the words, and evaluate it for the bands of the
     * scene. */
    murk_preset *preset = NULL;
    murk_preset_result result = {0};
    murk_scene_where where;
    where_of(walk, map, "preset", false, where);
    murk_status status = open_preset(walk, map, &preset);
    if (!status && is_by_weather(map)) {
        status = murk_weather_words(&medium->words, walk, map);
    }
    if (!status) {
        status = check_ranges(walk, map, preset, &medium->words);
    }
    if (!status) {
        status = murk_preset_evaluate(&result, preset, &medium->words, &bands,
                                      where, walk->err);
    }
    if (!status && medium->by_word) {
        status = make_law(walk, map, medium, preset, &result, &bands, where);
    }
    if (!status) {
        fill(medium, map, &result, scene->bands);
    }
    murk_preset_result_release(&result);
    murk_preset_destroy(preset);
    return status;
}

/* ---- droplets of a file ---- */

murk_status murk_medium_droplets_fill(murk_scene_medium *out,
                                      const murk_scene_medium *medium,
                                      double radius_um,
                                      const murk_scene_desc *scene,
                                      murk_error *err)
{
    murk_scene_medium made = *medium;
    made.effective_radius_um = radius_um;
    made.albedo = same_in_all(1);
    made.n_phases = 1;
    made.phase[0] = (murk_scene_phase){.kind = MURK_PHASE_HG};
    if (!(radius_um > 0)) {
        *out = made;
        return MURK_OK;
    }
    /* The number of droplets of radius r goes as r^(1/v - 3) exp(-r / (R v))
     * for the effective radius R and the effective variance v. */
    const double v = medium->effective_variance;
    const murk_words words = {
        .value[MURK_WORD_DROPLET_SHAPE] = {1 / v - 3, 1 / (radius_um * v), 1},
        .given[MURK_WORD_DROPLET_SHAPE] = true};
    const murk_preset_bands bands = bands_of(scene);
    murk_preset *preset = NULL;
    murk_preset_result result = {0};
    murk_error cause = {0};
    murk_status status =
        murk_presets_read(&preset, DROPLETS, medium->where, err);
    if (!status) {
        status = murk_preset_evaluate(&result, preset, &words, &bands,
                                      medium->where, &cause);
    }
    if (cause.code) {
        murk_fail(err, status, medium->where, "%s%s", cause.text,
                  status == MURK_BAD_VALUE ? "; or give albedo and phase" : "");
    }
    if (!status) {
        made.albedo = result.albedo;
        fill_phases(&made, &result, scene->bands);
        *out = made;
    }
    murk_preset_result_release(&result);
    murk_preset_destroy(preset);
    return status;
}

void murk_medium_droplets_release(murk_scene_medium *medium)
{
    for (size_t k = 0; k < medium->n_phases; ++k) {
        murk_mixture_destroy(medium->phase[k].mixture);
    }
}

/* ---- the light's key ---- */

static void put_numbers(FILE *out, const double *value, size_t n)
{
    char text[MURK_NUMBER_SIZE];
    for (size_t i = 0; i < n; ++i) {
        murk_number_print(text, value[i]);
        fprintf(out, " %s", text);
    }
}

static void put_mixture(FILE *out, const murk_mixture *mixture)
{
    for (size_t i = 0; i < mixture->n; ++i) {
        const murk_mixture_part *part = &mixture->part[i];
        uint64_t sum[2][2] = {{0}};
        if (part->angles) {
            const size_t bytes = part->angles * sizeof(double);
            murk_checksum(part->angle_deg, bytes, sum[0]);
            murk_checksum(part->phase_per_sr, bytes, sum[1]);
        }
        fprintf(out, " {%d", (int)part->kind);
        put_numbers(out, &part->share, 1);
        put_numbers(out, part->value, MURK_PHASE_NUMBERS_MAX);
        fprintf(out, " %016" PRIx64 "%016" PRIx64 "}", sum[0][1] ^ sum[0][0],
                sum[1][1] ^ sum[1][0]);
    }
}

/* Prints the albedo and the phase functions. */
static void put_scattering(FILE *out, const murk_scene_medium *medium,
                           size_t bands)
{
    put_numbers(out, medium->albedo.band, bands);
    for (size_t k = 0; k < medium->n_phases; ++k) {
        const murk_scene_phase *phase = &medium->phase[k];
        /* The columns must stay as they were in earlier light.murk files: a
         * mixture has the kind 5, and the numbers of fournier_forand come after
         * those of two_hg. */
        double value[MURK_PHASE_NUMBERS_MAX + 2] = {0};
        const bool is_later = phase->kind == MURK_PHASE_FOURNIER_FORAND;
        memcpy(value + (is_later ? MURK_PHASE_NUMBERS_MAX : 0), phase->value,
               (is_later ? 2 : MURK_PHASE_NUMBERS_MAX) * sizeof *value);
        fprintf(out, " %d", phase->mixture ? 5 : (int)phase->kind);
        put_numbers(out, phase->mean_cosine.band, bands);
        put_numbers(out, value, MURK_PHASE_NUMBERS_MAX + 2);
        if (phase->mixture) {
            put_mixture(out, phase->mixture);
        }
    }
}

static void put_medium(FILE *out, const murk_scene_medium *medium, size_t bands)
{
    fprintf(out, "preset %s:", medium->preset);
    put_numbers(out, medium->extinction_per_m.band, bands);
    put_scattering(out, medium, bands);
    put_numbers(out, medium->law.density, medium->law.n);
    fputc('\n', out);
}

void murk_medium_droplets_sign(FILE *out, const murk_scene_medium *medium,
                               int bands)
{
    fprintf(out, "droplets of %s, r in um:", medium->name);
    put_numbers(out, &medium->effective_radius_um, 1);
    put_scattering(out, medium, (size_t)bands);
    fputc('\n', out);
}

void murk_medium_preset_sign(FILE *out, const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_media; ++i) {
        if (scene->media[i].preset) {
            put_medium(out, &scene->media[i], (size_t)scene->bands);
        }
    }
}
