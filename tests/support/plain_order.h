/* The order of a photon map by the definition in photonmap/order.h, step by
 * step: each node is sorted as a whole along the widest side of the bounding
 * box of its records. */
#ifndef MURK_TESTS_PLAIN_ORDER_H
#define MURK_TESTS_PLAIN_ORDER_H

#include "photonmap/order.h"
#include "photonmap/range_test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static inline int plain_widest_axis(const murk_photon *photons, size_t n)
{
    int widest = 0;
    float largest = -1;
    for (int axis = 0; axis < 3; ++axis) {
        float min = INFINITY, max = -INFINITY;
        for (size_t i = 0; i < n; ++i) {
            min = fminf(min, photons[i].position_m[axis]);
            max = fmaxf(max, photons[i].position_m[axis]);
        }
        if (max - min > largest) {
            largest = max - min;
            widest = axis;
        }
    }
    return widest;
}

/* Compares by a coordinate, then by all bytes: 0 only for equal records. */
static inline int plain_compare(const murk_photon *a, const murk_photon *b,
                                int axis)
{
    const float x = a->position_m[axis], y = b->position_m[axis];
    return x < y ? -1 : x > y ? 1 : memcmp(a, b, sizeof *a);
}

static inline int plain_compare_x(const void *a, const void *b)
{
    return plain_compare(a, b, 0);
}

static inline int plain_compare_y(const void *a, const void *b)
{
    return plain_compare(a, b, 1);
}

static inline int plain_compare_z(const void *a, const void *b)
{
    return plain_compare(a, b, 2);
}

static inline void plain_sort(murk_photon *photons, size_t n, int axis)
{
    qsort(photons, n, sizeof *photons,
          axis == 0   ? plain_compare_x
          : axis == 1 ? plain_compare_y
                      : plain_compare_z);
}

/* Orders the n records of a node of `leaves` leaves, a power of 2. */
static inline void plain_order(murk_photon *photons, size_t n, size_t leaves)
{
    const size_t half = leaves / 2 * MURK_LEAF;
    if (leaves == 1) {
        plain_sort(photons, n, 0);
    } else if (n > half) {
        plain_sort(photons, n, plain_widest_axis(photons, n));
        plain_order(photons, half, leaves / 2);
        plain_order(photons + half, n - half, leaves / 2);
    } else {
        plain_order(photons, n, leaves / 2);
    }
}

#endif
