/* Presets: every file that is built in reads and gives sane numbers over all of
 * its wavelengths and words; words, overrides and refusals. No randomness. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "preset/visibility.h"
#include "scene/presets.h"
#include "scene_files.h"

#define SCENE(bands, medium)                            \
    "murk: 1\n" bands "\nmedia:\n  fog: {" medium "}\n" \
    "lights: [{type: point, position_m: [0, 0, 0], "    \
    "power_w: 1}]\n"
#define LINES "bands_nm: [450, 550]"
#define EDGES "band_edges_nm: [400, 500, 600]"

static void check_result(const murk_preset_result *result, const char *name)
{
    for (int band = 0; band < 2; ++band) {
        const double extinction = result->extinction_per_m.band[band];
        const double albedo = result->albedo.band[band];
        double sum = 0;
        for (size_t i = 0; i < result->mixture[band]->n; ++i) {
            sum += result->mixture[band]->part[i].share;
        }
        const bool is_sane = extinction >= 0 && isfinite(extinction) &&
                             albedo >= 0 && albedo <= 1 &&
                             fabs(sum - 1) < 1e-12;
        if (!is_sane) {
            printf("%s: extinction %g, albedo %g\n", name, extinction, albedo);
        }
        CHECK(is_sane);
    }
}

/* Every built-in preset with default words, at lines on the ends of the
 * wavelengths and in two bands over all of them. */
static void test_all_that_are_built_in(void)
{
    /* Each preset can be read. */
    CHECK(murk_presets_count() > 10);
    char past[MURK_PRESET_NAME_SIZE] = "x";
    murk_presets_name(murk_presets_count(), past);
    CHECK_TEXT(past, "");
    for (size_t i = 0; i < murk_presets_count(); ++i) {
        char name[MURK_PRESET_NAME_SIZE];
        murk_preset *preset = NULL;
        murk_error err = {0};
        murk_presets_name(i, name);
        CHECK(murk_presets_read(&preset, name, "", &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
        if (!preset) {
            continue;
        }
        /* Evaluate the preset at both ends of the wavelengths, and in two
         * bands over all of them. */
        const double *range = preset->wavelength_nm;
        const double edges[3] = {range[0], (range[0] + range[1]) / 2, range[1]};
        murk_words words = {{0}, {{0}}};
        for (int k = 0; k < 2; ++k) {
            const murk_preset_bands bands = {2, range, k ? edges : NULL};
            murk_preset_result result = {0};
            CHECK(murk_preset_evaluate(&result, preset, &words, &bands, "",
                                       &err) == MURK_OK);
            CHECK_TEXT(err.text, "");
            if (err.code == MURK_OK) {
                check_result(&result, name);
            }
            murk_preset_result_release(&result);
        }
        murk_preset_destroy(preset);
    }
}

static murk_spectrum extinction_of(const char *text, murk_error *err)
{
    murk_scene_desc *scene = NULL;
    murk_spectrum out = {{0}};
    if (scene_of(&scene, text, NULL, 0, err) == MURK_OK) {
        out = scene->media[0].extinction_per_m;
    }
    CHECK_TEXT(err->text, "");
    murk_scene_desc_destroy(scene);
    return out;
}

static void test_visibility_and_mor(void)
{
    murk_error err;
    murk_spectrum s =
        extinction_of(SCENE(LINES, "preset: fog/kim, visibility_m: 50"), &err);
    CHECK_NEAR(s.band[1], 3.912023 / 50, 1e-8);
    s = extinction_of(SCENE(LINES, "preset: fog/kim, mor_m: 50"), &err);
    CHECK_NEAR(s.band[1], 2.995732 / 50, 1e-8);
    /* scaled parts make up what the others leave */
    s = extinction_of(SCENE(LINES, "preset: air/haze, mor_m: 5000"), &err);
    CHECK_NEAR(s.band[1], 2.995732 / 5000, 1e-10);
}

/* The mean of (x / 550)^-q over a band, by its integral. */
static void test_a_band_with_edges_is_its_mean(void)
{
    murk_error err;
    const murk_spectrum s = extinction_of(
        SCENE(EDGES, "preset: fog/kruse, visibility_m: 10000"), &err);
    const double q = 1.3, c = murk_visibility_extinction(10000) * pow(550, q);
    const double mean = c * (pow(500, 1 - q) - pow(400, 1 - q)) / (1 - q) / 100;
    CHECK_NEAR(s.band[0], mean, 1e-4 * mean); /* midpoints: 3e-5 */
    CHECK(fabs(s.band[0] - c * pow(450, -q)) > 3e-3 * mean); /* teeth */
}

static void test_what_the_scene_says_wins(void)
{
    murk_scene_desc *scene = NULL;
    murk_error err;
    CHECK(scene_of(&scene,
                   SCENE(LINES, "preset: smoke/flaming, albedo: .5, "
                                "extinction_per_m: [1, 2], phase: {hg: .1}"),
                   NULL, 0, &err) == MURK_OK);
    if (scene) {
        const murk_scene_medium *m = &scene->media[0];
        CHECK(m->albedo.band[0] == .5 && m->albedo.band[1] == .5);
        CHECK(m->extinction_per_m.band[1] == 2 && m->n_phases == 1);
        CHECK(m->phase[0].mean_cosine.band[1] == .1);
        CHECK(strstr(scene->resolved, "soot_g_per_m3: 0.1") != NULL);
        CHECK(strstr(scene->light_key, "preset smoke/flaming:") != NULL);
    }
    murk_scene_desc_destroy(scene);
}

/* Haze is a mixture: a lobe and the molecules, by their scattering. */
static void test_mixtures(void)
{
    murk_scene_desc *scene = NULL;
    murk_error err;
    CHECK(scene_of(&scene, SCENE(LINES, "preset: air/haze"), NULL, 0, &err) ==
          MURK_OK);
    if (scene) {
        const murk_scene_medium *m = &scene->media[0];
        const murk_mixture *mixture = m->phase[1].mixture;
        CHECK(m->n_phases == 2 && mixture && mixture->n == 2);
        if (mixture && mixture->n == 2) {
            const double air =
                1.14871e-5 / (m->extinction_per_m.band[1] * m->albedo.band[1]);
            CHECK(mixture->part[0].kind == MURK_PHASE_RAYLEIGH);
            CHECK_NEAR(mixture->part[0].share, air, 1e-6);
        }
    }
    murk_scene_desc_destroy(scene);
}

/* Options and conditions turn the words, and what is resolved reads the same.
 */
static void test_options_and_conditions(void)
{
    static const char text[] =
        SCENE(LINES,
              "preset: fog/kim") "conditions: {thick: {media.fog.mor_m: 50}}\n";
    const murk_override set = {.text = "media.fog.visibility_m=100"};
    murk_scene_desc *scene = NULL, *again = NULL;
    murk_error err;
    CHECK(scene_of(&scene, text, &set, 1, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (scene) {
        const murk_scene_desc *thick = scene->conditions[0].scene;
        CHECK_NEAR(scene->media[0].extinction_per_m.band[1], .03912023, 1e-8);
        CHECK_NEAR(thick->media[0].extinction_per_m.band[1], .05991465, 1e-8);
        CHECK(strcmp(thick->light_key, scene->light_key) != 0);
        CHECK(scene_of(&again, scene->resolved, NULL, 0, &err) == MURK_OK);
        CHECK(again && strcmp(again->resolved, scene->resolved) == 0);
        CHECK(again && strcmp(again->light_key, scene->light_key) == 0);
    }
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

/* Whether a scene and its resolved form give the same light with an option,
 * NULL for none: both do, or neither. */
static bool turns_alike(const char *text, const char *resolved,
                        const char *option)
{
    const murk_override set = {.text = option};
    murk_scene_desc *one = NULL, *other = NULL;
    murk_error err;
    scene_of(&one, text, &set, option != NULL, &err);
    scene_of(&other, resolved, &set, option != NULL, &err);
    const bool is_alike = one && other
                              ? strcmp(one->light_key, other->light_key) == 0 &&
                                    strcmp(one->resolved, other->resolved) == 0
                              : !one && !other;
    if (!is_alike) {
        printf("%s\n-> %s (%s %s)\n", text, option ? option : "", err.where,
               err.text);
    }
    murk_scene_desc_destroy(other);
    murk_scene_desc_destroy(one);
    return is_alike;
}

/* "media.fog.WORD=VALUE" of a number that the preset takes. */
static void word_option(char *out, size_t size, const murk_preset *preset,
                        murk_word_id word)
{
    const murk_preset_word *w = &preset->word[word];
    const int numbers = murk_word_rows[word].numbers;
    size_t used = (size_t)snprintf(out, size, "media.fog.%s=[",
                                   murk_word_rows[word].name);
    for (int i = 0; i < numbers; ++i) {
        const double value = w->has_preset
                                 ? .75 * w->preset[i] + .25 * w->min[i]
                                 : fmin(w->max[i], fmax(w->min[i], 1));
        used += (size_t)snprintf(out + used, size - used, "%s%.9g",
                                 i ? ", " : "", value);
    }
    snprintf(out + used, size - used, "]");
    if (numbers == 1) { /* a number, not a list of one */
        *strchr(out, '[') = ' ';
        *strchr(out, ']') = ' ';
    }
}

/* Bits of the words that it knows. */
static unsigned words_of(const murk_preset *preset)
{
    unsigned known = 0;
    for (int w = 0; w < MURK_WORDS; ++w) {
        known |= preset->word[w].is_known ? 1u << w : 0;
    }
    return known;
}

static void check_turning(const murk_preset *preset)
{
    char text[400], option[200];
    murk_scene_desc *scene = NULL;
    murk_error err;
    snprintf(text, sizeof text, SCENE("bands_nm: [550]", "preset: %s"),
             preset->name);
    CHECK(scene_of(&scene, text, NULL, 0, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (scene) {
        CHECK(turns_alike(text, scene->resolved, NULL));
        CHECK(turns_alike(text, scene->resolved, "media.fog.albedo=.5"));
    }
    for (int w = 0; scene && w < MURK_WORDS; ++w) {
        if (preset->word[w].is_known) {
            word_option(option, sizeof option, preset, (murk_word_id)w);
            CHECK(turns_alike(text, scene->resolved, option));
        }
    }
    murk_scene_desc_destroy(scene);
}

/* The scene.yaml of a result folder can be turned like the scene it is of: by
 * one preset for each set of words. */
static void test_what_is_resolved_can_be_turned(void)
{
    unsigned seen[32] = {0};
    size_t kinds = 0;
    for (size_t i = 0; i < murk_presets_count(); ++i) {
        char name[MURK_PRESET_NAME_SIZE];
        murk_preset *preset = NULL;
        murk_error err = {0};
        size_t k = 0;
        murk_presets_name(i, name);
        CHECK(murk_presets_read(&preset, name, "", &err) == MURK_OK);
        while (preset && k < kinds && seen[k] != words_of(preset)) {
            ++k;
        }
        if (preset && k == kinds && kinds < sizeof seen / sizeof *seen) {
            seen[kinds++] = words_of(preset);
            check_turning(preset);
        }
        murk_preset_destroy(preset);
    }
    CHECK(kinds > 5);
}

static void test_refusals(void)
{
    /* Values outside of the limits of all words, and outside of the limits
     * of the preset. */
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kim, visibility_m: 0"),
                  MURK_BAD_VALUE, "fog.yaml:4:40: media.fog.visibility_m",
                  "0, must be more than 0 and at most 1e9 m");
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kim, visibility_m: -5"),
                  MURK_BAD_VALUE, "fog.yaml:4:40: media.fog.visibility_m",
                  "-5, must be more than 0 and at most 1e9 m");
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kim, visibility_m: 5"),
                  MURK_BAD_VALUE, "fog.yaml:4:40: media.fog.visibility_m",
                  "5, must be 10..200000 m for fog/kim");
    /* Two words for one quantity, a misspelt preset, and a word of other
     * presets. */
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kim, visibility_m: 50, mor_m: 5"),
                  MURK_BAD_VALUE, "fog.yaml:4:3: media.fog",
                  "has visibility_m and mor_m, must have one of them");
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kimm"), MURK_BAD_VALUE,
                  "fog.yaml:4:17: media.fog.preset",
                  "no preset fog/kimm, did you mean fog/kim?");
    CHECK_REFUSED(SCENE(LINES, "preset: fog/kim, rain_mm_per_h: 1"),
                  MURK_BAD_VALUE, "fog.yaml:4:26: media.fog.rain_mm_per_h",
                  "fog/kim does not know it, must be one of visibility_m, "
                  "mor_m");
    /* A band outside of the wavelengths, and a list in place of a name. */
    CHECK_REFUSED(SCENE("bands_nm: [350]", "preset: air/haze"), MURK_BAD_VALUE,
                  "fog.yaml:4:17: media.fog.preset",
                  "a band at 350 nm, must be within 400..1550 nm for air/haze "
                  "(Angstrom, Tellus 16 (1964) 64, "
                  "doi:10.1111/j.2153-3490.1964.tb00144.x)");
    CHECK_REFUSED(SCENE(LINES, "preset: [fog/kim]"), MURK_BAD_VALUE,
                  "fog.yaml:4:9: media.fog.preset",
                  "no preset , must be one of those that `murk media` lists");
}

/* Preset files come with murk, and still an error in one is reported with
 * its place. */
static void test_files_that_are_wrong(void)
{
    /* A head that is right, followed by a rest with an error. */
    static const char HEAD[] = "murk_preset: 1\nabout: x\n"
                               "sources: [{what: a, from: b}]\n";
    static const struct {
        const char *rest, *where, *text;
    } wrong[] = {
        {"wavelength_nm: [500, 400]\nparts: [{table: {wavelength_nm: [400, "
         "500], scattering_per_m: [1, 1]}}]\n",
         "x.yaml:4:1", "wavelength_nm must rise"},
        {"wavelength_nm: [400, 500]\nparts: []\n", "x.yaml:5:1: parts",
         "an empty list, must be a list of 1..8 parts"},
        {"wavelength_nm: [400, 500]\nparts: [{law: none}]\n",
         "x.yaml:5:15: parts.0.law", "none, must be the name of a law"},
        {"wavelength_nm: [400, 500]\nparts: [{law: kim, albedo: 1}]\n",
         "x.yaml:5:15: parts.0",
         "the law kim needs the word visibility_m with a default"},
        {"wavelength_nm: [400, 500]\nparts: [{table: {wavelength_nm: [400, "
         "450], scattering_per_m: [1, 1]}}]\n",
         "x.yaml:5:10: parts.0", "spans 400..450 nm, less than wavelength_nm"},
        {"wavelength_nm: [400, 500]\nparts: [{phase: {table: none.csv}}]\n",
         "x.yaml:5:25: parts.0.phase.table", "no file none.csv in media"},
    };
    /* The message names line, column and fault. */
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        char text[400];
        murk_preset *preset = NULL;
        murk_error err = {0};
        snprintf(text, sizeof text, "%s%s", HEAD, wrong[i].rest);
        CHECK(murk_preset_parse(&preset, "x", text, strlen(text), &err) ==
              MURK_BAD_VALUE);
        CHECK(preset == NULL);
        CHECK_TEXT(err.where, wrong[i].where);
        CHECK_TEXT(err.text, wrong[i].text);
    }
}

int main(void)
{
    test_all_that_are_built_in();
    test_files_that_are_wrong();
    if (folder_enter()) {
        test_visibility_and_mor();
        test_a_band_with_edges_is_its_mean();
        test_what_the_scene_says_wins();
        test_mixtures();
        test_options_and_conditions();
        test_what_is_resolved_can_be_turned();
        test_refusals();
        folder_leave((const char *const[]){"fog.yaml", NULL});
    }
    return check_done();
}
