/* A search that is asked to finish (base/interrupt.h) gives a plan of the
 * wanted number that keeps all rules, the value of that plan, and a valid
 * bound, whenever the request comes: before the search, at any row that the
 * search asks for, or at some time from another thread. A deadline does the
 * same. Small problems are
 * compared with brute force. Nothing is random but the fixed seeds and, in the
 * last tests, the times of requests, on which no check depends. */
#include "base/host.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "check.h"
#include "made_up_rules.h"
#include "placement/at_least.h"
#include "placement/worst.h"

#include <math.h>
#include <pthread.h>
#include <time.h>

#define MATRIX_MAX ((uint64_t)1 << 32)
#define ENDLESS    UINT64_C(1000000000000)

/* ---- requests at a row of an unknown environment ---- */

typedef struct counted {
    const made_up *of;
    size_t rows,
        at; /* rows asked for so far; the request comes with row `at` */
} counted;

static void row_and_request(void *context, unsigned worker, size_t candidate,
                            murk_sparse_row *row)
{
    counted *c = context;
    if (c->rows++ == c->at) {
        CHECK(murk_finish_request(murk_host_now()));
        CHECK(!murk_finish_request(murk_host_now()));
    }
    made_up_row((void *)c->of, worker, candidate, row);
}

/* ---- small problems ---- */

/* `plan` is a plan of the problem under the rules, with a valid bound; best[]
 * as made_up_ruled_optima() sets it. */
static void check_plan(const made_up *m, const made_up_constraints *r,
                       const murk_place_desc *desc,
                       const murk_place_result *plan,
                       const uint64_t best[MADE_UP_MAX + 1])
{
    const uint32_t set = made_up_set(plan);
    const uint64_t optimum = made_up_ruled_optimum(r, best, desc->count);
    const bool has_budget = r->kinds & BUDGET;
    CHECK(has_budget || plan->count == desc->count);
    CHECK((size_t)__builtin_popcount(set) == plan->count);
    CHECK(made_up_keeps(r, set));
    CHECK(plan->value == made_up_set_value(m, set));
    CHECK(plan->upper >= plan->value && plan->upper >= optimum);
    CHECK(plan->proven_optimal == (plan->value == plan->upper));
    /* A guarantee of greedy still holds, because greedy is completed. */
    if (strcmp(plan->guarantee, "1 - (1 - 1/n)^n") == 0) {
        const double n = (double)plan->count;
        CHECK((double)(plan->value + made_up_rounding(m)) >=
              (1 - pow(1 - 1 / n, n)) * (double)optimum * (1 - 1e-15));
    }
    for (size_t k = 0; k < plan->curve_points; ++k) {
        const murk_curve_point *point = &plan->curve[k];
        CHECK(point->value <= best[point->count]);
        CHECK(point->upper >= best[point->count]);
    }
}

/* The request comes before the search (at == SIZE_MAX), or, in an unknown
 * environment, with row `at`. Returns whether the search was asked. */
static bool try_at(const made_up *m, const made_up_constraints *r,
                   const murk_place_desc *desc, bool known, size_t at,
                   const uint64_t best[MADE_UP_MAX + 1])
{
    counted c = {.of = m, .at = at};
    murk_problem problem = m->problem;
    problem.threads = 1;
    problem.get_row = row_and_request;
    problem.context = &c;
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    murk_place_result plan = {0};
    if (known) {
        CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
              MURK_OK);
    }
    murk_finish_allow(true);
    if (at == SIZE_MAX) {
        CHECK(!murk_finish_request(murk_host_now())); /* no search runs */
        murk_finish_search_begins();
        CHECK(murk_finish_request(murk_host_now()));
    }
    const bool is_possible =
        made_up_ruled_optimum(r, best, desc->count) != UINT64_MAX;
    const murk_status status =
        murk_place_sensors(&plan, &problem, matrix, desc, &err);
    CHECK((status == MURK_OK) == is_possible);
    const bool was_asked = at == SIZE_MAX || c.rows > at;
    if (!status) {
        check_plan(m, r, desc, &plan, best);
        CHECK(plan.is_interrupted == was_asked);
    }
    murk_finish_allow(false);
    murk_place_release(&plan);
    murk_matrix_destroy(matrix);
    return was_asked && !status;
}

static void test_small(uint32_t seed)
{
    int asked = 0;
    for (uint32_t k = 0; k < 60; ++k) {
        /* No rules, each kind of rule, and pairs of kinds. */
        const unsigned kinds = k < 8 ? 1u << k >> 1 : 1u << k % 7 | 1u << k % 5;
        made_up *m = made_up_create(seed + k, 120, 11, 0.3, k % 3 ? 40 : 1,
                                    1 + k % 4, 1);
        m->problem.combining =
            k % 4 == 3 ? MURK_COMBINE_INDEPENDENT : MURK_COMBINE_CLEAREST;
        made_up_constraints r;
        uint64_t best[MADE_UP_MAX + 1];
        made_up_constraints_fill(&r, seed + k, kinds, 11);
        made_up_ruled_optima(m, &r, best);
        murk_place_desc desc = murk_place_defaults();
        desc.count = 4;
        desc.restarts = 4;
        desc.seed = seed + k;
        desc.with_curve = k % 2;
        desc.row_memory = 0; /* every evaluation asks for a row */
        desc.constraints = kinds ? &r.constraints : NULL;
        for (int method = 0; method < 4; ++method) {
            desc.method = (murk_place_method)method;
            asked += try_at(m, &r, &desc, true, SIZE_MAX, best);
            if (desc.method == MURK_PLACE_EXACT) {
                continue;
            }
            asked += try_at(m, &r, &desc, false, SIZE_MAX, best);
            for (size_t at = 11; at < 2000; at += 1 + at / 8) {
                asked += try_at(m, &r, &desc, false, at, best);
            }
        }
        made_up_destroy(m);
    }
    printf("%d plans of searches that were asked to finish\n", asked);
    CHECK(asked > 1000);
}

/* Without a request, and where none is allowed, nothing changes. */
static void test_refused(uint32_t seed)
{
    made_up *m = made_up_create(seed, 120, 11, 0.3, 40, 3, 1);
    counted c = {.of = m, .at = SIZE_MAX};
    murk_problem problem = m->problem;
    murk_place_desc desc = murk_place_defaults();
    desc.count = 3;
    murk_place_result plan = {0};
    murk_finish_search_begins();
    CHECK(!murk_finish_request(murk_host_now()));
    CHECK(!murk_finish_search_ends() && !murk_must_finish());
    murk_finish_allow(true);
    problem.get_row = row_and_request;
    problem.context = &c;
    CHECK(murk_place_sensors(&plan, &problem, NULL, &desc, NULL) == MURK_OK);
    CHECK(!plan.is_interrupted);
    CHECK(!murk_finish_request(murk_host_now())); /* the search has ended */
    murk_finish_allow(false);
    murk_place_release(&plan);
    made_up_destroy(m);
}

/* The target is the best value that maximum counts by class admit. Greedy
 * reaches it or not, and only a plan that reaches it is a result. */
static void test_target(uint32_t seed)
{
    int reached = 0, missed = 0;
    for (uint32_t k = 0; k < 40; ++k) {
        made_up *m = made_up_create(seed + k, 120, 11, 0.3, 40, 3, 1);
        made_up_constraints r;
        uint64_t best[MADE_UP_MAX + 1];
        made_up_constraints_fill(&r, seed + k, CAPS, 11);
        made_up_ruled_optima(m, &r, best);
        /* The largest count that has a plan, and the best value of it. */
        murk_place_desc desc = murk_place_defaults();
        desc.constraints = &r.constraints;
        for (size_t n = 1; n <= 11 && best[n] != UINT64_MAX; ++n) {
            desc.count = n;
            desc.target = best[n];
        }
        murk_matrix *matrix = NULL;
        murk_place_result plan = {0};
        murk_error err = {0};
        CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
              MURK_OK);
        /* The request comes before the search. */
        murk_finish_allow(true);
        murk_finish_search_begins();
        CHECK(murk_finish_request(murk_host_now()));
        const murk_status status =
            murk_place_sensors(&plan, &m->problem, matrix, &desc, &err);
        murk_finish_allow(false);
        if (status) {
            CHECK(status == MURK_INTERRUPTED);
            CHECK_MENTIONS(err.text, "before a plan was found that reaches");
            ++missed;
        } else {
            CHECK(plan.is_interrupted && plan.value == desc.target);
            CHECK(made_up_keeps(&r, made_up_set(&plan)));
            ++reached;
        }
        murk_place_release(&plan);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
    CHECK(reached > 2 && missed > 2);
}

/* ---- requests from another thread, to searches without an end ---- */

typedef struct asker {
    murk_host *host;
    long delay_ns;
} asker;

/* Asks once a search runs and some time has passed. */
static void *ask(void *context)
{
    const asker *a = context;
    const struct timespec delay = {0, a->delay_ns}, step = {0, 1000};
    nanosleep(&delay, NULL);
    while (!murk_finish_request(a->host)) {
        nanosleep(&step, NULL);
    }
    return NULL;
}

typedef murk_status (*place_function)(murk_place_result *out, const made_up *m,
                                      murk_matrix *matrix,
                                      const murk_place_desc *desc,
                                      murk_error *err);

static murk_status place_value(murk_place_result *out, const made_up *m,
                               murk_matrix *matrix, const murk_place_desc *desc,
                               murk_error *err)
{
    return murk_place_sensors(out, &m->problem, matrix, desc, err);
}

static murk_status place_worst(murk_place_result *out, const made_up *m,
                               murk_matrix *matrix, const murk_place_desc *desc,
                               murk_error *err)
{
    const size_t n = m->problem.photons;
    const murk_blocks blocks = {.n = 3, .first = {0, n / 2, n - n / 5, n}};
    return murk_place_worst(out, &m->problem, matrix, &blocks, desc, err);
}

static murk_status place_at_least(murk_place_result *out, const made_up *m,
                                  murk_matrix *matrix,
                                  const murk_place_desc *desc, murk_error *err)
{
    return murk_place_at_least(out, &m->problem, matrix, desc, err);
}

/* Asks a search that branch and bound or the starts would keep busy for hours,
 * after different times, from 0 to .14 s. */
static void test_times(place_function place, const made_up *m,
                       const murk_place_desc *desc)
{
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    for (long delay_ns = 0; delay_ns < 400000000;
         delay_ns = 4 * delay_ns + 100000) {
        asker a = {murk_host_now(), delay_ns};
        pthread_t thread;
        murk_place_result plan = {0};
        murk_finish_allow(true);
        CHECK(pthread_create(&thread, NULL, ask, &a) == 0);
        CHECK(place(&plan, m, matrix, desc, &err) == MURK_OK);
        CHECK(pthread_join(thread, NULL) == 0);
        murk_finish_allow(false);
        /* A plan of the wanted number, or one that reaches the target. */
        CHECK(plan.is_interrupted);
        CHECK(desc->target
                  ? plan.value >= desc->target && plan.count >= plan.fewest
                  : plan.count == desc->count);
        CHECK(plan.upper >= plan.value && plan.value > 0);
        for (size_t k = 1; k < plan.count; ++k) {
            CHECK(plan.sensor[k - 1] < plan.sensor[k]);
        }
        CHECK(place != place_value ||
              plan.value == made_up_value(m, plan.sensor, plan.count));
        murk_place_release(&plan);
    }
    murk_matrix_destroy(matrix);
}

/* A deadline ends a search as a request does. One that has passed leaves a plan
 * that is no worse than the start plan, whose value is that of the plan in
 * which all its sensors are fixed; one that is far changes nothing. */
static void test_deadline(place_function place, uint32_t seed)
{
    static const murk_place_method methods[] = {
        MURK_PLACE_BEST, MURK_PLACE_SPOQ, MURK_PLACE_EXACT};
    int starts_that_won = 0;
    for (uint32_t k = 0; k < 30; ++k) {
        made_up *m = made_up_create(seed + k, 400, 40, 0.1, k % 2 ? 40 : 1,
                                    1 + k % 4, 1);
        murk_place_desc desc = murk_place_defaults(), whole = desc;
        murk_place_result good = {0}, free = {0}, start = {0}, late = {0},
                          early = {0};
        murk_matrix *matrix = NULL;
        murk_error err = {0};
        desc.count = whole.count = 5;
        CHECK(!murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err));
        /* A good start, or the first candidates. */
        CHECK(place(&good, m, matrix, &desc, &err) == MURK_OK);
        uint32_t list[5];
        size_t fixed[5];
        for (size_t i = 0; i < 5; ++i) {
            fixed[i] = k % 3 ? good.sensor[i] : i;
            list[i] = (uint32_t)fixed[i];
        }
        const murk_constraints all_fixed = {.fixed = fixed, .fixed_count = 5};
        whole.constraints = &all_fixed;
        CHECK(place(&start, m, matrix, &whole, &err) == MURK_OK);
        /* Without a deadline, with one that is far, and one that has passed. */
        desc.method = methods[k % 3];
        desc.start_plan = list;
        desc.start_size = 5;
        CHECK(place(&free, m, matrix, &desc, &err) == MURK_OK);
        murk_finish_set_deadline(murk_clock_s() + 1e6);
        CHECK(place(&early, m, matrix, &desc, &err) == MURK_OK);
        murk_finish_set_deadline(murk_clock_s());
        CHECK(place(&late, m, matrix, &desc, &err) == MURK_OK);
        murk_finish_set_deadline(INFINITY);
        CHECK(!murk_must_finish());
        CHECK(!free.is_late && !early.is_late && late.is_late);
        CHECK(!late.is_interrupted && late.count == 5);
        CHECK(early.value == free.value && early.upper == free.upper &&
              early.evaluations == free.evaluations);
        CHECK(memcmp(early.sensor, free.sensor, 5 * sizeof *free.sensor) == 0);
        CHECK(late.value >= start.value);
        CHECK(late.upper >= free.value && late.upper >= late.value);
        starts_that_won += late.value >= good.value;
        murk_place_release(&good);
        murk_place_release(&free);
        murk_place_release(&start);
        murk_place_release(&late);
        murk_place_release(&early);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
    CHECK(starts_that_won >= 20);
}

static void test_endless(uint32_t seed)
{
    murk_place_desc desc = murk_place_defaults();
    desc.nodes = ENDLESS;
    desc.restarts = 1000000;
    /* Rows of clarities, whose starts share passes, and rows of bits. */
    for (uint32_t levels = 1; levels <= 50; levels += 49) {
        made_up *m = made_up_create(seed, 1500, 300, 0.2, levels, 9, 2);
        desc.count = 14;
        desc.target = 0;
        test_times(place_value, m, &desc);
        test_times(place_worst, m, &desc);
        /* Branch and bound right after greedy and the bound. */
        desc.method = MURK_PLACE_EXACT;
        test_times(place_value, m, &desc);
        test_times(place_worst, m, &desc);
        desc.method = MURK_PLACE_BEST;
        /* Most of the photons, by fewer sensors than greedy takes. */
        uint64_t weight = 0;
        for (size_t i = 0; i < 1500; ++i) {
            weight += m->weight[i];
        }
        desc.count = 300;
        desc.target = weight * MURK_CLEAR / 8 * (levels == 1 ? 7 : 5);
        test_times(place_value, m, &desc);
        made_up_destroy(m);
    }
    /* The strict target: a share of the photons seen by two sensors. */
    made_up *m = made_up_create(seed + 1, 1000, 200, 0.15, 1, 1, 2);
    murk_at_least strict;
    murk_at_least_init(&strict, &m->problem, 2);
    made_up of = *m;
    of.problem = strict.problem;
    desc.count = 200;
    desc.target = (uint64_t)3 * 1000 * MURK_CLEAR / 10 * 9;
    test_times(place_at_least, &of, &desc);
    desc.method = MURK_PLACE_EXACT;
    test_times(place_at_least, &of, &desc);
    made_up_destroy(m);
}

int main(void)
{
    test_small(7100);
    test_refused(7200);
    test_target(7250);
    test_deadline(place_value, 7260);
    test_deadline(place_worst, 7290);
    test_endless(7300);
    return check_done();
}
