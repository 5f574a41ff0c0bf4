/* The rows of a validation run, between tracing and report. */
#ifndef MURK_TESTS_VALIDATION_ROWS_H
#define MURK_TESTS_VALIDATION_ROWS_H

#include "validation.h"

typedef struct validation_row {
    char group[32], name[96], quantity[64], source[224];
    char wrong[96]; /* empty: not a twin */
    double reference, uncertainty;
    murk_estimate murk;
    uint64_t photons;
    bool is_short; /* photons_most ended it before its error was reached */
} validation_row;

struct validation {
    validation_settings settings;
    char group[32];
    validation_row *row;
    size_t rows, room;
    size_t unsound; /* cases that lost light, or whose ledger is off */
};

/* A new row without an estimate. Ends the program where memory is short. */
validation_row *validation_add_row(validation *v, const char *name,
                                   const char *source, const char *is_wrong,
                                   const validation_reference *reference);

/* murk - reference in standard deviations of both; infinite where anything is
 * not a number or nothing is uncertain. */
double validation_sigmas(const validation_row *row);

#endif
