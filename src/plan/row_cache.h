/* A problem whose looks are made once and kept, as far as there is room.
 *
 * A look is kept when it takes no more than its candidate's even share of
 * MURK_ROW_CACHE_BYTES; others are made anew. So which are kept depends on
 * neither threads nor the machine. */
#ifndef MURK_PLAN_ROW_CACHE_H
#define MURK_PLAN_ROW_CACHE_H

#include "placement/problem.h"

#define MURK_ROW_CACHE_BYTES 1073741824u

typedef struct murk_cached_row murk_cached_row;

typedef struct murk_row_cache {
    murk_problem problem; /* the same but for its looks */
    const murk_problem *source;
    _Atomic(murk_cached_row *) *kept; /* [candidates] NULL: not yet, or not */
} murk_row_cache;

/* Borrows the source; must not move while it is used. */
murk_status murk_row_cache_init(murk_row_cache *out, const murk_problem *source,
                                murk_error *err);
void murk_row_cache_release(murk_row_cache *remembered);

#endif
