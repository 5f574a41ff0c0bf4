/* Walks tables of result fields: makes JSON objects, CSV files and the
 * description for the manual from the same list of rows. */
#include "results/fields.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PATH_SIZE 160 /* of the names around a row: "outer.inner." */

/* The purpose of one walk over a table. */
typedef enum walk { JSON, CSV_HEADING, CSV_LINE, DESCRIBE, DESCRIBE_CSV } walk;

struct murk_results_fields {
    walk walk;
    FILE *to;             /* of CSV and descriptions */
    cJSON *object;        /* of JSON: receives the rows */
    const char *name;     /* of the row that was begun */
    size_t columns;       /* of CSV: number begun so far on this line */
    char path[PATH_SIZE]; /* of descriptions: "outer.", before each name */
};

bool murk_results_describes(const murk_results_fields *f)
{
    return f->walk != JSON && f->walk != CSV_LINE;
}

bool murk_results_is_csv(const murk_results_fields *f)
{
    return f->walk != JSON && f->walk != DESCRIBE;
}

bool murk_results_next(murk_results_fields *f, const char *name,
                       const char *unit, const char *help)
{
    f->name = name;
    if ((f->walk == CSV_HEADING || f->walk == CSV_LINE) && f->columns++ > 0) {
        fputc(',', f->to);
    }
    if (f->walk == CSV_HEADING) {
        fputs(name, f->to);
    } else if (murk_results_describes(f)) {
        const bool has_unit = unit[0] && strcmp(unit, "1") != 0;
        fprintf(f->to, "| `%s%s` | %s%s%s%s |\n", f->path, name, help,
                has_unit ? " (" : "", has_unit ? unit : "",
                has_unit ? ")" : "");
    }
    return !murk_results_describes(f);
}

/* ---- values ---- */

void murk_results_put_number(murk_results_fields *f, double value)
{
    char text[32];
    if (f->walk == JSON && isfinite(value)) {
        cJSON_AddNumberToObject(f->object, f->name, value);
    } else if (f->walk == JSON) {
        cJSON_AddNullToObject(f->object, f->name);
    } else if (isfinite(value)) {
        murk_number_text(text, value);
        fputs(text, f->to);
    }
}

void murk_results_put_rounded(murk_results_fields *f, double value, int digits)
{
    if (f->walk == JSON) {
        murk_results_put_number(f, value);
    } else if (isfinite(value)) {
        fprintf(f->to, "%.*g", digits, value);
    }
}

void murk_results_put_count(murk_results_fields *f, uint64_t value)
{
    if (f->walk == JSON) {
        cJSON_AddNumberToObject(f->object, f->name, (double)value);
    } else {
        fprintf(f->to, "%llu", (unsigned long long)value);
    }
}

void murk_results_put_flag(murk_results_fields *f, bool value)
{
    if (f->walk == JSON) {
        cJSON_AddBoolToObject(f->object, f->name, value);
    } else {
        fputs(value ? "true" : "false", f->to);
    }
}

void murk_results_put_text(murk_results_fields *f, const char *text)
{
    if (f->walk != JSON) {
        murk_results_csv_cell(f->to, text ? text : "");
    } else if (text) {
        cJSON_AddStringToObject(f->object, f->name, text);
    } else {
        cJSON_AddNullToObject(f->object, f->name);
    }
}

void murk_results_put_numbers(murk_results_fields *f, const double *value,
                              size_t n)
{
    cJSON_AddItemToObject(f->object, f->name,
                          n ? cJSON_CreateDoubleArray(value, (int)n)
                            : cJSON_CreateArray());
}

void murk_results_put_json(murk_results_fields *f, cJSON *item)
{
    cJSON_AddItemToObject(f->object, f->name, item);
}

void murk_results_put_vector(murk_results_fields *f, murk_vec3 v)
{
    const double xyz[3] = {v.x, v.y, v.z};
    if (isfinite(v.x)) {
        murk_results_put_numbers(f, xyz, 3);
    } else {
        murk_results_put_number(f, NAN);
    }
}

/* ---- objects and lists ---- */

/* The walk over an inner table. In descriptions, its names are preceded by the
 * path so far, `name` and `end`. */
static murk_results_fields inner(const murk_results_fields *f, cJSON *object,
                                 const char *name, const char *end)
{
    murk_results_fields in = {.walk = f->walk, .to = f->to, .object = object};
    snprintf(in.path, sizeof in.path, "%s%s%s", f->path, name, end);
    return in;
}

void murk_results_object(murk_results_fields *f, const char *name,
                         const char *help, murk_results_list list,
                         const void *of)
{
    if (murk_results_is_csv(f)) {
        return;
    }
    const bool has_value = murk_results_next(f, name, "", help);
    if (has_value && !of) {
        murk_results_put_number(f, NAN);
        return;
    }
    murk_results_fields in =
        inner(f, has_value ? cJSON_AddObjectToObject(f->object, name) : NULL,
              name, ".");
    list(&in, of);
}

void murk_results_items(murk_results_fields *f, const char *name,
                        const char *help, murk_results_item item,
                        const void *of, size_t n)
{
    if (murk_results_is_csv(f)) {
        return;
    }
    cJSON *array = murk_results_next(f, name, "", help)
                       ? cJSON_AddArrayToObject(f->object, name)
                       : NULL;
    for (size_t i = 0; i < n; ++i) {
        cJSON *object = array ? cJSON_CreateObject() : NULL;
        murk_results_fields in = inner(f, object, name, "[].");
        item(&in, of, i);
        if (object && object->child) {
            cJSON_AddItemToArray(array, object);
        } else {
            cJSON_Delete(object);
        }
    }
}

/* ---- what is made of a table ---- */

cJSON *murk_results_json(murk_results_list list, const void *of)
{
    murk_results_fields f = {.walk = JSON, .object = cJSON_CreateObject()};
    list(&f, of);
    return f.object;
}

void murk_results_csv_heading(FILE *to, murk_results_item item)
{
    murk_results_fields f = {.walk = CSV_HEADING, .to = to};
    item(&f, NULL, 0);
    fputc('\n', to);
}

void murk_results_csv_line(FILE *to, murk_results_item item, const void *of,
                           size_t i)
{
    murk_results_fields f = {.walk = CSV_LINE, .to = to};
    item(&f, of, i);
    fputc('\n', to);
}

typedef struct csv {
    murk_results_item item;
    const void *of;
    size_t n;
} csv;

static murk_status write_csv(FILE *to, const void *context, murk_error *err)
{
    const csv *c = context;
    murk_results_csv_heading(to, c->item);
    for (size_t i = 0; i < c->n; ++i) {
        murk_results_csv_line(to, c->item, c->of, i);
    }
    (void)err;
    return MURK_OK;
}

murk_status murk_results_add_csv(murk_results *results, const char *name,
                                 murk_results_item item, const void *of,
                                 size_t n, murk_error *err)
{
    const csv c = {item, of, n};
    return murk_results_add_stream(results, name, write_csv, &c, err);
}

void murk_results_describe(FILE *to, murk_results_list list)
{
    murk_results_fields f = {.walk = DESCRIBE, .to = to};
    list(&f, NULL);
}

void murk_results_describe_csv(FILE *to, murk_results_item item)
{
    murk_results_fields f = {.walk = DESCRIBE_CSV, .to = to};
    item(&f, NULL, 0);
}

double murk_share(uint64_t part, uint64_t whole)
{
    return whole ? (double)part / (double)whole : NAN;
}

void murk_number_text(char out[32], double value)
{
    /* 17 digits are enough for any double; most numbers need fewer */
    for (int digits = 6; digits <= 17; ++digits) {
        snprintf(out, 32, "%.*g", digits, value);
        if (strtod(out, NULL) == value) {
            return;
        }
    }
}

void murk_results_csv_cell(FILE *to, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, to);
        return;
    }
    fputc('"', to);
    for (; *text; ++text) {
        if (*text == '"') {
            fputc('"', to);
        }
        fputc(*text, to);
    }
    fputc('"', to);
}
