/* The cells of CSV text (RFC 4180), one after the other. Blanks (space, tab,
 * carriage return) around cells do not count. Blank lines, and lines whose
 * first character that is no blank is #, are passed over. The text is cut into
 * cells in place, so that no cell needs memory of its own. */
#ifndef MURK_BASE_CSV_H
#define MURK_BASE_CSV_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_csv {
    char *next, *end; /* the rest of the text; a '\0' is at `end`, and none from
                       * `next` up to there */
    size_t line;      /* of `next`, from 1 */
    bool is_one_line; /* a quoted cell must end in the line in which it begins
                       */
} murk_csv;

/* Advances to the next line that has cells; false at the end of the text. */
bool murk_csv_find_line(murk_csv *csv);

/* Reads the next cell of a line into *cell, the beginning of the cell in the
 * text. *is_last: the cell ends the line. Returns NULL on success. Otherwise
 * returns a constant text that says what is wrong with the cell; csv->line is
 * then the line for the message. */
const char *murk_csv_read_cell(murk_csv *csv, char **cell, bool *is_last);

#endif
