/* Proofs of optimality where plans nearly tie, against brute force.
 *
 * Searches usually find the best plan before branch and bound begins, so a
 * branch and bound that drops slightly better plans goes unnoticed. Here it
 * begins at plans that are known to be second best, by down to 1e-6 of their
 * value, and must reach the optimum. All modes of combining views and
 * constraints of every kind are tried through the public interface as well, on
 * the same nearly tied problems. Nothing is random but the fixed seeds. */
#include "constrained_plans.h"
#include "placement/exact.h"

/* Photons, of which the first are light and tell nearly equal plans apart. */
#define PHOTONS 48
#define LIGHT   24

/* A light photon weighs 3 to 12, a heavy one so many times as much: a single
 * light photon is 1e-5 to 1e-4 of what a plan is worth. */
#define HEAVY 3000

static const struct mode {
    const char *name;
    murk_combining combining;
    unsigned redundancy;
    uint32_t levels; /* of clarity; 1: all views are clear */
} modes[] = {
    {"threshold", MURK_COMBINE_CLEAREST, 0, 1},
    {"weighted", MURK_COMBINE_CLEAREST, 0, 977},
    {"redundancy 2 of clear views", MURK_COMBINE_CLEAREST, 2, 1},
    {"redundancy 2", MURK_COMBINE_CLEAREST, 2, 50},
    {"redundancy 3", MURK_COMBINE_CLEAREST, 3, 977},
    {"independent, power", MURK_COMBINE_INDEPENDENT, 0, 50},
};
#define MODES (sizeof modes / sizeof modes[0])

/* Candidates in groups of three that see the heavy photons alike, and each the
 * light ones in its own way: a plan of one group more or less differs much,
 * plans of the same groups differ by some light photons. */
static made_up *nearly_tied(uint32_t seed, const struct mode *mode,
                            size_t candidates)
{
    made_up *m =
        made_up_create(seed, PHOTONS, candidates, .45, mode->levels, 4, 1);
    m->problem.combining = mode->combining;
    m->problem.redundancy = mode->redundancy;
    for (size_t i = LIGHT; i < PHOTONS; ++i) {
        m->weight[i] *= HEAVY;
        for (size_t j = 0; j < candidates; ++j) {
            m->clarity[j * PHOTONS + i] = m->clarity[j / 3 * 3 * PHOTONS + i];
        }
    }
    if (seed % 4 == 0) {
        let_half_see_no_more(m, seed);
    }
    return m;
}

/* ---- branch and bound alone, from a plan that is nearly the best ---- */

typedef struct ranked_plan {
    uint64_t value;
    uint32_t set;
} ranked_plan;

static int by_value(const void *a, const void *b)
{
    const ranked_plan *x = a, *y = b;
    if (x->value != y->value) {
        return x->value > y->value ? -1 : 1;
    }
    return (x->set > y->set) - (x->set < y->set);
}

/* All plans of n, the best first. Returns how many there are. */
static size_t rank_plans(const made_up *m, size_t n, ranked_plan *plan)
{
    size_t plans = 0;
    for (uint32_t set = 0; set < 1u << m->problem.candidates; ++set) {
        if ((size_t)__builtin_popcount(set) == n) {
            plan[plans++] = (ranked_plan){made_up_set_value(m, set), set};
        }
    }
    qsort(plan, plans, sizeof *plan, by_value);
    return plans;
}

static size_t members_of(uint32_t set, uint32_t *plan)
{
    size_t n = 0;
    for (uint32_t j = 0; set >> j; ++j) {
        if (set >> j & 1) {
            plan[n++] = j;
        }
    }
    return n;
}

/* Branch and bound from the plan `from`, after `rounds` evaluations of the
 * bound, must find a plan of value `optimum` and prove it. */
static void prove_from(const made_up *m, const ranked_plan *from, size_t rounds,
                       uint64_t optimum)
{
    /* Tighten the bound from the given plan. */
    murk_matrix *matrix = NULL;
    murk_evaluator evaluator;
    murk_bound bound;
    murk_exact exact;
    murk_error err = {0};
    uint32_t plan[MADE_UP_MAX];
    const size_t n = members_of(from->set, plan);
    CHECK(murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err) ==
          MURK_OK);
    CHECK(murk_evaluator_init(&evaluator, &m->problem, matrix, NULL, n, 0,
                              false, &err) == MURK_OK);
    CHECK(murk_bound_init(&bound, &evaluator, &err) == MURK_OK);
    const uint64_t upper =
        murk_bound_tighten(&bound, n, from->value, plan, n, rounds);
    CHECK(upper >= optimum);
    /* The search runs to its end and closes the gap at the optimum. */
    CHECK(murk_exact_search(&exact, &bound, plan, n, n, from->value, upper,
                            1000000, NULL, &err) == MURK_OK);
    CHECK(!exact.is_cut);
    CHECK(exact.value == optimum && exact.upper == optimum);
    /* The plan found has the value that the search reports. */
    uint32_t found = 0;
    for (size_t k = 0; k < n; ++k) {
        found |= 1u << plan[k];
    }
    CHECK(made_up_set_value(m, found) == exact.value);
    murk_bound_release(&bound);
    murk_evaluator_release(&evaluator);
    murk_matrix_destroy(matrix);
}

/* From the plan next to the best, and from several further down. */
static void test_from_plans_that_nearly_tie(uint32_t seed)
{
    static ranked_plan plan[1 << 9];
    for (size_t mode = 0; mode < MODES; ++mode) {
        int close = 0, starts = 0;
        double closest = 1;
        for (uint32_t k = 0; k < 30; ++k) {
            made_up *m = nearly_tied(seed + k, &modes[mode], 9);
            const size_t plans = rank_plans(m, 2 + k % 3, plan);
            const uint64_t optimum = plan[0].value;
            size_t next = 0;
            while (next < plans && plan[next].value == optimum) {
                ++next;
            }
            for (size_t at = next; at < plans && at < next + 9; at += 4) {
                const double gap = 1 - (double)plan[at].value / (double)optimum;
                close += gap < .002;
                closest = gap < closest ? gap : closest;
                ++starts;
                prove_from(m, &plan[at], at == next ? 0 : 20, optimum);
            }
            made_up_destroy(m);
        }
        printf("%s: %d of %d starts within .2 %% of the optimum, the closest "
               "%.1e\n",
               modes[mode].name, close, starts, closest);
        CHECK(close > 20); /* or the problems do not tie nearly enough */
    }
}

/* ---- everything, through the public interface ---- */

/* Plans under every kind of constraint, alone and in pairs. */
static void test_every_constraint(uint32_t seed)
{
    for (size_t mode = 0; mode < MODES; ++mode) {
        tally t = {0};
        for (unsigned kinds = 0; kinds < 1u << KINDS; ++kinds) {
            const int bits = __builtin_popcount(kinds);
            const uint32_t problems = bits <= 1 ? 3 : bits == 2 ? 1 : 0;
            for (uint32_t k = 0; k < problems; ++k) {
                const uint32_t own = seed + 1000 * kinds + k;
                made_up *m = nearly_tied(own, &modes[mode], 9);
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

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_from_plans_that_nearly_tie(seed);
    test_every_constraint(seed);
    return check_done();
}
