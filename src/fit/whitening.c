/* Whitening by the Cholesky factor of the covariance, and the covariance of
 * sums over batches. */
#include "fit/whitening.h"

#include "fit/ceres_bridge.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct murk_whitening {
    size_t rows;
    double lower[]; /* [rows * rows], L in the lower triangle */
};

/* Checks row by row, so that the message can name the row or the pair of
 * rows. */
static murk_status check(const double *covariance, size_t rows, murk_error *err)
{
    for (size_t i = 0; i < rows; ++i) {
        const double variance = covariance[i * rows + i];
        if (!(variance > 0 && isfinite(variance))) {
            return murk_fail(err, MURK_RUN_FAILED, "fit",
                             "row %zu has a variance of %g, must be above 0",
                             i + 1, variance);
        }
        for (size_t j = 0; j < i; ++j) {
            if (!isfinite(covariance[i * rows + j])) {
                return murk_fail(err, MURK_RUN_FAILED, "fit",
                                 "rows %zu and %zu have a covariance of %g, "
                                 "must be finite",
                                 j + 1, i + 1, covariance[i * rows + j]);
            }
        }
    }
    return MURK_OK;
}

murk_status murk_whitening_create(murk_whitening **out,
                                  const double *covariance, size_t rows,
                                  murk_error *err)
{
    assert(out && covariance && rows > 0);
    murk_whitening *whitening = NULL;
    murk_status status = check(covariance, rows, err);
    if (status) {
        goto done;
    }
    /* Copy the covariance and factorise the copy. */
    const size_t cells = rows * rows;
    whitening = malloc(sizeof *whitening + cells * sizeof(double));
    if (!whitening) {
        status =
            murk_no_memory(err, "fit", "for the covariance of %zu rows", rows);
        goto done;
    }
    whitening->rows = rows;
    memcpy(whitening->lower, covariance, cells * sizeof(double));
    bool is_positive;
    const murk_ceres *ceres = murk_ceres_load(err);
    status = ceres ? ceres->cholesky(whitening->lower, rows, &is_positive, err)
                   : MURK_RUN_FAILED;
    if (status) {
        goto done;
    }
    if (!is_positive) {
        status = murk_fail(err, MURK_RUN_FAILED, "fit",
                           "the covariance of the %zu rows is not positive "
                           "definite: some of their errors follow from others",
                           rows);
        goto done;
    }
    *out = whitening;
    whitening = NULL;
done:
    murk_whitening_destroy(whitening);
    return status;
}

void murk_whitening_destroy(murk_whitening *whitening)
{
    free(whitening);
}

void murk_whitening_apply(const murk_whitening *whitening, double *a,
                          size_t columns)
{
    for (size_t i = 0; i < whitening->rows; ++i) {
        const double *lower = whitening->lower + i * whitening->rows;
        double *at = a + i * columns;
        for (size_t k = 0; k < i; ++k) {
            const double *above = a + k * columns;
            for (size_t c = 0; c < columns; ++c) {
                at[c] -= lower[k] * above[c];
            }
        }
        for (size_t c = 0; c < columns; ++c) {
            at[c] /= lower[i];
        }
    }
}

/* With b_i the sum of batch b for row i, the sum over the batches of b_i -
 * mean_i is 0. In sum (b_i - mean_i)(b_j - mean_j) any constant may therefore
 * replace mean_j. The value of the first batch avoids a loss of digits and
 * needs no memory. */
void murk_covariance_of_batches(double *covariance, const double *batch,
                                size_t batches, size_t rows)
{
    assert(batches >= 2);
    const double factor = (double)batches / (double)(batches - 1);
    for (size_t i = 0; i < rows; ++i) {
        double mean = 0;
        for (size_t b = 0; b < batches; ++b) {
            mean += (batch[b * rows + i] - batch[i]) / (double)batches;
        }
        for (size_t b = 1; b < batches; ++b) {
            const double *value = batch + b * rows;
            const double off = factor * (value[i] - batch[i] - mean);
            for (size_t j = i; j < rows; ++j) {
                covariance[i * rows + j] += off * (value[j] - batch[j]);
            }
        }
        for (size_t j = i + 1; j < rows; ++j) {
            covariance[j * rows + i] = covariance[i * rows + j];
        }
    }
}
