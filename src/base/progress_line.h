/* The text of a progress line. */
#ifndef MURK_BASE_PROGRESS_LINE_H
#define MURK_BASE_PROGRESS_LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of the text on the state of a step, with the '\0': about one line of a
 * terminal. */
#define MURK_PROGRESS_TEXT_SIZE 96

/* The state of a step. */
typedef struct murk_progress_facts {
    const char *step, *unit, *text; /* text: "" if there is none */
    uint64_t done, total;           /* total 0: unknown */
    double elapsed_s;
    uint64_t part, parts;
    double parts_left_s; /* NAN: unknown */
} murk_progress_facts;

/* Writes at most `columns` bytes, and at most size - 1, and a '\0' to
 * out[size]. Less important pieces are left out until the line fits: first the
 * bar, then the time of all parts, then the text. A line that is still too long
 * is cut. */
void murk_progress_line(char *out, size_t size, const murk_progress_facts *f,
                        size_t columns);

/* Writes all pieces but the bar as a sentence, "murk: trace: 51 %, ...", cut to
 * size - 1 bytes, without a line feed. */
void murk_progress_sentence(char *out, size_t size,
                            const murk_progress_facts *f);

#endif
