/* Cached rows as a binary heap with the last candidate by rank on top. When
 * the memory is exceeded, rows are dropped from the top, and no row behind a
 * dropped one is accepted later. So the cached rows are always those of the
 * first candidates by rank, and a row that belongs to the final ones is never
 * dropped: rows before it would have to exceed the memory alone. */
#include "placement/ranked_rows.h"

#include "base/sort.h"

#include <stdlib.h>

int murk_compare_ranked(const void *a, const void *b)
{
    const murk_ranked *x = a, *y = b;
    const int falling = MURK_ORDER(y->bound, x->bound);
    return falling ? falling : MURK_ORDER(x->candidate, y->candidate);
}

static bool is_behind(const murk_ranked *a, const murk_ranked *b)
{
    return murk_compare_ranked(a, b) > 0;
}

murk_status murk_ranked_rows_init(murk_ranked_rows *out, size_t candidates,
                                  uint64_t max_bytes, murk_error *err)
{
    *out = (murk_ranked_rows){.candidates = candidates, .max_bytes = max_bytes};
    out->row = murk_arena_array(&out->arena, candidates, sizeof *out->row);
    out->heap = murk_arena_array(&out->arena, candidates, sizeof *out->heap);
    if (out->arena.is_short) {
        murk_ranked_rows_release(out);
        return murk_no_memory(err, "", "for %zu candidates", candidates);
    }
    return MURK_OK;
}

void murk_ranked_rows_release(murk_ranked_rows *r)
{
    for (size_t j = 0; r->row && j < r->candidates; ++j) {
        free(r->row[j].memory);
    }
    murk_arena_release(&r->arena);
    *r = (murk_ranked_rows){0};
}

static void push(murk_ranked_rows *r, murk_ranked ranked)
{
    size_t at = r->count++;
    while (at > 0 && is_behind(&ranked, &r->heap[(at - 1) / 2])) {
        r->heap[at] = r->heap[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    r->heap[at] = ranked;
}

static murk_ranked pop(murk_ranked_rows *r)
{
    const murk_ranked top = r->heap[0], last = r->heap[--r->count];
    size_t at = 0;
    for (size_t child = 1; child < r->count; child = 2 * at + 1) {
        if (child + 1 < r->count &&
            is_behind(&r->heap[child + 1], &r->heap[child])) {
            ++child;
        }
        if (!is_behind(&r->heap[child], &last)) {
            break;
        }
        r->heap[at] = r->heap[child];
        at = child;
    }
    r->heap[at] = last;
    return top;
}

bool murk_ranked_rows_wants(const murk_ranked_rows *r, murk_ranked ranked)
{
    return r->max_bytes > 0 &&
           !(r->has_refused && is_behind(&ranked, &r->refused));
}

void murk_ranked_rows_offer(murk_ranked_rows *r, murk_ranked ranked,
                            const murk_row *row)
{
    if (!murk_ranked_rows_wants(r, ranked)) {
        free(row->memory);
        return;
    }
    r->row[ranked.candidate] = *row;
    r->bytes += row->memory_bytes;
    push(r, ranked);
    /* A row without memory counts as dropped. */
    bool is_missing = !row->memory;
    while (r->count > 0 && (is_missing || r->bytes > r->max_bytes)) {
        r->refused = pop(r);
        r->has_refused = true;
        murk_row *dropped = &r->row[r->refused.candidate];
        is_missing = is_missing && r->refused.candidate != ranked.candidate;
        r->bytes -= dropped->memory_bytes;
        free(dropped->memory);
        *dropped = (murk_row){0};
    }
}
