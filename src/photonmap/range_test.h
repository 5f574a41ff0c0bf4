/* The inner loops of map queries, in vector instructions if the machine has
 * them: tests of 16 bounding boxes, and of the photons of a leaf, against a
 * ball.
 *
 * All implementations give the same bits. A squared distance is (dx * dx + dy *
 * dy) + dz * dz in single precision, without fused multiply-add. Rounding is
 * monotonic (a <= b gives round(a) <= round(b)), so the same formula at the
 * nearest and at the farthest point of a box bounds the result for every photon
 * in the box, exactly and without a margin. */
#ifndef MURK_PHOTONMAP_RANGE_TEST_H
#define MURK_PHOTONMAP_RANGE_TEST_H

#include "photonmap/photon.h"

#include <stdint.h>

/* The photons of a leaf (the last leaf may have fewer): one bit each in a
 * word. */
#define MURK_LEAF 32
#define MURK_WIDE 16 /* boxes in a group: one register of AVX-512 */

/* Sixteen closed boxes; an unused box has min = +infinity, max = -infinity. */
typedef struct murk_bounds {
    float min[3][MURK_WIDE];
    float max[3][MURK_WIDE];
} murk_bounds;

/* The ball of a query. */
typedef struct murk_query_sphere {
    float center[3]; /* finite */
    float radius2;   /* finite, >= 0 */
} murk_query_sphere;

/* One implementation of the inner loops. */
typedef struct murk_range_test {
    const char *name;
    /* Bit i of the result: box i may contain photons within the ball; of
     * *whole: box i lies completely within the ball. */
    uint32_t (*bounds)(const murk_bounds *bounds, const murk_query_sphere *ball,
                       uint32_t *whole);
    /* Bit i: photon i of n <= MURK_LEAF lies within the ball. */
    uint32_t (*leaf)(const murk_photon *photons, uint32_t n,
                     const murk_query_sphere *ball);
    /* Squared distances of the center from 16 boxes, and from n photons. */
    void (*bounds_distance2)(const murk_bounds *bounds, const float center[3],
                             float out[MURK_WIDE]);
    void (*leaf_distance2)(const murk_photon *photons, uint32_t n,
                           const float center[3], float out[MURK_LEAF]);
} murk_range_test;

/* All implementations that this machine supports: plain C first, the fastest
 * last. */
const murk_range_test *const *murk_range_tests(unsigned *n);

#endif
