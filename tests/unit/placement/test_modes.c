/* Modes of combining views, against brute force: covers, thresholds, plans
 * under every kind of rule, and scans against plain ones. Nothing is random but
 * the fixed seeds. */
#include "placement/place.h"

#include "constrained_plans.h"
#include "placement/cover.h"
#include "placement/multipliers.h"

static const struct mode {
    const char *name;
    murk_combining combining;
    unsigned redundancy;
} modes[] = {
    {"clearest", MURK_COMBINE_CLEAREST, 0},
    {"two clearest", MURK_COMBINE_CLEAREST, 2},
    {"three clearest", MURK_COMBINE_CLEAREST, 3},
    {"independent", MURK_COMBINE_INDEPENDENT, 1},
};
#define MODES (sizeof modes / sizeof modes[0])

static void set_mode(made_up *m, const struct mode *mode)
{
    m->problem.combining = mode->combining;
    m->problem.redundancy = mode->redundancy;
}

/* Most clarities so small that rounding is most of what they add, some larger,
 * so that there is something to round. */
static void make_faint(made_up *m)
{
    for (size_t k = 0; k < m->problem.photons * m->problem.candidates; ++k) {
        const uint32_t p = m->clarity[k];
        const bool is_faint = k / m->problem.photons % 8 > 0;
        m->clarity[k] = (uint16_t)(p == 0     ? 0
                                   : is_faint ? 1 + p % 2
                                              : 200 + p % 700);
    }
}

/* One of a few kinds of problems, by number. */
static made_up *create(uint32_t seed, uint32_t k, size_t photons,
                       size_t candidates, unsigned threads)
{
    made_up *m =
        made_up_create(seed, photons, candidates, k % 3 ? .35 : .1,
                       k % 2 ? 1 : 40 + 1000 * (k % 4), 1 + k % 4, threads);
    if (k % 5 == 4 && !m->is_binary) {
        make_faint(m);
    }
    if (k % 2 == k / 2 % 2) {
        let_half_see_no_more(m, seed);
    }
    return m;
}

static murk_matrix *matrix_of(const made_up *m)
{
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return matrix;
}

/* Covers are worth what brute force says, whatever the order and form, and
 * rows add what they make of it. */
static void test_covers(uint32_t seed)
{
    int less = 0;
    for (uint32_t k = 0; k < 40; ++k) {
        made_up *m = create(seed + k, k, 150, 8, 1);
        set_mode(m, &modes[k / 2 % MODES]); /* clear and not */
        murk_matrix *matrix = matrix_of(m);
        const murk_layout *layout = &matrix->layout;
        murk_cover cover, graded, other;
        CHECK(murk_cover_init(&cover, layout, matrix->is_binary));
        CHECK(murk_cover_init(&graded, layout, false));
        CHECK(murk_cover_init(&other, layout, matrix->is_binary));
        size_t plan[8];
        for (size_t n = 0; n < 8; ++n) {
            const size_t j = (n * 3 + k) % 8;
            const uint64_t before = made_up_value(m, plan, n);
            plan[n] = j;
            const uint64_t now = made_up_value(m, plan, n + 1);
            CHECK(murk_row_gain(layout, &matrix->row[j], &cover) ==
                  now - before);
            CHECK(murk_row_gain(layout, &matrix->row[j], &graded) ==
                  now - before);
            if (cover.dose) {
                const uint64_t rest =
                    murk_row_gain_bound(layout, &matrix->row[j], &cover);
                const uint64_t slack = MURK_GAIN_BOUND_SLACK *
                                       murk_row_weight(layout, &matrix->row[j]);
                CHECK(rest + slack >= now - before);
                CHECK(rest <= now - before + slack);
                less += rest < now - before;
            }
            murk_cover_add(&cover, layout, &matrix->row[j]);
            murk_cover_add(&graded, layout, &matrix->row[j]);
            CHECK(murk_cover_value(&cover, layout) == now);
            CHECK(murk_cover_value(&graded, layout) == now);
        }
        murk_cover_clear(&cover, layout);
        for (size_t n = 0; n < 8; ++n) {
            murk_cover_add(n < 5 ? &other : &cover, layout,
                           &matrix->row[plan[n]]);
        }
        murk_cover_join(&cover, layout, &other);
        CHECK(murk_cover_value(&cover, layout) == made_up_value(m, plan, 8));
        murk_cover_copy(&other, layout, &cover);
        CHECK(murk_cover_value(&other, layout) == made_up_value(m, plan, 8));
        murk_cover_release(&cover);
        murk_cover_release(&graded);
        murk_cover_release(&other);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
    CHECK(less > 0); /* the slack is needed */
}

/* For any thresholds, any partial plan and any sensors that join, the sum
 * over thresholds and the sum over gains together are not less than the
 * value of the plan. The test counts cases in which a bound lower by a
 * hundredth would be wrong. */
static void check_multipliers(const made_up *m, uint32_t seed, int *too_low)
{
    /* A cover for the partial plan, and room for one threshold for each
     * photon. */
    murk_matrix *matrix = matrix_of(m);
    murk_evaluator evaluator;
    murk_multipliers t;
    murk_cover stand;
    murk_error err = {0};
    const murk_layout *layout = &matrix->layout;
    CHECK(murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, 3, 0, true,
                              &err) == MURK_OK);
    CHECK(murk_multipliers_init(&t, &evaluator, &err) == MURK_OK);
    CHECK(murk_cover_init(&stand, layout, false));
    float *threshold = calloc(layout->slots + 1, sizeof *threshold);
    for (uint32_t k = 0; k < 30; ++k) {
        /* Draw a plan: up to three sensors stand, up to three more join. */
        size_t plan[6], stands = made_up_draw(seed, 40, k, 4);
        const size_t n = stands + made_up_draw(seed, 41, k, 4);
        uint32_t joins[6];
        uint64_t gain[6];
        murk_cover_clear(&stand, layout);
        for (size_t i = 0; i < n; ++i) {
            plan[i] = (i + k) % m->problem.candidates;
            joins[i] = (uint32_t)plan[i];
            if (i < stands) {
                murk_cover_add(&stand, layout, &matrix->row[plan[i]]);
            }
        }
        /* Draw thresholds from the floor upward, some of them all at the
         * floor. */
        murk_multipliers_set_partial_plan(&t, stands > 0 ? &stand : NULL);
        for (size_t i = 0; i < layout->slots; ++i) {
            const uint32_t at = made_up_draw(seed, 42, (uint32_t)i + 1000 * k,
                                             k % 4 == 0   ? 1
                                             : k % 4 == 1 ? 20000
                                                          : MURK_CLEAR + 1);
            threshold[i] = (float)at > t.floor[i] ? (float)at : t.floor[i];
        }
        /* The sum over thresholds and gains bounds the value of the plan. */
        uint64_t sum = murk_multipliers_set(&t, threshold);
        murk_multipliers_gains(&t, joins + stands, n - stands, gain);
        for (size_t i = 0; i < n - stands; ++i) {
            sum += gain[i];
        }
        const uint64_t worth = made_up_value(m, plan, n);
        CHECK(sum >= worth);
        *too_low += (double)sum * .99 < (double)worth;
    }
    free(threshold);
    murk_cover_release(&stand);
    murk_multipliers_release(&t);
    murk_evaluator_release(&evaluator);
    murk_matrix_destroy(matrix);
}

static void test_multipliers(uint32_t seed)
{
    for (size_t mode = 0; mode < MODES; ++mode) {
        int too_low = 0;
        for (uint32_t k = 0; k < 20; ++k) {
            made_up *m = create(seed + k, k, 60, 9, 1);
            set_mode(m, &modes[mode]);
            check_multipliers(m, seed + k, &too_low);
            made_up_destroy(m);
        }
        printf("%s: a bound lower by a hundredth fails %d times of 600\n",
               modes[mode].name, too_low);
        CHECK(too_low > 0);
    }
}

/* The slope that the descent follows is the bound's: a small step down lowers
 * it by so much, as long as nobody else is chosen. */
static void test_slopes(uint32_t seed)
{
    for (size_t mode = 0; mode < MODES; ++mode) {
        made_up *m = made_up_create(seed, 200, 9, .5, 977, 3, 1);
        set_mode(m, &modes[mode]);
        murk_matrix *matrix = matrix_of(m);
        const murk_layout *layout = &matrix->layout;
        murk_evaluator evaluator;
        murk_multipliers t;
        murk_cover stand;
        murk_error err = {0};
        CHECK(murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, 3, 0,
                                  true, &err) == MURK_OK);
        CHECK(murk_multipliers_init(&t, &evaluator, &err) == MURK_OK);
        CHECK(murk_cover_init(&stand, layout, false));
        murk_cover_add(&stand, layout, &matrix->row[0]);
        murk_cover_add(&stand, layout, &matrix->row[1]);
        murk_multipliers_set_partial_plan(&t, &stand);
        float *threshold = calloc(layout->slots, sizeof *threshold);
        float *down = calloc(layout->slots, sizeof *down);
        const uint32_t joins[] = {4, 6};
        const murk_ranked chosen[] = {{0, 4}, {0, 6}};
        double expected = 0;
        uint64_t sum[2], gain[2];
        for (int lower = 0; lower < 2; ++lower) {
            for (size_t i = 0; i < layout->slots; ++i) {
                const uint32_t at = made_up_draw(seed, 43, (uint32_t)i, 60000);
                threshold[i] = (float)at;
                if (at <= t.floor[i] + 1u) {
                    threshold[i] = t.floor[i];
                } else if (lower && down[i] > 0) {
                    threshold[i] -= 1;
                    expected += (double)down[i] * layout->weight[i];
                }
            }
            sum[lower] = murk_multipliers_set(&t, threshold);
            murk_multipliers_gains(&t, joins, 2, gain);
            sum[lower] += gain[0] + gain[1];
            if (!lower) {
                murk_multipliers_subgradient(&t, chosen, 2, down);
            }
        }
        /* Of chances, slopes change by up to 2 / 5535 within the step. */
        CHECK_NEAR((double)sum[0] - (double)sum[1], expected,
                   fabs(expected) * .001 + 2);
        CHECK(expected > 100);
        free(threshold);
        free(down);
        murk_cover_release(&stand);
        murk_multipliers_release(&t);
        murk_evaluator_release(&evaluator);
        murk_matrix_destroy(matrix);
        made_up_destroy(m);
    }
}

static void test_every_rule_in_every_mode(uint32_t seed)
{
    for (size_t mode = 1; mode < MODES; ++mode) {
        tally t = {0};
        for (unsigned kinds = 0; kinds < 1u << KINDS; ++kinds) {
            const int bits = __builtin_popcount(kinds);
            const uint32_t problems = bits <= 1 ? 6 : bits == 2 ? 2 : 1;
            for (uint32_t k = 0; k < problems; ++k) {
                const uint32_t own = seed + 1000 * kinds + k;
                made_up *m = create(own, k + kinds, 60, 9, 1);
                set_mode(m, &modes[mode]);
                made_up_constraints r;
                made_up_constraints_fill(&r, own, kinds, 9);
                const size_t count = kinds & BUDGET && k % 3
                                         ? 0
                                         : 1 + made_up_draw(own, 20, 0, 4);
                try_all_methods(m, &r, own, count, &t);
                made_up_destroy(m);
            }
        }
        printf("%s: %d plans, %d refusals, %d short of the best, %d proven\n",
               modes[mode].name, t.plans, t.refused, t.not_best, t.proven);
        CHECK(t.not_best > 0 && t.proven > 0);
    }
}

/* Plans without constraints at all counts of sensors, with bounds that
 * would be wrong if they were lower by a hundredth. */
static void test_curves(uint32_t seed)
{
    for (size_t mode = 0; mode < MODES; ++mode) {
        int too_low = 0, points = 0;
        for (uint32_t k = 0; k < 16; ++k) {
            /* Problems of several kinds, each for all methods. */
            made_up *m = create(seed + k, k, 80, 10, 2);
            set_mode(m, &modes[mode]);
            for (int method = 0; method < METHODS; ++method) {
                murk_place_desc desc = murk_place_defaults();
                desc.method = (murk_place_method)method;
                desc.count = 4;
                desc.restarts = 3;
                desc.keep_dominated = k % 3 == 0;
                murk_place_result plan = {0};
                murk_error err = {0};
                CHECK(place_any(&plan, m, &desc, true, &err) == MURK_OK);
                /* The optimum by brute force lies between value and upper
                 * bound at every count. */
                for (size_t i = 0; i < plan.curve_points; ++i) {
                    const uint64_t optimum = made_up_optimum(m, i + 1);
                    CHECK(plan.curve[i].upper >= optimum);
                    CHECK(plan.curve[i].value <= optimum);
                    too_low +=
                        (double)plan.curve[i].upper * .99 < (double)optimum;
                    ++points;
                }
                /* The value is that of the set; methods that prove find the
                 * optimum. */
                CHECK(plan.value == made_up_value(m, plan.sensor, plan.count));
                CHECK(method == MURK_PLACE_SPOQ ||
                      method == MURK_PLACE_GREEDY ||
                      (plan.proven_optimal &&
                       plan.value == made_up_optimum(m, 4)));
                /* The whole is the value of full coverage in all layers. */
                uint64_t whole = 0;
                for (size_t i = 0; i < 80; ++i) {
                    whole += (uint64_t)m->weight[i] * MURK_CLEAR *
                             murk_problem_layers(&m->problem);
                }
                CHECK(plan.whole == whole);
                murk_place_release(&plan);
            }
            made_up_destroy(m);
        }
        /* The bounds are tight enough that a hundredth less would be wrong
         * somewhere. */
        printf("%s: bounds lower by a hundredth fail %d times of %d\n",
               modes[mode].name, too_low, points);
        CHECK(too_low > 0);
    }
}

/* Greedy with nothing skipped: the lowest number of those that add most. */
static void plain_greedy(const made_up *m, size_t *plan, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        uint64_t best = 0;
        size_t chosen = SIZE_MAX;
        for (size_t j = 0; j < m->problem.candidates; ++j) {
            bool stands = false;
            for (size_t i = 0; i < k; ++i) {
                stands |= plan[i] == j;
            }
            size_t with[16];
            memcpy(with, plan, k * sizeof *with);
            with[k] = j;
            const uint64_t value = stands ? 0 : made_up_value(m, with, k + 1);
            if (!stands && (chosen == SIZE_MAX || value > best)) {
                best = value;
                chosen = j;
            }
        }
        plan[k] = chosen;
    }
}

static int by_number(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

/* Scans skip many candidates and still find the plan of a plain greedy
 * search. Faint views need the slack of the scans: some candidates gain
 * more beside a plan than alone. */
static void test_scans_against_plain_ones(uint32_t seed)
{
    int grew = 0;
    for (uint32_t k = 0; k < 60; ++k) {
        /* A plan by a greedy search that looks at all candidates. */
        made_up *m = made_up_create(seed + k, 40, 300, .5, 1000, 1 + k % 3, 1);
        set_mode(m, &modes[k % MODES]);
        make_faint(m);
        size_t plan[6];
        plain_greedy(m, plan, 6);
        /* Count candidates that gain more next to the plan than alone. */
        for (size_t j = 0; j < 300; ++j) {
            size_t with[7];
            memcpy(with, plan, sizeof plan);
            with[6] = j;
            grew += made_up_value(m, with, 7) - made_up_value(m, with, 6) >
                    made_up_value(m, &j, 1);
        }
        /* The scans find the same plan, in known and unknown environments. */
        qsort(plan, 6, sizeof *plan, by_number);
        murk_place_desc desc = {
            .method = MURK_PLACE_GREEDY, .count = 6, .restarts = 1};
        for (int known = 0; known < 2; ++known) {
            murk_place_result r = {0};
            murk_error err = {0};
            CHECK(place_any(&r, m, &desc, known, &err) == MURK_OK);
            CHECK(memcmp(r.sensor, plan, sizeof plan) == 0);
            murk_place_release(&r);
        }
        made_up_destroy(m);
    }
    printf("%d gains grew\n", grew);
    CHECK(grew > 0);
}

static void check_same(const murk_place_result *a, const murk_place_result *b)
{
    CHECK(a->count == b->count && a->value == b->value);
    CHECK(memcmp(a->sensor, b->sensor, a->count * sizeof *a->sensor) == 0);
    CHECK(a->upper == b->upper && a->nodes == b->nodes);
    CHECK(a->evaluations == b->evaluations && a->restarts == b->restarts);
}

/* Every set of kernels and every number of threads lead to the same plan. */
static void test_kernels_and_threads_change_nothing(uint32_t seed)
{
    for (uint32_t k = 0; k < 2 * MODES; ++k) {
        murk_place_result first = {0};
        size_t sets = 0;
        for (size_t set = 0; murk_kernels_number(set); ++set, ++sets) {
            /* The first kernel set runs with one thread, the others with
             * three. */
            made_up *m = made_up_create(seed, 700, 60, .12, k < MODES ? 9 : 1,
                                        3, 1 + 2 * (set > 0));
            set_mode(m, &modes[k % MODES]);
            murk_matrix *matrix = matrix_of(m);
            matrix->layout.kernels = murk_kernels_number(set);
            /* Place with these kernels; all later plans must equal the
             * first. */
            murk_place_desc desc = murk_place_defaults();
            desc.count = 4;
            desc.restarts = 30;
            desc.nodes = 200;
            murk_place_result r = {0};
            murk_error err = {0};
            CHECK(murk_place_sensors(&r, &m->problem, matrix, &desc, &err) ==
                  MURK_OK);
            if (set == 0) {
                first = r;
            } else {
                check_same(&first, &r);
                murk_place_release(&r);
            }
            murk_matrix_destroy(matrix);
            made_up_destroy(m);
        }
        CHECK(sets >= 1);
        murk_place_release(&first);
    }
}

/* A target counts in the same worth. */
static void test_targets(uint32_t seed)
{
    for (uint32_t k = 0; k < 24; ++k) {
        made_up *m = create(seed + k, k, 80, 10, 1);
        set_mode(m, &modes[k / 2 % MODES]);
        const size_t aim = 1 + k / 8 % 4;
        murk_place_desc desc = murk_place_defaults();
        desc.count = 10;
        desc.restarts = 3;
        desc.target = made_up_optimum(m, aim);
        murk_place_result r = {0};
        murk_error err = {0};
        CHECK(place_any(&r, m, &desc, true, &err) == MURK_OK);
        size_t fewest = 1;
        while (made_up_optimum(m, fewest) < desc.target) {
            ++fewest;
        }
        CHECK(r.count == fewest && r.fewest == fewest);
        CHECK(r.value >= desc.target);
        murk_place_release(&r);
        made_up_destroy(m);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_covers(seed);
    test_multipliers(seed);
    test_slopes(seed);
    test_every_rule_in_every_mode(seed);
    test_curves(seed);
    test_scans_against_plain_ones(seed);
    test_kernels_and_threads_change_nothing(seed);
    test_targets(seed);
    return check_done();
}
