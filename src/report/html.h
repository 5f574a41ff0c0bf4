/* HTML as the report writes it: escaped text, numbers, tables, hashes.
 *
 * Whatever comes out of a file or a name goes through murk_page_text(), so it
 * can never be markup. Errors of writing are the stream's: commit asks it. */
#ifndef MURK_REPORT_HTML_H
#define MURK_REPORT_HTML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Rows of a table that a page shows; the rest is in the files. */
#define MURK_PAGE_ROWS_MAX 200

/* Text between tags or in a quoted attribute. What is no UTF-8, and control
 * characters, become U+FFFD. NULL is no text. */
void murk_page_text(FILE *to, const char *text);

/* JSON text inside a script element: '<' cannot begin a tag there. */
void murk_page_json(FILE *to, const char *json);

void murk_page_base64(FILE *to, const void *bytes, size_t size);

/* The source of a content security policy that lets this text, and no other,
 * run or style: sha256-... */
#define MURK_PAGE_HASH_SIZE 56
void murk_page_hash(char out[MURK_PAGE_HASH_SIZE], const char *text,
                    size_t size);

/* A finite value to so many digits (1..9), very large and small ones as
 * 2.5·10¹³. */
void murk_page_power(FILE *to, double value, int digits);
/* The same to five digits; an en dash where there is none (NaN). */
void murk_page_number(FILE *to, double value);
/* With its standard error, to two digits of that: 1.235 ± 0.023,
 * (8.90 ± 0.15)·10¹⁴. */
void murk_page_estimate(FILE *to, double value, double standard_error);
/* A share 0..1 in per cent. */
void murk_page_share(FILE *to, double share, double standard_error);

/* "1 sensor", "3 sensors". */
void murk_page_count(FILE *to, double n, const char *one, const char *more);

/* <section> with a heading that a list of contents can point to. */
void murk_page_section_begin(FILE *to, const char *id, const char *title);
void murk_page_section_end(FILE *to);
void murk_page_paragraph(FILE *to, const char *text);

/* A table inside a box that scrolls, also by keyboard. Cells are of a row that
 * is begun; heads[n], n may be 0. A head that begins with '<' stands over a
 * column of text, which is set from the left; the mark is not shown. */
void murk_page_table_begin(FILE *to, const char *caption,
                           const char *const *heads, size_t n);
void murk_page_table_end(FILE *to);
void murk_page_row_begin(FILE *to, const char *head); /* head: its first cell */
void murk_page_row_end(FILE *to);
void murk_page_cell_text(FILE *to, const char *text);
void murk_page_cell_number(FILE *to, double value);
void murk_page_cell_share(FILE *to, double share, double standard_error);
void murk_page_cell_estimate(FILE *to, double value, double standard_error);
/* A cell of any content on a shade -1..1, which tells its sign and, in six
 * steps, its size; none for 0 and NaN. */
void murk_page_shaded_begin(FILE *to, double shade);
void murk_page_shaded_end(FILE *to);
/* Two cells, a row: a name and what it is. */
void murk_page_fact(FILE *to, const char *name, const char *text);
void murk_page_fact_number(FILE *to, const char *name, double value,
                           const char *unit);
void murk_page_fact_share(FILE *to, const char *name, double share,
                          double standard_error);
/* A name and what is said of it, inside <dl class="facts">. */
void murk_page_line_begin(FILE *to, const char *name);
void murk_page_line_end(FILE *to);
/* Says how many rows are left out, where some are. */
void murk_page_more(FILE *to, size_t rows, const char *file);

#endif
