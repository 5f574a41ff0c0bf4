/* Whitening: transforms rows r whose covariance matrix is L L^T into
 * uncorrelated rows of unit variance, r -> L^-1 r. */
#ifndef MURK_FIT_WHITENING_H
#define MURK_FIT_WHITENING_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_whitening murk_whitening;

/* covariance[rows * rows] is symmetric. Only the lower triangle is read. Fails
 * with MURK_RUN_FAILED if that triangle has a number that is not finite, or if
 * the covariance is not positive definite, or with MURK_NO_MEMORY. The caller
 * destroys *out. */
murk_status murk_whitening_create(murk_whitening **out,
                                  const double *covariance, size_t rows,
                                  murk_error *err);
void murk_whitening_destroy(murk_whitening *whitening); /* NULL is fine */

/* Applies L^-1 in place to the columns of a[rows][columns], stored row by
 * row. */
void murk_whitening_apply(const murk_whitening *whitening, double *a,
                          size_t columns);

/* Adds the covariance of a total over batches of equal size to the symmetric
 * covariance[rows * rows]. batch[batches][rows] (row by row) has the sums b of
 * each batch, and
 * the value of a row is the sum over all batches. The covariance of the total
 * is B/(B - 1) sum (b - mean)(b - mean)^T, where B is the number of batches.
 * batches >= 2. */
void murk_covariance_of_batches(double *covariance, const double *batch,
                                size_t batches, size_t rows);

#endif
