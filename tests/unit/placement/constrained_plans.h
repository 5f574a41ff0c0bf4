/* Plans under made-up constraints, made by every method and compared with brute
 * force: each method, known and unknown environment, with presolve and
 * without. */
#ifndef MURK_TESTS_CONSTRAINED_PLANS_H
#define MURK_TESTS_CONSTRAINED_PLANS_H

#include "check.h"
#include "made_up_rules.h"

#include <math.h>

#define MATRIX_MAX ((uint64_t)1 << 32)
#define METHODS    4

typedef struct tally {
    int plans, refused, not_best, proven;
} tally;

static murk_status place_any(murk_place_result *out, const made_up *m,
                             const murk_place_desc *desc, bool known,
                             murk_error *err)
{
    if (!known) {
        return murk_place_sensors(out, &m->problem, NULL, desc, err);
    }
    murk_matrix *matrix = NULL;
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, err) == MURK_OK);
    const murk_status status =
        murk_place_sensors(out, &m->problem, matrix, desc, err);
    murk_matrix_destroy(matrix);
    return status;
}

static double share_promised(const char *guarantee, size_t n)
{
    if (strcmp(guarantee, "none") == 0) {
        return 0;
    }
    if (strcmp(guarantee, "1 - (1 - 1/n)^n") == 0) {
        return 1 - pow(1 - 1 / (double)n, (double)n);
    }
    if (strcmp(guarantee, ".405") == 0) {
        return .405;
    }
    int k = 0;
    CHECK(sscanf(guarantee, "1/%d", &k) == 1 && k >= 2 && k <= 15);
    return 1 / (double)k;
}

/* No other place for one sensor, and with a budget no further sensor, is worth
 * more. */
static void check_certificate(const made_up *m, const made_up_constraints *r,
                              const murk_place_result *plan, size_t count)
{
    const uint32_t set = made_up_set(plan);
    for (size_t i = 0; i < r->candidates; ++i) {
        for (size_t j = 0; j < r->candidates; ++j) {
            const uint32_t moved = (set & ~(1u << i)) | 1u << j;
            const size_t n = (size_t)__builtin_popcount(moved);
            if (set >> i & 1 && n == plan->count && made_up_keeps(r, moved)) {
                CHECK(made_up_set_value(m, moved) <= plan->value);
            }
        }
        const uint32_t more = set | 1u << i;
        if (r->kinds & BUDGET && made_up_keeps(r, more) &&
            (count == 0 || plan->count < count)) {
            CHECK(made_up_set_value(m, more) <= plan->value);
        }
    }
}

static void check_curve(const made_up_constraints *r,
                        const murk_place_result *plan, const uint64_t *best)
{
    CHECK((plan->curve_points == 0) == ((r->kinds & BUDGET) != 0));
    for (size_t k = 0; k < plan->curve_points; ++k) {
        const murk_curve_point *at = &plan->curve[k];
        CHECK(at->count == plan->count - plan->curve_points + 1 + k);
        CHECK(best[at->count] != UINT64_MAX);
        CHECK(at->value <= best[at->count] && at->upper >= best[at->count]);
    }
    if (plan->curve_points > 0) {
        const size_t before = plan->count - plan->curve_points;
        CHECK(before == 0 || best[before] == UINT64_MAX);
    }
}

static void check_plan(const made_up *m, const made_up_constraints *r,
                       const murk_place_desc *desc, bool known,
                       const murk_place_result *plan, const uint64_t *best,
                       tally *t)
{
    /* The plan meets the constraints, and the value is that of the set. */
    const uint64_t optimum = made_up_ruled_optimum(r, best, desc->count);
    const uint32_t set = made_up_set(plan);
    CHECK(made_up_keeps(r, set));
    CHECK(r->kinds & BUDGET ? desc->count == 0 || plan->count <= desc->count
                            : plan->count == desc->count);
    CHECK(plan->value == made_up_set_value(m, set));
    /* The optimum lies between value and upper bound, and the promised share of
     * the optimum is reached. */
    CHECK(plan->value <= optimum);
    CHECK(plan->upper >= optimum);
    CHECK(!plan->proven_optimal || plan->value == optimum);
    CHECK((double)(plan->value + made_up_rounding(m)) >=
          share_promised(plan->guarantee, plan->count) * (double)optimum *
              (1 - 1e-15));
    check_curve(r, plan, best);
    /* The cost is the sum over all sensors of the plan. */
    uint64_t cost = 0;
    for (size_t k = 0; k < plan->count && r->kinds & BUDGET; ++k) {
        cost += (uint64_t)r->cost[plan->sensor[k]];
    }
    CHECK(plan->cost == cost);
    /* Methods that prove find the optimum in a known environment, and the best
     * plan has no better neighbour. */
    const bool proves =
        desc->method == MURK_PLACE_BEST || desc->method == MURK_PLACE_EXACT;
    if (known && proves) {
        CHECK(plan->value == optimum && plan->proven_optimal);
    }
    if (desc->method == MURK_PLACE_BEST) {
        check_certificate(m, r, plan, desc->count);
    }
    /* Count plans for the checks of the caller. */
    ++t->plans;
    t->not_best += plan->value < optimum;
    t->proven += plan->proven_optimal;
}

static void try_all_methods(const made_up *m, const made_up_constraints *r,
                            uint32_t seed, size_t count, tally *t)
{
    uint64_t best[MADE_UP_MAX + 1];
    made_up_ruled_optima(m, r, best);
    const bool is_possible =
        made_up_ruled_optimum(r, best, count) != UINT64_MAX;
    murk_place_result first[METHODS] = {{0}};
    for (int direction = 0; direction < 3 * METHODS; ++direction) {
        const int method = direction % METHODS;
        const bool known = direction < 2 * METHODS;
        murk_place_desc desc = murk_place_defaults();
        desc.method = (murk_place_method)method;
        desc.count = count;
        desc.restarts = 3;
        desc.seed = seed;
        desc.constraints = &r->constraints;
        desc.keep_dominated = direction >= METHODS;
        desc.with_curve = seed % 4 < 2;
        if (!known && method == MURK_PLACE_EXACT) {
            continue;
        }
        murk_error err = {0};
        murk_place_result plan = {0};
        const murk_status status = place_any(&plan, m, &desc, known, &err);
        CHECK((status == MURK_OK) == is_possible);
        if (status) {
            CHECK(err.text[0] != 0 && plan.sensor == NULL);
            CHECK(!is_possible || err.text[0] == 0); /* show the text */
            ++t->refused;
            continue;
        }
        if (desc.with_curve) {
            check_plan(m, r, &desc, known, &plan, best, t);
        } else {
            murk_place_desc as_if = desc;
            CHECK(plan.curve_points == 0);
            plan.curve_points = r->kinds & BUDGET ? 0 : 1;
            murk_curve_point point = {plan.count, plan.value, plan.upper};
            murk_curve_point *none = plan.curve;
            plan.curve = &point;
            const size_t fewer = plan.count - 1;
            const uint64_t held = best[fewer];
            best[fewer] = UINT64_MAX;
            check_plan(m, r, &as_if, known, &plan, best, t);
            best[fewer] = held;
            plan.curve = none;
        }
        /* Presolve is for speed; SPOQ and greedy do not even notice it, nor
         * whether the environment is known. */
        if (direction < METHODS) {
            first[method] = plan;
            continue;
        }
        if (method == MURK_PLACE_SPOQ || method == MURK_PLACE_GREEDY) {
            CHECK(made_up_set(&plan) == made_up_set(&first[method]));
        }
        murk_place_release(&plan);
    }
    for (int method = 0; method < METHODS; ++method) {
        murk_place_release(&first[method]);
    }
}

/* The last half of the candidates see what the first half do, or less: each is
 * dominated, if the rules let it be. */
static void let_half_see_no_more(made_up *m, uint32_t seed)
{
    const size_t n = m->problem.photons, half = m->problem.candidates / 2;
    for (uint32_t j = 0; j < half; ++j) {
        const uint32_t thinning = made_up_draw(seed, 30, j, 3);
        for (size_t i = 0; i < n; ++i) {
            m->clarity[(half + j) * n + i] =
                thinning == 0 || i % (thinning + 1) ? m->clarity[j * n + i] : 0;
        }
    }
}

#endif
