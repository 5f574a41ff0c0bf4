/* The summary on standard output: a label of up to 11 letters, filled with
 * blanks to 12, then text.
 *
 *   coverage    0.8253 in sample (surface 0.7839 +- 0.0016, volume 0.8667 +-
 *               0.0022); all candidates: 0.9540
 *
 * Lines of more than 80 bytes, also rows of tables, are broken between words;
 * the rest is indented like the text of the line. Characters in names and paths
 * that a terminal might act on, and line feeds in them, are shown escaped
 * (base/utf8.h). A line that has not ended, and the list of collected lines,
 * belong to the calling thread. */
#ifndef MURK_RESULTS_SUMMARY_H
#define MURK_RESULTS_SUMMARY_H

#include "results/json.h"

#include <stddef.h>

/* Width of a label with the blanks after it. */
#define MURK_PRINTED_LABEL 12

/* Like printf(). A line is shown, or collected within murk_print_collect(),
 * when the format ends it with a line feed. */
void murk_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A function that prints the lines of some results with murk_print(). `of`
 * points to the results. */
typedef void murk_print_results(const void *of);

/* Calls print(of) and returns the lines as a list of texts, instead of showing
 * them: escaped, and not yet broken at 80 columns. The caller deletes the list,
 * which is NULL when out of memory. */
cJSON *murk_print_collect(murk_print_results *print, const void *of);

/* Shows lines that were collected. */
void murk_print_lines(const cJSON *lines);

/* Prints the text of a JSON, and a line feed if it does not end with one.
 * Characters that a terminal might act on are written as \uNNNN, which means
 * the same in strings of JSON; bytes that are not UTF-8 as \ufffd. */
void murk_print_json(const char *text);

/* Prints "time 4.70 s: load 0.07, trace 0.01; memory 0.05 GB", without parts of
 * less than 0.005 s. other: name of a further part, of other_s seconds; NULL:
 * none. */
void murk_print_time(const murk_run_facts *run, const char *other,
                     double other_s);

/* Largest number of rows of a table that are shown. If n is more,
 * murk_print_more() prints how many more rows `file` in the folder has (folder
 * NULL: no file is written). */
#define MURK_PRINTED_ROWS 12
void murk_print_more(size_t n, const char *folder, const char *file);

#endif
