/* A coverage problem whose rows are cached when they are first computed, as far
 * as memory allows.
 *
 * A row is cached if it takes no more than MURK_ROW_CACHE_BYTES divided by the
 * number of candidates; other rows are computed again each time. Unless memory
 * runs short, the choice of the cached rows therefore depends neither on
 * threads nor on the machine. */
#ifndef MURK_PLAN_ROW_CACHE_H
#define MURK_PLAN_ROW_CACHE_H

#include "placement/problem.h"

#define MURK_ROW_CACHE_BYTES 1073741824u /* 1 GiB for all rows */

typedef struct murk_cached_row murk_cached_row;

typedef struct murk_row_cache {
    murk_problem problem; /* the source problem with cached rows */
    const murk_problem *source;
    _Atomic(murk_cached_row *) *cached; /* [candidates]; NULL: the row is not
                                         * cached, or not yet */
} murk_row_cache;

/* Borrows the source. out->problem.context points to *out, so *out must not
 * move. Fails with MURK_NO_MEMORY. */
murk_status murk_row_cache_init(murk_row_cache *out, const murk_problem *source,
                                murk_error *err);
void murk_row_cache_release(murk_row_cache *cache);

#endif
