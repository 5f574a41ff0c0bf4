/* Ranks whose rows stay with the rank that computed them find what one process
 * finds: plans, bounds, curves and counts of work, for every method, objective
 * and way of combining entries, with rows in memory and in a scratch file, and
 * with merged photons. A rank that loses another's gains, or fetches a row with
 * a wrong bit, is noticed, and a request to stop in one rank ends all. Seeds
 * are fixed. */
#include "base/log.h"
#include "check.h"
#include "made_up.h"
#include "placement/at_least.h"
#include "placement/lanes.h"
#include "placement/worst.h"
#include "thread_ranks.h"

#include <string.h>

enum {
    SOILED = 1 << 18
}; /* more stack than a search takes, less than a thread
    * has */
enum { PHOTONS = 300, CANDIDATES = 29, MANY = 301 }; /* no multiples of ranks */

typedef enum objective { VALUE, AT_LEAST, WORST } objective;

typedef struct search {
    objective objective;
    murk_place_method method;
    uint32_t levels; /* distinct clarities; 1: all clear */
    murk_combining combining;
    unsigned redundancy;
    int64_t budget; /* 0: none */
    bool has_target;
    murk_merging merging;
} search;

typedef struct job {
    search search;
    double share; /* of the pairs that are seen */
    size_t candidates;
    unsigned threads;
    uint64_t memory_bytes;
    /* of each rank */
    made_up *made_up[THREAD_RANKS_MAX];
    murk_matrix *matrix[THREAD_RANKS_MAX];
    murk_place_result plan[THREAD_RANKS_MAX];
    bool has_own_rows_alone[THREAD_RANKS_MAX];
} job;

/* Photons of which three in a row are seen alike; one candidate sees nothing.
 */
static made_up *make_problem(const job *j)
{
    made_up *m = made_up_create(11, PHOTONS, j->candidates, j->share,
                                j->search.levels, 2, j->threads);
    for (size_t i = 0; i < PHOTONS * j->candidates; ++i) {
        m->clarity[i] = i / PHOTONS == 4 ? 0 : m->clarity[i / 3 * 3];
    }
    /* Dominated candidates: 8 by 7, 20 by 11, 12 and 16 by the same. */
    for (size_t i = 0; i < PHOTONS; ++i) {
        m->clarity[8 * PHOTONS + i] = i % 9 ? m->clarity[7 * PHOTONS + i] : 0;
        m->clarity[12 * PHOTONS + i] = m->clarity[11 * PHOTONS + i];
        m->clarity[20 * PHOTONS + i] =
            i < 90 ? m->clarity[11 * PHOTONS + i] : 0;
        m->clarity[16 * PHOTONS + i] = i % 3 ? 0 : m->clarity[20 * PHOTONS + i];
    }
    m->problem.combining = j->search.combining;
    m->problem.redundancy = j->search.redundancy;
    m->problem.is_distributed = true;
    return m;
}

static bool owns_its_rows_alone(const murk_matrix *matrix)
{
    bool is_so = matrix->is_distributed;
    for (size_t k = 0; k < matrix->candidates; ++k) {
        is_so = is_so && (murk_row_is_own(k) || !matrix->row[k].memory);
    }
    return is_so;
}

static murk_status find(murk_place_result *out, const murk_problem *problem,
                        const murk_matrix *matrix, const search *s,
                        murk_error *err)
{
    static const int64_t cost[CANDIDATES] = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3,
                                             5, 8, 9, 7, 9, 3, 2, 3, 8, 4,
                                             6, 2, 6, 4, 3, 3, 8, 3, 2};
    const murk_constraints costs = {.cost = cost, .budget = s->budget};
    const murk_blocks blocks = {.n = 2, .first = {0, PHOTONS / 2, PHOTONS}};
    /* Small limits, so that searches are short; the rest by the objective. */
    murk_place_desc desc = murk_place_defaults();
    desc.method = s->method;
    desc.count = s->has_target ? 20 : 5;
    desc.restarts = 3;
    desc.nodes = 20;
    desc.constraints = s->budget ? &costs : NULL;
    if (s->objective == WORST) {
        desc.target = s->has_target ? MURK_SHARE_ONE / 2 : 0;
        return murk_place_worst(out, problem, matrix, &blocks, &desc, err);
    }
    /* Half of the weight is the target. */
    uint64_t whole = 0;
    for (size_t i = 0; i < PHOTONS; ++i) {
        whole += problem->weight[i];
    }
    desc.target = s->has_target ? whole * MURK_CLEAR / 2 : 0;
    return s->objective == AT_LEAST
               ? murk_place_at_least(out, problem, matrix, &desc, err)
               : murk_place_sensors(out, problem, matrix, &desc, err);
}

/* Leaves bytes other than 0 on the stack, so that an error without a value
 * there has no message. */
static void soil_stack(void)
{
    volatile char soiled[SOILED];
    for (size_t i = 0; i < SOILED; ++i) {
        soiled[i] = (char)0xa5;
    }
    (void)soiled[0];
}

static murk_status place(void *context, unsigned number, murk_error *err)
{
    job *j = context;
    soil_stack();
    murk_warn_to(NULL); /* of the scratch file */
    made_up *m = j->made_up[number] = make_problem(j);
    murk_at_least strict;
    const murk_problem *problem = &m->problem;
    if (j->search.objective == AT_LEAST) {
        murk_at_least_init(&strict, &m->problem, j->search.redundancy);
        problem = &strict.problem;
    }
    murk_matrix **matrix = &j->matrix[number];
    murk_status status = murk_matrix_make(matrix, problem, j->memory_bytes,
                                          j->search.merging, err);
    if (!status) {
        j->has_own_rows_alone[number] = owns_its_rows_alone(*matrix);
    }
    return status ? status
                  : find(&j->plan[number], problem, *matrix, &j->search, err);
}

static void release(job *j, unsigned count)
{
    for (unsigned r = 0; r < count; ++r) {
        murk_place_release(&j->plan[r]);
        murk_matrix_destroy(j->matrix[r]);
        made_up_destroy(j->made_up[r]);
    }
}

static bool same_plan(const murk_place_result *a, const murk_place_result *b)
{
    bool is_same =
        a->count == b->count && a->value == b->value && a->upper == b->upper &&
        a->nodes == b->nodes && a->evaluations == b->evaluations &&
        a->restarts == b->restarts && a->ceiling == b->ceiling &&
        a->is_cut == b->is_cut && a->curve_points == b->curve_points &&
        a->after_presolve == b->after_presolve && a->fewest == b->fewest &&
        a->cost == b->cost &&
        memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0;
    for (size_t k = 0; is_same && k < a->curve_points; ++k) {
        is_same = a->curve[k].count == b->curve[k].count &&
                  a->curve[k].value == b->curve[k].value &&
                  a->curve[k].upper == b->curve[k].upper;
    }
    return is_same;
}

typedef struct verdict {
    bool has_succeeded, is_distributed, same_pairs, same_plans;
    size_t undominated;
} verdict;

/* Compares the plans of `count` ranks with that of one. */
static verdict compare(const job *settings, unsigned count,
                       thread_ranks_defect defect)
{
    job one = *settings, all = *settings;
    one.threads = 1;
    thread_ranks_end end = thread_ranks_run(1, THREAD_RANKS_SOUND, place, &one);
    CHECK(thread_ranks_succeeded(&end, 1) && !one.matrix[0]->is_distributed);
    end = thread_ranks_run(count, defect, place, &all);
    verdict v = {thread_ranks_succeeded(&end, count), true, true, true,
                 one.plan[0].after_presolve};
    for (unsigned r = 0; r < count && v.has_succeeded; ++r) {
        v.is_distributed = v.is_distributed && all.has_own_rows_alone[r];
        v.same_pairs = v.same_pairs && murk_matrix_pairs(all.matrix[r]) ==
                                           murk_matrix_pairs(one.matrix[0]);
        v.same_plans = v.same_plans && same_plan(&all.plan[r], &one.plan[0]);
    }
    release(&one, 1);
    release(&all, count);
    return v;
}

static const search searches[] = {
    {VALUE, MURK_PLACE_BEST, 1, MURK_COMBINE_CLEAREST, 1, 0, false,
     MURK_MERGE_NEVER},
    {VALUE, MURK_PLACE_BEST, 9, MURK_COMBINE_CLEAREST, 1, 0, false,
     MURK_MERGE_ALWAYS},
    {VALUE, MURK_PLACE_GREEDY, 9, MURK_COMBINE_CLEAREST, 1, 0, true,
     MURK_MERGE_NEVER},
    {VALUE, MURK_PLACE_SPOQ, 9, MURK_COMBINE_CLEAREST, 1, 0, false,
     MURK_MERGE_NEVER},
    {VALUE, MURK_PLACE_EXACT, 9, MURK_COMBINE_CLEAREST, 2, 0, false,
     MURK_MERGE_NEVER},
    {VALUE, MURK_PLACE_BEST, 1, MURK_COMBINE_CLEAREST, 3, 0, true,
     MURK_MERGE_ALWAYS},
    {VALUE, MURK_PLACE_BEST, 9, MURK_COMBINE_INDEPENDENT, 1, 0, false,
     MURK_MERGE_NEVER},
    {VALUE, MURK_PLACE_BEST, 9, MURK_COMBINE_CLEAREST, 1, 20, false,
     MURK_MERGE_NEVER},
    {AT_LEAST, MURK_PLACE_BEST, 1, MURK_COMBINE_CLEAREST, 2, 0, true,
     MURK_MERGE_NEVER},
    {WORST, MURK_PLACE_BEST, 9, MURK_COMBINE_CLEAREST, 1, 0, false,
     MURK_MERGE_NEVER},
    {WORST, MURK_PLACE_GREEDY, 9, MURK_COMBINE_INDEPENDENT, 1, 0, true,
     MURK_MERGE_NEVER},
};

enum { SEARCHES = sizeof searches / sizeof *searches };

static void test_ranks_find_the_plan_of_one(void)
{
    static const unsigned counts[] = {2, 3, 5};
    for (size_t k = 0; k < SEARCHES; ++k) {
        const job j = {.search = searches[k],
                       .share = 0.15,
                       .candidates = CANDIDATES,
                       .threads = 1 + (unsigned)k % 2,
                       .memory_bytes = k % 4 == 1 ? 0 : UINT64_MAX};
        const verdict v = compare(&j, counts[k % 3], THREAD_RANKS_SOUND);
        CHECK(v.has_succeeded && v.is_distributed && v.same_pairs);
        CHECK(v.same_plans && (k > 0 || v.undominated < CANDIDATES));
    }
}

/* Starts share the passes over rows that are large compared with covers. */
static void test_starts_share_passes(void)
{
    const job j = {.search = searches[1],
                   .share = 0.9,
                   .candidates = MANY,
                   .threads = 2,
                   .memory_bytes = UINT64_MAX};
    made_up *m = make_problem(&j);
    murk_matrix *matrix = NULL;
    murk_evaluator evaluator;
    CHECK(!murk_matrix_make(&matrix, &m->problem, UINT64_MAX, MURK_MERGE_ALWAYS,
                            NULL));
    CHECK(!murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, 5, 0,
                               true, NULL));
    CHECK(murk_lanes_pay(&evaluator));
    murk_evaluator_release(&evaluator);
    murk_matrix_destroy(matrix);
    made_up_destroy(m);
    const verdict v = compare(&j, 3, THREAD_RANKS_SOUND);
    CHECK(v.has_succeeded && v.is_distributed && v.same_pairs && v.same_plans);
}

static void test_a_wrong_exchange_is_noticed(void)
{
    job j = {.search = searches[0],
             .share = 0.15,
             .candidates = CANDIDATES,
             .threads = 1,
             .memory_bytes = UINT64_MAX};
    verdict v = compare(&j, 3, THREAD_RANKS_LOSE_WORDS);
    CHECK(v.has_succeeded && !v.same_plans);
    /* In rows of so many clarities the bit is one of a clarity. */
    j.search = searches[1];
    j.share = 0.9;
    v = compare(&j, 2, THREAD_RANKS_FLIP_BIT);
    CHECK(v.has_succeeded && !v.same_plans);
}

/* Rank 1 is asked to stop in exchanges from the first one on, further and
 * further into the search, so that the others are in the middle of any
 * function. */
static void test_a_stopped_rank_ends_all(void)
{
    for (size_t k = 0; k < SEARCHES; ++k) {
        bool has_ended = false;
        unsigned stopped = 0;
        for (unsigned at = 1; !has_ended; at += 1 + at / 2 + (unsigned)k % 3) {
            job j = {.search = searches[k],
                     .share = 0.15,
                     .candidates = CANDIDATES,
                     .threads = 1,
                     .memory_bytes = UINT64_MAX};
            const thread_ranks_end end =
                thread_ranks_run_stopped(2, at, place, &j);
            has_ended = thread_ranks_succeeded(&end, 2);
            stopped += !has_ended;
            for (unsigned r = 0; r < 2 && !has_ended; ++r) {
                CHECK(end.status[r] == MURK_INTERRUPTED && !j.plan[r].sensor);
                CHECK_TEXT(end.error[r].text, "interrupted");
            }
            release(&j, 2);
        }
        CHECK(stopped >= 8); /* in 40 exchanges and more */
    }
}

int main(void)
{
    test_ranks_find_the_plan_of_one();
    test_starts_share_passes();
    test_a_wrong_exchange_is_noticed();
    test_a_stopped_rank_ends_all();
    return check_done();
}
