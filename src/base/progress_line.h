/* The text of a progress line. */
#ifndef MURK_BASE_PROGRESS_LINE_H
#define MURK_BASE_PROGRESS_LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_PROGRESS_TEXT_SIZE 96

typedef struct murk_progress_facts {
    const char *step, *unit, *text; /* text: "" for none */
    uint64_t done, total;           /* total 0: unknown */
    double elapsed_s;
    uint64_t part, parts;
    double parts_left_s; /* NAN: not known */
} murk_progress_facts;

/* At most `columns` characters to out[size], which what matters less gives way
 * for: the bar, the time of all parts, the text. */
void murk_progress_line(char *out, size_t size, const murk_progress_facts *f,
                        size_t columns);

/* The same as a sentence: "murk: trace: 51 %, ...", of any length. */
void murk_progress_sentence(char *out, size_t size,
                            const murk_progress_facts *f);

#endif
