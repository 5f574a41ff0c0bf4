/* Rows that share their noise, made independent: r -> L^-1 r, where L L^T is
 * the rows' covariance. */
#ifndef MURK_FIT_WHITENING_H
#define MURK_FIT_WHITENING_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_whitening murk_whitening;

/* covariance[rows * rows], symmetric; fails with MURK_RUN_FAILED where it is
 * not positive definite. *out is the caller's. */
murk_status murk_whitening_create(murk_whitening **out,
                                  const double *covariance, size_t rows,
                                  murk_error *err);
void murk_whitening_destroy(murk_whitening *whitening); /* NULL is fine */

/* In place: columns of a[rows][columns], kept row by row. */
void murk_whitening_apply(const murk_whitening *whitening, double *a,
                          size_t columns);

/* Covariance of the mean over batches of equal size: batch[batches][rows] (row
 * by row) are sums whose total over batches is the rows' value; adds the
 * covariance of that total, B/(B - 1) sum (b - mean)(b - mean)^T, to
 * covariance[rows * rows]. batches >= 2. */
void murk_covariance_of_batches(double *covariance, const double *batch,
                                size_t batches, size_t rows);

#endif
