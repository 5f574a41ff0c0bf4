/* Cache of phase tables: the same input gives the same table, and computing
 * one takes some ten milliseconds. Inside this room only. */
#ifndef MURK_MEDIUM_PHASE_CACHE_H
#define MURK_MEDIUM_PHASE_CACHE_H

#include "medium/phase_table.h"

/* The input of a table: a[n] and b[n] are angles and values of a measured
 * function; or one of each, the index n and the slope of Fournier-Forand. */
typedef struct murk_phase_origin {
    size_t n;
    const double *a, *b;
} murk_phase_origin;

/* Finds a table in the cache; false if it must be computed. */
bool murk_phase_cache_find(murk_phase_table **out,
                           const murk_phase_origin *origin);
void murk_phase_cache_put(const murk_phase_table *table,
                          const murk_phase_origin *origin);

#endif
