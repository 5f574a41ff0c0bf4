/* The rows of a validation run, between tracing and report. */
#ifndef MURK_TESTS_VALIDATION_ROWS_H
#define MURK_TESTS_VALIDATION_ROWS_H

#include "validation.h"

typedef struct validation_row {
    char group[32], name[96], quantity[64], source[224];
    char wrong[96];      /* empty: not a twin */
    char why_short[160]; /* empty: it may not be, in the nightly form */
    double reference, uncertainty;
    murk_estimate murk;
    uint64_t photons;
    double sigmas_max; /* 0: only the run's own limit */
    bool is_bound;     /* murk may be anything up to the reference */
    bool is_short;     /* photons ended before its error was reached */
    bool is_quick;     /* its form */
    bool is_unsound;   /* of a case that lost light, or whose ledger is off */
} validation_row;

struct validation {
    validation_settings settings;
    char group[32];
    validation_row *row;
    size_t rows, capacity;
};

/* A new row without an estimate. Ends the program where memory is short. */
validation_row *validation_add_row(validation *v, const char *name,
                                   const char *source, const char *is_wrong,
                                   const validation_reference *reference);

/* murk - reference in standard deviations of both; infinite where anything is
 * not a number or nothing is uncertain. */
double validation_sigmas(const validation_row *row);

#endif
