/* Readers of the values of single options: numbers, words, lists and files of
 * keys. Each checks its value and stores it. */
#include "app/option_values.h"

#include "app/field.h"
#include "base/export_kind.h"
#include "base/log.h"
#include "base/number.h"
#include "base/picture_limits.h"
#include "base/shard.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Pixels along a side: the range of the key of a scene. */
#define SIDE_MAX     65536
#define EXPOSURE_MAX 100.0 /* stops: 2^100 is beyond any radiance */

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for the options");
}

/* Takes over a text until the options are released. NULL when out of memory,
 * also if `text` is NULL for that reason. */
static const char *keep(murk_options *out, char *text)
{
    char **grown = realloc(out->owned, (out->n_owned + 1) * sizeof *grown);
    if (grown) {
        out->owned = grown;
    }
    if (!grown || !text) {
        free(text);
        return NULL;
    }
    return out->owned[out->n_owned++] = text;
}

murk_status murk_option_override(murk_options *out, const char *key,
                                 const char *value, const char *option,
                                 murk_error *err)
{
    const size_t size = strlen(key) + strlen(value) + 2;
    char *text = malloc(size);
    if (text) {
        snprintf(text, size, "%s%s%s", key, *key ? "=" : "", value);
    }
    murk_given_key *overrides =
        realloc(out->overrides, (out->n_overrides + 1) * sizeof *overrides);
    if (overrides) {
        out->overrides = overrides;
    }
    const char *owned = keep(out, text);
    if (!owned || !overrides) {
        return no_memory(err);
    }
    out->overrides[out->n_overrides++] = (murk_given_key){owned, option};
    return MURK_OK;
}

murk_status murk_option_out(murk_options *out, const char *name,
                            const char *value, murk_error *err)
{
    out->out = value;
    return *value ? MURK_OK
                  : murk_fail(err, MURK_BAD_VALUE, name,
                              "\"\", must name a folder");
}

murk_status murk_option_exports(murk_options *out, const char *name,
                                const char *value, murk_error *err)
{
    return murk_exports_read(&out->exports, value, name, err);
}

static murk_status take_words(murk_options *out, murk_words_given *words,
                              const char *value, const char *name,
                              murk_error *err)
{
    /* Word by word between commas. */
    for (const char *at = value;;) {
        const size_t length = strcspn(at, ",");
        const char **grown =
            realloc(words->word, (words->n + 2) * sizeof *grown);
        if (grown) {
            words->word = grown;
        }
        const char *word = keep(out, strndup(at, length));
        if (!word || !grown) {
            return no_memory(err);
        }
        words->word[words->n++] = word;
        words->word[words->n] = NULL;
        if (length == 0) {
            return murk_fail(err, MURK_BAD_VALUE, name,
                             "\"%s\", must be words with commas between",
                             value);
        }
        if (!at[length]) {
            return MURK_OK;
        }
        at += length + 1;
    }
}

murk_status murk_option_free(murk_options *out, const char *name,
                             const char *value, murk_error *err)
{
    return take_words(out, &out->fit.free, value, name, err);
}

murk_status murk_option_bounds(murk_options *out, const char *name,
                               const char *value, murk_error *err)
{
    return take_words(out, &out->fit.bounds, value, name, err);
}

/* Prints a warning about a file of keys, which --quiet does not hide: it is
 * read while the command line is parsed. */
static void tell(void *user, bool is_warning, const char *where,
                 const char *text)
{
    (void)user;
    murk_message(is_warning ? "warning: " : "note: ", where, text);
}

/* Sets the keys in the file of --set @FILE. Messages about a key name the
 * file. */
static murk_status set_keys_of(murk_options *out, const char *file,
                               murk_context *context, murk_error *err)
{
    const murk_fields *f = NULL;
    const size_t length = strlen(file) + sizeof "--set @";
    char *option = malloc(length);
    if (option) {
        snprintf(option, length, "--set @%s", file);
    }
    const char *source = keep(out, option);
    murk_status status = source ? murk_context_read_keys(context, file, &f, err)
                                : no_memory(err);
    const size_t n = status ? 0 : murk_field_length(f, "keys");
    for (size_t i = 0; i < n && !status; ++i) {
        status = murk_option_override(
            out, murk_field_text(f, "keys.%zu.key", i),
            murk_field_text(f, "keys.%zu.value", i), source, err);
    }
    return status;
}

static murk_status read_keys(murk_options *out, const char *file,
                             murk_error *err)
{
    const murk_context_options options = {
        .size = sizeof options, .threads = 1, .log = tell};
    murk_context *context = NULL;
    if (!*file) {
        return murk_fail(err, MURK_BAD_VALUE, "--set @",
                         "no name, must be --set @FILE");
    }
    murk_status status = murk_context_create(&context, &options, err);
    if (!status) {
        status = set_keys_of(out, file, context, err);
    }
    murk_context_destroy(context);
    return status;
}

murk_status murk_option_set(murk_options *out, const char *name,
                            const char *value, murk_error *err)
{
    if (*value == '@') {
        return read_keys(out, value + 1, err);
    }
    return strchr(value, '=') && *value != '='
               ? murk_option_override(out, "", value, NULL, err)
               : murk_fail(err, MURK_BAD_VALUE, name, "%s, must be KEY=VALUE",
                           value);
}

murk_status murk_option_shard(murk_options *out, const char *name,
                              const char *value, murk_error *err)
{
    uint64_t number = 0, count = 0;
    char text[32];
    const size_t length = strcspn(value, "/");
    const bool has_both = length < sizeof text && value[length] == '/';
    snprintf(text, sizeof text, "%.*s", (int)(has_both ? length : 0), value);
    if (!has_both || !murk_count_parse(text, &number) ||
        !murk_count_parse(value + length + 1, &count) || number < 1 ||
        number > count || count > MURK_SHARDS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be K/N: part K of N, 1/1 to %d/%d", value,
                         MURK_SHARDS_MAX, MURK_SHARDS_MAX);
    }
    out->shard = (murk_given_shard){(uint32_t)number, (uint32_t)count};
    return MURK_OK;
}

/* ---- pictures ---- */

static bool is_side(unsigned long n)
{
    return n >= 1 && n <= SIDE_MAX;
}

/* "640x480" */
murk_status murk_option_pixels(murk_options *out, const char *name,
                               const char *value, murk_error *err)
{
    char *end = NULL, *last = NULL;
    const bool begins = *value >= '0' && *value <= '9';
    const unsigned long width = begins ? strtoul(value, &end, 10) : 0;
    const bool goes_on =
        begins && *end == 'x' && end[1] >= '0' && end[1] <= '9';
    const unsigned long height = goes_on ? strtoul(end + 1, &last, 10) : 0;
    if (!is_side(width) || !is_side(height) || *last ||
        (uint64_t)width * height > MURK_PIXELS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be WIDTHxHEIGHT, such as 640x480: each "
                         "1..%d, %llu pixels together at most",
                         value, SIDE_MAX, (unsigned long long)MURK_PIXELS_MAX);
    }
    out->render.pixels[0] = width;
    out->render.pixels[1] = height;
    return MURK_OK;
}

murk_status murk_option_exposure(murk_options *out, const char *name,
                                 const char *value, murk_error *err)
{
    char *end;
    const double stops = strtod(value, &end);
    if (end == value || *end || !(fabs(stops) <= EXPOSURE_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be a number of stops, %g..%g", value,
                         -EXPOSURE_MAX, EXPOSURE_MAX);
    }
    out->render.has_exposure = true;
    out->render.exposure_stops = stops;
    return MURK_OK;
}

/* "LOW:HIGH" */
murk_status murk_option_range(murk_options *out, const char *name,
                              const char *value, murk_error *err)
{
    char *middle, *end = NULL;
    const double low = strtod(value, &middle);
    const bool goes_on = middle != value && *middle == ':';
    const double high = goes_on ? strtod(middle + 1, &end) : NAN;
    if (!goes_on || end == middle + 1 || *end || !isfinite(low) ||
        !isfinite(high) || !(low < high)) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be LOW:HIGH, two numbers, the first less "
                         "than the second",
                         value);
    }
    out->render.has_range = true;
    out->render.range[0] = low;
    out->render.range[1] = high;
    return MURK_OK;
}

/* "X,Y,Z" */
murk_status murk_option_cut(murk_options *out, const char *name,
                            const char *value, murk_error *err)
{
    const char *at = value;
    double cut_m[3];
    for (int k = 0; k < 3; ++k) {
        char *end;
        cut_m[k] = strtod(at, &end);
        const bool is_number = end != at && isfinite(cut_m[k]);
        if (!is_number || *end != (k < 2 ? ',' : '\0')) {
            return murk_fail(err, MURK_BAD_VALUE, name,
                             "%s, must be X,Y,Z, three numbers of metres with "
                             "commas between",
                             value);
        }
        at = end + 1;
    }
    out->section.has_cut = true;
    memcpy(out->section.cut_m, cut_m, sizeof cut_m);
    return MURK_OK;
}
