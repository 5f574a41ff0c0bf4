/* Lines for people on standard output: a label of up to 11 letters, filled with
 * blanks to 12, then text.
 *
 *   coverage    0.8253 in sample (surface 0.7839 +- 0.0016, volume 0.8667 +-
 *               0.0022); all candidates: 0.9540
 *
 * Lines of more than 80 bytes, also rows of tables, are broken between words;
 * the rest is indented like the text of the line. Characters in names and paths
 * that a terminal might act on, and line feeds in them, are shown escaped
 * (base/utf8.h). A line that has not ended, and the receiver of lines, belong
 * to the calling thread. */
#ifndef MURK_BASE_PRINT_H
#define MURK_BASE_PRINT_H

/* Width of a label with the blanks after it. */
#define MURK_PRINTED_LABEL 12

/* Like printf(). A line is shown, or handed over within murk_print_into(), when
 * the format ends it with a line feed. */
void murk_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A function that prints the lines of some results with murk_print(). `of`
 * points to the results. */
typedef void murk_print_results(const void *of);

/* A function that receives a line without the line feed: escaped, and not yet
 * broken at 80 columns. The line is valid during the call. */
typedef void murk_print_take(void *to, const char *line);

/* Calls print(of), and take(to, line) with each of its lines instead of showing
 * them. */
void murk_print_into(murk_print_take *take, void *to, murk_print_results *print,
                     const void *of);

/* Shows a line that was handed over, broken where it is too long. */
void murk_print_line(const char *line);

/* Prints the text of a JSON, and a line feed if it does not end with one.
 * Characters that a terminal might act on are written as \uNNNN, which means
 * the same in strings of JSON; bytes that are not UTF-8 as \ufffd. */
void murk_print_json(const char *text);

#endif
