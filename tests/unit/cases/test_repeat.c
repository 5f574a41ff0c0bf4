/* What repeated runs say, by hand and in a world small enough to enumerate.
 *
 * The world: CELLS cells of known chances, PHOTONS photons a map, plans that
 * each see a set of cells. All counts of photons by cell are enumerated, so
 * the mean of the best plan's coverage of its own sample is known exactly.
 *
 * 2 z-tests share a chance of 1e-6 of a false alarm per seed (Sidak); the seed
 * is fixed, so the verdict repeats. */
#include "cases/repeat.h"

#include "base/rng.h"
#include "base/stats.h"
#include "check.h"

#define CHECKS  2
#define BUDGET  1e-6
#define CELLS   4
#define PLANS   4
#define PHOTONS 20
#define RUNS    12
#define WORLDS  4000

static const double chance[CELLS] = {0.4, 0.3, 0.2, 0.1};
static const bool sees[PLANS][CELLS] = {{true, false, false, true},
                                        {false, true, true, false},
                                        {true, false, false, false},
                                        {false, true, false, true}};

static double covered(int plan, const int count[CELLS])
{
    int seen = 0;
    for (int c = 0; c < CELLS; ++c) {
        seen += sees[plan][c] ? count[c] : 0;
    }
    return (double)seen / PHOTONS;
}

static int best_of(const int count[CELLS])
{
    int best = 0;
    for (int p = 1; p < PLANS; ++p) {
        best = covered(p, count) > covered(best, count) ? p : best;
    }
    return best;
}

static double truth(int plan)
{
    double sum = 0;
    for (int c = 0; c < CELLS; ++c) {
        sum += sees[plan][c] ? chance[c] : 0;
    }
    return sum;
}

/* Over all samples: the mean coverage of their best plan, on the sample and in
 * truth. */
static void enumerate(double *upper, double *true_coverage)
{
    *upper = *true_coverage = 0;
    double whole = 0;
    for (int a = 0; a <= PHOTONS; ++a) {
        for (int b = 0; a + b <= PHOTONS; ++b) {
            for (int c = 0; a + b + c <= PHOTONS; ++c) {
                const int n[CELLS] = {a, b, c, PHOTONS - a - b - c};
                double log_p = lgamma(PHOTONS + 1);
                for (int k = 0; k < CELLS; ++k) {
                    log_p += n[k] * log(chance[k]) - lgamma(n[k] + 1);
                }
                const int best = best_of(n);
                *upper += exp(log_p) * covered(best, n);
                *true_coverage += exp(log_p) * truth(best);
                whole += exp(log_p);
            }
        }
    }
    CHECK_NEAR(whole, 1, 1e-12);
}

static void sample(int count[CELLS], uint64_t world, uint32_t map)
{
    for (int c = 0; c < CELLS; ++c) {
        count[c] = 0;
    }
    for (uint32_t i = 0; i < PHOTONS; ++i) {
        double u = murk_random(9, MURK_TEST, world, map, i).u[0];
        int c = 0;
        while (c < CELLS - 1 && u >= chance[c]) {
            u -= chance[c++];
        }
        ++count[c];
    }
}

/* The runs of one world; held_out false: the first plan is taken at the word of
 * its own sample. Returns the first plan. */
static int run_all(murk_repeat_run run[RUNS], uint64_t world, bool held_out)
{
    int first = 0;
    for (uint32_t k = 0; k < RUNS; ++k) {
        int own[CELLS], other[CELLS];
        sample(own, world, 2 * k);
        sample(other, world, 2 * k + 1);
        const int best = best_of(own);
        first = k == 0 ? best : first;
        run[k] = (murk_repeat_run){
            .seed = k,
            .sensors = 1,
            .in_sample = covered(best, own),
            .upper = covered(best, own),
            .held_out = {covered(best, other), 0.1},
            .plan = {covered(first, k == 0 && held_out ? other : own), 0.1}};
    }
    return first;
}

/* The gap is right in the mean, and its upper end holds the distance from the
 * plan to the best there is, which is what it is for. */
static void test_gap(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    double upper, mean_truth, best = 0;
    enumerate(&upper, &mean_truth);
    for (int p = 0; p < PLANS; ++p) {
        best = fmax(best, truth(p));
    }
    double sum = 0, squares = 0, fooled = 0;
    int holds = 0;
    for (uint64_t w = 0; w < WORLDS; ++w) {
        murk_repeat_run run[RUNS];
        murk_repeat_summary s = {0};
        const murk_repeat repeat = {
            .run = run, .runs = RUNS, .asked = RUNS, .has_gap = true};
        const int plan = run_all(run, w, true);
        CHECK(!murk_repeat_sum_up(&s, &repeat, NULL));
        const double off = s.gap.value - (upper - mean_truth);
        sum += off;
        squares += off * off;
        holds += s.gap.upper >= best - truth(plan);
        run_all(run, w, false);
        CHECK(!murk_repeat_sum_up(&s, &repeat, NULL));
        fooled += s.gap.value - (upper - mean_truth);
    }
    const double sigma = sqrt(squares / WORLDS / WORLDS);
    CHECK_WITHIN(limit, sum / WORLDS, 0, sigma);
    CHECK((double)holds / WORLDS >=
          0.975 - limit * sqrt(0.975 * 0.025 / WORLDS));
    /* Teeth: the first plan at the word of the map that chose it. */
    CHECK(sigmas_off(fooled / WORLDS, 0, sigma) > 2 * limit);
}

/* Differences that are normal, few of them: the interval holds their mean 95
 * times in a hundred. */
static void test_interval(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    int holds = 0, holds_two_thirds = 0;
    for (uint64_t w = 0; w < WORLDS; ++w) {
        murk_repeat_run run[4] = {{.seed = 0}};
        for (uint32_t k = 0; k < 4; ++k) {
            const murk_random4 r = murk_random(10, MURK_TEST, w, k, 0);
            const double normal =
                sqrt(-2 * log(r.u[0])) * cos(2 * MURK_PI * r.u[1]);
            run[k].upper = 0.8 + 0.01 * normal;
            run[k].plan.value = 0.7;
        }
        murk_repeat_summary s = {0};
        const murk_repeat repeat = {
            .run = run, .runs = 4, .asked = 4, .has_gap = true};
        CHECK(!murk_repeat_sum_up(&s, &repeat, NULL));
        const double off = fabs(s.gap.value - 0.1);
        holds += s.gap.lower <= 0.1 && 0.1 <= s.gap.upper;
        holds_two_thirds += off <= (s.gap.upper - s.gap.value) * 1.96 / 3.18;
    }
    const double sigma = sqrt(0.95 * 0.05 / WORLDS);
    CHECK_WITHIN(limit, (double)holds / WORLDS, 0.95, sigma);
    /* Teeth: the normal's quantile in place of Student's. */
    CHECK(sigmas_off((double)holds_two_thirds / WORLDS, 0.95, sigma) >
          2 * limit);
}

/* Four runs worked out by hand: differences .2 .1 .1 .2, so mean .15, standard
 * error sqrt(.01 / 12), t of 3 degrees 3.182. */
static void test_by_hand(void)
{
    const murk_estimate none = {NAN, NAN};
    murk_repeat_run run[4] = {{.seed = 7,
                               .sensors = 2,
                               .in_sample = .9,
                               .upper = .9,
                               .held_out = {.7, .1},
                               .plan = {.7, .1}},
                              {.seed = 8,
                               .sensors = 3,
                               .in_sample = .8,
                               .upper = .9,
                               .held_out = {.75, .1},
                               .plan = {.8, .1}},
                              {.seed = 9,
                               .sensors = 2,
                               .in_sample = .7,
                               .upper = .8,
                               .held_out = {.6, .1},
                               .plan = {.7, .1}},
                              {.seed = 10,
                               .sensors = 2,
                               .in_sample = .8,
                               .upper = 1,
                               .held_out = {.65, .1},
                               .plan = {.8, .1}}};
    murk_repeat r = {.run = run, .runs = 4, .asked = 9, .has_gap = true};
    murk_repeat_summary s = {0};
    CHECK(!murk_repeat_sum_up(&s, &r, NULL));
    CHECK_NEAR(s.in_sample.median, .8, 1e-15);
    CHECK(s.in_sample.min == .7 && s.in_sample.max == .9);
    CHECK_NEAR(s.held_out.median, .675, 1e-15);
    CHECK_NEAR(s.upper.median, .9, 1e-15);
    CHECK(s.sensors.median == 2 && s.sensors.max == 3);
    CHECK(s.best == 1);
    CHECK_NEAR(s.plan.value, .75, 1e-15);
    CHECK_NEAR(s.upper_mean.value, .9, 1e-15);
    const double half = 3.182446 * sqrt(.01 / 12);
    CHECK(s.gap.runs == 4);
    CHECK_NEAR(s.gap.value, .15, 1e-15);
    CHECK_NEAR(s.gap.lower, .15 - half, 1e-6);
    CHECK_NEAR(s.gap.upper, .15 + half, 1e-6);

    r.runs = 1; /* one run: a value, no limits */
    CHECK(!murk_repeat_sum_up(&s, &r, NULL));
    CHECK_NEAR(s.gap.value, .2, 1e-15);
    CHECK(isnan(s.gap.lower) && isnan(s.gap.upper));
    CHECK(s.in_sample.median == .9);

    r.runs = 4; /* a target: no gap, and how many meet it */
    r.target = .65;
    r.has_gap = false;
    CHECK(!murk_repeat_sum_up(&s, &r, NULL));
    CHECK(s.gap.runs == 0 && isnan(s.gap.lower));
    CHECK(s.met == 3);

    r.has_gap = true;
    r.target = 0; /* nothing held out: the first run's map has no second */
    for (int i = 0; i < 4; ++i) {
        run[i].held_out = none;
    }
    run[0].plan = none;
    CHECK(!murk_repeat_sum_up(&s, &r, NULL));
    CHECK(isnan(s.held_out.median) && s.best == 4);
    CHECK(s.gap.runs == 3);
    CHECK_NEAR(s.gap.value, .4 / 3, 1e-15);
}

int main(void)
{
    test_by_hand();
    test_gap();
    test_interval();
    return check_done();
}
