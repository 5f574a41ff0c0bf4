/* Quantiles of the Student t distribution and of a sample. */
#ifndef MURK_BASE_QUANTILE_H
#define MURK_BASE_QUANTILE_H

#include <stddef.h>

/* The upper quantile t of the Student t distribution with `degrees` >= 1
 * degrees of freedom: P(T > t) = p, 0 < p < 1. For whole degrees P is a finite
 * sum (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, 26.7.3
 * and 26.7.4). */
double murk_student_upper(double p, size_t degrees);

/* Sorts n numbers in rising order in place; none may be NaN. */
void murk_sort(double *x, size_t n);

/* Ranks in a sample of n numbers in rising order, 1..n. */
typedef struct murk_order_statistics {
    size_t value;        /* estimates the quantile: the smallest rank with a
                          * share of at least q of the sample at or below it */
    size_t lower, upper; /* the ends of a confidence interval of the quantile;
                          * 0: n is too small for a limit on that side */
} murk_order_statistics;

/* Ranks for the q-quantile, 0 < q < 1, of the distribution from which the n >=
 * 1 independent numbers are drawn. Each limit is wrong with a probability of at
 * most `miss`, by the binomial distribution of the count of numbers below the
 * quantile (Conover, Practical Nonparametric Statistics, 1999, ch. 3.2). */
murk_order_statistics murk_quantile_ranks(size_t n, double q, double miss);

#endif
