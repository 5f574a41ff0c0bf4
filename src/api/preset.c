/* Presets of media: the list, and the words, optics, sources and doubts of one.
 * Its numbers are those of a scene with this one medium. */
#include "api/save.h"

#include "base/progress.h"
#include "medium/phase.h"
#include "preset/check_words.h"
#include "scene/presets.h"
#include "scene/yaml.h"
#include "world/phases.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MEDIUM "media.medium."

/* The wavelengths that a preset is asked for unless the caller gives bands
 * [nm]: three of the visible and two of lidars. */
static const double USUAL_NM[] = {450, 550, 650, 850, 1550};

/* ---- the list ---- */

static cJSON *list_json(void)
{
    cJSON *root = murk_json_begin_murk();
    cJSON *list = cJSON_AddArrayToObject(root, "presets");
    for (size_t i = 0; i < murk_presets_count(); ++i) {
        char name[MURK_PRESET_NAME_SIZE];
        murk_preset *preset = NULL;
        murk_presets_name(i, name);
        if (murk_presets_read(&preset, name, "", NULL)) {
            continue;
        }
        cJSON *item = murk_json_item(list);
        cJSON_AddStringToObject(item, "name", name);
        cJSON_AddStringToObject(item, "about", preset->about);
        murk_json_numbers(item, "wavelength_nm", preset->wavelength_nm, 2);
        murk_preset_destroy(preset);
    }
    return root;
}

/* ---- one preset, resolved ---- */

/* What is asked for. */
typedef struct request {
    const char *name;
    const char *const *key, *const *value; /* [n] */
    size_t n;
} request;

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

/* True if the key is one of the scene: "visibility_m" is of the medium. */
static bool is_of_scene(const char *key)
{
    return strncmp(key, "band", 4) == 0 || strcmp(key, "seed") == 0;
}

/* Makes overrides of the keys: those of the medium get its path, and the place
 * of a message is the key without the path. False when out of memory. */
static bool make_overrides(murk_override *set, char **text, const request *r)
{
    for (size_t i = 0; i < r->n; ++i) {
        const char *key = r->key[i], *value = r->value[i];
        const size_t size =
            strlen(key) + strlen(value) + sizeof MEDIUM + sizeof MURK_SET_MARK;
        text[i] = malloc(2 * size);
        if (!text[i]) {
            return false;
        }
        char *shown = text[i] + size;
        snprintf(text[i], size, "%s%s=%s", is_of_scene(key) ? "" : MEDIUM, key,
                 value);
        snprintf(shown, size, MURK_SET_MARK "%s=%s", key, value);
        set[i] = (murk_override){text[i], shown};
    }
    return true;
}

/* Reads a scene with this one medium, at the usual wavelengths of the preset
 * unless the caller gives bands. */
static murk_status read_scene(resolved *r, const request *asked,
                              murk_error *err)
{
    const size_t n = asked->n;
    murk_override *set = calloc(n + 1, sizeof *set);
    char **text = calloc(n + 1, sizeof *text);
    char *yaml = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&yaml, &size);
    bool is_whole = set && text && to && make_overrides(set, text, asked);
    /* The text of the scene. */
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

static murk_status make_one(cJSON **out, const request *asked, murk_error *err)
{
    resolved r = {0};
    murk_progress_begin_group("media", 0, "");
    murk_status status =
        murk_presets_read(&r.preset, asked->name, "media", err);
    if (!status) {
        status = read_scene(&r, asked, err);
    }
    if (!status) {
        status = murk_phases_create(&r.phases, r.scene, NULL, err);
    }
    murk_progress_end();
    *out = status ? NULL : one_json(&r);
    murk_phases_destroy(r.phases);
    murk_scene_desc_destroy(r.scene);
    murk_preset_destroy(r.preset);
    return status;
}

/* ---- the call ---- */

/* The text of all input, for the identity; NULL when out of memory. */
static char *input_of(const request *asked)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return NULL;
    }
    fprintf(to, "%s\n", asked->name ? asked->name : "");
    for (size_t i = 0; i < asked->n; ++i) {
        fprintf(to, "%s=%s\n", asked->key[i], asked->value[i]);
    }
    if (fclose(to) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

static murk_status describe(murk_fields *fields, const request *asked,
                            const murk_save_options *options, murk_error *err)
{
    /* Check the keys. */
    cJSON *root = NULL;
    murk_status status =
        murk_call_check_texts(err, "key", asked->key, asked->n);
    if (!status) {
        status = murk_call_check_texts(err, "value", asked->value, asked->n);
    }
    if (!status && !asked->name && asked->n > 0) {
        status = murk_call_bad_argument(err, "key",
                                        "the list of all presets has no keys");
    }
    /* The preset or the list, with the identity. */
    if (!status && asked->name) {
        status = make_one(&root, asked, err);
    }
    if (status) {
        return status;
    }
    root = asked->name ? root : list_json();
    char *input = input_of(asked);
    status = input ? murk_save_alone(fields, root, "media", options, input,
                                     NULL, err)
                   : murk_no_memory(err, "", "for the identity");
    if (!input) {
        cJSON_Delete(root);
    }
    free(input);
    return status;
}

murk_status murk_context_preset(murk_context *context, const char *name,
                                const char *const *key,
                                const char *const *value, size_t n,
                                const murk_save_options *options,
                                const murk_fields **fields, murk_error *error)
{
    if (!context || !fields) {
        return murk_save_refuse(fields, error, "context or fields is NULL");
    }
    const request asked = {name, key, value, n};
    murk_call call = murk_call_begin(context, NULL, error);
    murk_status status = murk_save_check_options(options, &call.failure);
    if (!status) {
        status = describe(&context->preset, &asked, options, &call.failure);
    }
    status = murk_call_end_long(&call, status);
    *fields = status ? NULL : &context->preset;
    return status;
}
