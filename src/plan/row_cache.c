/* Caches coverage rows in memory, one allocation for each row. Threads may ask
 * for the same row at the same time: an atomic compare-and-exchange decides
 * which copy stays. */
#include "plan/row_cache.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct murk_cached_row {
    murk_sparse_row row;
    uint32_t photon[]; /* [row.seen], followed by the clarities if there are any
                        */
};

/* Copies a row; NULL if it takes more than max_bytes or memory is short. */
static murk_cached_row *keep(const murk_sparse_row *row, size_t max_bytes)
{
    const size_t photons = row->seen * sizeof *row->photon;
    const size_t clarities =
        row->clarity ? row->seen * sizeof *row->clarity : 0;
    murk_cached_row *copy = NULL;
    if (photons + clarities <= max_bytes) {
        copy = malloc(sizeof *copy + photons + clarities);
    }
    if (!copy) {
        return NULL;
    }
    uint16_t *clarity = (uint16_t *)(copy->photon + row->seen);
    copy->row = (murk_sparse_row){row->seen, copy->photon, NULL};
    if (photons) {
        memcpy(copy->photon, row->photon, photons);
    }
    if (clarities) {
        memcpy(clarity, row->clarity, clarities);
        copy->row.clarity = clarity;
    }
    return copy;
}

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *row)
{
    murk_row_cache *r = context;
    murk_cached_row *cached = atomic_load(&r->cached[candidate]);
    if (cached) {
        *row = cached->row;
        return;
    }
    r->source->get_row(r->source->context, worker, candidate, row);
    cached = keep(row, MURK_ROW_CACHE_BYTES / r->source->candidates);
    murk_cached_row *none = NULL;
    if (cached &&
        !atomic_compare_exchange_strong(&r->cached[candidate], &none, cached)) {
        free(cached); /* another worker cached it first */
    }
}

murk_status murk_row_cache_init(murk_row_cache *out, const murk_problem *source,
                                murk_error *err)
{
    *out = (murk_row_cache){.problem = *source, .source = source};
    out->problem.get_row = get_row;
    out->problem.get_part = NULL;
    out->problem.rest = NULL;
    out->problem.list_counters = NULL;
    out->problem.context = out;
    out->cached = calloc(source->candidates + 1, sizeof *out->cached);
    return out->cached ? MURK_OK
                       : murk_no_memory(err, "", "for %zu candidates",
                                        source->candidates);
}

void murk_row_cache_release(murk_row_cache *r)
{
    for (size_t j = 0; r->cached && j < r->source->candidates; ++j) {
        free(atomic_load(&r->cached[j]));
    }
    free(r->cached);
    *r = (murk_row_cache){0};
}
