/* Line integrals of the trilinear field between dense samples, as one would
 * write them for speed: the reference of the march with `linear`. */
#ifndef MURK_BENCH_PEER_MARCH_H
#define MURK_BENCH_PEER_MARCH_H

#include <stdbool.h>
#include <stddef.h>

/* Samples at whole coordinates 0 .. size - 1, x fastest; the outermost samples
 * are 0, so that the field ends there. */
typedef struct dense_field {
    int size[3];
    float *sample;
    int bricks[3];     /* of BRICK cells along each axis */
    bool *is_occupied; /* by brick, x fastest: any sample of the brick is not
                          0 */
} dense_field;

/* Memory for samples of the size, all 0. False: out of memory. */
bool dense_field_create(dense_field *field, const int size[3]);

/* Finds the occupied bricks once all samples are set. */
void dense_field_prepare(dense_field *field);
void dense_field_release(dense_field *field);

/* The integral from the origin along the unit direction, over the length. */
double dense_field_integral(const dense_field *field, const float origin[3],
                            const float direction[3], float length);

#endif
