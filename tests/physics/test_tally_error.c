/* The stated standard error of a tally is the true one.
 *
 * In 300 seeds a tally lies within one stated sigma of the value of a run 100
 * times as large as often as a normal distribution does: sqrt(1.01) sigma of
 * the difference, so with probability erf(1 / sqrt(2.02)) = .6803. The counts
 * are binomial; the checks share a 1e-6 false-alarm budget. The seeds are
 * fixed, so the verdict repeats.
 *
 * A closed bright room in thick fog, of two lamps of unequal power: a photon
 * passes a plane to and fro, and comes back to a cell many times.
 *
 * Teeth: the error by passages, which takes them for independent, must be seen
 * to fail; so must an error that is half too large. */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define SEEDS     300
#define PHOTONS   200
#define TRUTH     100
#define TRUE_SEED 100000
#define VALUES    6
#define VARIANTS  2
#define CHECKS    (VALUES * VARIANTS)
#define LAMPS     2

static const murk_domain domain = {{{0, 0, 0}, {4, 3, 2}}, false};

static const murk_tally_desc descs[4] = {{.name = "plane",
                                          .type = MURK_TALLY_PLANE,
                                          .point = {0, 0, 1},
                                          .normal = {0.2, 0, 1},
                                          .bins = {1, 1},
                                          .angle_bins = 1},
                                         {.name = "grid",
                                          .type = MURK_TALLY_GRID,
                                          .box = {{1, 0.5, 0}, {4, 3, 2}},
                                          .size = {2, 2, 2}},
                                         {.name = "ball",
                                          .type = MURK_TALLY_SPHERE,
                                          .center = {1.5, 1.5, 1},
                                          .radius_m = 0.9},
                                         {.name = "halves",
                                          .type = MURK_TALLY_SPHERE,
                                          .center = {3, 2, 1},
                                          .radius_m = 0.8,
                                          .hemispheres = true}};

/* Which cell of which tally each value is. */
static const size_t tally[VALUES] = {0, 0, 1, 1, 2, 3};
static const size_t cell[VALUES] = {0, 1, 0, 5, 0, 1};

typedef struct measured {
    murk_estimate value[VALUES];
    double by_passages; /* error of the plane's forward power, if passages were
                           independent */
} measured;

static measured measure(const murk_transport_world *world, uint64_t photons,
                        uint32_t seed, double least_weight)
{
    /* Trace with four tallies and a ledger. */
    measured out;
    murk_error err = {0};
    murk_tallies *tallies = NULL;
    murk_ledger *ledger = NULL;
    if (murk_tallies_create(&tallies, descs, 4, &domain, LAMPS, 1, 1, INFINITY,
                            &err) ||
        murk_ledger_create(&ledger, world, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    murk_trace trace = murk_trace_defaults();
    trace.world = world;
    trace.seed = seed;
    trace.last = photons;
    trace.tallies = tallies;
    trace.least_weight = least_weight;
    murk_trace_run(&trace, ledger);

    /* Power of a packet of each light. */
    uint64_t dealt[LAMPS];
    double packet_w[LAMPS];
    murk_sources_deal(world->lights, photons, dealt);
    for (size_t c = 0; c < LAMPS; ++c) {
        packet_w[c] =
            murk_sources_channel_power_w(world->lights, c) / (double)dealt[c];
    }
    /* Read the chosen cells, and the error that the plane would have if
     * passages were independent. */
    for (size_t i = 0; i < VALUES; ++i) {
        out.value[i] = murk_tallies_read(tallies, tally[i], 0, cell[i],
                                         ledger->emitted, packet_w);
    }
    out.by_passages = sqrt(out.value[0].value * packet_w[0]);
    murk_ledger_destroy(ledger);
    murk_tallies_destroy(tallies);
    return out;
}

static void test_errors(const murk_transport_world *world, double least_weight,
                        double limit)
{
    const double p = erf(1 / sqrt(2.02));
    const double sigma = sqrt(SEEDS * p * (1 - p));
    const measured truth =
        measure(world, PHOTONS * TRUTH, TRUE_SEED, least_weight);
    double within[VALUES] = {0}, within_passages = 0, within_larger = 0;
    for (uint32_t seed = 1; seed <= SEEDS; ++seed) {
        const measured m = measure(world, PHOTONS, seed, least_weight);
        for (size_t i = 0; i < VALUES; ++i) {
            const double off = fabs(m.value[i].value - truth.value[i].value);
            within[i] += off < m.value[i].standard_error;
            if (i == 0) {
                within_passages += off < m.by_passages;
                within_larger += off < 1.5 * m.value[i].standard_error;
            }
        }
    }
    for (size_t i = 0; i < VALUES; ++i) {
        printf("least weight %g: %s cell %zu: %g of %d within one stated "
               "sigma\n",
               least_weight, descs[tally[i]].name, cell[i], within[i], SEEDS);
        CHECK_WITHIN(limit, within[i], SEEDS * p, sigma);
    }
    printf("plane: %g within one sigma of independent passages, %g within "
           "one and a half\n",
           within_passages, within_larger);
    CHECK(sigmas_off(within_larger, SEEDS * p, sigma) > limit);
    if (least_weight == 1) { /* else a passage is less than a packet */
        CHECK(sigmas_off(within_passages, SEEDS * p, sigma) > limit);
    }
}

int main(void)
{
    /* A room of fog with bright walls, so that a photon scores many times
     * and scores of one photon depend on each other; two lights of
     * different power. */
    const double limit = murk_sidak_limit(1e-6, CHECKS);
    murk_source lamps[LAMPS] = {test_point(murk_vec(1, 1, 1.5)),
                                test_point(murk_vec(3.2, 2, 0.4))};
    lamps[0].power_w.band[0] = 10;
    lamps[1].power_w.band[0] = 3;
    const murk_material wall = test_material(0.9, 0, 0, 0);
    const murk_surface_desc walls =
        test_box(murk_vec(0.01, 0.01, 0.01), murk_vec(3.99, 2.99, 1.99), 0);
    const murk_medium fog = test_medium(1.5, 0.99, 0.5);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(&(test_setup){.domain = domain,
                                                 .lights = lamps,
                                                 .n_lights = LAMPS,
                                                 .surfaces = &walls,
                                                 .n_surfaces = 1,
                                                 .materials = &wall,
                                                 .n_materials = 1,
                                                 .media = &fog,
                                                 .n_media = 1,
                                                 .regions = &region,
                                                 .n_regions = 1});
    /* With photons of full weight, and with weights down to 1e-3. */
    test_errors(&w.world, 1, limit);
    test_errors(&w.world, 1e-3, limit);
    test_world_unmade(&w);
    return check_done();
}
