/* Plans against brute force on small made-up problems, and the promises of
 * place.h: bounds, guarantees, certificates, and one plan whatever the
 * environment or the threads. Nothing here is random but the fixed seeds, so
 * it cannot cry wolf. */
#include "placement/place.h"

#include "check.h"
#include "made_up.h"

#define MATRIX_MAX ((uint64_t)1 << 32)

static murk_place_result place_known(const made_up *m,
                                     const murk_place_desc *desc)
{
    murk_error err = {0};
    murk_matrix *matrix = NULL;
    murk_place_result result = {0};
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    CHECK(murk_place_sensors(&result, &m->problem, matrix, desc, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_matrix_destroy(matrix);
    return result;
}

static murk_place_result place_unknown(const made_up *m,
                                       const murk_place_desc *desc)
{
    murk_error err = {0};
    murk_place_result result = {0};
    CHECK(murk_place_sensors(&result, &m->problem, NULL, desc, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return result;
}

static bool same_plan(const murk_place_result *a, const murk_place_result *b)
{
    return a->count == b->count && a->value == b->value &&
           memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0;
}

/* The plan's claims about itself, by other means. */
static void check_claims(const made_up *m, const murk_place_result *r,
                         murk_place_method method, uint64_t optimum)
{
    CHECK(r->value == made_up_value(m, r->sensor, r->count));
    for (size_t k = 1; k < r->count; ++k) {
        CHECK(r->sensor[k] > r->sensor[k - 1]);
    }
    CHECK(r->value <= optimum);
    CHECK(r->upper >= optimum);
    CHECK(r->ceiling >= optimum);
    CHECK(r->whole >= r->ceiling);
    CHECK(!r->proven_optimal || r->value == optimum);
    if (method != MURK_PLACE_SPOQ) {
        const double n = (double)r->count;
        const double share = 1 - pow(1 - 1 / n, n);
        CHECK((double)r->value >= share * (double)optimum * (1 - 1e-15));
    }
}

/* The most that moving one sensor of the plan leads to. */
static uint64_t best_single_move(const made_up *m, const size_t *from, size_t n)
{
    size_t plan[8];
    uint64_t best = 0;
    for (size_t k = 0; k < n; ++k) {
        memcpy(plan, from, n * sizeof *plan);
        for (size_t j = 0; j < m->problem.candidates; ++j) {
            plan[k] = j;
            const uint64_t value = made_up_value(m, plan, n);
            best = value > best ? value : best;
        }
    }
    return best;
}

static void check_curve(const made_up *m, const murk_place_result *r,
                        murk_place_method method)
{
    CHECK(r->curve_points == r->count);
    for (size_t k = 0; k < r->curve_points; ++k) {
        const murk_curve_point *at = &r->curve[k];
        const uint64_t optimum = made_up_optimum(m, k + 1);
        CHECK(at->count == k + 1);
        CHECK(at->value <= optimum && at->upper >= optimum);
        if (k > 0 && method != MURK_PLACE_SPOQ) {
            CHECK(at->value >= r->curve[k - 1].value);
            CHECK(at->upper >= r->curve[k - 1].upper);
        }
    }
    CHECK(r->curve[r->count - 1].value == r->value);
    CHECK(r->curve[r->count - 1].upper == r->upper);
}

static void test_against_brute_force(uint32_t seed)
{
    static const struct {
        size_t photons, candidates;
        double share;
        uint32_t levels, weights;
    } kinds[] = {
        {40, 14, 0.3, 1, 1},     {40, 14, 0.02, 1, 1},   {30, 12, 0.5, 4, 1},
        {30, 12, 0.1, 1000, 5},  {600, 12, 0.3, 1, 2},   {600, 12, 0.5, 50, 2},
        {200, 14, 0.02, 1, 999}, {200, 14, 0.6, 1, 999}, {5, 14, 0.3, 1, 1},
        {200, 12, 0.6, 3, 999},
    };
    int plans = 0, optimal = 0, proven = 0;
    for (size_t kind = 0; kind < sizeof kinds / sizeof kinds[0]; ++kind) {
        for (uint32_t k = 0; k < 6; ++k) {
            made_up *m = made_up_create(
                seed + k, kinds[kind].photons, kinds[kind].candidates,
                kinds[kind].share, kinds[kind].levels, kinds[kind].weights, 2);
            for (size_t n = 1; n <= 3; ++n) {
                const uint64_t optimum = made_up_optimum(m, n);
                for (int method = 0; method < 3; ++method) {
                    murk_place_desc desc = murk_place_defaults();
                    desc.method = (murk_place_method)method;
                    desc.count = n;
                    desc.restarts = 5;
                    desc.seed = seed + k;
                    murk_place_result known = place_known(m, &desc);
                    murk_place_result unknown = place_unknown(m, &desc);
                    check_claims(m, &known, desc.method, optimum);
                    check_claims(m, &unknown, desc.method, optimum);
                    check_curve(m, &known, desc.method);
                    check_curve(m, &unknown, desc.method);
                    /* Best of all, or what cannot be proven without looks. */
                    CHECK(method == MURK_PLACE_BEST ||
                          same_plan(&known, &unknown));
                    if (method == MURK_PLACE_BEST) {
                        CHECK(best_single_move(m, known.sensor, n) ==
                              known.value);
                        ++plans;
                        optimal += known.value == optimum;
                        proven += known.proven_optimal;
                    }
                    murk_place_release(&known);
                    murk_place_release(&unknown);
                }
            }
            made_up_destroy(m);
        }
    }
    printf("best: %d plans, %d optimal, %d proven so\n", plans, optimal,
           proven);
    CHECK(optimal == plans);
    CHECK(proven == plans);
}

/* Without branch and bound, known and unknown environments lead to the same
 * plan. */
static void test_known_is_unknown(uint32_t seed)
{
    for (uint32_t k = 0; k < 20; ++k) {
        made_up *m = made_up_create(seed + k, 200, 14, 0.4, 3, 5, 2);
        murk_place_desc desc = murk_place_defaults();
        desc.count = 3;
        desc.restarts = 5;
        desc.nodes = 0;
        desc.seed = seed + k;
        murk_place_result known = place_known(m, &desc);
        murk_place_result unknown = place_unknown(m, &desc);
        CHECK(same_plan(&known, &unknown));
        murk_place_release(&known);
        murk_place_release(&unknown);
        made_up_destroy(m);
    }
}

/* In an unknown environment greedy looks at each candidate once, and again
 * only at those that may add most to what stands: its bounds cost no look. */
static void test_greedy_evaluates_few_again(uint32_t seed)
{
    made_up *m = made_up_create(seed, 2000, 600, 0.02, 1, 1, 2);
    murk_place_desc desc = murk_place_defaults();
    desc.method = MURK_PLACE_GREEDY;
    desc.count = 3;
    murk_place_result r = place_unknown(m, &desc);
    CHECK(r.queries == 600 + r.evaluations + 3);
    CHECK(r.evaluations < 3 * 600 - 600);
    CHECK(r.upper < r.ceiling / 2);
    murk_place_release(&r);
    made_up_destroy(m);
}

/* Exact finds the optimum and proves it; cut short, its bound still holds, and
 * it says that it was cut. */
static void test_exact(uint32_t seed)
{
    int segment_start = 0;
    for (uint32_t k = 0; k < 40; ++k) {
        made_up *m = made_up_create(seed + k, 400, 40, 0.15, k % 2 ? 1 : 200,
                                    1 + k % 7, 1);
        const uint64_t optimum = made_up_optimum(m, 3);
        for (int is_short = 0; is_short < 2; ++is_short) {
            murk_place_desc desc = {.method = MURK_PLACE_EXACT,
                                    .count = 3,
                                    .restarts = 1,
                                    .nodes = is_short ? 1 : 1000000,
                                    .seed = seed};
            murk_place_result r = place_known(m, &desc);
            CHECK(r.upper >= optimum && r.value <= optimum);
            CHECK(r.proven_optimal == (r.value == r.upper));
            CHECK(is_short || (r.value == optimum && r.proven_optimal));
            CHECK(is_short || !r.is_cut);
            CHECK(!r.is_cut || r.nodes >= 1);
            segment_start += r.is_cut;
            murk_place_release(&r);
        }
        made_up_destroy(m);
    }
    CHECK(segment_start > 0); /* or nothing was tested of being cut */
    made_up *m = made_up_create(seed, 40, 14, 0.3, 1, 1, 1);
    murk_place_desc desc = murk_place_defaults();
    desc.method = MURK_PLACE_EXACT;
    murk_place_result r = {0};
    murk_error err = {0};
    CHECK(murk_place_sensors(&r, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "knowledge must be known");
    made_up_destroy(m);
}

/* The fewest sensors that reach a target: as many as brute force needs, with
 * a plan that does reach it, and a bound that says so. */
static void test_target(uint32_t seed)
{
    for (uint32_t k = 0; k < 30; ++k) {
        made_up *m = made_up_create(seed + k, 200, 13, 0.2, k % 2 ? 1 : 90,
                                    1 + k % 5, 2);
        const uint64_t goal = made_up_optimum(m, 1 + k % 5) + k % 2;
        size_t fewest = 1;
        while (fewest < 8 && made_up_optimum(m, fewest) < goal) {
            ++fewest;
        }
        CHECK(made_up_optimum(m, fewest) >= goal);
        murk_place_desc desc = murk_place_defaults();
        desc.method = k % 3 ? MURK_PLACE_BEST : MURK_PLACE_EXACT;
        desc.count = 13;
        desc.restarts = 5;
        desc.target = goal; /* met exactly by a count, or missed by one */
        murk_place_result r = place_known(m, &desc);
        CHECK(r.count == fewest);
        CHECK(r.fewest == fewest);
        CHECK(r.value >= desc.target);
        CHECK(r.value == made_up_value(m, r.sensor, r.count));
        CHECK(r.curve_points == fewest);
        murk_place_release(&r);
        desc.method = MURK_PLACE_GREEDY;
        r = place_known(m, &desc);
        CHECK(r.count >= fewest && r.fewest <= fewest);
        murk_place_release(&r);
        desc.target = UINT64_MAX;
        murk_error err = {0};
        murk_place_result none = {0};
        CHECK(murk_place_sensors(&none, &m->problem, NULL, &desc, &err) ==
              MURK_BAD_VALUE);
        CHECK_MENTIONS(err.text, "all 13 usable candidates together see");
        made_up_destroy(m);
    }
}

/* The limit of branch and bound holds for all counts on the way to a target
 * together, not for each; the bounds so far are valid, and it is said that the
 * limit cut. */
static void test_nodes_limit_all_counts_together(uint32_t seed)
{
    made_up *m = made_up_create(seed, 2000, 90, 0.1, 300, 7, 1);
    murk_place_desc desc = murk_place_defaults();
    desc.method = MURK_PLACE_EXACT;
    desc.count = 90;
    uint64_t whole = 0;
    for (size_t i = 0; i < 2000; ++i) {
        whole += (uint64_t)m->weight[i] * MURK_CLEAR;
    }
    desc.target = whole / 2;
    desc.nodes = 40;
    murk_place_result r = place_known(m, &desc);
    CHECK(r.is_cut && r.value >= desc.target);
    CHECK(r.fewest >= 3 && r.fewest <= r.count);
    CHECK(r.nodes < 80); /* two counts are open */
    murk_place_release(&r);
    made_up_destroy(m);
}

/* Half of many candidates asked for: the search ends within its limit of
 * work, with a bound that holds and a curve that rises. */
static void test_search_ends_within_its_work(uint32_t seed)
{
    made_up *m = made_up_create(seed, 400, 100, 0.3, 65535, 5, 1);
    murk_place_desc desc = murk_place_defaults();
    desc.count = 50;
    desc.nodes = 0;
    desc.search_work = 50000 * (uint64_t)(4 * 400);
    murk_place_result r = place_known(m, &desc);
    CHECK(r.is_work_cut && r.evaluations < 3 * 50000 && !r.proven_optimal);
    CHECK(r.count == 50 && r.curve_points == 50);
    CHECK(r.value <= r.upper && r.upper <= r.ceiling);
    for (size_t k = 1; k < r.curve_points; ++k) {
        CHECK(r.curve[k].value >= r.curve[k - 1].value);
        CHECK(r.curve[k].upper >= r.curve[k].value);
    }
    murk_place_release(&r);
    made_up_destroy(m);
}

/* Teeth: some SPOQ ends lack the certificate that `best` always carries. */
static void test_certificate_notices_a_bad_plan(void)
{
    int improvable = 0;
    for (uint32_t seed = 0; seed < 400; ++seed) {
        made_up *m = made_up_create(seed, 30, 14, 0.2, 1, 1, 1);
        murk_place_desc desc = {
            .method = MURK_PLACE_SPOQ, .count = 3, .restarts = 1, .seed = seed};
        murk_place_result r = place_known(m, &desc);
        improvable += best_single_move(m, r.sensor, 3) > r.value;
        murk_place_release(&r);
        made_up_destroy(m);
    }
    printf("spoq: a single move improves %d of 400 plans\n", improvable);
    CHECK(improvable > 0);
}

/* SPOQ sweeps until a whole sweep gains nothing. Where no two candidates add
 * the same (weights of a thousand sizes), that sweep moved nobody, so no single
 * move helps. Ended after one or two sweeps, many of these plans would be
 * improvable. */
static void test_spoq_sweeps_until_nothing_gains(void)
{
    for (uint32_t seed = 0; seed < 60; ++seed) {
        made_up *m = made_up_create(seed, 120, 40, 0.15, 1, 100000, 1);
        murk_place_desc desc = {
            .method = MURK_PLACE_SPOQ, .count = 6, .restarts = 1, .seed = seed};
        murk_place_result r = place_known(m, &desc);
        CHECK(best_single_move(m, r.sensor, 6) == r.value);
        murk_place_release(&r);
        made_up_destroy(m);
    }
}

static void test_threads_change_nothing(void)
{
    static const unsigned threads[] = {1, 2, 5};
    murk_place_result first[2] = {{0}};
    for (size_t k = 0; k < 3; ++k) {
        for (size_t weighted = 0; weighted < 2; ++weighted) {
            /* A problem with clear views, and one with nine levels of
             * clarity. */
            made_up *m = made_up_create(3, 700, 60, 0.12, weighted ? 9 : 1, 2,
                                        threads[k]);
            murk_place_desc desc = murk_place_defaults();
            desc.count = 4;
            desc.restarts = 40;
            murk_place_result r = place_known(m, &desc);
            murk_place_result *was = &first[weighted];
            /* One thread gives the plan, bound, numbers of steps and curve
             * that other numbers of threads must repeat. */
            if (k == 0) {
                *was = r;
            } else {
                CHECK(same_plan(was, &r));
                CHECK(was->upper == r.upper);
                CHECK(was->restarts == r.restarts);
                CHECK(was->evaluations == r.evaluations);
                CHECK(was->queries == r.queries);
                CHECK(memcmp(was->curve, r.curve,
                             r.curve_points * sizeof *r.curve) == 0);
                murk_place_release(&r);
            }
            made_up_destroy(m);
        }
    }
    murk_place_release(&first[0]);
    murk_place_release(&first[1]);
}

/* Most candidates see nothing: SPOQ must get away from a blind start. */
static void test_blind_start_does_not_end_spoq(void)
{
    made_up *m = made_up_create(1, 50, 200, 0, 1, 1, 1);
    m->clarity[150 * 50 + 7] = MURK_CLEAR;
    m->clarity[90 * 50 + 8] = MURK_CLEAR;
    for (uint32_t seed = 0; seed < 20; ++seed) {
        murk_place_desc desc = {
            .method = MURK_PLACE_SPOQ, .count = 2, .restarts = 1, .seed = seed};
        murk_place_result r = place_known(m, &desc);
        CHECK(r.count == 2 && r.sensor[0] == 90 && r.sensor[1] == 150);
        CHECK(r.proven_optimal);
        CHECK(r.restarts == 1);
        murk_place_release(&r);
    }
    made_up_destroy(m);
}

/* Eight candidates see the same: each is chosen by some seed. */
static void test_ties_are_broken_at_random(void)
{
    made_up *m = made_up_create(1, 50, 8, 0, 1, 1, 1);
    for (size_t j = 0; j < 8; ++j) {
        m->clarity[j * 50 + 7] = MURK_CLEAR;
    }
    int chosen[8] = {0};
    for (uint32_t seed = 0; seed < 200; ++seed) {
        murk_place_desc desc = {
            .method = MURK_PLACE_SPOQ, .count = 1, .restarts = 1, .seed = seed};
        murk_place_result r = place_known(m, &desc);
        CHECK(r.after_presolve == 1);
        ++chosen[r.sensor[0]];
        murk_place_release(&r);
    }
    for (size_t j = 0; j < 8; ++j) {
        CHECK(chosen[j] > 0); /* missed by chance once in 4e11 */
    }
    made_up_destroy(m);
}

static void test_more_sensors_than_photons(void)
{
    made_up *m = made_up_create(5, 2, 9, 0.5, 1, 1, 2);
    murk_place_desc desc = murk_place_defaults();
    desc.count = 9;
    for (int method = 0; method < 3; ++method) {
        desc.method = (murk_place_method)method;
        murk_place_result r = place_known(m, &desc);
        for (size_t k = 0; k < 9; ++k) {
            CHECK(r.sensor[k] == k);
        }
        CHECK(r.value == r.ceiling && r.proven_optimal);
        murk_place_release(&r);
    }
    made_up_destroy(m);
}

static void test_no_photons(void)
{
    made_up *m = made_up_create(5, 0, 4, 0.5, 1, 1, 2);
    murk_place_desc desc = murk_place_defaults();
    desc.count = 2;
    murk_place_result r = place_known(m, &desc);
    CHECK(r.value == 0 && r.upper == 0 && r.whole == 0 && r.proven_optimal);
    murk_place_release(&r);
    r = place_unknown(m, &desc);
    CHECK(r.value == 0 && r.upper == 0 && r.count == 2);
    murk_place_release(&r);
    made_up_destroy(m);
}

static void test_too_many_sensors_are_refused(void)
{
    made_up *m = made_up_create(5, 4, 3, 0.5, 1, 1, 1);
    murk_place_desc desc = murk_place_defaults();
    murk_place_result r = {0};
    murk_error err = {0};
    desc.count = 7;
    CHECK(murk_place_sensors(&r, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "7 sensors asked for, but only 3 usable candidates");
    CHECK(r.sensor == NULL);
    err = (murk_error){0};
    desc.count = 0;
    CHECK(murk_place_sensors(&r, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    m->problem.candidates = 0;
    err = (murk_error){0};
    desc.count = 1;
    CHECK(murk_place_sensors(&r, &m->problem, NULL, &desc, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "1 sensors asked for, but only 0 usable candidates");
    made_up_destroy(m);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_against_brute_force(seed);
    test_known_is_unknown(seed);
    test_greedy_evaluates_few_again(seed);
    test_exact(seed);
    test_target(seed);
    test_nodes_limit_all_counts_together(seed);
    test_search_ends_within_its_work(seed);
    test_certificate_notices_a_bad_plan();
    test_spoq_sweeps_until_nothing_gains();
    test_threads_change_nothing();
    test_blind_start_does_not_end_spoq();
    test_ties_are_broken_at_random();
    test_more_sensors_than_photons();
    test_no_photons();
    test_too_many_sensors_are_refused();
    return check_done();
}
