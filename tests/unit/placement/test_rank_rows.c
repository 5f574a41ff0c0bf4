/* Ranks that divide the rows of the coverage matrix have the matrix of one rank
 * afterwards: entries, pairs, merged photons, counters of work and plans, with
 * rows in memory and in a scratch file. An exchange that loses a rank's sums or
 * changes a bit of its rows is noticed. The same holds for rows that a search
 * in an unknown environment remembers. Seeds are fixed. */
#include "base/log.h"
#include "check.h"
#include "made_up.h"
#include "placement/matrix.h"
#include "thread_ranks.h"

#include <math.h>
#include <string.h>

enum {
    PHOTONS = 1000,
    CANDIDATES = 29,         /* no multiple of a rank count */
    CANDIDATES_UNKNOWN = 301 /* more than one group of the first look */
};

/* A problem that counts the rows that are asked for: by all ranks together, and
 * by this rank. */
typedef struct counted {
    made_up *m;
    murk_problem problem;
    murk_tally rows, own_rows;
} counted;

static void counted_row(void *context, unsigned worker, size_t candidate,
                        murk_sparse_row *row)
{
    counted *c = context;
    murk_tally_add(&c->rows, 1);
    murk_tally_add(&c->own_rows, 1);
    made_up_row(c->m, worker, candidate, row);
}

static void list_counters(void *context, murk_counters *list)
{
    counted *c = context;
    list->counter[list->n++] = &c->rows;
}

/* Makes the problem that counts, of c->m. */
static void count_rows(counted *c)
{
    c->problem = c->m->problem;
    c->problem.get_row = counted_row;
    c->problem.list_counters = list_counters;
    c->problem.context = c;
}

typedef struct job {
    double share;
    uint32_t levels;
    unsigned threads;
    uint64_t memory_bytes;
    murk_merging merging;
    size_t unknown; /* candidates in an unknown environment */
    /* of each rank */
    counted problem[THREAD_RANKS_MAX];
    murk_matrix *matrix[THREAD_RANKS_MAX];
    murk_place_result plan[THREAD_RANKS_MAX];
} job;

/* Makes a problem of photons, of which five in a row are seen alike; one
 * candidate sees nothing, one sees all. Then makes the matrix and a plan. */
static murk_status make(void *context, unsigned number, murk_error *err)
{
    job *j = context;
    counted *c = &j->problem[number];
    murk_warn_to(NULL); /* of the scratch file */
    c->m = made_up_create(7, PHOTONS, CANDIDATES, j->share, j->levels, 2,
                          j->threads);
    for (size_t i = 0; i < PHOTONS * CANDIDATES; ++i) {
        const size_t row = i / PHOTONS;
        c->m->clarity[i] = c->m->clarity[i / 5 * 5];
        c->m->clarity[i] = row == 4   ? 0
                           : row == 5 ? MURK_CLEAR
                                      : c->m->clarity[i];
    }
    count_rows(c);
    murk_place_desc desc = murk_place_defaults();
    desc.count = 4;
    desc.restarts = 2;
    desc.nodes = 200;
    const murk_status status = murk_matrix_make(
        &j->matrix[number], &c->problem, j->memory_bytes, j->merging, err);
    return status ? status
                  : murk_place_sensors(&j->plan[number], &c->problem,
                                       j->matrix[number], &desc, err);
}

static bool has_entries(const murk_matrix *matrix, const made_up *m)
{
    uint16_t *clarity = calloc(matrix->layout.slots, sizeof *clarity), p;
    bool is_equal = true;
    for (size_t j = 0; j < matrix->candidates; ++j) {
        size_t slot;
        memset(clarity, 0, matrix->layout.slots * sizeof *clarity);
        for (murk_row_walk walk =
                 murk_row_begin(&matrix->layout, murk_matrix_row(matrix, j));
             murk_row_next(&walk, &slot, &p);) {
            clarity[slot] = p;
        }
        for (size_t i = 0; i < PHOTONS; ++i) {
            is_equal =
                is_equal &&
                clarity[murk_layout_slot(&matrix->layout, (uint32_t)i)] ==
                    m->clarity[j * PHOTONS + i];
        }
    }
    free(clarity);
    return is_equal;
}

static bool same_plan(const murk_place_result *a, const murk_place_result *b)
{
    return a->count == b->count && a->value == b->value &&
           a->upper == b->upper && a->nodes == b->nodes &&
           a->evaluations == b->evaluations &&
           memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0;
}

typedef struct verdict {
    bool has_succeeded, same_rows, same_counters, same_photons, same_plans;
    double share_max; /* of the rows: those that one of the ranks computes */
} verdict;

static void release(job *j, unsigned count)
{
    for (unsigned r = 0; r < count; ++r) {
        murk_place_release(&j->plan[r]);
        murk_matrix_destroy(j->matrix[r]);
        made_up_destroy(j->problem[r].m);
    }
}

/* Compares the matrices of `count` ranks with that of one. */
static verdict compare(const job *settings, unsigned count,
                       thread_ranks_defect defect)
{
    job one = *settings, all = *settings;
    one.threads = 1;
    thread_ranks_end end = thread_ranks_run(1, THREAD_RANKS_SOUND, make, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    end = thread_ranks_run(count, defect, make, &all);
    verdict v = {
        thread_ranks_succeeded(&end, count), true, true, true, true, 0};
    for (unsigned r = 0; r < count && v.has_succeeded; ++r) {
        const murk_matrix *got = all.matrix[r], *want = one.matrix[0];
        /* Merged photons have no slot of their own, so their rows are compared
         * by plans alone. */
        v.same_rows = v.same_rows && got->pairs == want->pairs &&
                      got->is_binary == want->is_binary &&
                      (settings->merging != MURK_MERGE_NEVER ||
                       has_entries(got, all.problem[r].m));
        v.same_photons = v.same_photons &&
                         got->layout.photons == want->layout.photons &&
                         murk_matrix_bytes(got) == murk_matrix_bytes(want);
        v.same_counters =
            v.same_counters && murk_tally_read(&all.problem[r].rows) ==
                                   murk_tally_read(&one.problem[0].rows);
        v.same_plans = v.same_plans && same_plan(&all.plan[r], &one.plan[0]);
    }
    release(&one, 1);
    release(&all, count);
    return v;
}

/* Rows of all formats, from few entries to many. */
static void test_ranks_have_the_matrix_of_one(uint64_t memory_bytes)
{
    static const unsigned counts[] = {1, 2, 3, 5};
    static const struct {
        double share;
        uint32_t levels;
    } rows[] = {{0.01, 1}, {0.01, 9}, {0.3, 1}, {0.3, 9}, {0.9, 9}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; ++k) {
        for (size_t c = 0; c < sizeof counts / sizeof *counts; ++c) {
            for (int merging = 0; merging < 3; ++merging) {
                const job j = {.share = rows[k].share,
                               .levels = rows[k].levels,
                               .threads = 1 + (unsigned)(k + c) % 2,
                               .memory_bytes = memory_bytes,
                               .merging = (murk_merging)merging};
                const verdict v = compare(&j, counts[c], THREAD_RANKS_SOUND);
                CHECK(v.has_succeeded && v.same_rows && v.same_counters);
                CHECK(v.same_photons && v.same_plans);
            }
        }
    }
}

static void test_a_wrong_exchange_is_noticed(void)
{
    job j = {.share = 0.9,
             .levels = 9,
             .threads = 1,
             .memory_bytes = UINT64_MAX,
             .merging = MURK_MERGE_NEVER};
    verdict v = compare(&j, 3, THREAD_RANKS_FLIP_BIT);
    CHECK(v.has_succeeded && !v.same_rows && v.same_counters);
    v = compare(&j, 3, THREAD_RANKS_LOSE_WORDS);
    CHECK(v.has_succeeded && v.same_rows && !v.same_counters);
    /* Columns whose hashes lack a rank's rows look equal and are not. */
    j.share = 0.02;
    j.merging = MURK_MERGE_ALWAYS;
    v = compare(&j, 3, THREAD_RANKS_LOSE_WORDS);
    CHECK(v.has_succeeded && !v.same_photons);
}

/* One rank fails before the rows. */
static murk_status make_or_fail(void *context, unsigned number, murk_error *err)
{
    return number == 1 ? murk_fail(err, MURK_RUN_FAILED, "rank 1", "is full")
                       : make(context, number, err);
}

static void test_a_rank_that_fails_ends_all(void)
{
    job j = {.share = 0.3, .levels = 9, .threads = 2};
    const thread_ranks_end end =
        thread_ranks_run(3, THREAD_RANKS_SOUND, make_or_fail, &j);
    for (unsigned r = 0; r < 3; ++r) {
        CHECK(end.status[r] == MURK_RUN_FAILED && !j.matrix[r]);
        CHECK_TEXT(end.error[r].text, "is full");
    }
    made_up_destroy(j.problem[0].m);
    made_up_destroy(j.problem[2].m);
}

/* ---- unknown environment: no matrix; ranks divide the looks ---- */

static murk_status place_unknown(void *context, unsigned number,
                                 murk_error *err)
{
    job *j = context;
    counted *c = &j->problem[number];
    c->m = made_up_create(9, PHOTONS, j->unknown, j->share, j->levels, 2,
                          j->threads);
    count_rows(c);
    murk_place_desc desc = murk_place_defaults();
    desc.count = 4;
    desc.restarts = 2;
    desc.row_memory = j->memory_bytes;
    return murk_place_sensors(&j->plan[number], &c->problem, NULL, &desc, err);
}

static verdict compare_unknown(const job *settings, unsigned count,
                               thread_ranks_defect defect)
{
    job one = *settings, all = *settings;
    thread_ranks_end end =
        thread_ranks_run(1, THREAD_RANKS_SOUND, place_unknown, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    end = thread_ranks_run(count, defect, place_unknown, &all);
    verdict v = {.has_succeeded = thread_ranks_succeeded(&end, count),
                 .same_counters = true,
                 .same_plans = true};
    /* Every rank has what one rank has alone. */
    for (unsigned r = 0; r < count && v.has_succeeded; ++r) {
        v.same_counters =
            v.same_counters && murk_tally_read(&all.problem[r].rows) ==
                                   murk_tally_read(&one.problem[0].rows);
        v.same_plans = v.same_plans && same_plan(&all.plan[r], &one.plan[0]) &&
                       all.plan[r].queries == one.plan[0].queries &&
                       all.plan[r].upper == one.plan[0].upper;
        const double share = (double)murk_tally_read(&all.problem[r].own_rows) /
                             (double)murk_tally_read(&one.problem[0].rows);
        v.share_max = fmax(v.share_max, share);
    }
    release(&one, 1);
    release(&all, count);
    return v;
}

/* All rows are remembered, some, or none. */
static void test_ranks_divide_an_unknown_environment(void)
{
    static const uint64_t memory[] = {UINT64_MAX, 100000, 0};
    static const double share[] = {0.02, 0.3, 0.9};
    for (size_t k = 0; k < sizeof memory / sizeof *memory; ++k) {
        for (unsigned count = 1; count <= 5; count += 2) {
            const job j = {.share = share[(k + count) % 3],
                           .levels = k % 2 ? 9 : 1,
                           .threads = 1 + (unsigned)k % 2,
                           .memory_bytes = memory[k],
                           .unknown = CANDIDATES_UNKNOWN};
            const verdict v = compare_unknown(&j, count, THREAD_RANKS_SOUND);
            CHECK(v.has_succeeded && v.same_counters && v.same_plans);
            /* All ranks compute the rows of the sensors of a plan, and the last
             * row of an odd number. */
            CHECK(v.share_max < 1.2 / count);
        }
    }
    /* A wrong exchange is noticed, if all candidates belong to the plan. (With
     * this share the bit that is flipped is one of an entry.) */
    const job j = {.share = 0.35,
                   .levels = 9,
                   .threads = 1,
                   .memory_bytes = UINT64_MAX,
                   .unknown = 4};
    verdict v = compare_unknown(&j, 3, THREAD_RANKS_LOSE_WORDS);
    CHECK(!v.has_succeeded || !v.same_counters || !v.same_plans);
    v = compare_unknown(&j, 3, THREAD_RANKS_FLIP_BIT);
    CHECK(!v.has_succeeded || !v.same_plans);
}

int main(void)
{
    test_ranks_have_the_matrix_of_one(UINT64_MAX);
    test_ranks_have_the_matrix_of_one(0);
    test_a_wrong_exchange_is_noticed();
    test_a_rank_that_fails_ends_all();
    test_ranks_divide_an_unknown_environment();
    return check_done();
}
