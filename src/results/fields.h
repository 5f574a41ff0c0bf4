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
 * description that the manual prints. The description and the heading of a CSV
 * file are made without results: `of` is NULL then. So a list reads `of` only
 * inside the value of a row, inside MURK_LISTED_IF() and inside the arguments
 * of MURK_OBJECT() and MURK_LIST(), which are not evaluated if there are no
 * results. In the comments below, "a description" includes the heading of a CSV
 * file. */
#ifndef MURK_RESULTS_FIELDS_H
#define MURK_RESULTS_FIELDS_H

#include "base/stats.h"
#include "results/results.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>

typedef struct murk_results_fields murk_results_fields;

/* Lists the fields of one object: of the object `of`, or of item i of the list
 * `of`. */
typedef void (*murk_results_list)(murk_results_fields *f, const void *of);
typedef void (*murk_results_item)(murk_results_fields *f, const void *of,
                                  size_t i);

/* One row: name, unit, help, value. unit: "1" for a share, "" for none. The
 * value is what the murk_results_put_...() function of the same name takes. */
#define MURK_NUMBER(f, ...)  MURK_RESULT(f, number, __VA_ARGS__)
#define MURK_VECTOR(f, ...)  MURK_RESULT(f, vector, __VA_ARGS__)
#define MURK_NUMBERS(f, ...) MURK_RESULT(f, numbers, __VA_ARGS__)
#define MURK_JSON(f, ...)    MURK_RESULT(f, json, __VA_ARGS__)
#define MURK_ROUNDED(f, ...) MURK_RESULT(f, rounded, __VA_ARGS__)
/* One row that never has a unit: name, help, value. MURK_NULL is a row whose
 * value is always null: name, unit, help. */
#define MURK_COUNT(f, name, ...) MURK_RESULT(f, count, name, "", __VA_ARGS__)
#define MURK_FLAG(f, name, ...)  MURK_RESULT(f, flag, name, "", __VA_ARGS__)
#define MURK_TEXT(f, name, ...)  MURK_RESULT(f, text, name, "", __VA_ARGS__)
#define MURK_NULL(f, name, unit, help) \
    MURK_RESULT(f, number, name, unit, help, (double)NAN)

/* One row by `kind`, the end of the name of a murk_results_put_...() function.
 * The macros above use it. */
#define MURK_RESULT(f, kind, name, unit, help, ...)   \
    do {                                              \
        if (murk_results_next(f, name, unit, help)) { \
            murk_results_put_##kind(f, __VA_ARGS__);  \
        }                                             \
    } while (0)

/* Two rows: NAME and NAME_standard_error, of a murk_estimate, whose expression
 * is evaluated twice. */
#define MURK_ESTIMATE(f, name, unit, help, ...)                               \
    do {                                                                      \
        MURK_NUMBER(f, name, unit, help, (__VA_ARGS__).value);                \
        MURK_NUMBER(f, name "_standard_error", unit,                          \
                    "standard error of " name, (__VA_ARGS__).standard_error); \
    } while (0)

/* True if the condition holds, and in a description, which lists all rows. The
 * condition is not evaluated in a description. */
#define MURK_LISTED_IF(f, condition) (murk_results_describes(f) || (condition))

/* An object with rows of its own; null if of_them is NULL. Left out in CSV. */
#define MURK_OBJECT(f, name, help, list, of_them) \
    murk_results_object(f, name, help, list,      \
                        murk_results_describes(f) ? NULL : (of_them))

/* A list of n objects. In JSON an object without rows is left out of the list;
 * in CSV the whole list is left out. */
#define MURK_LIST(f, name, help, item, of_them, n)                   \
    murk_results_items(f, name, help, item,                          \
                       murk_results_describes(f) ? NULL : (of_them), \
                       murk_results_describes(f) ? 1 : (n))

/* Begins a row. If true, the caller must pass its value to one
 * murk_results_put_...() function; false in a description. */
bool murk_results_next(murk_results_fields *f, const char *name,
                       const char *unit, const char *help);

/* The murk_results_put_...() functions give the value of the row that was
 * begun. A number that is not finite and a NULL text are null in JSON and an
 * empty cell in CSV. */
void murk_results_put_number(murk_results_fields *f, double value);
void murk_results_put_count(murk_results_fields *f, uint64_t value);
void murk_results_put_flag(murk_results_fields *f, bool value);
void murk_results_put_text(murk_results_fields *f, const char *text);
/* For JSON only: a list of three numbers, null if v.x is not finite; and a list
 * of n numbers. */
void murk_results_put_vector(murk_results_fields *f, murk_vec3 v);
void murk_results_put_numbers(murk_results_fields *f, const double *value,
                              size_t n);
/* For JSON only: an item, which the object then owns. */
void murk_results_put_json(murk_results_fields *f, cJSON *item);
/* As a number; in CSV with `digits` significant digits, instead of as many as
 * it takes to read the same number back. */
void murk_results_put_rounded(murk_results_fields *f, double value, int digits);

bool murk_results_describes(const murk_results_fields *f);
bool murk_results_is_csv(const murk_results_fields *f);
void murk_results_object(murk_results_fields *f, const char *name,
                         const char *help, murk_results_list list,
                         const void *of);
void murk_results_items(murk_results_fields *f, const char *name,
                        const char *help, murk_results_item item,
                        const void *of, size_t n);

/* List the rows that a JSON begins with. murk_results_list_murk() lists the row
 * "murk" alone and does not use `of`. murk_results_list_every() lists the rows
 * "murk" to "seed"; `of` points to a murk_scene_desc. murk_results_list_head()
 * lists the same rows, but none in a description, because they are described
 * once for all files. */
void murk_results_list_murk(murk_results_fields *f, const void *of);
void murk_results_list_every(murk_results_fields *f, const void *of);
void murk_results_list_head(murk_results_fields *f,
                            const murk_scene_desc *scene);

/* ---- what is made of a table ---- */

/* Returns a JSON object with the rows as keys, which the caller deletes. NULL
 * when out of memory. */
cJSON *murk_results_json(murk_results_list list, const void *of);

/* The first writes the names of the rows as the heading of a CSV file, the
 * second item i as one line. */
void murk_results_csv_heading(FILE *to, murk_results_item item);
void murk_results_csv_line(FILE *to, murk_results_item item, const void *of,
                           size_t i);

/* Adds a CSV file to the results: the heading and n lines. Fails as
 * murk_results_add() does. */
murk_status murk_results_add_csv(murk_results *results, const char *name,
                                 murk_results_item item, const void *of,
                                 size_t n, murk_error *err);

/* Prints "| `name` | help (unit) |" for each row, a line of a Markdown table,
 * without the units "" and "1". Rows of inner objects are named "outer.inner",
 * those of lists "list[].inner". */
void murk_results_describe(FILE *to, murk_results_list list);
void murk_results_describe_csv(FILE *to, murk_results_item item);

/* part / whole; NaN if whole is 0. */
double murk_share(uint64_t part, uint64_t whole);

/* Writes a decimal that reads back to the same number: with 6 significant
 * digits, or as many more, up to 17, as that takes. */
void murk_number_text(char out[32], double value);

/* Writes a text as one CSV cell: quoted where it must be (RFC 4180). */
void murk_results_csv_cell(FILE *to, const char *text);

#endif
