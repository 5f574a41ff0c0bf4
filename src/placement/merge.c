#include "placement/merge.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/tally.h"

#include <stdlib.h>
#include <string.h>

#define NOBODY UINT32_MAX

/* Beside its words a segment costs a call, as much as so many words; a word of
 * mixed weights as much as so many others. Rows must become so much shorter. */
#define WORDS_PER_SEGMENT 8
#define WORDS_PER_MIXED   16
#define COST_KEPT         0.7

/* SplitMix64's finaliser: the word of a candidate and clarity. */
static uint64_t word_of(uint64_t candidate, uint16_t clarity)
{
    uint64_t x = (candidate << 16 | clarity) + UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

void murk_merge_note(_Atomic uint64_t *print, size_t candidate,
                     const murk_look *look)
{
    const uint64_t clear = word_of(candidate, MURK_CLEAR);
    for (size_t k = 0; k < look->seen; ++k) {
        const uint64_t word =
            look->clarity ? word_of(candidate, look->clarity[k]) : clear;
        atomic_fetch_add_explicit(&print[look->photon[k]], word,
                                  memory_order_relaxed);
    }
}

typedef struct viewed {
    uint64_t print;
    uint32_t weight, photon;
} viewed;

typedef struct merging {
    murk_matrix *matrix;
    size_t photons, groups, kept;
    uint32_t *group;  /* [photons] */
    uint32_t *size;   /* [groups] */
    uint32_t *number; /* [photons] among those kept, or NOBODY */
    uint32_t *weight; /* [kept] */
    uint32_t *photon; /* [slots] of the matrix as it is, or NOBODY */
    murk_layout layout;
    /* [threads][..] */
    uint32_t **met;     /* [groups] photons of a row */
    uint16_t **clarity; /* [groups] theirs */
    uint32_t **seen;    /* [kept] */
    uint16_t **packed;  /* [kept] */
    unsigned threads;
    murk_tally differ, out_of_memory, bytes;
} merging;

static int by_view(const void *a, const void *b)
{
    const viewed *x = a, *y = b;
    if (x->print != y->print) {
        return x->print < y->print ? -1 : 1;
    }
    if (x->weight != y->weight) {
        return x->weight < y->weight ? -1 : 1;
    }
    return (x->photon > y->photon) - (x->photon < y->photon);
}

/* Who of a group's m photons stand for all, and with which weight. */
static void deal(merging *m, const viewed *first, size_t n)
{
    size_t left = n;
    for (size_t k = 0; k < n; ++k) {
        m->number[first[k].photon] = NOBODY;
    }
    for (size_t k = 0; left > 0; ++k) {
        uint64_t part = 1;
        while (2 * part <= left &&
               2 * part * first->weight <= (uint64_t)UINT32_MAX) {
            part *= 2;
        }
        m->number[first[k].photon] = 0; /* numbered later, in order */
        m->weight[first[k].photon] = (uint32_t)(part * first->weight);
        left -= part;
    }
}

static bool group_photons(merging *m, const murk_problem *problem,
                          const _Atomic uint64_t *print)
{
    viewed *v = malloc((m->photons + 1) * sizeof *v);
    if (!v) {
        return false;
    }
    for (size_t i = 0; i < m->photons; ++i) {
        v[i] =
            (viewed){atomic_load(&print[i]), problem->weight[i], (uint32_t)i};
    }
    qsort(v, m->photons, sizeof *v, by_view);
    for (size_t i = 0; i < m->photons;) {
        size_t end = i;
        for (; end < m->photons && v[end].print == v[i].print &&
               v[end].weight == v[i].weight;
             ++end) {
            m->group[v[end].photon] = (uint32_t)m->groups;
        }
        m->size[m->groups++] = (uint32_t)(end - i);
        deal(m, v + i, end - i);
        i = end;
    }
    free(v);
    for (size_t i = 0; i < m->photons; ++i) {
        if (m->number[i] != NOBODY) {
            m->weight[m->kept] = m->weight[i]; /* kept <= i */
            m->number[i] = (uint32_t)m->kept++;
        }
    }
    return true;
}

static double cost_of(const murk_layout *layout)
{
    double cost = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *at = &layout->segment[s];
        cost += WORDS_PER_SEGMENT +
                (double)at->words * (at->is_mixed ? WORDS_PER_MIXED : 1);
    }
    return cost;
}

/* A group's photons are all in the row, with one clarity, or none is. */
static void check_row(void *context, unsigned worker, uint64_t batch)
{
    merging *m = context;
    uint32_t *met = m->met[worker];
    uint16_t *clarity = m->clarity[worker];
    const murk_layout *layout = &m->matrix->layout;
    const murk_row *row = &m->matrix->row[batch];
    size_t slot;
    uint16_t p;
    for (int pass = 0; pass < 2; ++pass) {
        for (murk_row_walk walk = murk_row_begin(layout, row);
             murk_row_next(&walk, &slot, &p);) {
            if (p == 0) {
                continue;
            }
            const uint32_t g = m->group[m->photon[slot]];
            if (pass == 0) {
                if (met[g]++ > 0 && clarity[g] != p) {
                    murk_tally_add(&m->differ, 1);
                }
                clarity[g] = p;
            } else if (met[g] > 0) {
                if (met[g] != m->size[g]) {
                    murk_tally_add(&m->differ, 1);
                }
                met[g] = 0;
            }
        }
    }
}

static void store_row(void *context, unsigned worker, uint64_t batch)
{
    merging *m = context;
    const murk_layout *layout = &m->matrix->layout;
    murk_row *row = &m->matrix->row[batch];
    uint32_t *seen = m->seen[worker];
    uint16_t *packed = m->packed[worker];
    size_t n = 0, slot;
    uint16_t p;
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &slot, &p);) {
        const uint32_t number = p > 0 ? m->number[m->photon[slot]] : NOBODY;
        if (number != NOBODY) {
            seen[n] = number;
            packed[n++] = p;
        }
    }
    const bool is_clear =
        row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_CLEAR_LIST;
    const murk_look look = {n, seen, is_clear ? NULL : packed};
    murk_row stored = {0};
    if (!murk_row_store(&stored, &m->layout, &look)) {
        murk_tally_add(&m->out_of_memory, 1);
        return;
    }
    free(row->memory);
    *row = stored;
    murk_tally_add(&m->bytes, (int64_t)(row->memory_bytes + sizeof *row));
}

static bool merging_init(merging *m, murk_matrix *matrix,
                         const murk_problem *problem)
{
    const size_t n = problem->photons + 1;
    *m =
        (merging){.matrix = matrix,
                  .photons = problem->photons,
                  .threads = problem->threads,
                  .group = calloc(n, sizeof *m->group),
                  .size = calloc(n, sizeof *m->size),
                  .number = calloc(n, sizeof *m->number),
                  .weight = calloc(n, sizeof *m->weight),
                  .photon = calloc(matrix->layout.slots + 1, sizeof *m->photon),
                  .met = calloc(problem->threads, sizeof *m->met),
                  .clarity = calloc(problem->threads, sizeof *m->clarity),
                  .seen = calloc(problem->threads, sizeof *m->seen),
                  .packed = calloc(problem->threads, sizeof *m->packed)};
    return m->group && m->size && m->number && m->weight && m->photon &&
           m->met && m->clarity && m->seen && m->packed;
}

static bool set_aside(merging *m)
{
    bool has_memory = true;
    for (unsigned k = 0; k < m->threads && has_memory; ++k) {
        m->met[k] = calloc(m->groups + 1, sizeof *m->met[k]);
        m->clarity[k] = calloc(m->groups + 1, sizeof *m->clarity[k]);
        m->seen[k] = calloc(m->kept + 1, sizeof *m->seen[k]);
        m->packed[k] = calloc(m->kept + 1, sizeof *m->packed[k]);
        has_memory = m->met[k] && m->clarity[k] && m->seen[k] && m->packed[k];
    }
    for (uint32_t i = 0; i < m->photons; ++i) {
        m->photon[murk_layout_slot(&m->matrix->layout, i)] = i;
    }
    return has_memory;
}

static void merging_release(merging *m)
{
    for (unsigned k = 0; k < m->threads; ++k) {
        free(m->met ? m->met[k] : NULL);
        free(m->clarity ? m->clarity[k] : NULL);
        free(m->seen ? m->seen[k] : NULL);
        free(m->packed ? m->packed[k] : NULL);
    }
    free(m->met);
    free(m->clarity);
    free(m->seen);
    free(m->packed);
    free(m->group);
    free(m->size);
    free(m->number);
    free(m->weight);
    free(m->photon);
    murk_layout_release(&m->layout);
}

/* The rows under the new layout. */
static void rewrite(merging *m)
{
    murk_matrix *matrix = m->matrix;
    murk_pool_run_workers(m->threads, matrix->candidates, store_row, m);
    const murk_layout old = matrix->layout;
    m->layout.common = old.common; /* what is worth a step stays */
    if (!old.doses) {
        free(m->layout.doses);
        m->layout.doses = NULL;
    }
    matrix->layout = m->layout;
    m->layout = old;
    matrix->memory_bytes = sizeof *matrix + (size_t)murk_tally_read(&m->bytes);
}

murk_status murk_merge(murk_matrix *matrix, const murk_problem *problem,
                       const _Atomic uint64_t *print, bool is_forced,
                       murk_error *err)
{
    merging m;
    murk_status status = MURK_OK;
    bool has_memory = merging_init(&m, matrix, problem) &&
                      group_photons(&m, problem, print) && set_aside(&m);
    if (has_memory) {
        murk_problem fewer = *problem;
        fewer.photons = m.kept;
        fewer.weight = m.weight;
        status = murk_layout_init(&m.layout, &fewer, true, err);
    }
    const bool pays = has_memory && !status &&
                      (is_forced || cost_of(&m.layout) <
                                        COST_KEPT * cost_of(&matrix->layout));
    if (pays) {
        murk_pool_run_workers(m.threads, matrix->candidates, check_row, &m);
    }
    if (pays && !murk_interrupted() && murk_tally_read(&m.differ) == 0) {
        rewrite(&m);
        has_memory = murk_tally_read(&m.out_of_memory) == 0;
    }
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    } else if (!status && !has_memory) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory to merge equal ones of %zu photons",
                           problem->photons);
    }
    merging_release(&m);
    return status;
}
