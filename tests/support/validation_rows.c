/* The growing list of rows of a validation run, and the standard error that
 * each row is traced to in the quick and in the nightly form. */
#include "validation_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RELATIVE_ERROR 1e-3
#define ABSOLUTE_ERROR 3e-5
#define QUICK_FACTOR   4

validation_row *validation_add_row(validation *v, const char *name,
                                   const char *source, const char *is_wrong,
                                   const validation_reference *reference)
{
    if (v->rows == v->capacity) {
        v->capacity = v->capacity ? 2 * v->capacity : 256;
        validation_row *grown = realloc(v->row, v->capacity * sizeof *grown);
        if (!grown) {
            fprintf(stderr, "no memory for %zu rows\n", v->capacity);
            exit(1);
        }
        v->row = grown;
    }
    validation_row *row = &v->row[v->rows++];
    *row = (validation_row){.reference = reference->value,
                            .uncertainty = reference->uncertainty,
                            .is_quick = v->settings.is_quick};
    snprintf(row->group, sizeof row->group, "%s", v->group);
    snprintf(row->name, sizeof row->name, "%s", name);
    snprintf(row->quantity, sizeof row->quantity, "%s", reference->quantity);
    snprintf(row->source, sizeof row->source, "%s", source);
    snprintf(row->wrong, sizeof row->wrong, "%s", is_wrong ? is_wrong : "");
    return row;
}

void validation_check(validation *v, const char *name, const char *source,
                      const char *is_wrong,
                      const validation_reference *reference, murk_estimate murk,
                      uint64_t photons)
{
    if (validation_wants(v, name)) {
        validation_row *row =
            validation_add_row(v, name, source, is_wrong, reference);
        row->murk = murk;
        row->photons = photons;
    }
}

void validation_mark_short(validation *v, const char *why_short)
{
    validation_row *row = &v->row[v->rows - 1];
    row->is_short = true;
    snprintf(row->why_short, sizeof row->why_short, "%s",
             why_short ? why_short : "");
}

void validation_mark_limit(validation *v, double sigmas_max)
{
    v->row[v->rows - 1].sigmas_max = sigmas_max;
}

void validation_mark_bound(validation *v)
{
    v->row[v->rows - 1].is_bound = true;
}

bool validation_wants(const validation *v, const char *name)
{
    const size_t length = strlen(v->group);
    for (size_t i = 0; i < v->settings.n_wanted; ++i) {
        const char *wanted = v->settings.wanted[i];
        if (strncmp(wanted, v->group, length) == 0 &&
            (wanted[length] == '\0' ||
             (wanted[length] == '/' && strstr(name, wanted + length + 1)))) {
            return true;
        }
    }
    return v->settings.n_wanted == 0;
}

bool validation_is_quick(const validation *v)
{
    return v->settings.is_quick;
}

double validation_error_wanted(const validation *v, double reference,
                               double error_scale)
{
    const double scale = error_scale > 0 ? error_scale : 1;
    return (v->settings.is_quick ? QUICK_FACTOR : 1) *
           fmax(RELATIVE_ERROR * fabs(reference), ABSOLUTE_ERROR * scale);
}

uint32_t validation_seed(const validation *v)
{
    return v->settings.seed;
}

unsigned validation_threads(const validation *v)
{
    return v->settings.threads;
}

double validation_half_digit(int digits)
{
    return .5 * pow(10, -digits);
}

double validation_half_digit_of(const char *text)
{
    const char *point = strchr(text, '.');
    const char *exponent = strpbrk(text, "eE");
    const char *end = exponent ? exponent : text + strlen(text);
    const int digits = point && point < end ? (int)(end - point) - 1 : 0;
    return validation_half_digit(
        digits - (exponent ? (int)strtol(exponent + 1, NULL, 10) : 0));
}

validation *validation_create(const validation_settings *settings)
{
    validation *v = calloc(1, sizeof *v);
    if (!v) {
        fprintf(stderr, "no memory for a validation\n");
        exit(1);
    }
    v->settings = *settings;
    return v;
}

void validation_destroy(validation *v)
{
    if (v) {
        free(v->row);
        free(v);
    }
}

void validation_group(validation *v, const char *group)
{
    snprintf(v->group, sizeof v->group, "%s", group);
}
