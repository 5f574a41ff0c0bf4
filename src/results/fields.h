/* The tables of result fields: one row for each key of a result's JSON and each
 * column of a result's CSV.
 *
 * A table is a function that lists its rows in order. A row has a name, a unit,
 * a line of help and a value:
 *
 *     static void list_map(murk_results_fields *f, const void *of)
 *     {
 *         const murk_traced *traced = of;
 *         MURK_COUNT(f, "emitted", "emitted photons", traced->emitted);
 *     }
 *
 * The same rows become keys of a JSON object, columns of a CSV file and the
 * description that the manual prints. The description has no results: `of` is
 * NULL then. So a list reads `of` only inside the value of a row, inside
 * MURK_LISTED_IF() and inside the arguments of MURK_OBJECT() and
 * MURK_LIST(), which are not evaluated for a description. */
#ifndef MURK_RESULTS_FIELDS_H
#define MURK_RESULTS_FIELDS_H

#include "base/stats.h"
#include "results/results.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>

typedef struct murk_results_fields murk_results_fields;

/* Lists the fields of one object; of an object or of item i of a list. */
typedef void (*murk_results_list)(murk_results_fields *f, const void *of);
typedef void (*murk_results_item)(murk_results_fields *f, const void *of,
                                  size_t i);

/* One row: name, unit, help, value. unit: "1" for a share, "" for none. The
 * value is as murk_results_put_...() below take it. */
#define MURK_NUMBER(f, ...)  MURK_RESULT(f, number, __VA_ARGS__)
#define MURK_VECTOR(f, ...)  MURK_RESULT(f, vector, __VA_ARGS__)
#define MURK_NUMBERS(f, ...) MURK_RESULT(f, numbers, __VA_ARGS__)
#define MURK_JSON(f, ...)    MURK_RESULT(f, json, __VA_ARGS__)
#define MURK_ROUNDED(f, ...) MURK_RESULT(f, rounded, __VA_ARGS__)
/* One row that never has a unit: name, help, value. */
#define MURK_COUNT(f, name, ...) MURK_RESULT(f, count, name, "", __VA_ARGS__)
#define MURK_FLAG(f, name, ...)  MURK_RESULT(f, flag, name, "", __VA_ARGS__)
#define MURK_TEXT(f, name, ...)  MURK_RESULT(f, text, name, "", __VA_ARGS__)
#define MURK_NULL(f, name, unit, help) \
    MURK_RESULT(f, number, name, unit, help, (double)NAN)

/* The same by the end of a function's name, as the rows above use it. */
#define MURK_RESULT(f, kind, name, unit, help, ...)   \
    do {                                              \
        if (murk_results_next(f, name, unit, help)) { \
            murk_results_put_##kind(f, __VA_ARGS__);  \
        }                                             \
    } while (0)

/* Two rows: NAME and NAME_standard_error, of a murk_estimate. */
#define MURK_ESTIMATE(f, name, unit, help, ...)                               \
    do {                                                                      \
        MURK_NUMBER(f, name, unit, help, (__VA_ARGS__).value);                \
        MURK_NUMBER(f, name "_standard_error", unit,                          \
                    "standard error of " name, (__VA_ARGS__).standard_error); \
    } while (0)

/* True if rows that depend on a condition are to be listed. */
#define MURK_LISTED_IF(f, condition) (murk_results_describes(f) || (condition))

/* An object with rows of its own; null if of_them is NULL. CSV has none. */
#define MURK_OBJECT(f, name, help, list, of_them) \
    murk_results_object(f, name, help, list,      \
                        murk_results_describes(f) ? NULL : (of_them))

/* A list of n objects; one that gets no rows is left out. CSV has none. */
#define MURK_LIST(f, name, help, item, of_them, n)                   \
    murk_results_items(f, name, help, item,                          \
                       murk_results_describes(f) ? NULL : (of_them), \
                       murk_results_describes(f) ? 1 : (n))

/* Begins a row. True if its value is wanted, by one murk_results_put_...(). */
bool murk_results_next(murk_results_fields *f, const char *name,
                       const char *unit, const char *help);

/* Values; what is not finite, and a NULL text, is null in JSON and an empty
 * cell in CSV. */
void murk_results_put_number(murk_results_fields *f, double value);
void murk_results_put_count(murk_results_fields *f, uint64_t value);
void murk_results_put_flag(murk_results_fields *f, bool value);
void murk_results_put_text(murk_results_fields *f, const char *text);
/* In JSON alone: three numbers, or n of them. */
void murk_results_put_vector(murk_results_fields *f, murk_vec3 v);
void murk_results_put_numbers(murk_results_fields *f, const double *value,
                              size_t n);
/* In JSON alone: an item, which the object takes over. */
void murk_results_put_json(murk_results_fields *f, cJSON *item);
/* As a number; in CSV with so many significant digits, where a number has as
 * many as it takes to read it back. */
void murk_results_put_rounded(murk_results_fields *f, double value, int digits);

bool murk_results_describes(const murk_results_fields *f);
bool murk_results_is_csv(const murk_results_fields *f);
void murk_results_object(murk_results_fields *f, const char *name,
                         const char *help, murk_results_list list,
                         const void *of);
void murk_results_items(murk_results_fields *f, const char *name,
                        const char *help, murk_results_item item,
                        const void *of, size_t n);

/* Rows that every JSON begins with: "murk" alone (of: NULL), and "murk" to
 * "seed" (of: a murk_scene_desc). The head of a file has the latter, but for
 * descriptions. */
void murk_results_list_murk(murk_results_fields *f, const void *of);
void murk_results_list_every(murk_results_fields *f, const void *of);
void murk_results_list_head(murk_results_fields *f,
                            const murk_scene_desc *scene);

/* ---- what is made of a table ---- */

/* An object of JSON with the rows as keys, the caller's. */
cJSON *murk_results_json(murk_results_list list, const void *of);

/* Writes the names as the heading of a CSV file, and item i as one line. */
void murk_results_csv_heading(FILE *to, murk_results_item item);
void murk_results_csv_line(FILE *to, murk_results_item item, const void *of,
                           size_t i);

/* Adds a CSV file: the heading and n lines. */
murk_status murk_results_add_csv(murk_results *results, const char *name,
                                 murk_results_item item, const void *of,
                                 size_t n, murk_error *err);

/* Prints "| `name` | help (unit) |" for each row, a line of a Markdown table;
 * keys of inner objects as "outer.inner", of lists as "list[].inner". */
void murk_results_describe(FILE *to, murk_results_list list);
void murk_results_describe_csv(FILE *to, murk_results_item item);

/* part / whole; NaN if whole is 0. */
double murk_share(uint64_t part, uint64_t whole);

/* The shortest decimal that reads back to the same number. */
void murk_number_text(char out[32], double value);

/* Writes a text as one CSV cell: quoted where it must be (RFC 4180). */
void murk_results_csv_cell(FILE *to, const char *text);

#endif
