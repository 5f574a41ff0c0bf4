/* Comparisons for qsort() and bsearch(), and a sort that needs no memory. */
#ifndef MURK_BASE_SORT_H
#define MURK_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>

/* -1, 0 or 1: a is less than b, equal to b, or greater than b. 0 also if one of
 * them is NaN. */
#define MURK_ORDER(a, b) (((a) > (b)) - ((a) < (b)))

/* Defines murk_by_NAME(), which compares two numbers of a type. */
#define MURK_BY(name, type)                                        \
    static inline int murk_by_##name(const void *a, const void *b) \
    {                                                              \
        return MURK_ORDER(*(const type *)a, *(const type *)b);     \
    }
MURK_BY(double, double)
MURK_BY(float, float)
MURK_BY(size, size_t)
MURK_BY(uint32, uint32_t)
MURK_BY(uint64, uint64_t)
#undef MURK_BY

/* Sorts key[n] in ascending order, in place. */
void murk_sort_uint64(uint64_t *key, size_t n);

#endif
