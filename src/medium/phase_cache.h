/* Phase tables that were laid before: the same rows give the same table, and
 * laying it takes some ten milliseconds. Inside this room only. */
#ifndef MURK_MEDIUM_PHASE_CACHE_H
#define MURK_MEDIUM_PHASE_CACHE_H

#include "medium/phase_table.h"

/* All that a table follows from: a[n] and b[n], angles and values; or one of
 * each, n and slope of Fournier-Forand. */
typedef struct murk_phase_origin {
    size_t n;
    const double *a, *b;
} murk_phase_origin;

/* False: lay it. */
bool murk_phase_cache_find(murk_phase_table **out,
                           const murk_phase_origin *origin);
void murk_phase_cache_put(const murk_phase_table *table,
                          const murk_phase_origin *origin);

#endif
