/* Standard errors of the pixels of a path-traced picture, from the variances of
 * the samples of each pixel and the pixels around it. */
#ifndef MURK_RENDER_POOLED_ERRORS_H
#define MURK_RENDER_POOLED_ERRORS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* An error is unsure if it rests effectively on less than this share of the
 * pixels in the window: at 16 samples on fewer than 6 of 50 pixels, so that the
 * variance is known to about 40 % only. */
#define MURK_POOLED_FEW 0.12

typedef struct murk_pooling {
    size_t width, height, samples;
    bool is_round;         /* the first column follows the last one */
    const uint8_t *is_own; /* [height * width]: the pixel keeps its own error,
                            * which is not used for other pixels */
    unsigned threads;
} murk_pooling;

/* Pools error[height * width] in place; the values are finite. scratch: as many
 * floats. Returns the number of unsure pooled errors. */
size_t murk_pool_errors(const murk_pooling *pooling, float *error,
                        float *scratch);

#endif
