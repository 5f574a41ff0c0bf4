/* The text of a progress line. */
#ifndef MURK_BASE_PROGRESS_LINE_H
#define MURK_BASE_PROGRESS_LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of the text on the state of a search: about one line of a terminal. */
#define MURK_PROGRESS_TEXT_SIZE 96

/* The state of a step. */
typedef struct murk_progress_facts {
    const char *step, *unit, *text; /* text: "" if there is none */
    uint64_t done, total;           /* total 0: unknown */
    double elapsed_s;
    uint64_t part, parts;
    double parts_left_s; /* NAN: unknown */
} murk_progress_facts;

/* Writes at most `columns` characters to out[size]. Less important pieces are
 * left out until the line fits: first the bar, then the time of all parts, then
 * the text. */
void murk_progress_line(char *out, size_t size, const murk_progress_facts *f,
                        size_t columns);

/* Writes the line as a sentence of any length: "murk: trace: 51 %, ...". */
void murk_progress_sentence(char *out, size_t size,
                            const murk_progress_facts *f);

#endif
