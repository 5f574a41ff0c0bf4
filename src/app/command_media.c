/* murk media: lists the presets of media, or prints one of them with the
 * optical properties in each band. The numbers are those of
 * murk_context_preset(). */
#include "app/field.h"
#include "app/given.h"
#include "app/media_profile.h"
#include "app/show.h"
#include "base/print.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 26 /* of names in the list */

/* ---- the list ---- */

static void print_list(const murk_fields *f)
{
    const size_t n = murk_fields_length(f, "presets");
    for (size_t i = 0; i < n; ++i) {
        murk_print("%-*s %5g..%-5g nm  %s\n", WIDTH,
                   murk_field_text(f, "presets.%zu.name", i),
                   murk_field_number(f, "presets.%zu.wavelength_nm.0", i),
                   murk_field_number(f, "presets.%zu.wavelength_nm.1", i),
                   murk_field_text(f, "presets.%zu.about", i));
    }
}

/* ---- one preset ---- */

/* Prints a number or a list of numbers: the field `name` of a word. */
static void print_numbers(const murk_fields *f, const char *word,
                          const char *name)
{
    const size_t n = murk_field_length(f, "words.%s.%s", word, name);
    if (n == 0) {
        murk_print("%.6g", murk_field_number(f, "words.%s.%s", word, name));
        return;
    }
    murk_print("[");
    for (size_t k = 0; k < n; ++k) {
        murk_print("%s%.6g", k ? ", " : "",
                   murk_field_number(f, "words.%s.%s.%zu", word, name, k));
    }
    murk_print("]");
}

/* Prints a value of a word, unless it is null. */
static void print_value(const murk_fields *f, const char *before,
                        const char *word, const char *name)
{
    char path[MURK_FIELD_PATH_SIZE];
    snprintf(path, sizeof path, "words.%s.%s", word, name);
    if (murk_fields_kind(f, path) != MURK_FIELD_ABSENT) {
        murk_print("%s", before);
        print_numbers(f, word, name);
    }
}

static void print_words(const murk_fields *f)
{
    const size_t n = murk_fields_length(f, "words");
    if (n > 0) {
        murk_print("\nwords\n");
    }
    for (size_t i = 0; i < n; ++i) {
        const char *name = murk_fields_name(f, "words", i);
        murk_print("  %s: ", name);
        print_numbers(f, name, "least");
        murk_print(" to ");
        print_numbers(f, name, "most");
        murk_print(" %s", murk_field_text(f, "words.%s.unit", name));
        print_value(f, ", default ", name, "default");
        print_value(f, ", here ", name, "value");
        murk_print("\n");
    }
}

/* Prints "400..500" or "550", right-aligned. */
static void print_band(const murk_fields *f, size_t i)
{
    char name[40];
    if (murk_field_length(f, "bands.%zu.band_edges_nm", i) > 0) {
        snprintf(name, sizeof name, "%.6g..%.6g",
                 murk_field_number(f, "bands.%zu.band_edges_nm.0", i),
                 murk_field_number(f, "bands.%zu.band_edges_nm.1", i));
    } else {
        snprintf(name, sizeof name, "%.6g",
                 murk_field_number(f, "bands.%zu.band_nm", i));
    }
    murk_print("%13s", name);
}

static void print_bands(const murk_fields *f)
{
    murk_print("\n%13s  %12s  %8s  %12s  %12s  %9s  %s\n", "band nm",
               "extinction/m", "albedo", "absorption/m", "scattering/m",
               "mean cos", "phase");
    const size_t n = murk_fields_length(f, "bands");
    for (size_t i = 0; i < n; ++i) {
        print_band(f, i);
        murk_print("  %12.6g  %8.6f  %12.6g  %12.6g  %9.4f  %s\n",
                   murk_field_number(f, "bands.%zu.extinction_per_m", i),
                   murk_field_number(f, "bands.%zu.albedo", i),
                   murk_field_number(f, "bands.%zu.absorption_per_m", i),
                   murk_field_number(f, "bands.%zu.scattering_per_m", i),
                   murk_field_number(f, "bands.%zu.mean_cosine", i),
                   murk_field_text(f, "bands.%zu.phase", i));
    }
}

static void print_sources(const murk_fields *f)
{
    murk_print("\nsources\n");
    const size_t sources = murk_fields_length(f, "sources"),
                 doubts = murk_fields_length(f, "doubts");
    for (size_t i = 0; i < sources; ++i) {
        const char *by = murk_field_text(f, "sources.%zu.quoted_by", i);
        murk_print("  %s: %s%s%s%s\n",
                   murk_field_text(f, "sources.%zu.what", i),
                   murk_field_text(f, "sources.%zu.from", i),
                   by ? " (second hand: " : "", by ? by : "", by ? ")" : "");
    }
    if (doubts > 0) {
        murk_print("\ndoubts\n");
    }
    for (size_t i = 0; i < doubts; ++i) {
        murk_print("  %s\n", murk_field_text(f, "doubts.%zu", i));
    }
}

static void print_one(const murk_fields *f)
{
    murk_print("%s: %s\nwavelengths %g..%g nm\n", murk_field_text(f, "preset"),
               murk_field_text(f, "about"),
               murk_field_number(f, "wavelength_nm.0"),
               murk_field_number(f, "wavelength_nm.1"));
    print_words(f);
    print_bands(f);
    print_sources(f);
}

/* ---- the command ---- */

/* The keys of the command line and their values, as texts of the library. */
typedef struct given_keys {
    char **text; /* [n] "KEY", a zero byte, "VALUE" */
    const char **key, **value;
    size_t n;
} given_keys;

static void keys_release(given_keys *keys)
{
    for (size_t i = 0; i < keys->n && keys->text; ++i) {
        free(keys->text[i]);
    }
    free(keys->text);
    free(keys->key);
    free(keys->value);
}

static murk_status keys_split(given_keys *out, const murk_options *options,
                              murk_error *err)
{
    const size_t n = options->n_overrides;
    *out = (given_keys){calloc(n + 1, sizeof *out->text),
                        calloc(n + 1, sizeof *out->key),
                        calloc(n + 1, sizeof *out->value), n};
    bool is_whole = out->text && out->key && out->value;
    for (size_t i = 0; i < n && is_whole; ++i) {
        char *text = out->text[i] = strdup(options->overrides[i].text);
        is_whole = text != NULL;
        if (is_whole) {
            char *equals = strchr(text, '=');
            *equals = '\0';
            out->key[i] = text;
            out->value[i] = equals + 1;
        }
    }
    return is_whole ? MURK_OK : murk_no_memory(err, "", "for the options");
}

static murk_status show(const murk_options *options, murk_error *err)
{
    given_keys keys = {.n = 0};
    murk_given_save save = {.exports = NULL};
    const murk_fields *fields = NULL;
    murk_status status = keys_split(&keys, options, err);
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status = murk_context_preset(options->context, options->input, keys.key,
                                     keys.value, keys.n, &save.options, &fields,
                                     err);
    }
    /* JSON, or the text of one preset or of the list. */
    if (!status && options->json) {
        murk_print_json(murk_fields_json(fields));
    } else if (!status && !options->quiet) {
        (options->input ? print_one : print_list)(fields);
    }
    murk_given_save_end(&save);
    keys_release(&keys);
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
    if (!options->input && options->n_overrides) {
        return murk_fail(err, MURK_BAD_VALUE, "media",
                         "--set needs the name of a preset");
    }
    return show(options, err);
}
