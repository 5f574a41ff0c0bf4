/* Checks of the programs of this folder that end with the first failure.
 * plan.c has its own, because it is a whole program as a user writes it. */
#ifndef MURK_TESTS_API_CHECKS_H
#define MURK_TESTS_API_CHECKS_H

#include <murk.h>

#include <stdio.h>
#include <stdlib.h>

#define CHECK(condition)                                                    \
    do {                                                                    \
        if (!(condition)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                        \
        }                                                                   \
    } while (0)

/* Ends the program with the message of a failed call. */
static inline void must_be_ok(murk_status status, const murk_error *error)
{
    if (status) {
        fprintf(stderr, "%s: %s: %s\n", murk_status_text(status), error->where,
                error->text);
        exit(1);
    }
}

#endif
