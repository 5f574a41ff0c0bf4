/* Merges photons with equal columns in the coverage matrix (presolve of
 * photons). Photons are grouped by the hash of the column and by weight; each
 * row is then checked to contain all photons of a group with one clarity, or
 * none of them. So a collision of hashes is detected, and the result never
 * depends on the hash function. The rows are rewritten in the layout of the
 * remaining photons. */
#include "placement/merge.h"

#include "base/arena.h"
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/ranks.h"
#include "base/tally.h"
#include "placement/row_exchange.h"

#include <stdlib.h>
#include <string.h>

#define MERGED_AWAY UINT32_MAX

/* The cost of evaluating a row, in words: a call of a kernel for each segment
 * costs as much as 8 words, a word of mixed weights as much as 16 words.
 * Merging must lower the cost below .7 times the cost before, or rewriting the
 * rows does not pay. Rough figures; they decide about time only. */
#define WORDS_PER_SEGMENT 8
#define WORDS_PER_MIXED   16
#define COST_RATIO_MAX    0.7

/* The pseudo-random word of an entry: the finaliser of SplitMix64 (Steele, Lea,
 * Flood, OOPSLA 2014, doi:10.1145/2660193.2660195). */
static uint64_t hash_entry(uint64_t candidate, uint16_t clarity)
{
    uint64_t x = (candidate << 16 | clarity) + UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

/* Adds the words of a row times `sign`, 1 or -1. */
static void add_hash(_Atomic uint64_t *hash, size_t candidate,
                     const murk_sparse_row *entries, uint64_t sign)
{
    const uint64_t clear = hash_entry(candidate, MURK_CLEAR);
    for (size_t k = 0; k < entries->seen; ++k) {
        const uint64_t word = entries->clarity
                                  ? hash_entry(candidate, entries->clarity[k])
                                  : clear;
        atomic_fetch_add_explicit(&hash[entries->photon[k]], sign * word,
                                  memory_order_relaxed);
    }
}

void murk_merge_hash(_Atomic uint64_t *hash, size_t candidate,
                     const murk_sparse_row *entries)
{
    add_hash(hash, candidate, entries, 1);
}

void murk_merge_unhash(_Atomic uint64_t *hash, size_t candidate,
                       const murk_sparse_row *entries)
{
    add_hash(hash, candidate, entries, UINT64_MAX);
}

/* Scratch arrays of one thread. */
typedef struct merge_scratch {
    uint32_t *group_count; /* [groups] photons of the group met in the row */
    uint16_t *clarity;     /* [groups] clarity of the group in the row */
    uint32_t *seen;        /* [representatives] photons of the new row */
    uint16_t *packed;      /* [representatives] clarities of the new row */
} merge_scratch;

typedef struct merging {
    murk_layout *old; /* layout of the given rows */
    murk_row *row;    /* [candidates] */
    murk_row_space *space;
    size_t candidates, photons, groups, representatives;
    uint32_t *group;  /* [slots] group of the photon in each slot of the old
                       * layout */
    uint32_t *size;   /* [groups] photons in each group */
    uint32_t *number; /* [slots] index of the photon in the slot among the
                         remaining photons, or MERGED_AWAY */
    uint32_t *weight; /* [representatives] weights of the remaining photons */
    murk_layout layout;
    merge_scratch *scratch; /* [threads] */
    unsigned threads;
    bool is_distributed;
    murk_tally mismatches, out_of_memory;
    murk_arena arena;
} merging;

/* The first photon of each group, in a hash table with open addressing and
 * linear probing (Knuth, The Art of Computer Programming, vol. 3, 6.4). */
typedef struct group_table {
    const _Atomic uint64_t *hash;
    const uint32_t *weight;
    uint32_t *first; /* [places] NO_PHOTON: the place is empty */
    size_t places;   /* a power of two */
} group_table;

#define NO_PHOTON    UINT32_MAX
#define FIRST_PLACES 4096 /* a choice; the table grows */

static bool table_init(group_table *table, size_t places)
{
    table->first = malloc(places * sizeof *table->first);
    table->places = places;
    for (size_t k = 0; table->first && k < places; ++k) {
        table->first[k] = NO_PHOTON;
    }
    return table->first;
}

/* The place of the group of a photon, or the empty place where it belongs. */
static uint32_t *table_find(const group_table *table, uint32_t photon)
{
    const uint64_t hash = atomic_load(&table->hash[photon]);
    const uint32_t weight = table->weight[photon];
    /* The weight moves photons of other weights and equal columns to other
     * places; the factor is that of Fibonacci hashing. */
    size_t k = (size_t)(hash + weight * UINT64_C(0x9e3779b97f4a7c15)) &
               (table->places - 1);
    for (;; k = (k + 1) & (table->places - 1)) {
        const uint32_t first = table->first[k];
        if (first == NO_PHOTON || (atomic_load(&table->hash[first]) == hash &&
                                   table->weight[first] == weight)) {
            return &table->first[k];
        }
    }
}

/* Doubles the table. False when out of memory; the table is then as before. */
static bool table_grow(group_table *table)
{
    const group_table old = *table;
    if (!table_init(table, 2 * old.places)) {
        *table = old;
        return false;
    }
    for (size_t k = 0; k < old.places; ++k) {
        if (old.first[k] != NO_PHOTON) {
            *table_find(table, old.first[k]) = old.first[k];
        }
    }
    free(old.first);
    return true;
}

/* Numbers the groups, photons of equal hash and weight, in the order of their
 * first photons, and counts the photons of each. False when out of memory. */
static bool find_groups(merging *m, const murk_problem *problem,
                        const _Atomic uint64_t *hash)
{
    group_table table = {.hash = hash, .weight = problem->weight};
    bool has_memory = table_init(&table, FIRST_PLACES);
    for (uint32_t i = 0; has_memory && i < m->photons; ++i) {
        uint32_t *first = table_find(&table, i);
        if (*first == NO_PHOTON) {
            *first = i;
            m->group[murk_layout_slot(m->old, i)] = (uint32_t)m->groups++;
            /* At most three places in four are taken. */
            has_memory =
                4 * m->groups <= 3 * table.places || table_grow(&table);
        } else {
            m->group[murk_layout_slot(m->old, i)] =
                m->group[murk_layout_slot(m->old, *first)];
        }
        ++m->size[m->group[murk_layout_slot(m->old, i)]];
    }
    free(table.first);
    return has_memory;
}

/* Chooses and numbers the representatives of each group of n photons, the first
 * ones: one for each binary digit 1 of n, with the weight times the power of
 * two of that digit, the largest first. A weight that would exceed 32 bits is
 * split. False when out of memory. */
static bool choose_representatives(merging *m, const murk_problem *problem)
{
    uint32_t *left = malloc(m->groups * sizeof *left + 1);
    if (!left) {
        return false;
    }
    memcpy(left, m->size, m->groups * sizeof *left);
    /* The first photons of each group stay, until they stand for all of it. */
    for (uint32_t i = 0; i < m->photons; ++i) {
        const size_t slot = murk_layout_slot(m->old, i);
        const uint32_t rest = left[m->group[slot]];
        const uint64_t weight = problem->weight[i];
        uint64_t part = 1;
        m->number[slot] = MERGED_AWAY;
        if (rest == 0) {
            continue;
        }
        while (2 * part <= rest && 2 * part * weight <= (uint64_t)UINT32_MAX) {
            part *= 2;
        }
        m->weight[m->representatives] = (uint32_t)(part * weight);
        m->number[slot] = (uint32_t)m->representatives++;
        left[m->group[slot]] -= (uint32_t)part;
    }
    free(left);
    return true;
}

static double scan_cost(const murk_layout *layout)
{
    double cost = 0;
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *at = &layout->segment[s];
        cost += WORDS_PER_SEGMENT +
                (double)at->words * (at->is_mixed ? WORDS_PER_MIXED : 1);
    }
    return cost;
}

static bool has_row(const merging *m, uint64_t candidate)
{
    return !m->is_distributed || murk_row_is_own((size_t)candidate);
}

/* Checks one row: it contains all photons of a group with one clarity, or none
 * of them. The first pass counts the photons of each group and compares
 * clarities, the second one compares the counts and resets them. */
static void check_row(void *context, unsigned worker, uint64_t batch)
{
    merging *m = context;
    uint32_t *group_count = m->scratch[worker].group_count;
    uint16_t *clarity = m->scratch[worker].clarity;
    const murk_layout *layout = m->old;
    const murk_row *row = &m->row[batch];
    size_t slot;
    uint16_t p;
    if (!has_row(m, batch)) {
        return;
    }
    murk_row_space_read(m->space, row);
    /* Pass 0 counts and compares clarities; pass 1 compares the counts. */
    for (int pass = 0; pass < 2; ++pass) {
        for (murk_row_walk walk = murk_row_begin(layout, row);
             murk_row_next(&walk, &slot, &p);) {
            if (p == 0) {
                continue;
            }
            const uint32_t g = m->group[slot];
            if (pass == 0) {
                if (group_count[g]++ > 0 && clarity[g] != p) {
                    murk_tally_add(&m->mismatches, 1);
                }
                clarity[g] = p;
            } else if (group_count[g] > 0) {
                if (group_count[g] != m->size[g]) {
                    murk_tally_add(&m->mismatches, 1);
                }
                group_count[g] = 0;
            }
        }
    }
}

static void store_row(void *context, unsigned worker, uint64_t batch)
{
    merging *m = context;
    const murk_layout *layout = m->old;
    const murk_row *row = &m->row[batch];
    if (!has_row(m, batch)) {
        return;
    }
    uint32_t *seen = m->scratch[worker].seen;
    uint16_t *packed = m->scratch[worker].packed;
    /* Collect the entries of the representatives. */
    size_t n = 0, slot;
    uint16_t p;
    murk_row_space_read(m->space, row);
    for (murk_row_walk walk = murk_row_begin(layout, row);
         murk_row_next(&walk, &slot, &p);) {
        const uint32_t number = p > 0 ? m->number[slot] : MERGED_AWAY;
        if (number != MERGED_AWAY) {
            seen[n] = number;
            packed[n++] = p;
        }
    }
    /* Replace the stored row. */
    const bool is_clear =
        row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_CLEAR_LIST;
    const murk_sparse_row entries = {n, seen, is_clear ? NULL : packed};
    murk_row stored = {0};
    if (!murk_row_store(&stored, &m->layout, &entries)) {
        murk_tally_add(&m->out_of_memory, 1);
        return;
    }
    murk_row_space_drop(m->space, &m->row[batch]);
    /* murk_row_space_check() knows of a row that the file cannot take. */
    (void)murk_row_space_keep(m->space, &stored);
    m->row[batch] = stored;
}

/* Arrays for the groups. False when out of memory. */
static bool merging_init(merging *m, murk_layout *layout, murk_row *row,
                         murk_row_space *space, const murk_problem *problem)
{
    const size_t n = problem->photons;
    *m = (merging){.old = layout,
                   .row = row,
                   .space = space,
                   .candidates = problem->candidates,
                   .photons = n,
                   .threads = problem->threads};
    m->group = murk_arena_array(&m->arena, layout->slots, sizeof *m->group);
    m->size = murk_arena_array(&m->arena, n, sizeof *m->size);
    m->number = murk_arena_array(&m->arena, layout->slots, sizeof *m->number);
    m->weight = murk_arena_array(&m->arena, n, sizeof *m->weight);
    m->scratch = murk_arena_array(&m->arena, m->threads, sizeof *m->scratch);
    return !m->arena.is_short;
}

/* Arrays whose sizes are known once the photons are grouped. */
static bool allocate_scratch(merging *m)
{
    for (unsigned k = 0; k < m->threads; ++k) {
        merge_scratch *s = &m->scratch[k];
        s->group_count =
            murk_arena_array(&m->arena, m->groups, sizeof *s->group_count);
        s->clarity = murk_arena_array(&m->arena, m->groups, sizeof *s->clarity);
        s->seen =
            murk_arena_array(&m->arena, m->representatives, sizeof *s->seen);
        s->packed =
            murk_arena_array(&m->arena, m->representatives, sizeof *s->packed);
    }
    return !m->arena.is_short;
}

/* The representative of each photon: the first one of its group. The caller
 * frees the result; NULL when out of memory. */
static uint32_t *list_representatives(const merging *m)
{
    uint32_t *of_group = malloc((m->groups + 1) * sizeof *of_group);
    uint32_t *out = of_group ? malloc((m->photons + 1) * sizeof *out) : NULL;
    for (size_t i = m->photons; out && i-- > 0;) {
        const size_t slot = murk_layout_slot(m->old, (uint32_t)i);
        if (m->number[slot] != MERGED_AWAY) {
            of_group[m->group[slot]] = m->number[slot];
        }
    }
    for (size_t i = 0; out && i < m->photons; ++i) {
        out[i] = of_group[m->group[murk_layout_slot(m->old, (uint32_t)i)]];
    }
    free(of_group);
    return out;
}

/* Rewrites the rows in the new layout, and exchanges the layouts. */
static void rewrite(merging *m)
{
    murk_pool_run_workers(m->threads, m->candidates, store_row, m);
    const murk_layout old = *m->old;
    m->layout.weight_gcd = old.weight_gcd; /* the granularity of values is that
                                              of the original weights */
    if (!old.doses) {
        free(m->layout.doses);
        m->layout.doses = NULL;
    }
    *m->old = m->layout;
    m->layout = old;
}

static murk_status no_memory(const murk_problem *problem, murk_error *err)
{
    return murk_no_memory(err, "", "to merge equal ones of %zu photons",
                          problem->photons);
}

/* *is: whether it is so in all ranks; for a distributed matrix only. */
static murk_status agree_on(bool *is, bool is_distributed, murk_status status,
                            murk_error *err)
{
    uint64_t otherwise = !*is;
    if (is_distributed) {
        status = murk_ranks_sum(&otherwise, 1, false, status, err);
        *is = otherwise == 0;
    }
    return status;
}

murk_status murk_merge(murk_layout *layout, murk_row *row,
                       murk_row_space *space, bool is_distributed,
                       const murk_problem *problem, _Atomic uint64_t *hash,
                       bool keeps_hash, bool is_forced,
                       uint32_t **representative, murk_error *err)
{
    merging m;
    murk_status status = MURK_OK;
    /* Group the photons and lay out the representatives. */
    bool has_memory = merging_init(&m, layout, row, space, problem) &&
                      find_groups(&m, problem, hash);
    if (!keeps_hash) {
        free(hash);
    }
    m.is_distributed = is_distributed;
    has_memory = has_memory && choose_representatives(&m, problem) &&
                 allocate_scratch(&m);
    if (has_memory) {
        murk_problem fewer = *problem;
        fewer.photons = m.representatives;
        fewer.weight = m.weight;
        status = murk_layout_init(&m.layout, &fewer, true, err);
    }
    if (!status && !has_memory) {
        status = no_memory(problem, err);
    }
    bool pays = !status && murk_row_space_holds_twice(space) &&
                (is_forced ||
                 scan_cost(&m.layout) < COST_RATIO_MAX * scan_cost(layout));
    status = agree_on(&pays, is_distributed, status, err);
    if (pays) {
        murk_pool_run_workers(m.threads, m.candidates, check_row, &m);
    }
    /* Rewrite the rows if no hash collided. */
    bool is_sound = pays && murk_tally_read(&m.mismatches) == 0;
    status = status ? status : murk_interrupt_check(err);
    status = agree_on(&is_sound, is_distributed, status, err);
    if (is_sound && !status && representative) {
        *representative = list_representatives(&m);
        status = *representative ? MURK_OK : no_memory(problem, err);
    }
    if (is_sound && !status) {
        rewrite(&m);
        status = murk_tally_read(&m.out_of_memory) == 0
                     ? murk_interrupt_check(err)
                     : no_memory(problem, err);
        status = status ? status : murk_row_space_check(space, err);
    }
    murk_layout_release(&m.layout);
    murk_arena_release(&m.arena);
    return status;
}
