/* Sequences of plans with few moves, or moves that cost something, against the
 * best sequence of all by dynamic programming over all plans: no sequence has
 * more than the sum of the bounds of its steps alone. The sum of the bounds of
 * each step under the rule, from the plan that happens to be before, would be
 * no bound; nor would a sum that left out half a percent. Made-up problems of
 * fixed seeds. */
#include "placement/place.h"

#include "check.h"
#include "made_up_rules.h"

#define MATRIX_MAX ((uint64_t)1 << 32)
#define CANDIDATES 8
#define SENSORS    3
#define PHOTONS    40
#define STEPS      4
#define PLANS      56 /* 8 choose 3 */
#define PROBLEMS   60

typedef struct made_sequence {
    made_up *step[STEPS];
    size_t moves_max;
    double cost;
    uint32_t plan[PLANS];
    double value[STEPS][PLANS]; /* coverage as a share */
} made_sequence;

static double whole_of(const made_up *m)
{
    double sum = 0;
    for (size_t i = 0; i < PHOTONS; ++i) {
        sum += m->weight[i];
    }
    return sum * MURK_CLEAR;
}

/* Each step sees the photons of the step before, but for some. */
static void make(made_sequence *out, uint32_t seed)
{
    size_t n = 0;
    for (uint32_t set = 0; set < 1u << CANDIDATES; ++set) {
        if (__builtin_popcount(set) == SENSORS) {
            out->plan[n++] = set;
        }
    }
    CHECK(n == PLANS);
    /* The photons and clarities of each step, and the value of all plans. */
    for (uint32_t t = 0; t < STEPS; ++t) {
        made_up *m =
            made_up_create(seed + t, PHOTONS, CANDIDATES, .3, 40, 3, 1);
        const made_up *before = t > 0 ? out->step[t - 1] : NULL;
        for (size_t i = 0; before && i < PHOTONS; ++i) {
            const bool stays = made_up_draw(seed, 40 + t, (uint32_t)i, 3) > 0;
            m->weight[i] = stays ? before->weight[i] : m->weight[i];
            for (size_t j = 0; stays && j < CANDIDATES; ++j) {
                m->clarity[j * PHOTONS + i] = before->clarity[j * PHOTONS + i];
            }
        }
        out->step[t] = m;
        for (size_t k = 0; k < PLANS; ++k) {
            out->value[t][k] =
                (double)made_up_set_value(m, out->plan[k]) / whole_of(m);
        }
    }
    out->moves_max = seed % 2 ? 1 + seed % 2 : SIZE_MAX;
    out->cost = seed % 3 ? .01 * (1 + seed % 5) : 0;
}

static size_t moves_between(uint32_t from, uint32_t to)
{
    return (size_t)__builtin_popcount(to & ~from);
}

/* The best sequence: for each plan of a step, the best sequence that ends
 * there. */
static double best_sequence(const made_sequence *s)
{
    double best[PLANS], next[PLANS], largest = 0;
    memcpy(best, s->value[0], sizeof best);
    for (size_t t = 1; t < STEPS; ++t) {
        for (size_t k = 0; k < PLANS; ++k) {
            next[k] = -INFINITY;
            for (size_t i = 0; i < PLANS; ++i) {
                const size_t moves = moves_between(s->plan[i], s->plan[k]);
                const double so_far =
                    best[i] + s->value[t][k] - s->cost * (double)moves;
                next[k] =
                    moves <= s->moves_max ? fmax(next[k], so_far) : next[k];
            }
        }
        memcpy(best, next, sizeof best);
    }
    for (size_t k = 0; k < PLANS; ++k) {
        largest = fmax(largest, best[k]);
    }
    return largest;
}

/* The plan of a step; start NULL: none, and no rule. */
static murk_place_result place(const made_sequence *s, size_t t,
                               const uint32_t *start, bool has_rule)
{
    const made_up *m = s->step[t];
    const murk_constraints rules = {.start = start,
                                    .start_count = SENSORS,
                                    .moves_max = s->moves_max,
                                    .move_cost = s->cost};
    murk_place_desc desc = murk_place_defaults();
    murk_place_result plan = {0};
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    desc.count = SENSORS;
    desc.start_plan = start;
    desc.start_size = start ? SENSORS : 0;
    desc.constraints = has_rule ? &rules : NULL;
    CHECK(!murk_matrix_create(&matrix, &m->problem, MATRIX_MAX, &err));
    CHECK(!murk_place_sensors(&plan, &m->problem, matrix, &desc, &err));
    murk_matrix_destroy(matrix);
    return plan;
}

typedef struct sums {
    double reached, free_upper, ruled_upper;
} sums;

static sums follow(const made_sequence *s)
{
    sums out = {0};
    uint32_t start[SENSORS], before = 0;
    for (size_t t = 0; t < STEPS; ++t) {
        const double whole = whole_of(s->step[t]);
        murk_place_result free_plan = place(s, t, t ? start : NULL, false);
        murk_place_result plan = place(s, t, t ? start : NULL, t > 0);
        const uint32_t set = made_up_set(&plan);
        CHECK(t == 0 || plan.moves == moves_between(before, set));
        out.reached +=
            (double)plan.value / whole - (t ? s->cost * (double)plan.moves : 0);
        out.free_upper += (double)free_plan.upper / whole;
        out.ruled_upper += (double)plan.upper / whole;
        for (size_t k = 0; k < SENSORS; ++k) {
            start[k] = (uint32_t)plan.sensor[k];
        }
        before = set;
        murk_place_release(&free_plan);
        murk_place_release(&plan);
    }
    return out;
}

int main(void)
{
    int behind = 0, wrong = 0, too_low = 0;
    for (uint32_t k = 0; k < PROBLEMS; ++k) {
        made_sequence s = {.moves_max = 0};
        make(&s, 500 + 10 * k + k % 7);
        const double best = best_sequence(&s);
        const sums sum = follow(&s);
        /* Costs are rounded to a multiple of the grain. */
        const double rounding = 1e-5;
        CHECK(sum.reached <= best + rounding);
        CHECK(best <= sum.free_upper + rounding);
        behind += sum.reached < best - 1e-3;
        wrong += sum.ruled_upper < best - 1e-3;
        too_low += .995 * sum.free_upper < best;
        for (size_t t = 0; t < STEPS; ++t) {
            made_up_destroy(s.step[t]);
        }
    }
    printf("%d of %d sequences are behind the best; the bounds under the rule "
           "are too low for %d, and for %d those of the steps less .5 %%\n",
           behind, PROBLEMS, wrong, too_low);
    CHECK(behind > PROBLEMS / 4 && wrong > PROBLEMS / 10 && too_low > 0);
    return check_done();
}
