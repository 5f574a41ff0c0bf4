/* Standard errors of a path-traced picture's pixels, from the variances of
 * their own samples and of their neighbours'. */
#ifndef MURK_RENDER_POOLED_ERRORS_H
#define MURK_RENDER_POOLED_ERRORS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* An error is unsure that rests, effectively, on less than this share of the
 * pixels in its window: of the 50 there are at 16 samples, on fewer than 6, so
 * that the variance that it is the root of is known to some 40 % only. */
#define MURK_POOLED_FEW 0.12

typedef struct murk_pooling {
    size_t width, height, samples;
    bool is_round;         /* the first column follows the last */
    const uint8_t *is_own; /* [height * width]: the pixel keeps its own error,
                              and lends it to no other */
    unsigned threads;
} murk_pooling;

/* Pools error[height * width] in place; the values are finite. scratch: as many
 * floats. Returns how many of the pooled errors are unsure. */
size_t murk_pool_errors(const murk_pooling *pooling, float *error,
                        float *scratch);

#endif
