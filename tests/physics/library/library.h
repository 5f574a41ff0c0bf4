/* Values of the media library and the sky against published or independently
 * computed ones: the section "Media and sky" of RESULTS.md, and the ctest
 * entry physics/library.
 *
 * A subject is a file NAME.c here with the function murk_library_NAME, and a
 * row X(NAME) below. */
#ifndef MURK_TESTS_LIBRARY_H
#define MURK_TESTS_LIBRARY_H

#include <stdbool.h>
#include <stdio.h>

#define MURK_LIBRARY_SUBJECTS(X) \
    X(calendar)                  \
    X(night) X(sun) X(dome) X(water) X(surface) X(droplets) X(presets)

typedef struct murk_library {
    FILE *out;
    bool is_nightly; /* all rows; else only those of seconds */
    int rows, off;
} murk_library;

/* Begins a table, with a sentence on what is compared. */
void murk_library_title(murk_library *library, const char *title,
                        const char *text);

/* One row. The limit is on |value - reference|, in the same unit, and `why`
 * says where it comes from ("last digit printed", "1 %: the issue's"). Counts
 * it as off where it is more, or not a number. */
void murk_library_row(murk_library *library, const char *quantity,
                      const char *unit, double reference, double value,
                      double limit, const char *why, const char *source);

#define X(name) void murk_library_##name(murk_library *library);
MURK_LIBRARY_SUBJECTS(X)
#undef X

#endif
