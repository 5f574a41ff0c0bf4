/* Writes a placement problem as an integer program for other solvers
 * (formulation: sparse/matrix.h). Rows with equal entries become one row with
 * the summed weight. Rows with equal entries are found by a hash of 128 bits
 * for each row, built column by column. A collision of hashes is neglected:
 * among 1e7 rows the probability is below 1e-24. */
#include "sparse/matrix.h"

#include "base/file.h"
#include "base/sort.h"

#include <stdarg.h>
#include <stdlib.h>

/* The largest number of entries, and of conflicting pairs of candidates, in an
 * LP file: at up to a hundred bytes each they make files of up to a gigabyte,
 * beyond which solvers are of no use. */
#define ENTRIES_MAX 10000000
/* Keeps lines below 255 bytes, the limit of some readers, except for terms with
 * long weights and long numbers of rows and columns (a term of an objective has
 * 46 bytes at most). */
#define TERMS_A_LINE 8

/* Groups of rows with equal entries; the first row of a group stands for it. */
typedef struct kinds {
    bool *is_first;        /* [rows] */
    uint64_t *weight;      /* [rows] weight of the group, at the first row */
    murk_sparse_rows rows; /* entries of the first rows */
    murk_arena arena;
} kinds;

typedef struct row_hash {
    uint64_t low, high;
    size_t row;
} row_hash;

/* Adds a number to a hash: xor, multiplication by the odd number `factor`, and
 * a fold of the high bits (Steele, Lea, Flood, OOPSLA 2014,
 * doi:10.1145/2660193.2660195). */
static uint64_t mix(uint64_t hash, uint64_t number, uint64_t factor)
{
    hash = (hash ^ number) * factor;
    return hash ^ (hash >> 29);
}

static int by_hash(const void *a, const void *b)
{
    const row_hash *x = a, *y = b;
    const int low = MURK_ORDER(x->low, y->low);
    const int high = MURK_ORDER(x->high, y->high);
    return low ? low : high ? high : MURK_ORDER(x->row, y->row);
}

static row_hash *hash_rows(const murk_sparse_matrix *m)
{
    row_hash *hash = malloc(m->rows * sizeof *hash);
    for (size_t i = 0; hash && i < m->rows; ++i) {
        hash[i] = (row_hash){0, 0, i};
    }
    for (size_t j = 0; hash && j < m->columns; ++j) {
        for (size_t k = m->begin[j]; k < m->begin[j + 1]; ++k) {
            row_hash *h = &hash[m->row[k]];
            const uint64_t entry = (j + 1) << 16 | m->clarity[k];
            h->low = mix(h->low, entry, UINT64_C(0xbf58476d1ce4e5b9));
            h->high = mix(h->high, entry, UINT64_C(0x94d049bb133111eb));
        }
    }
    if (hash) {
        qsort(hash, m->rows, sizeof *hash, by_hash);
    }
    return hash;
}

/* Groups the rows and sorts the entries of the first rows. is_first is false
 * for all rows of a group without entries or without weight. False when out of
 * memory. */
static bool group(kinds *k, const murk_sparse_matrix *m)
{
    row_hash *hash = hash_rows(m);
    k->is_first = murk_arena_array(&k->arena, m->rows, sizeof *k->is_first);
    k->weight = murk_arena_array(&k->arena, m->rows, sizeof *k->weight);
    const bool is_good = hash && !k->arena.is_short;
    size_t first = 0;
    for (size_t n = 0; is_good && n < m->rows; ++n) {
        const row_hash *h = &hash[n];
        const bool is_like =
            n > 0 && h->low == h[-1].low && h->high == h[-1].high;
        first = is_like ? first : h->row;
        k->weight[first] += m->weight[h->row];
        k->is_first[first] = k->weight[first] > 0 && (h->low || h->high);
    }
    free(hash);
    return is_good &&
           murk_sparse_matrix_by_rows(&k->rows, m, k->is_first, &k->arena);
}

/* ---- terms ---- */

typedef struct terms {
    FILE *to;
    size_t n;
} terms;

/* Prints a term, behind `sign` unless the term is the first. */
static void print_term(terms *t, const char *sign, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void print_term(terms *t, const char *sign, const char *format, ...)
{
    va_list arguments;
    fputs(t->n && t->n % TERMS_A_LINE == 0 ? "\n  " : " ", t->to);
    fputs(t->n ? sign : "", t->to);
    va_start(arguments, format);
    vfprintf(t->to, format, arguments);
    va_end(arguments);
    ++t->n;
}

static void print_columns(terms *t, const murk_sparse_matrix *m,
                          const char *sign)
{
    for (size_t j = 0; j < m->columns; ++j) {
        print_term(t, sign, "x%zu", j + 1);
    }
}

/* Prints the terms of the value of the covered rows, in weights as given,
 * divided by the redundancy. */
static void print_value(terms *t, const murk_sparse_matrix *m, const kinds *k,
                        unsigned redundancy)
{
    for (size_t i = 0; i < m->rows; ++i) {
        const double weight = (double)k->weight[i] / m->unit / redundancy;
        if (m->is_clear && k->is_first[i]) {
            print_term(t, "+ ", "%.15g y%zu", weight, i + 1);
            continue;
        }
        for (size_t e = k->rows.begin[i]; e < k->rows.begin[i + 1]; ++e) {
            print_term(t, "+ ", "%.15g y%zu_%zu",
                       weight * k->rows.clarity[e] / MURK_CLEAR, i + 1,
                       (size_t)k->rows.column[e] + 1);
        }
    }
}

/* A 0/1 row: y is at most the number of chosen columns that cover the row. The
 * section of bounds limits y to the redundancy. */
static void print_clear_row(FILE *to, const kinds *k, size_t i)
{
    terms t = {to, 0};
    fprintf(to, " r%zu:", i + 1);
    print_term(&t, "", "y%zu", i + 1);
    for (size_t e = k->rows.begin[i]; e < k->rows.begin[i + 1]; ++e) {
        print_term(&t, "- ", "x%zu", (size_t)k->rows.column[e] + 1);
    }
    fputs(" <= 0\n", to);
}

/* A row with clarities: one variable y for each entry. The sum of these
 * variables is at most the redundancy, and each is at most the x of its column.
 */
static void print_dimmed_row(FILE *to, const kinds *k, size_t i,
                             unsigned redundancy)
{
    terms t = {to, 0};
    fprintf(to, " r%zu:", i + 1);
    for (size_t e = k->rows.begin[i]; e < k->rows.begin[i + 1]; ++e) {
        print_term(&t, "+ ", "y%zu_%zu", i + 1, (size_t)k->rows.column[e] + 1);
    }
    fprintf(to, " <= %u\n", redundancy);
    for (size_t e = k->rows.begin[i]; e < k->rows.begin[i + 1]; ++e) {
        const size_t j = (size_t)k->rows.column[e] + 1;
        fprintf(to, " r%zu_%zu: y%zu_%zu - x%zu <= 0\n", i + 1, j, i + 1, j, j);
    }
}

static void print_rows(FILE *to, const murk_sparse_matrix *m, const kinds *k,
                       unsigned redundancy)
{
    for (size_t i = 0; i < m->rows; ++i) {
        if (k->is_first[i] && m->is_clear) {
            print_clear_row(to, k, i);
        } else if (k->is_first[i]) {
            print_dimmed_row(to, k, i, redundancy);
        }
    }
}

static unsigned redundancy_of(const murk_lp_goal *goal)
{
    return goal->redundancy > 1 ? goal->redundancy : 1;
}

static void print_goal(FILE *to, const murk_sparse_matrix *m, const kinds *k,
                       const murk_lp_goal *goal)
{
    terms aim = {to, 0}, limit = {to, 0};
    if (goal->count > 0 && goal->target == 0) {
        fputs("Maximize\n covered:", to);
        print_value(&aim, m, k, redundancy_of(goal));
        fputs("\nSubject To\n count:", to);
        print_columns(&limit, m, "+ ");
        fprintf(to, " = %zu\n", goal->count);
    } else if (goal->target == 0) {
        fputs("Maximize\n covered:", to);
        print_value(&aim, m, k, redundancy_of(goal));
        fputs("\nSubject To\n", to);
    } else {
        /* Values of plans are whole multiples of weight 1 * clarity 1. A limit
         * that is half a unit lower admits the same plans, and leaves a
         * tolerance to the solver. */
        const double min = ((double)goal->target - 0.5) / redundancy_of(goal) /
                           MURK_CLEAR / m->unit;
        fputs("Minimize\n columns:", to);
        print_columns(&aim, m, "+ ");
        fputs("\nSubject To\n target:", to);
        print_value(&limit, m, k, redundancy_of(goal));
        fprintf(to, " >= %.15g\n", min);
    }
}

/* ---- constraints ---- */

static void print_cost(terms *t, int64_t cost, size_t column)
{
    if (cost == 1) {
        print_term(t, "+ ", "x%zu", column + 1);
    } else {
        print_term(t, "+ ", "%lld x%zu", (long long)cost, column + 1);
    }
}

static void print_budget(FILE *to, const murk_constraints *constraints,
                         size_t columns)
{
    terms t = {to, 0};
    fputs(" budget:", to);
    for (size_t j = 0; j < columns; ++j) {
        if (constraints->cost[j] > 0) {
            print_cost(&t, constraints->cost[j], j);
        }
    }
    if (t.n == 0) { /* no column has a cost */
        print_cost(&t, 0, 0);
    }
    fprintf(to, " <= %lld\n", (long long)constraints->budget);
}

static void print_class(FILE *to, const murk_constraint_set *set,
                        uint32_t number, bool is_min)
{
    terms t = {to, 0};
    fprintf(to, " class%u_%s:", number + 1, is_min ? "least" : "most");
    for (size_t j = 0; j < set->candidates; ++j) {
        if (set->class_of[j] == number) {
            print_term(&t, "+ ", "x%zu", j + 1);
        }
    }
    fprintf(to, " %s %zu\n",
            is_min ? ">=" : "<=", is_min ? set->min[number] : set->max[number]);
}

static bool print_sites(FILE *to, const murk_constraint_set *set)
{
    const size_t n = set->candidates;
    uint64_t *order = malloc((n + 1) * sizeof *order);
    for (size_t j = 0; order && j < n; ++j) {
        order[j] = (uint64_t)set->site[j] << 32 | j;
    }
    if (!order) {
        return false;
    }
    /* Runs of one site. */
    qsort(order, n, sizeof *order, murk_by_uint64);
    for (size_t k = 0; k < n;) {
        size_t end = k + 1;
        while (end < n && order[end] >> 32 == order[k] >> 32) {
            ++end;
        }
        if (end - k > 1) {
            terms t = {to, 0};
            fprintf(to, " site%zu:", (size_t)(order[k] >> 32) + 1);
            for (size_t i = k; i < end; ++i) {
                print_term(&t, "+ ", "x%zu", (size_t)(uint32_t)order[i] + 1);
            }
            fputs(" <= 1\n", to);
        }
        k = end;
    }
    free(order);
    return true;
}

static bool is_of_one_site(const murk_constraint_set *set, uint32_t a,
                           uint32_t b)
{
    return set->site && set->site[a] == set->site[b];
}

/* Conflicting pairs that are not of one site; false beyond the limit. */
static bool print_pairs(FILE *to, const murk_constraint_set *set)
{
    size_t pairs = 0;
    for (uint32_t a = 0; a < set->candidates; ++a) {
        for (uint32_t b = a + 1; b < set->candidates; ++b) {
            if (!murk_constraint_set_conflict(set, a, b) ||
                is_of_one_site(set, a, b)) {
                continue;
            }
            if (++pairs > ENTRIES_MAX) {
                return false;
            }
            fprintf(to, " apart%zu: x%zu + x%zu <= 1\n", pairs, (size_t)a + 1,
                    (size_t)b + 1);
        }
    }
    return true;
}

static murk_status print_constraints(FILE *to, const murk_sparse_matrix *m,
                                     const murk_lp_goal *goal, const char *path,
                                     murk_error *err)
{
    const murk_constraints *constraints = goal->constraints;
    if (!constraints) {
        return MURK_OK;
    }
    murk_constraint_set set;
    const size_t count = goal->count ? goal->count : m->columns;
    murk_status status =
        murk_constraint_set_init(&set, constraints, m->columns, count,
                                 goal->count == 0 || goal->target > 0, err);
    if (status) {
        return status;
    }
    /* Budget, classes, fixed columns, sites, pairs. */
    if (set.has_budget) {
        print_budget(to, constraints, m->columns);
    }
    for (uint32_t c = 0; c < constraints->classes; ++c) {
        if (set.min[c] > 0) {
            print_class(to, &set, c, true);
        }
        if (set.has_caps) {
            print_class(to, &set, c, false);
        }
    }
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        fprintf(to, " fixed%zu: x%zu = 1\n", k + 1, constraints->fixed[k] + 1);
    }
    if (set.site && !print_sites(to, &set)) {
        status = murk_no_memory(err, path, "to write it");
    }
    if (!status && set.has_conflicts && !print_pairs(to, &set)) {
        status = murk_fail(err, MURK_RUN_FAILED, path,
                           "more than %d pairs of candidates exclude each "
                           "other, an LP file may have so many",
                           ENTRIES_MAX);
    }
    murk_constraint_set_release(&set);
    return status;
}

static void print_bounds(FILE *to, const murk_sparse_matrix *m, const kinds *k,
                         unsigned redundancy)
{
    if (m->is_clear) { /* otherwise the rows limit them */
        fputs("Bounds\n", to);
        for (size_t i = 0; i < m->rows; ++i) {
            if (k->is_first[i]) {
                fprintf(to, " y%zu <= %u\n", i + 1, redundancy);
            }
        }
    }
    fputs("Binaries\n", to);
    terms t = {to, 0};
    print_columns(&t, m, "");
    fputs("\nEnd\n", to);
}

murk_status murk_sparse_matrix_write_lp(const murk_sparse_matrix *m,
                                        const murk_lp_goal *goal,
                                        const char *path, murk_error *err)
{
    murk_file *file = NULL;
    kinds k = {0};
    murk_status status = MURK_OK;
    /* Refuse too many entries before the file is created. Too many conflicting
     * pairs are found while the file is written. */
    if (!group(&k, m)) {
        status = murk_no_memory(err, path, "to write it");
    } else if (k.rows.begin[m->rows] > ENTRIES_MAX) {
        status = murk_fail(err, MURK_RUN_FAILED, path,
                           "%zu entries of rows that differ, an LP file may "
                           "have %d",
                           k.rows.begin[m->rows], ENTRIES_MAX);
    }
    if (!status) {
        status = murk_file_create(&file, path, err);
    }
    if (!status) {
        FILE *to = murk_file_stream(file);
        double whole = 0;
        for (size_t i = 0; i < m->rows; ++i) {
            whole += m->weight[i];
        }
        fprintf(to,
                "\\ %zu rows of weight %.15g, %zu columns; x: column chosen, "
                "y: row covered\n",
                m->rows, whole / m->unit, m->columns);
        /* Objective, constraints on plans, rows, bounds. */
        print_goal(to, m, &k, goal);
        status = print_constraints(to, m, goal, path, err);
        print_rows(to, m, &k, redundancy_of(goal));
        print_bounds(to, m, &k, redundancy_of(goal));
        if (status) {
            murk_file_discard(file);
        } else {
            status = murk_file_commit(&file, err);
        }
    }
    murk_arena_release(&k.arena);
    return status;
}
