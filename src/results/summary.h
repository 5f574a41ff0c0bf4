/* The summary on standard output: a label of up to 11 letters, then text from
 * column 12 on.
 *
 *   coverage    0.8253 in sample (surface 0.7839 +- 0.0016, volume 0.8667 +-
 *               0.0022); all candidates: 0.9540
 *
 * Lines wider than 80 columns are broken between words and go on under their
 * text, rows of tables, too. Bytes count as columns. What a terminal might act
 * on, in names and paths, is shown escaped (base/utf8.h), a line feed in them
 * too. From the main thread only. */
#ifndef MURK_RESULTS_SUMMARY_H
#define MURK_RESULTS_SUMMARY_H

#include "results/json.h"

#include <stddef.h>

/* Columns of a label, with the blanks behind it. */
#define MURK_PRINTED_LABEL 12

/* As printf(); a line is shown when it ends. */
void murk_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Prints the lines of some results with murk_print(). `of` points to the
 * results. */
typedef void murk_print_results(const void *of);

/* Returns the lines that `print` prints as a list of texts, instead of showing
 * them: escaped, and not yet broken at 80 columns. The caller deletes the list,
 * which is NULL when out of memory. */
cJSON *murk_print_collect(murk_print_results *print, const void *of);

/* Shows lines that were collected. */
void murk_print_lines(const cJSON *lines);

/* Prints JSON text, and a line feed where it has none at its end. DEL, the
 * control characters beyond ASCII and whatever else a terminal might act on in
 * strings are written \uNNNN, which means the same. */
void murk_print_json(const char *text);

/* "time  4.70 s: load 0.07, trace 0.01; memory 0.05 GB", without what took no
 * time; other: a part of the command's own, or NULL. */
void murk_print_time(const murk_run_facts *run, const char *other,
                     double other_s);

/* Rows of a table that are shown, of n: what is more stands in `file` of the
 * folder (NULL: none is written), which murk_print_more() says. */
#define MURK_PRINTED_ROWS 12
void murk_print_more(size_t n, const char *folder, const char *file);

#endif
