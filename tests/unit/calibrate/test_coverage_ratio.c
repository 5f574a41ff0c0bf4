/* Coverage as a ratio of sums, its slopes and the parts of its slopes, against
 * differences of sums that depend on a parameter in a known way; and the two
 * maps under unequal weights, by hand. Exact to rounding and to the step of the
 * differences. */
#include "calibrate/coverage_ratio.h"

#include "check.h"

#include <string.h>

#define MAPS    MURK_MAP_PARTS
#define BATCHES 6
#define RUNS    3
#define KEYS    2
#define GROUPS  2

/* The step of central differences: errors of rounding and of the third
 * derivative are both near 1e-10. */
#define STEP 1e-4

/* Sums of batches at parameters x: any smooth functions that differ by map,
 * batch, key and group; what is seen is less than all. */
typedef struct case_of {
    double all[BATCHES * MAPS], all_slope[RUNS * MAPS * KEYS];
    double seen[GROUPS * BATCHES * MAPS];
    double seen_slope[GROUPS * RUNS * MAPS * KEYS];
    murk_coverage_sums sums;
    murk_coverage_mix mix;
} case_of;

static double all_at(size_t b, size_t map, const double x[KEYS])
{
    return (2 + (double)map) * (1 + .1 * (double)b) *
           exp(.3 * x[0] * (1 + (double)map) - .2 * x[1] * sin((double)b));
}

static double seen_at(size_t g, size_t b, size_t map, const double x[KEYS])
{
    const double share = .3 + .1 * (double)g + .05 * (double)map +
                         .04 * cos((double)(b + g)) * x[1] + .1 * x[0];
    return share * all_at(b, map, x);
}

/* The slope by key k of one batch's sum; SIZE_MAX: of all, else of a group. */
static double slope_at(size_t g, size_t b, size_t map, size_t k,
                       const double x[KEYS])
{
    double low[KEYS], high[KEYS];
    memcpy(low, x, sizeof low);
    memcpy(high, x, sizeof high);
    low[k] -= STEP;
    high[k] += STEP;
    const double down =
        g == SIZE_MAX ? all_at(b, map, low) : seen_at(g, b, map, low);
    const double up =
        g == SIZE_MAX ? all_at(b, map, high) : seen_at(g, b, map, high);
    return (up - down) / (2 * STEP);
}

static void make(case_of *c, const murk_map_weights *weights,
                 const double x[KEYS])
{
    /* Sums of each batch: of all power, and of the power that each group
     * sees. */
    double whole[MAPS] = {0};
    memset(c, 0, sizeof *c);
    for (size_t b = 0; b < BATCHES; ++b) {
        const size_t run = b * RUNS / BATCHES;
        for (size_t map = 0; map < MAPS; ++map) {
            c->all[b * MAPS + map] = all_at(b, map, x);
            whole[map] += c->all[b * MAPS + map];
            for (size_t g = 0; g < GROUPS; ++g) {
                c->seen[(g * BATCHES + b) * MAPS + map] = seen_at(g, b, map, x);
            }
            /* Slopes are sums over the batches of a run. */
            for (size_t k = 0; k < KEYS; ++k) {
                const size_t at = (run * MAPS + map) * KEYS + k;
                c->all_slope[at] += slope_at(SIZE_MAX, b, map, k, x);
                for (size_t g = 0; g < GROUPS; ++g) {
                    c->seen_slope[g * RUNS * MAPS * KEYS + at] +=
                        slope_at(g, b, map, k, x);
                }
            }
        }
    }
    /* The case refers to these arrays, and mixes the maps by the weights. */
    c->sums = (murk_coverage_sums){.batches = BATCHES,
                                   .runs = RUNS,
                                   .keys = KEYS,
                                   .all = c->all,
                                   .all_slope = c->all_slope,
                                   .in_view = c->seen,
                                   .in_view_slope = c->seen_slope};
    CHECK(murk_coverage_mix_of(&c->mix, weights, whole));
}

/* Coverage of a group at x, and the parts of runs. */
static double coverage_at(const murk_map_weights *weights, size_t group,
                          const double x[KEYS], double part[RUNS])
{
    static case_of c;
    double value, slope[KEYS], batch[BATCHES];
    make(&c, weights, x);
    murk_coverage_ratio(&value, slope, batch, 1, group, &c.sums, &c.mix);
    for (size_t run = 0; run < RUNS; ++run) {
        part[run] = 0;
    }
    for (size_t b = 0; b < BATCHES; ++b) {
        part[b * RUNS / BATCHES] += batch[b];
    }
    return value;
}

static void check_slopes(const murk_map_weights *weights)
{
    /* Coverage, the slopes, and the parts of the slopes by runs. */
    const double x[KEYS] = {.4, -.7};
    static case_of c;
    for (size_t g = 0; g < GROUPS; ++g) {
        double value, slope[KEYS], part[RUNS * KEYS];
        make(&c, weights, x);
        murk_coverage_ratio(&value, slope, NULL, 1, g, &c.sums, &c.mix);
        murk_coverage_slope_parts(part, KEYS, slope, g, &c.sums, &c.mix);
        for (size_t k = 0; k < KEYS; ++k) {
            /* Each slope is the central difference of the coverage. */
            double low[KEYS], high[KEYS], down[RUNS], up[RUNS], sum = 0;
            memcpy(low, x, sizeof low);
            memcpy(high, x, sizeof high);
            low[k] -= STEP;
            high[k] += STEP;
            const double by = (coverage_at(weights, g, high, up) -
                               coverage_at(weights, g, low, down)) /
                              (2 * STEP);
            CHECK_NEAR(slope[k], by, 1e-8);
            /* The parts are differences of the parts, and add up to the
             * slope. */
            for (size_t run = 0; run < RUNS; ++run) {
                CHECK_NEAR(part[run * KEYS + k],
                           (up[run] - down[run]) / (2 * STEP), 1e-8);
                sum += part[run * KEYS + k];
            }
            CHECK_NEAR(sum, slope[k], 1e-12);
        }
    }
}

static void test_slopes_and_their_parts(void)
{
    const murk_map_weights balanced = {.balanced = true};
    const murk_map_weights unequal = {.surface = 3, .volume = .25};
    const murk_map_weights one = {.surface = 1, .volume = 0};
    check_slopes(&balanced);
    check_slopes(&unequal);
    check_slopes(&one);
}

/* Seen 1 of 2 of surfaces, 6 of 8 of the volume: balanced (1/2 + 3/4) / 2; by
 * 3 and .25, (3 + 1.5) / (6 + 2); an empty map's half goes to the other. */
static void test_unequal_weights(void)
{
    double seen[] = {1, 6}, all[] = {2, 8}, empty[] = {0, 8},
           of_empty[] = {0, 6};
    murk_coverage_sums sums = {
        .batches = 1, .runs = 1, .all = all, .in_view = seen};
    const murk_map_weights balanced = {.balanced = true};
    const murk_map_weights unequal = {.surface = 3, .volume = .25};
    murk_coverage_mix mix;
    double value, none[1];
    CHECK(murk_coverage_mix_of(&mix, &balanced, all));
    murk_coverage_ratio(&value, none, NULL, 1, 0, &sums, &mix);
    CHECK_NEAR(value, .625, 1e-15);
    CHECK(murk_coverage_mix_of(&mix, &unequal, all));
    murk_coverage_ratio(&value, none, NULL, 1, 0, &sums, &mix);
    CHECK_NEAR(value, 4.5 / 8, 1e-15);
    sums.all = empty;
    sums.in_view = of_empty;
    CHECK(murk_coverage_mix_of(&mix, &balanced, empty));
    murk_coverage_ratio(&value, none, NULL, 1, 0, &sums, &mix);
    CHECK_NEAR(value, .75, 1e-15);
}

int main(void)
{
    test_slopes_and_their_parts();
    test_unequal_weights();
    return check_done();
}
