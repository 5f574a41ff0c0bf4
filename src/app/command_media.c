/* murk media: lists the presets of media, or prints one of them with the
 * optical properties in each band. The numbers are computed for a scene whose
 * only medium is the preset. */
#include "app/identity.h"
#include "app/media_profile.h"
#include "base/progress.h"
#include "results/results.h"
#include "results/summary.h"

#include "medium/phase.h"
#include "preset/check_words.h"
#include "scene/presets.h"
#include "world/phases.h"

#include <stdlib.h>
#include <string.h>

#define MEDIUM "media.medium."
#define WIDTH  26 /* of names in the list */

/* The wavelengths [nm] at which a preset is shown, if they are in the range of
 * the preset and --set gives no others. */
static const double USUAL_NM[] = {450, 550, 650, 850, 1550};

/* ---- the list ---- */

/* Prints all presets, or adds them to a list of JSON. */
static void show_list(cJSON *list)
{
    for (size_t i = 0; i < murk_presets_count(); ++i) {
        char name[MURK_PRESET_NAME_SIZE];
        murk_preset *preset = NULL;
        murk_presets_name(i, name);
        if (murk_presets_read(&preset, name, "", NULL)) {
            continue;
        }
        const double *range = preset->wavelength_nm;
        if (list) {
            cJSON *item = murk_json_item(list);
            cJSON_AddStringToObject(item, "name", name);
            cJSON_AddStringToObject(item, "about", preset->about);
            murk_json_numbers(item, "wavelength_nm", range, 2);
        } else {
            murk_print("%-*s %5g..%-5g nm  %s\n", WIDTH, name, range[0],
                       range[1], preset->about);
        }
        murk_preset_destroy(preset);
    }
}

/* ---- one preset, resolved ---- */

typedef struct resolved {
    murk_preset *preset;
    murk_scene_desc *scene;
    murk_phases *phases;
} resolved;

static void put_bands(FILE *to, const murk_preset *preset)
{
    const double *range = preset->wavelength_nm;
    size_t n = 0;
    for (size_t i = 0; i < sizeof USUAL_NM / sizeof *USUAL_NM; ++i) {
        if (USUAL_NM[i] >= range[0] && USUAL_NM[i] <= range[1]) {
            fprintf(to, "%s%.9g", n++ ? ", " : "", USUAL_NM[i]);
        }
    }
    if (n == 0) {
        fprintf(to, "%.17g", range[0]);
    }
}

/* "visibility_m=50" speaks of the medium, "bands_nm=[532]" of the scene. */
static bool is_of_scene(const char *text)
{
    return strncmp(text, "band", 4) == 0 || strncmp(text, "seed=", 5) == 0;
}

static murk_status read_scene(resolved *r, const murk_options *options,
                              murk_error *err)
{
    const size_t n = options->n_overrides;
    murk_override *set = calloc(n + 1, sizeof *set);
    char **text = calloc(n + 1, sizeof *text);
    char *yaml = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&yaml, &size);
    bool is_whole = set && text && to;
    /* Keys of --set belong to the medium, except those of bands and seed;
     * messages show them as they were typed. */
    for (size_t i = 0; i < n && is_whole; ++i) {
        const murk_override *given = &options->overrides[i];
        const size_t capacity = strlen(given->text) + sizeof MEDIUM;
        text[i] = malloc(2 * capacity);
        is_whole = text[i] != NULL;
        if (is_whole) {
            char *shown = text[i] + capacity;
            snprintf(text[i], capacity, "%s%s",
                     is_of_scene(given->text) ? "" : MEDIUM, given->text);
            snprintf(shown, capacity, "--set %s", given->text);
            set[i] =
                (murk_override){text[i], given->option ? given->option : shown};
        }
    }
    /* A scene with this one medium, at the usual wavelengths of the preset. */
    if (to) {
        fputs("murk: 1\nbands_nm: [", to);
        put_bands(to, r->preset);
        fprintf(to,
                "]\nmedia: {medium: {preset: %s}}\n"
                "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n",
                r->preset->name);
        is_whole = fclose(to) == 0 && is_whole;
    }
    /* Read it as any scene is read. */
    const murk_status status =
        is_whole ? murk_scene_desc_parse(&r->scene, yaml, r->preset->name, set,
                                         n, err)
                 : murk_no_memory(err, "", "for a preset");
    for (size_t i = 0; i < n && text; ++i) {
        free(text[i]);
    }
    free(yaml);
    free(set);
    free(text);
    return status;
}

/* "400..500" or "550" */
static void band_name(const murk_scene_desc *scene, int band, char out[40])
{
    if (scene->has_edges) {
        snprintf(out, 40, "%.6g..%.6g", scene->band_edge_nm[band],
                 scene->band_edge_nm[band + 1]);
    } else {
        snprintf(out, 40, "%.6g", scene->band_nm[band]);
    }
}

/* ---- as text ---- */

static void print_numbers(const double *value, int n)
{
    murk_print("%s", n > 1 ? "[" : "");
    for (int k = 0; k < n; ++k) {
        murk_print("%s%.6g", k ? ", " : "", value[k]);
    }
    murk_print("%s", n > 1 ? "]" : "");
}

static void print_words(const resolved *r)
{
    const murk_scene_medium *medium = &r->scene->media[0];
    bool any = false;
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_word_id id = (murk_word_id)i;
        const murk_preset_word word = murk_preset_word_of(r->preset, id);
        const int n = murk_word_rows[id].numbers;
        if (!word.is_known) {
            continue;
        }
        if (!any) { /* newlines stand in the format, because murk_print()
                     * escapes those in arguments */
            murk_print("\nwords\n");
        }
        murk_print("  %s: ", murk_word_rows[id].name);
        any = true;
        print_numbers(word.min, n);
        murk_print(" to ");
        print_numbers(word.max, n);
        murk_print(" %s", murk_word_rows[id].unit);
        if (word.has_preset) {
            murk_print(", default ");
            print_numbers(word.preset, n);
        }
        if (medium->words.given[i]) {
            murk_print(", here ");
            print_numbers(medium->words.value[i], n);
        }
        murk_print("\n");
    }
}

static void print_sources(const murk_preset *preset)
{
    murk_print("\nsources\n");
    for (size_t i = 0; i < preset->sources; ++i) {
        const murk_preset_source *s = &preset->source[i];
        murk_print("  %s: %s%s%s%s\n", s->what, s->from,
                   s->quoted_by ? " (second hand: " : "",
                   s->quoted_by ? s->quoted_by : "", s->quoted_by ? ")" : "");
    }
    if (preset->doubts.n > 0) {
        murk_print("\ndoubts\n");
    }
    for (size_t i = 0; i < preset->doubts.n; ++i) {
        murk_print("  %s\n", preset->doubts.text[i]);
    }
}

static void print_one(const resolved *r)
{
    const murk_scene_medium *medium = &r->scene->media[0];
    murk_print("%s: %s\nwavelengths %g..%g nm\n", r->preset->name,
               r->preset->about, r->preset->wavelength_nm[0],
               r->preset->wavelength_nm[1]);
    print_words(r);
    murk_print("\n%13s  %12s  %8s  %12s  %12s  %9s  %s\n", "band nm",
               "extinction/m", "albedo", "absorption/m", "scattering/m",
               "mean cos", "phase");
    for (int band = 0; band < r->scene->bands; ++band) {
        char name[40];
        const double extinction = medium->extinction_per_m.band[band];
        const double albedo = medium->albedo.band[band];
        band_name(r->scene, band, name);
        murk_print("%13s  %12.6g  %8.6f  %12.6g  %12.6g  %9.4f  %s\n", name,
                   extinction, albedo, extinction * (1 - albedo),
                   extinction * albedo,
                   murk_phase_mean_cosine(&r->phases->medium[0][band]),
                   murk_phases_kind(medium, band));
    }
    print_sources(r->preset);
}

/* ---- as JSON ---- */

static cJSON *numbers_json(const double *value, int n)
{
    return n == 1 ? cJSON_CreateNumber(value[0])
                  : cJSON_CreateDoubleArray(value, n);
}

static void add_words(cJSON *root, const resolved *r)
{
    const murk_scene_medium *medium = &r->scene->media[0];
    cJSON *words = cJSON_AddObjectToObject(root, "words");
    for (int i = 0; i < MURK_WORDS; ++i) {
        const murk_word_id id = (murk_word_id)i;
        const murk_preset_word word = murk_preset_word_of(r->preset, id);
        const int n = murk_word_rows[id].numbers;
        if (!word.is_known) {
            continue;
        }
        cJSON *item = cJSON_AddObjectToObject(words, murk_word_rows[id].name);
        cJSON_AddItemToObject(item, "value",
                              medium->words.given[i]
                                  ? numbers_json(medium->words.value[i], n)
                                  : cJSON_CreateNull());
        cJSON_AddItemToObject(item, "default",
                              word.has_preset ? numbers_json(word.preset, n)
                                              : cJSON_CreateNull());
        cJSON_AddItemToObject(item, "least", numbers_json(word.min, n));
        cJSON_AddItemToObject(item, "most", numbers_json(word.max, n));
        cJSON_AddStringToObject(item, "unit", murk_word_rows[id].unit);
    }
}

static void add_bands(cJSON *root, const resolved *r)
{
    const murk_scene_desc *scene = r->scene;
    const murk_scene_medium *medium = &scene->media[0];
    cJSON *bands = cJSON_AddArrayToObject(root, "bands");
    for (int band = 0; band < scene->bands; ++band) {
        cJSON *item = murk_json_item(bands);
        const double extinction = medium->extinction_per_m.band[band];
        const double albedo = medium->albedo.band[band];
        murk_json_number(item, "band_nm", scene->band_nm[band]);
        if (scene->has_edges) {
            murk_json_numbers(item, "band_edges_nm", &scene->band_edge_nm[band],
                              2);
        }
        murk_json_number(item, "extinction_per_m", extinction);
        murk_json_number(item, "albedo", albedo);
        murk_json_number(item, "absorption_per_m", extinction * (1 - albedo));
        murk_json_number(item, "scattering_per_m", extinction * albedo);
        murk_json_number(item, "mean_cosine",
                         murk_phase_mean_cosine(&r->phases->medium[0][band]));
        cJSON_AddStringToObject(item, "phase", murk_phases_kind(medium, band));
    }
}

static cJSON *one_json(const resolved *r)
{
    const murk_preset *preset = r->preset;
    cJSON *root = murk_json_begin_murk();
    cJSON_AddStringToObject(root, "preset", preset->name);
    cJSON_AddStringToObject(root, "about", preset->about);
    murk_json_numbers(root, "wavelength_nm", preset->wavelength_nm, 2);
    /* The words that the preset knows, and the optics of each band. */
    add_words(root, r);
    add_bands(root, r);
    /* Sources and doubts. */
    cJSON *sources = cJSON_AddArrayToObject(root, "sources");
    for (size_t i = 0; i < preset->sources; ++i) {
        const murk_preset_source *s = &preset->source[i];
        cJSON *item = murk_json_item(sources);
        cJSON_AddStringToObject(item, "what", s->what);
        cJSON_AddStringToObject(item, "from", s->from);
        cJSON_AddItemToObject(item, "quoted_by",
                              s->quoted_by ? cJSON_CreateString(s->quoted_by)
                                           : cJSON_CreateNull());
    }
    cJSON *doubts = cJSON_AddArrayToObject(root, "doubts");
    for (size_t i = 0; i < preset->doubts.n; ++i) {
        cJSON_AddItemToArray(doubts,
                             cJSON_CreateString(preset->doubts.text[i]));
    }
    return root;
}

/* ---- the command ---- */

static murk_status say_one(const murk_options *options, murk_error *err)
{
    resolved r = {0};
    murk_progress_set(options->quiet ? MURK_PROGRESS_NEVER : options->progress);
    murk_progress_begin_group("media", 0, "");
    murk_status status =
        murk_presets_read(&r.preset, options->input, "media", err);
    if (!status) {
        status = read_scene(&r, options, err);
    }
    if (!status) {
        status = murk_phases_create(&r.phases, r.scene, err);
    }
    murk_progress_end();
    if (!status && options->json) {
        status =
            murk_print_alone(one_json(&r), options, options->input, NULL, err);
    } else if (!status && !options->quiet) {
        print_one(&r);
    }
    murk_phases_destroy(r.phases);
    murk_scene_desc_destroy(r.scene);
    murk_preset_destroy(r.preset);
    return status;
}

murk_status murk_command_media(const murk_options *options, murk_error *err)
{
    if (options->profile) {
        return murk_command_media_profile(options, err);
    }
    /* Options of --profile have no meaning without it. */
    if (options->out || murk_option_text(options, "--column") ||
        murk_option_text(options, "--rows") || options->voxel ||
        murk_option_text(options, "--width")) {
        return murk_fail(err, MURK_BAD_VALUE, "media",
                         "-o, --column, --rows, --voxel and --width need "
                         "--profile");
    }
    /* One preset, or the list of all. */
    if (options->input) {
        return say_one(options, err);
    }
    if (options->n_overrides) {
        return murk_fail(err, MURK_BAD_VALUE, "media",
                         "--set needs the name of a preset");
    }
    if (options->json) {
        cJSON *root = murk_json_begin_murk();
        show_list(cJSON_AddArrayToObject(root, "presets"));
        return murk_print_alone(root, options, "", NULL, err);
    }
    if (!options->quiet) {
        show_list(NULL);
    }
    return MURK_OK;
}
