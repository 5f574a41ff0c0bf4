/* Cursor over the text of a photometric file: lines, and numbers between
 * blanks, with messages that name file and line. For use inside src/luminaire
 * only. */
#ifndef MURK_LUMINAIRE_TEXT_H
#define MURK_LUMINAIRE_TEXT_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_luminaire_text {
    const char *path;
    char *next, *end; /* the rest of the text; *end is '\0' */
    size_t line;      /* of `next`, from 1 */
    size_t word_line; /* of the number that was read last */
    murk_error *err;
} murk_luminaire_text;

/* Begins at the first line, behind a byte order mark. Fails with MURK_BAD_FILE
 * if the text is empty or has a NUL byte. A Ctrl-Z at the end, by which DOS
 * marked the end of a file, is removed. */
murk_status murk_luminaire_text_begin(murk_luminaire_text *out,
                                      const char *path, char *text, size_t size,
                                      murk_error *err);

/* Fails with MURK_BAD_FILE at "PATH:LINE". */
murk_status murk_luminaire_text_fail(const murk_luminaire_text *text,
                                     size_t line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Warns at "PATH:LINE". */
void murk_luminaire_text_warn(const murk_luminaire_text *text, size_t line,
                              const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The next line without the line end and without blanks around it, and the
 * number of the line. The line is cut out of the text. Returns NULL at the end
 * of the text. */
char *murk_luminaire_text_line(murk_luminaire_text *text, size_t *line);

/* Reads the next number, which must lie in min..max. Numbers stand between
 * blanks, commas and line ends. what: the name of the number in messages. */
murk_status murk_luminaire_text_number(murk_luminaire_text *text,
                                       const char *what, double min, double max,
                                       double *out);

/* Reads a whole number likewise. */
murk_status murk_luminaire_text_count(murk_luminaire_text *text,
                                      const char *what, double min, double max,
                                      size_t *out);

/* Checks that nothing but blanks and line ends follows. */
murk_status murk_luminaire_text_end(murk_luminaire_text *text);

/* Parses a number that a line of its own holds, as murk_luminaire_text_number()
 * does; a decimal comma is accepted. may_be_blank: an empty line is 0. */
murk_status murk_luminaire_text_field(murk_luminaire_text *text,
                                      const char *what, bool may_be_blank,
                                      double min, double max, double *out);

/* Copies text to out[size] as printable ASCII: '?' for each other byte. */
void murk_luminaire_text_copy(char *out, size_t size, const char *text);

/* Checks that the angle `now` is above the angle before, if there is one. */
murk_status murk_luminaire_text_rising(const murk_luminaire_text *text,
                                       size_t line, const char *what,
                                       const double *angle, size_t index);

#endif
