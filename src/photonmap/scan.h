/* The two inner loops of a map query, as wide as the machine allows: which of
 * 16 boxes a ball meets, and which photons of a leaf lie in it.
 *
 * All ways give the same bits. A squared distance is
 * (dx * dx + dy * dy) + dz * dz in single precision, without fused
 * multiply-add. Rounding keeps order (a <= b gives round(a) <= round(b)), so
 * the same formula at a box's nearest and farthest point bounds what it gives
 * for every photon of the box, exactly and without a margin. */
#ifndef MURK_PHOTONMAP_SCAN_H
#define MURK_PHOTONMAP_SCAN_H

#include "photonmap/photon.h"

#include <stdint.h>

#define MURK_LEAF 32 /* photons in a leaf; the last one may hold fewer */
#define MURK_WIDE 16 /* boxes side by side */

/* Closed boxes; an unused one has min = +infinity, max = -infinity. */
typedef struct murk_boxes {
    float min[3][MURK_WIDE];
    float max[3][MURK_WIDE];
} murk_boxes;

typedef struct murk_query_sphere {
    float center[3]; /* finite */
    float radius2;   /* finite, >= 0 */
} murk_query_sphere;

typedef struct murk_scan {
    const char *name;
    /* Bit i: box i may hold photons of the ball; of *whole: holds no others. */
    uint32_t (*boxes)(const murk_boxes *boxes, const murk_query_sphere *ball,
                      uint32_t *whole);
    /* Bit i: photon i of n <= MURK_LEAF lies in the ball. */
    uint32_t (*leaf)(const murk_photon *photons, uint32_t n,
                     const murk_query_sphere *ball);
    /* Squared distances of the center from 16 boxes, from n photons. */
    void (*boxes_distance2)(const murk_boxes *boxes, const float center[3],
                            float out[MURK_WIDE]);
    void (*leaf_distance2)(const murk_photon *photons, uint32_t n,
                           const float center[3], float out[MURK_LEAF]);
} murk_scan;

/* Plain C first, then what this machine has; the last is the fastest. */
const murk_scan *const *murk_scans(unsigned *n);

#endif
