/* Dominance between candidates: compares pairs of rows in the order of falling
 * value, each row only with the rows behind it, because no row is dominated by
 * a row of smaller value. With one dominator needed the comparisons run in
 * parallel; the result is the same for any number of threads
 * (placement/presolve.h). */
#include "placement/presolve.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/ranks.h"
#include "placement/gain.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* The row that is compared with others. A row is first compared by the slots of
 * its entries, without clarities, which rules out nearly all pairs; the cover
 * of the row is made for the first pair that remains. */
typedef struct compared_row {
    const murk_row *row;
    bool has_bits;  /* `bits` are those of the row */
    uint64_t *bits; /* [words] a bit for each slot with an entry */
    bool has_cover; /* `cover` is that of the row */
    murk_cover cover;
} compared_row;

typedef struct presolving {
    const murk_matrix *matrix;
    const murk_constraint_set *set;
    const uint32_t *order;
    _Atomic uint32_t *first; /* [candidates] by number in the order: the number
                                of the first dominator found; the own number:
                                none */
    compared_row *compared;  /* [threads] */
} presolving;

static void lower_to(_Atomic uint32_t *cell, uint32_t value)
{
    uint32_t now = atomic_load_explicit(cell, memory_order_relaxed);
    while (value < now &&
           !atomic_compare_exchange_weak_explicit(
               cell, &now, value, memory_order_relaxed, memory_order_relaxed)) {
    }
}

static bool is_dominated(const presolving *p, uint32_t at)
{
    return atomic_load_explicit(&p->first[at], memory_order_relaxed) < at;
}

static bool has_bits(const murk_row *row)
{
    return row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED;
}

static void begin_row(compared_row *c, const murk_layout *layout,
                      const murk_row *row)
{
    c->row = row;
    c->has_cover = false;
    c->has_bits = has_bits(row);
    if (c->has_bits) {
        memset(c->bits, 0, layout->words * sizeof *c->bits);
        for (size_t k = 0; k < row->words; ++k) {
            c->bits[murk_row_word(row, k)] = row->bits[k];
        }
    }
}

/* True if the compared row is nowhere below another row. */
static bool covers(compared_row *c, const murk_layout *layout,
                   const murk_row *row)
{
    if (c->has_bits && has_bits(row)) {
        for (size_t k = 0; k < row->words; ++k) {
            if (row->bits[k] & ~c->bits[murk_row_word(row, k)]) {
                return false;
            }
        }
    }
    if (!c->has_cover) {
        murk_cover_clear(&c->cover, layout);
        murk_cover_add(&c->cover, layout, c->row);
        c->has_cover = true;
    }
    return murk_row_is_covered(layout, row, &c->cover);
}

/* Marks the candidate number b of the order if number a dominates it, whose row
 * is compared. */
static void compare(presolving *p, compared_row *compared, uint32_t a,
                    uint32_t b)
{
    const uint32_t candidate = p->order[b];
    if (murk_matrix_has(p->matrix, candidate) &&
        atomic_load_explicit(&p->first[b], memory_order_relaxed) > a &&
        covers(compared, &p->matrix->layout,
               murk_matrix_row(p->matrix, candidate)) &&
        (!p->set ||
         murk_constraint_set_may_drop(p->set, p->order[a], candidate))) {
        lower_to(&p->first[b], a);
    }
}

/* Marks all candidates that number `batch` of the order dominates. A dominated
 * candidate may be passed over: the dominator marks the same candidates and
 * comes first. So the result does not depend on the order of the tasks. */
static void mark(void *context, unsigned worker, uint64_t batch)
{
    presolving *p = context;
    const uint32_t a = (uint32_t)batch;
    compared_row *compared = &p->compared[worker];
    if (is_dominated(p, a)) {
        return;
    }
    begin_row(compared, &p->matrix->layout,
              murk_matrix_row(p->matrix, p->order[a]));
    for (uint32_t b = a + 1; b < p->matrix->candidates; ++b) {
        compare(p, compared, a, b);
    }
}

/* ---- distributed matrices: the ranks take one candidate after the other,
 * whose row all fetch, and compare the rows of their own candidates with it
 * ---- */

/* Makes the row of a candidate the cover. False if the candidate is passed
 * over, which the rank that has its row knows, or after a failure of a rank. */
static bool begin_candidate(const murk_matrix *matrix, uint32_t candidate,
                            bool is_passed_over, murk_cover *cover)
{
    murk_error err = {0};
    uint64_t word = murk_matrix_has(matrix, candidate) && is_passed_over;
    if (murk_ranks_complete(&word, sizeof word, murk_interrupt_check(&err),
                            &err) ||
        word) {
        return false;
    }
    const murk_row row = murk_matrix_fetch(matrix, candidate);
    murk_cover_clear(cover, &matrix->layout);
    murk_cover_add(cover, &matrix->layout, &row);
    return !murk_interrupted();
}

/* Candidates that a thread compares at once. */
#define CANDIDATES_AT_ONCE 64

typedef struct marking {
    presolving *p;
    uint32_t a;
} marking;

static void mark_some(void *context, unsigned worker, uint64_t batch)
{
    const marking *m = context;
    const uint64_t n = m->p->matrix->candidates;
    const uint64_t first = m->a + 1 + batch * CANDIDATES_AT_ONCE;
    (void)worker;
    for (uint64_t b = first; b < n && b < first + CANDIDATES_AT_ONCE; ++b) {
        compare(m->p, &m->p->compared[0], m->a, (uint32_t)b);
    }
}

static void mark_by_ranks(presolving *p, unsigned threads)
{
    const uint32_t n = (uint32_t)p->matrix->candidates;
    p->compared[0].has_cover = true; /* all threads read it */
    for (uint32_t a = 0; a < n && !murk_interrupted(); ++a) {
        marking m = {p, a};
        if (begin_candidate(p->matrix, p->order[a], is_dominated(p, a),
                            &p->compared[0].cover)) {
            murk_pool_run_workers(
                threads, (n - a + CANDIDATES_AT_ONCE - 2) / CANDIDATES_AT_ONCE,
                mark_some, &m);
        }
    }
}

/* Completes value[candidates], of which each rank knows those of its own
 * candidates. */
static murk_status complete(const murk_matrix *matrix, uint32_t *value,
                            murk_error *err)
{
    if (!matrix->is_distributed) {
        return MURK_OK;
    }
    for (size_t j = 0; j < matrix->candidates; ++j) {
        value[j] = murk_matrix_has(matrix, j) ? value[j] : 0;
    }
    return murk_ranks_complete(value, matrix->candidates * sizeof *value,
                               murk_interrupt_check(err), err);
}

murk_status murk_presolve(uint32_t *dominator, const murk_matrix *matrix,
                          const murk_constraint_set *set, const uint32_t *order,
                          unsigned threads, murk_error *err)
{
    const size_t n = matrix->candidates;
    for (size_t j = 0; j < n; ++j) {
        dominator[j] = (uint32_t)j;
    }
    if (n > MURK_PRESOLVE_CANDIDATES_MAX) {
        return MURK_OK;
    }
    murk_status status = MURK_OK;
    /* Each thread compares a row with others. */
    presolving p = {.matrix = matrix,
                    .set = set,
                    .order = order,
                    .first = malloc((n + 1) * sizeof *p.first),
                    .compared = calloc(threads, sizeof *p.compared)};
    bool has_memory = p.first && p.compared;
    for (unsigned k = 0; has_memory && k < threads; ++k) {
        compared_row *c = &p.compared[k];
        c->bits = malloc((matrix->layout.words + 1) * sizeof *c->bits);
        has_memory =
            c->bits && murk_cover_init_single(&c->cover, &matrix->layout,
                                              matrix->is_binary);
    }
    if (!has_memory) {
        status = murk_no_memory(err, "", "to compare %zu candidates", n);
        goto done;
    }
    for (uint32_t k = 0; k < n; ++k) {
        atomic_init(&p.first[k], k);
    }
    /* Compare the pairs of rows; then translate numbers to candidates. */
    if (matrix->is_distributed) {
        mark_by_ranks(&p, threads);
    } else {
        murk_pool_run_workers(threads, n, mark, &p);
    }
    for (size_t k = 0; k < n; ++k) {
        dominator[order[k]] = order[atomic_load(&p.first[k])];
    }
    status = complete(matrix, dominator, err);
done:
    for (unsigned k = 0; p.compared && k < threads; ++k) {
        murk_cover_release(&p.compared[k].cover);
        free(p.compared[k].bits);
    }
    free(p.compared);
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
        if (matrix->is_distributed
                ? !begin_candidate(matrix, a, is_dropped[a], cover)
                : is_dropped[a]) {
            continue;
        }
        /* The row of candidate a is the cover. */
        if (!matrix->is_distributed) {
            murk_cover_clear(cover, layout);
            murk_cover_add(cover, layout, murk_matrix_row(matrix, a));
        }
        for (size_t i = k + 1; i < matrix->candidates; ++i) {
            const uint32_t b = order[i];
            if (murk_matrix_has(matrix, b) && !is_dropped[b] &&
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
    if (n > MURK_PRESOLVE_CANDIDATES_MAX || needed >= n) {
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
    return matrix->is_distributed
               ? murk_ranks_complete(is_dropped, n * sizeof *is_dropped,
                                     murk_interrupt_check(err), err)
               : MURK_OK;
}
