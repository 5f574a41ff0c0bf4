/* Quantiles: of Student's t, and of a sample. */
#ifndef MURK_BASE_QUANTILE_H
#define MURK_BASE_QUANTILE_H

#include <stddef.h>

/* Student's t with so many degrees of freedom, >= 1: the upper quantile t with
 * P(T > t) = p, 0 < p < 1. For whole degrees P is a finite sum (Abramowitz and
 * Stegun, Handbook of Mathematical Functions, 1964, 26.7.3 and 26.7.4). */
double murk_student_upper(double p, size_t degrees);

/* Ranks among n numbers in rising order, 1..n. */
typedef struct murk_ranks {
    size_t value;        /* stands for the quantile: the least rank with a share
                            of at least q at or below it */
    size_t lower, upper; /* hold the quantile between them, ends included; 0: n
                            is too small for a limit on that side */
} murk_ranks;

/* For the q-quantile, 0 < q < 1, of whatever the n >= 1 independent numbers
 * are distributed like: each limit is wrong with a chance of at most `miss`,
 * by the binomial law of how many lie below it (Conover, Practical
 * Nonparametric Statistics, 1999, ch. 3.2). */
murk_ranks murk_quantile_ranks(size_t n, double q, double miss);

#endif
