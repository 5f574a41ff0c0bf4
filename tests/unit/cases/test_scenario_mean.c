/* Means over conditions by unequal weights: of the total, of each map, sensor,
 * region and number of sensors, against sums by hand. A mean by equal weights
 * is off by a tenth and more here. */
#include "cases/scenario_mean.h"

#include "check.h"

#include <math.h>

#define SENSORS 2
#define REGIONS 2

/* Weights 3 and 1, and a condition that has no say. */
static const double weight[] = {3, 0, 1};

static void test_means_by_sensor(bool are_independent)
{
    double covers[3][SENSORS] = {{.5, .25}, {.9, .9}, {.1, .05}};
    double only[3][SENSORS] = {{.4, .2}, {.9, .9}, {0, .08}};
    double seen[3][SENSORS] = {{.7, .3}, {.9, .9}, {.2, .1}};
    murk_region_coverage region[3][REGIONS] = {
        {{11, {.6, .02}}, {3, {.2, .03}}},
        {{5, {.9, .1}}, {7, {.8, .1}}},
        {{2, {.4, .06}}, {0, {NAN, NAN}}}}; /* the last is empty there */
    murk_coverage_result of[3] = {{.total = {.7, .01}, .sum_of_views = .75},
                                  {.total = {.9, .5}, .sum_of_views = 1.8},
                                  {.total = {.2, .04}, .sum_of_views = .15}};
    for (size_t c = 0; c < 3; ++c) {
        of[c].covers = covers[c];
        of[c].only_it_covers = only[c];
        of[c].seen_by_at_least = seen[c];
        of[c].region = region[c];
        of[c].surface = of[c].volume = of[c].total;
    }
    of[2].volume = (murk_estimate){NAN, NAN}; /* an empty map */
    of[0].map[0] = (murk_map_share){40, .5, .01};
    of[1].map[0] = (murk_map_share){7, 1, .5};
    of[2].map[0] = (murk_map_share){20, 1, .04};
    of[0].map[1] = (murk_map_share){9, .25, .08};
    of[1].map[1] = (murk_map_share){7, 1, .5};
    of[2].map[1] = (murk_map_share){4, .75, .32};
    murk_coverage_result mean = {0};
    murk_error err = {0};
    CHECK(murk_scenario_mean_coverage(&mean, of, weight, 3, SENSORS, REGIONS,
                                      are_independent, &err) == MURK_OK);
    CHECK_NEAR(mean.total.value, (3 * .7 + .2) / 4, 1e-15);
    CHECK_NEAR(mean.total.standard_error,
               are_independent ? sqrt(.03 * .03 + .04 * .04) / 4
                               : (.03 + .04) / 4,
               1e-15);
    CHECK_NEAR(mean.surface.value, (3 * .7 + .2) / 4, 1e-15);
    CHECK_NEAR(mean.volume.value, .7, 1e-15);
    CHECK_NEAR(mean.sum_of_views, (3 * .75 + .15) / 4, 1e-15);
    CHECK(mean.map[0].photons == 60);
    CHECK_NEAR(mean.map[0].weight, (3 * .5 + 1) / 4, 1e-15);
    CHECK_NEAR(mean.map[0].standard_error, mean.total.standard_error, 1e-15);
    CHECK(mean.map[1].photons == 13);
    CHECK_NEAR(mean.map[1].weight, (3 * .25 + .75) / 4, 1e-15);
    CHECK_NEAR(mean.map[1].standard_error,
               are_independent ? sqrt(.24 * .24 + .32 * .32) / 4
                               : (.24 + .32) / 4,
               1e-15);
    CHECK(mean.region[0].photons == 13 && mean.region[1].photons == 3);
    CHECK_NEAR(mean.region[0].coverage.value, (3 * .6 + .4) / 4, 1e-15);
    CHECK_NEAR(mean.region[0].coverage.standard_error,
               are_independent ? sqrt(.06 * .06 + .06 * .06) / 4
                               : (.06 + .06) / 4,
               1e-15);
    CHECK_NEAR(mean.region[1].coverage.value, .2, 1e-15);
    CHECK_NEAR(mean.region[1].coverage.standard_error, .03, 1e-15);
    CHECK_NEAR(mean.covers[0], (3 * .5 + .1) / 4, 1e-15);
    CHECK_NEAR(mean.covers[1], (3 * .25 + .05) / 4, 1e-15);
    CHECK_NEAR(mean.only_it_covers[0], 3 * .4 / 4, 1e-15);
    CHECK_NEAR(mean.only_it_covers[1], (3 * .2 + .08) / 4, 1e-15);
    CHECK_NEAR(mean.seen_by_at_least[0], (3 * .7 + .2) / 4, 1e-15);
    CHECK_NEAR(mean.seen_by_at_least[1], (3 * .3 + .1) / 4, 1e-15);
    murk_coverage_result_release(&mean);
}

int main(void)
{
    test_means_by_sensor(true);
    test_means_by_sensor(false);
    return check_done();
}
