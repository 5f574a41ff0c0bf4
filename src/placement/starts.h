/* SPOQ starts, each relocated: many at once, kept as if one after the other. */
#ifndef MURK_PLACEMENT_STARTS_H
#define MURK_PLACEMENT_STARTS_H

#include "placement/search.h"

typedef struct murk_starts {
    murk_gain_scan *search; /* [workers] */
    unsigned workers;
    size_t wave_max; /* made between two looks at the stop */
    size_t count;    /* sensors of a plan at most */
    uint32_t *plan;  /* [wave_most][count] */
    size_t *size;    /* [wave_most] sensors of each */
    uint64_t *value, *evaluations, *queries, *rows; /* [wave_most] */
    size_t n;                                       /* sensors wanted now */
    uint32_t seed;
    uint64_t first;                      /* start number of batch 0 */
    uint64_t all_evaluations, all_looks; /* of all starts kept so far, */
    uint64_t all_rows;                   /* which end the starts where there
                                            are too many, */
    bool is_cut;                         /* as is said here */
} murk_starts;

/* For plans of at most `count` sensors. Release it also after a failure. */
murk_status murk_starts_init(murk_starts *out, const murk_evaluator *evaluator,
                             size_t count, uint32_t seed, murk_error *err);
void murk_starts_release(murk_starts *starts);

/* Under rules: a plan for starts that end short; borrowed. */
void murk_starts_set_fallback(murk_starts *starts, const uint32_t *plan,
                              size_t size);

/* Tries starts 0..most-1 in order for plans of n and keeps what is strictly
 * better than plan[*size], worth value; stops after 20 in a row without gain,
 * or when `upper` is met. Returns the best value and adds the starts made. */
uint64_t murk_starts_try(murk_starts *starts, uint32_t *plan, size_t *size,
                         size_t n, uint64_t value, uint64_t upper, size_t max,
                         size_t *made);

#endif
