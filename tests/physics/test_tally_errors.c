/* The stated standard error of tallies is right: over many seeds, values lie
 * within one of them of the truth as often as normal numbers do, and their
 * squared distances in it have mean 1.
 *
 * Fog under two lamps of unlike power, in which one photon comes to a place
 * again and again: planes, bins of them by place and angle, cells of a grid,
 * spheres, hemispheres, each met by a hundred photons a run or more, since few
 * of them are skew. The truth is that of other seeds, TRUTH_RUNS times as many
 * photons as in all the runs that are tested: its own error adds 1 / (RUNS
 * TRUTH_RUNS) to the squares.
 *
 * A run is one trial of each quantity: binomial counts and chi-squares over
 * RUNS runs, as normal z, share a 1e-6 chance of a false alarm (Sidak). Teeth:
 * an error that takes a photon's events for independent ones is 1.7 times too
 * small in dense fog; such an error must be refused. */
#include "base/stats.h"
#include "check.h"
#include "transport/tallies.h"
#include "worlds.h"

#include <stdlib.h>

#define RUNS       200
#define PHOTONS    16384
#define TRUTH_RUNS 2

#define WITHIN_ONE 0.682689492137
#define TOO_SMALL  1.7

typedef struct quantity {
    const char *name;
    size_t tally, cell;
} quantity;

static const quantity quantities[] = {
    {"plane, forward", 0, 0},
    {"plane, backward", 0, 1},
    {"plane in bins, steep", 1, 1 + 2},
    {"plane in bins, flat", 1, 1},
    {"cell near a lamp", 2, 0},
    {"cell far from it", 2, 7},
    {"sphere", 3, 0},
    {"sphere, up", 4, 0},
    {"sphere, down", 4, 1},
};

#define QUANTITIES (sizeof quantities / sizeof quantities[0])
#define Z_TESTS    (2 * QUANTITIES)

static const murk_tally_desc descs[] = {
    {.name = "plane",
     .where = "plane",
     .type = MURK_TALLY_PLANE,
     .point = {0, 0, 1.2},
     .normal = {0, 0, 1},
     .bins = {1, 1},
     .angle_bins = 1},
    {.name = "bins",
     .where = "bins",
     .type = MURK_TALLY_PLANE,
     .point = {0, 0, 1.2},
     .normal = {.1, 0, 1},
     .bins = {2, 1},
     .angle_bins = 2},
    {.name = "grid",
     .where = "grid",
     .type = MURK_TALLY_GRID,
     .box = {{0, 0, 0}, {4, 3, 2}},
     .size = {2, 2, 2}},
    {.name = "sphere",
     .where = "sphere",
     .type = MURK_TALLY_SPHERE,
     .center = {2, 1.5, 1},
     .radius_m = .6},
    {.name = "hemispheres",
     .where = "hemispheres",
     .type = MURK_TALLY_SPHERE,
     .center = {2.5, 1.5, 1.2},
     .radius_m = .5,
     .hemispheres = true},
};

#define TALLIES  (sizeof descs / sizeof descs[0])
#define CHANNELS 2

static void must(murk_status status, const murk_error *err)
{
    if (status) {
        printf("%s: %s\n", err->where, err->text);
        exit(1);
    }
}

/* All quantities from `photons` photons of one seed. */
static void measured(const murk_world *world, uint64_t photons, uint32_t seed,
                     murk_estimate out[QUANTITIES])
{
    murk_error err = {0};
    murk_tallies *tallies = NULL;
    murk_ledger *ledger = NULL;
    must(murk_tallies_create(&tallies, descs, TALLIES, &world->domain, CHANNELS,
                             1, 1, 1e8, &err),
         &err);
    must(murk_ledger_create(&ledger, world, &err), &err);
    murk_trace trace = murk_trace_defaults();
    trace.world = world;
    trace.seed = seed;
    trace.last = photons;
    trace.tallies = tallies;
    murk_trace_run(&trace, ledger);
    double packet_w[CHANNELS];
    for (size_t c = 0; c < CHANNELS; ++c) {
        const double packets =
            (double)(murk_tally_read(&ledger->emitted[c]) / MURK_PACKET);
        packet_w[c] = murk_lights_channel_power_w(world->lights, c) / packets;
    }
    for (size_t i = 0; i < QUANTITIES; ++i) {
        out[i] =
            murk_tallies_read(tallies, quantities[i].tally, 0,
                              quantities[i].cell, ledger->emitted, packet_w);
    }
    murk_tallies_destroy(tallies);
    murk_ledger_destroy(ledger);
}

typedef struct trials {
    double within, square;
} trials;

static void check_trials(const char *name, const trials *t)
{
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    const double share = t->within / RUNS, mean = t->square / RUNS;
    const double share_sigma = sqrt(WITHIN_ONE * (1 - WITHIN_ONE) / RUNS);
    const double mean_sigma = sqrt(2.0 / RUNS);
    printf("%s: %.1f %% within one error, mean square %.3f\n", name,
           100 * share, mean);
    CHECK_WITHIN(limit, share, WITHIN_ONE, share_sigma);
    CHECK_WITHIN(limit, mean, 1, mean_sigma);
    CHECK(sigmas_off(mean * TOO_SMALL * TOO_SMALL, 1, mean_sigma) > limit);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    murk_light lamps[] = {test_point(murk_vec(.7, .8, .6)),
                          test_beam(murk_vec(3, 2.2, 0), murk_vec(-.2, 0, 1))};
    lamps[1].power_w = murk_spectrum_flat(3, 1);
    const murk_medium fog = test_medium(2, .97, .6);
    const murk_region region = test_everywhere(0);
    const murk_material white = test_material(.5, 0, 0, 0);
    const murk_surface_desc floor =
        test_rect(murk_vec(0, 0, .01), murk_vec(4, 0, 0), murk_vec(0, 3, 0), 0);
    test_world w =
        test_world_made(&(test_setup){.domain = {{{0, 0, 0}, {4, 3, 2}}},
                                      .lights = lamps,
                                      .n_lights = 2,
                                      .surfaces = &floor,
                                      .n_surfaces = 1,
                                      .materials = &white,
                                      .n_materials = 1,
                                      .media = &fog,
                                      .n_media = 1,
                                      .regions = &region,
                                      .n_regions = 1});
    murk_estimate truth[QUANTITIES];
    measured(&w.world, (uint64_t)TRUTH_RUNS * RUNS * PHOTONS, seed + 1000,
             truth);
    trials t[QUANTITIES] = {{0}};
    for (uint32_t run = 0; run < RUNS; ++run) {
        murk_estimate got[QUANTITIES];
        measured(&w.world, PHOTONS, 1000 * seed + 1 + run, got);
        for (size_t i = 0; i < QUANTITIES; ++i) {
            const double off =
                sigmas_off(got[i].value, truth[i].value, got[i].standard_error);
            t[i].within += off <= 1;
            t[i].square += off * off;
        }
    }
    for (size_t i = 0; i < QUANTITIES; ++i) {
        check_trials(quantities[i].name, &t[i]);
    }
    test_world_unmade(&w);
    return check_done();
}
