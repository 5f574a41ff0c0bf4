#include "placement/place.h"

#include "base/crew.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/bound.h"
#include "placement/exact.h"
#include "placement/search.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* `best` stops after so many starts in a row without gain. */
#define STARTS_WITHOUT_GAIN 20

/* Starts handed to each thread at once: fewer would wait for threads to begin,
 * more would be made in vain past the stop. */
#define STARTS_PER_WORKER 4

/* A curve point gets one start for each of so many of the plan's own. */
#define RESTARTS_PER_CURVE_START 10
#define CURVE_STARTS_MOST        20

/* Evaluations of the bound in a known environment, at most; matrices so large
 * that these would take long get fewer, by pairs. In an unknown environment
 * each costs a look at every candidate: one is made. */
#define ROUNDS_MOST        400
#define ROUNDS_LEAST       40
#define PAIRS_WEIGHED_MOST 20000000000.0

/* A curve point gets one round for each of so many of the plan's own. */
#define ROUNDS_PER_CURVE_ROUND 3

/* With a target, greedy goes so far at once, and then twice as far again. */
#define FIRST_GREEDY 8

/* Starts in a row on the way, worker by worker. */
typedef struct starts {
    murk_search *search; /* [workers] */
    unsigned workers;
    size_t wave_most; /* made between two looks at the stop */
    uint32_t *plan;   /* [wave_most][n] */
    uint64_t *value, *evaluations, *looks; /* [wave_most] */
    size_t n;
    uint32_t seed;
    uint64_t first; /* start number of batch 0 */
    bool relocates;
} starts;

typedef struct placing {
    const murk_oracle *oracle;
    const murk_place_desc *desc;
    murk_search search; /* spread over all threads */
    murk_bound bound;
    starts starts;
    uint32_t *greedy;       /* [count] in order of choice */
    uint64_t *greedy_value; /* [count] of its first k + 1 */
    uint32_t *plan;         /* [count] the best so far */
    uint32_t *last_plan;    /* [count] that of one sensor fewer */
    size_t rounds;
    murk_place_result *result;
} placing;

murk_place_desc murk_place_defaults(void)
{
    return (murk_place_desc){.method = MURK_PLACE_BEST,
                             .count = 1,
                             .restarts = 200,
                             .nodes = 1000000,
                             .seed = 1,
                             .with_curve = true};
}

static void run_start(void *context, unsigned worker, uint64_t batch)
{
    starts *t = context;
    murk_search *s = &t->search[worker];
    uint32_t *plan = t->plan + batch * t->n;
    s->evaluations = s->looks = 0;
    uint64_t value = murk_search_spoq(s, plan, t->n, t->seed, t->first + batch);
    if (t->relocates && !murk_interrupted()) {
        value = murk_search_relocate(s, plan, t->n);
    }
    t->value[batch] = value;
    t->evaluations[batch] = s->evaluations;
    t->looks[batch] = s->looks;
}

/* Tries starts 0..most-1 in order and keeps what is strictly better in plan
 * [n]. Several run at once; those past the stop are forgotten, so that the
 * outcome is that of one after the other. Returns the best value and adds the
 * starts made. */
static uint64_t try_starts(placing *p, uint32_t *plan, size_t n, uint64_t value,
                           uint64_t upper, size_t most, size_t *made)
{
    starts *t = &p->starts;
    size_t without_gain = 0, done = 0;
    t->n = n;
    t->relocates = true;
    while (done < most && without_gain < STARTS_WITHOUT_GAIN && value < upper &&
           !murk_interrupted()) {
        const size_t left = most - done;
        const size_t wave = left < t->wave_most ? left : t->wave_most;
        t->first = done;
        if (t->workers > 1) {
            murk_crew_run_workers(t->workers, wave, run_start, t);
        } else {
            run_start(t, 0, 0);
        }
        for (size_t k = 0;
             k < wave && without_gain < STARTS_WITHOUT_GAIN && value < upper;
             ++k) {
            ++done;
            ++without_gain;
            p->result->evaluations += t->evaluations[k];
            p->result->looks += t->looks[k];
            if (t->value[k] > value) {
                value = t->value[k];
                memcpy(plan, t->plan + k * n, n * sizeof *plan);
                without_gain = 0;
            }
        }
        murk_progress_add(wave);
    }
    *made += done;
    return value;
}

/* Greedy's first n, relocated, then starts. Where `from`, a plan of n - 1, is
 * worth more than that, it is completed and taken instead. */
static murk_curve_point find_best(placing *p, uint32_t *plan, size_t n,
                                  const uint32_t *from, uint64_t from_value,
                                  size_t most, size_t rounds, size_t *made)
{
    memcpy(plan, p->greedy, n * sizeof *plan);
    uint64_t value = p->greedy_value[n - 1];
    if (n > 1) { /* of one, greedy finds the best */
        value = murk_search_relocate(&p->search, plan, n);
    }
    if (from && from_value > value) {
        memcpy(plan, from, (n - 1) * sizeof *plan);
        murk_search_greedy(&p->search, plan, n - 1, n, NULL);
        value = murk_search_relocate(&p->search, plan, n);
    }
    uint64_t upper = value;
    if (n > 1) {
        const size_t before = p->oracle->matrix ? rounds / 2 : 0;
        upper = murk_bound_tighten(&p->bound, n, value, plan, n, before);
        value = try_starts(p, plan, n, value, upper, most, made);
        const uint64_t again = murk_bound_tighten(
            &p->bound, n, value, before ? NULL : plan, n, rounds - before);
        upper = again < upper ? again : upper;
    }
    return (murk_curve_point){n, value, upper};
}

/* The plan of one method without more ado, and its bound. */
static murk_curve_point find_once(placing *p, uint32_t *plan, size_t n,
                                  size_t rounds, size_t *made)
{
    uint64_t value = 0;
    if (p->desc->method == MURK_PLACE_SPOQ) {
        value = murk_search_spoq(&p->search, plan, n, p->desc->seed, 0);
        ++*made;
    } else {
        memcpy(plan, p->greedy, n * sizeof *plan);
        value = p->greedy_value[n - 1];
    }
    return (murk_curve_point){
        n, value, murk_bound_tighten(&p->bound, n, value, plan, n, rounds)};
}

/* Branch and bound from a plan whose bound was tightened last. */
static murk_status prove(placing *p, murk_curve_point *point, murk_error *err)
{
    const bool is_wanted = p->desc->method == MURK_PLACE_BEST ||
                           p->desc->method == MURK_PLACE_EXACT;
    if (!p->oracle->matrix || !is_wanted || point->count < 2) {
        return MURK_OK;
    }
    murk_exact exact;
    const murk_status status =
        murk_exact_search(&exact, &p->bound, p->plan, point->count,
                          point->value, point->upper, p->desc->nodes, err);
    if (!status) {
        point->value = exact.value;
        point->upper = exact.upper;
        p->result->nodes += exact.nodes;
        p->result->is_cut = exact.is_cut;
    }
    return status;
}

static size_t curve_starts(size_t restarts)
{
    const size_t share = restarts / RESTARTS_PER_CURVE_START;
    return share < CURVE_STARTS_MOST ? share : CURVE_STARTS_MOST;
}

static size_t curve_rounds(size_t rounds)
{
    return rounds > ROUNDS_PER_CURVE_ROUND ? rounds / ROUNDS_PER_CURVE_ROUND
                                           : rounds;
}

/* The curve's last count: the one asked for, or the first that reaches the
 * target. */
static bool is_last(const placing *p, size_t k, uint64_t value)
{
    return p->desc->target ? value >= p->desc->target || k == p->desc->count
                           : k == p->desc->count;
}

/* The plan of k sensors, from that of one fewer (NULL: none). */
static murk_status find_count(placing *p, size_t k, const uint32_t *from,
                              murk_curve_point *last, murk_error *err)
{
    const murk_place_desc *desc = p->desc;
    /* With a target, any count may turn out to be the plan's. */
    const bool is_plan = desc->target || k == desc->count;
    const size_t rounds = is_plan ? p->rounds : curve_rounds(p->rounds);
    size_t extra = 0;
    size_t *made = is_plan ? &p->result->restarts : &extra;
    const size_t most = is_plan ? desc->restarts : curve_starts(desc->restarts);
    *last =
        desc->method == MURK_PLACE_BEST
            ? find_best(p, p->plan, k, from, last->value, most, rounds, made)
            : find_once(p, p->plan, k, rounds, made);
    const bool is_open = desc->target == 0 || (last->value < desc->target &&
                                               last->upper >= desc->target);
    return is_plan && is_open && !murk_interrupted() ? prove(p, last, err)
                                                     : MURK_OK;
}

/* Greedy, as far as any plan can need it. */
static void greedy_enough(placing *p)
{
    const murk_place_desc *desc = p->desc;
    size_t have = 0;
    size_t n =
        desc->target && desc->count > FIRST_GREEDY ? FIRST_GREEDY : desc->count;
    while (have < n && !murk_interrupted()) {
        murk_search_greedy(&p->search, p->greedy, have, n, p->greedy_value);
        have = n;
        if (desc->target && p->greedy_value[n - 1] < desc->target) {
            n = n < desc->count / 2 ? 2 * n : desc->count;
        }
    }
}

static murk_status find_all(placing *p, murk_error *err)
{
    murk_place_result *result = p->result;
    const murk_place_desc *desc = p->desc;
    if (desc->method != MURK_PLACE_SPOQ) {
        greedy_enough(p);
    }
    murk_curve_point last = {0};
    const uint32_t *from = NULL;
    murk_status status = MURK_OK;
    const size_t first = desc->with_curve || desc->target ? 1 : desc->count;
    for (size_t k = first; !status && !murk_interrupted(); ++k) {
        status = find_count(p, k, from, &last, err);
        if (result->curve) {
            result->curve[k - 1] = last;
        }
        if (desc->target && result->fewest == 0 && last.upper >= desc->target) {
            result->fewest = k;
        }
        memcpy(p->last_plan, p->plan, k * sizeof *p->plan);
        from = p->last_plan;
        result->count = k;
        if (is_last(p, k, last.value)) {
            break;
        }
    }
    result->curve_points = result->curve ? result->count : 0;
    result->value = last.value;
    result->upper = last.upper;
    result->evaluations += p->search.evaluations;
    result->looks += p->search.looks + p->bound.looks + p->oracle->looks;
    return status;
}

static uint64_t lesser(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* Bounds of one count bound the others, too: fewer sensors see no more, and by
 * submodularity the best k + 1 see at most (k + 1) / k of the best k. */
static void join_bounds(murk_curve_point *curve, size_t n)
{
    for (size_t k = 1; k < n; ++k) {
        const uint64_t before = curve[k - 1].upper;
        curve[k].upper = lesser(curve[k].upper, before + before / k);
    }
    for (size_t k = n - 1; k > 0; --k) {
        curve[k - 1].upper = lesser(curve[k - 1].upper, curve[k].upper);
    }
}

static int by_number(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

static const char *guarantee_of(murk_place_method method)
{
    /* best starts from greedy and only improves; relocation alone would give
     * n / (2n - 1), which is less. */
    return method == MURK_PLACE_SPOQ ? "none" : "1 - (1 - 1/n)^n";
}

static size_t rounds_for(const murk_oracle *oracle)
{
    if (!oracle->matrix) {
        return 1;
    }
    const double pairs = (double)murk_matrix_pairs(oracle->matrix);
    const double rounds = PAIRS_WEIGHED_MOST / (pairs > 1 ? pairs : 1);
    return rounds > ROUNDS_MOST    ? ROUNDS_MOST
           : rounds < ROUNDS_LEAST ? ROUNDS_LEAST
                                   : (size_t)rounds;
}

static murk_status check(const murk_problem *problem, bool known,
                         const murk_place_desc *desc, murk_error *err)
{
    if (desc->count < 1) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "0 sensors asked for, must be 1 or more");
    }
    if (desc->count > problem->candidates) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but only %zu usable "
                         "candidates",
                         desc->count, problem->candidates);
    }
    if (desc->method == MURK_PLACE_EXACT && !known) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "method exact needs what every candidate sees: "
                         "knowledge must be known");
    }
    if (desc->restarts < 1) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "restarts is 0, must be 1 or more");
    }
    return MURK_OK;
}

static murk_status starts_init(starts *t, const murk_oracle *oracle,
                               const murk_place_desc *desc, murk_error *err)
{
    /* In an unknown environment, and where a scan is long, threads share each
     * scan; else each takes a start of its own. */
    const bool is_wide = oracle->wide_threads > 1 || !oracle->matrix;
    const unsigned workers = is_wide ? 1 : oracle->problem->threads;
    const size_t wave = workers > 1 ? workers * STARTS_PER_WORKER : 1;
    *t = (starts){.seed = desc->seed,
                  .search = calloc(workers, sizeof *t->search),
                  .wave_most = wave,
                  .plan = calloc(wave * desc->count, sizeof *t->plan),
                  .value = calloc(wave, sizeof *t->value),
                  .evaluations = calloc(wave, sizeof *t->evaluations),
                  .looks = calloc(wave, sizeof *t->looks)};
    if (!t->search || !t->plan || !t->value || !t->evaluations || !t->looks) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         desc->count);
    }
    murk_status status = MURK_OK;
    for (; t->workers < workers && !status; ++t->workers) {
        status = murk_search_init(&t->search[t->workers], oracle, t->workers,
                                  is_wide ? oracle->wide_threads : 1, err);
    }
    return status;
}

static void starts_release(starts *t)
{
    for (unsigned k = 0; k < t->workers; ++k) {
        murk_search_release(&t->search[k]);
    }
    free(t->search);
    free(t->plan);
    free(t->value);
    free(t->evaluations);
    free(t->looks);
}

static murk_status placing_init(placing *p, const murk_oracle *oracle,
                                const murk_place_desc *desc,
                                murk_place_result *result, murk_error *err)
{
    const size_t n = desc->count;
    *p = (placing){.oracle = oracle,
                   .desc = desc,
                   .result = result,
                   .rounds = rounds_for(oracle),
                   .greedy = calloc(n, sizeof *p->greedy),
                   .greedy_value = calloc(n, sizeof *p->greedy_value),
                   .plan = calloc(n, sizeof *p->plan),
                   .last_plan = calloc(n, sizeof *p->last_plan)};
    result->sensor = calloc(n, sizeof *result->sensor);
    if (desc->with_curve || desc->target) {
        result->curve = calloc(n, sizeof *result->curve);
        result->curve_points = n;
    }
    if (!p->greedy || !p->greedy_value || !p->plan || !p->last_plan ||
        !result->sensor ||
        ((desc->with_curve || desc->target) && !result->curve)) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         n);
    }
    murk_status status =
        murk_search_init(&p->search, oracle, 0, oracle->wide_threads, err);
    if (!status) {
        status = murk_bound_init(&p->bound, oracle, err);
    }
    if (!status) {
        status = starts_init(&p->starts, oracle, desc, err);
    }
    return status;
}

static void placing_release(placing *p)
{
    murk_search_release(&p->search);
    murk_bound_release(&p->bound);
    starts_release(&p->starts);
    free(p->greedy);
    free(p->greedy_value);
    free(p->plan);
    free(p->last_plan);
}

static murk_status place(murk_place_result *out, const murk_problem *problem,
                         const murk_matrix *matrix, const murk_place_desc *desc,
                         murk_error *err)
{
    murk_oracle oracle = {0};
    placing p = {0};
    murk_place_result result = {.count = desc->count,
                                .guarantee = guarantee_of(desc->method)};
    murk_status status = check(problem, matrix != NULL, desc, err);
    if (!status) {
        status = murk_oracle_init(&oracle, problem, matrix, err);
    }
    if (!status) {
        status = placing_init(&p, &oracle, desc, &result, err);
    }
    if (!status && desc->target > oracle.ceiling) {
        status =
            murk_fail(err, MURK_BAD_VALUE, "",
                      "target %.6g cannot be reached: all %zu usable "
                      "candidates together see %.6g",
                      (double)desc->target / (double)oracle.layout->whole,
                      oracle.candidates,
                      (double)oracle.ceiling / (double)oracle.layout->whole);
    }
    if (status) {
        goto done;
    }
    murk_progress_begin("place", desc->restarts, "starts");
    status = find_all(&p, err);
    murk_progress_end();
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (!status && result.value < desc->target) {
        status = murk_fail(err, MURK_RUN_FAILED, "",
                           "method spoq did not reach the target with %zu "
                           "sensors",
                           result.count);
    }
    if (status) {
        goto done;
    }
    for (size_t k = 0; k < result.count; ++k) {
        result.sensor[k] = p.plan[k];
    }
    qsort(result.sensor, result.count, sizeof *result.sensor, by_number);
    if (result.curve) {
        join_bounds(result.curve, result.curve_points);
        result.upper = result.curve[result.count - 1].upper;
    }
    result.proven_optimal = result.value == result.upper;
    result.ceiling = oracle.ceiling;
    result.whole = oracle.layout->whole;
    result.after_presolve = oracle.undominated;
    *out = result;
    result = (murk_place_result){0};
done:
    placing_release(&p);
    murk_oracle_release(&oracle);
    murk_place_release(&result);
    return status;
}

murk_status murk_place_known(murk_place_result *result,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_place_desc *desc, murk_error *err)
{
    assert(result && problem && matrix && desc);
    assert(matrix->candidates == problem->candidates);
    return place(result, problem, matrix, desc, err);
}

murk_status murk_place_unknown(murk_place_result *result,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err)
{
    assert(result && problem && desc);
    return place(result, problem, NULL, desc, err);
}

void murk_place_release(murk_place_result *result)
{
    free(result->sensor);
    free(result->curve);
    *result = (murk_place_result){0};
}
