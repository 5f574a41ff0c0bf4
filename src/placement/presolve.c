/* Dominance between candidates: compares pairs of rows in the order of falling
 * value, each row only with the rows behind it, because no row is dominated by
 * a row of smaller value. With one dominator needed the comparisons run in
 * parallel; the result is the same for any number of threads
 * (placement/presolve.h). */
#include "placement/presolve.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "placement/gain.h"

#include <stdatomic.h>
#include <stdlib.h>

typedef struct presolving {
    const murk_matrix *matrix;
    const murk_constraint_set *set;
    const uint32_t *order;
    _Atomic uint32_t *first; /* [candidates] by rank: the rank of the first
                                dominator found; the own rank: none */
    murk_cover *cover;       /* [threads] */
} presolving;

static void lower_to(_Atomic uint32_t *cell, uint32_t value)
{
    uint32_t now = atomic_load_explicit(cell, memory_order_relaxed);
    while (value < now &&
           !atomic_compare_exchange_weak_explicit(
               cell, &now, value, memory_order_relaxed, memory_order_relaxed)) {
    }
}

/* Marks all candidates that the candidate of this rank dominates. A dominated
 * candidate may be passed over: the dominator marks the same candidates and
 * ranks first. So the result does not depend on the order of the tasks. */
static void mark(void *context, unsigned worker, uint64_t batch)
{
    presolving *p = context;
    const uint32_t rank = (uint32_t)batch;
    if (atomic_load_explicit(&p->first[rank], memory_order_relaxed) < rank) {
        return;
    }
    const murk_layout *layout = &p->matrix->layout;
    murk_cover *cover = &p->cover[worker];
    murk_cover_clear(cover, layout);
    murk_cover_add(cover, layout, murk_matrix_row(p->matrix, p->order[rank]));
    for (uint32_t b = rank + 1; b < p->matrix->candidates; ++b) {
        if (atomic_load_explicit(&p->first[b], memory_order_relaxed) > rank &&
            murk_row_is_covered(layout, murk_matrix_row(p->matrix, p->order[b]),
                                cover) &&
            (!p->set || murk_constraint_set_may_drop(p->set, p->order[rank],
                                                     p->order[b]))) {
            lower_to(&p->first[b], rank);
        }
    }
}

murk_status murk_presolve(uint32_t *dominator, const murk_matrix *matrix,
                          const murk_constraint_set *set, const uint32_t *order,
                          unsigned threads, murk_error *err)
{
    const size_t n = matrix->candidates;
    for (size_t j = 0; j < n; ++j) {
        dominator[j] = (uint32_t)j;
    }
    if (n > MURK_PAIRED_CANDIDATES_MAX) {
        return MURK_OK;
    }
    murk_status status = MURK_OK;
    /* One cover per thread holds the row under comparison. */
    presolving p = {.matrix = matrix,
                    .set = set,
                    .order = order,
                    .first = malloc((n + 1) * sizeof *p.first),
                    .cover = calloc(threads, sizeof *p.cover)};
    bool has_memory = p.first && p.cover;
    for (unsigned k = 0; has_memory && k < threads; ++k) {
        has_memory = murk_cover_init_single(&p.cover[k], &matrix->layout,
                                            matrix->is_binary);
    }
    if (!has_memory) {
        status = murk_no_memory(err, "", "to compare %zu candidates", n);
        goto done;
    }
    for (uint32_t k = 0; k < n; ++k) {
        atomic_init(&p.first[k], k);
    }
    /* Compare the pairs of rows; then translate ranks to candidates. */
    murk_pool_run_workers(threads, n, mark, &p);
    for (size_t k = 0; k < n; ++k) {
        dominator[order[k]] = order[atomic_load(&p.first[k])];
    }
done:
    for (unsigned k = 0; p.cover && k < threads; ++k) {
        murk_cover_release(&p.cover[k]);
    }
    free(p.cover);
    free(p.first);
    return status;
}

/* Marks the candidates that at least `needed` kept candidates dominate. The
 * loop is sequential, because a candidate counts as a dominator of others only
 * if it is kept itself. */
static void drop_many(bool *is_dropped, size_t *dominators, murk_cover *cover,
                      const murk_matrix *matrix, const murk_constraint_set *set,
                      const uint32_t *order, size_t needed)
{
    const murk_layout *layout = &matrix->layout;
    for (size_t k = 0; k < matrix->candidates && !murk_interrupted(); ++k) {
        const uint32_t a = order[k];
        if (is_dropped[a]) {
            continue;
        }
        murk_cover_clear(cover, layout);
        murk_cover_add(cover, layout, murk_matrix_row(matrix, a));
        for (size_t i = k + 1; i < matrix->candidates; ++i) {
            const uint32_t b = order[i];
            if (!is_dropped[b] &&
                murk_row_is_covered(layout, murk_matrix_row(matrix, b),
                                    cover) &&
                (!set || murk_constraint_set_may_drop(set, a, b))) {
                is_dropped[b] = ++dominators[b] >= needed;
            }
        }
    }
}

murk_status murk_presolve_many(bool *is_dropped, const murk_matrix *matrix,
                               const murk_constraint_set *set,
                               const uint32_t *order, size_t needed,
                               murk_error *err)
{
    const size_t n = matrix->candidates;
    if (n > MURK_PAIRED_CANDIDATES_MAX || needed >= n) {
        return MURK_OK;
    }
    murk_cover cover = {0};
    size_t *dominators = calloc(n + 1, sizeof *dominators);
    if (!dominators ||
        !murk_cover_init_single(&cover, &matrix->layout, matrix->is_binary)) {
        free(dominators);
        return murk_no_memory(err, "", "to compare %zu candidates", n);
    }
    drop_many(is_dropped, dominators, &cover, matrix, set, order, needed);
    murk_cover_release(&cover);
    free(dominators);
    return MURK_OK;
}
