/* Photons traced side by side (transport/lanes.h) give the ledger, the tallies
 * and the events of photons traced one by one, to the bit, for every
 * instruction set of this processor, for several media, surfaces in clear air
 * and in media, packets that are split and roulette, with and without tallies,
 * and for batches that are not full. Nothing here is statistical. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "lane_sets.h"
#include "transport/lanes.h"
#include "worlds.h"

#define PHOTONS (MURK_BATCH_PHOTONS + 60)

/* A checksum of all events of each photon, in the order of the photon. */
typedef struct heard {
    bool skips_surfaces, skips_media, skips_ends; /* such events may be told or
                                                   * not */
    uint64_t sum[PHOTONS];
} heard;

static uint64_t mixed(uint64_t sum, const void *bytes, size_t n)
{
    const unsigned char *b = bytes;
    for (size_t i = 0; i < n; ++i) {
        sum = (sum ^ b[i]) * UINT64_C(0x100000001b3); /* FNV-1a */
    }
    return sum;
}

static void hear(void *context, uint64_t batch, const murk_event *event)
{
    heard *h = context;
    /* Events that may be told or not. */
    if ((h->skips_surfaces && event->kind == MURK_EVENT_SURFACE) ||
        (h->skips_media && event->kind == MURK_EVENT_MEDIUM) ||
        (h->skips_ends && (event->kind == MURK_EVENT_EMITTED ||
                           event->outcome == MURK_ABSORBED))) {
        return;
    }
    /* All that an event says. */
    uint64_t *sum = &h->sum[event->photon];
    const double numbers[] = {
        event->position.x,      event->position.y,      event->position.z,
        event->direction_in.x,  event->direction_in.y,  event->direction_in.z,
        event->direction_out.x, event->direction_out.y, event->direction_out.z,
        event->normal.x,        event->normal.y,        event->normal.z,
        event->reflectance,     event->weight,          event->leaving,
        event->path_m,          event->scattering_per_m};
    const uint32_t whole[] = {(uint32_t)batch,
                              (uint32_t)event->kind,
                              (uint32_t)event->outcome,
                              (uint32_t)event->event_class,
                              event->number,
                              event->light,
                              event->band,
                              event->material_or_medium,
                              (uint32_t)event->loss};
    *sum = mixed(*sum, numbers, sizeof numbers);
    *sum = mixed(*sum, whole, sizeof whole);
}

/* The sums of one run. */
#define CHANNELS_MAX 6
typedef struct outcome {
    int64_t account[20 * CHANNELS_MAX];
    double tally[CHANNELS_MAX * 2 * 256];
    heard heard;
} outcome;

static const murk_tally_desc descs[] = {{.name = "grid",
                                         .type = MURK_TALLY_GRID,
                                         .box = {{0, 0, 0}, {4, 4, 4}},
                                         .size = {5, 6, 7}},
                                        {.name = "plane",
                                         .type = MURK_TALLY_PLANE,
                                         .point = {0, 0, 2},
                                         .normal = {0, 0, 1},
                                         .bins = {3, 3},
                                         .angle_bins = 2},
                                        {.name = "ball",
                                         .type = MURK_TALLY_SPHERE,
                                         .center = {2, 2, 1},
                                         .radius_m = 1},
                                        {.name = "part",
                                         .type = MURK_TALLY_GRID,
                                         .box = {{1, 1.5, 0.5}, {3, 2.5, 3}},
                                         .size = {3, 2, 9}}};

#define DESCS (sizeof descs / sizeof *descs)

/* The settings of a run. */
typedef struct run {
    const char *lanes; /* value of MURK_LANES */
    unsigned threads;
    double least_weight;
    uint32_t events_max;
    uint64_t photons; /* 0: PHOTONS */
    bool has_tallies, has_sink, takes_back;
    bool skips_surfaces, skips_media, skips_ends; /* the sink skips such
                                                   * events */
} run;

static outcome *traced(const test_setup *setup, run given)
{
    outcome *o = calloc(1, sizeof *o);
    test_world w = test_world_made(setup);
    murk_trace trace = murk_trace_defaults();
    murk_error err = {0};
    trace.world = &w.world;
    trace.seed = 3;
    const uint64_t photons = given.photons ? given.photons : PHOTONS;
    trace.last = photons;
    trace.threads = given.threads;
    trace.least_weight = given.least_weight;
    trace.events_max = given.events_max;
    trace.takes_any_order = true;
    trace.skips_surfaces = o->heard.skips_surfaces = given.skips_surfaces;
    trace.skips_media = o->heard.skips_media = given.skips_media;
    trace.skips_ends = o->heard.skips_ends = given.skips_ends;
    if (given.has_sink) {
        trace.sink = hear;
        trace.context = &o->heard;
    }
    if (given.has_tallies) {
        CHECK(!murk_tallies_create(&trace.tallies, descs, DESCS, &setup->domain,
                                   w.ledger->channels, 1, given.threads,
                                   INFINITY, &err));
    }
    setenv("MURK_LANES", given.lanes, 1);
    const murk_lane_steps *steps = murk_lane_steps_chosen();
    const bool is_off = strcmp(given.lanes, "off") == 0;
    CHECK(is_off ? !steps
                 : steps && strcmp(murk_lane_set_name(steps->set),
                                   given.lanes) == 0);
    const murk_walk_setup walk = murk_walk_setup_of(&trace);
    CHECK(murk_photon_lanes_for(&walk) == steps);
    murk_trace_run(&trace, w.ledger);
    if (given.takes_back) {
        trace.takes_back = true;
        murk_trace_run(&trace, w.ledger);
    }
    unsetenv("MURK_LANES");
    /* Collect the sums of all channels. */
    const size_t channels = w.ledger->channels;
    size_t n = 0;
    CHECK(channels <= CHANNELS_MAX);
    o->account[n++] = murk_tally_read(&w.ledger->photons);
    o->account[n++] = murk_tally_read(&w.ledger->collisions);
    o->account[n++] = murk_ledger_imbalance(w.ledger);
    for (size_t l = 0; l < MURK_LOSSES; ++l) {
        o->account[n++] = murk_tally_read(&w.ledger->lost_photons[l]);
    }
    for (size_t c = 0; c < channels; ++c) {
        o->account[n++] = murk_tally_read(&w.ledger->emitted[c]);
        o->account[n++] = murk_tally_read(&w.ledger->absorbed_media[c]);
        o->account[n++] = murk_tally_read(&w.ledger->absorbed_surfaces[c]);
        o->account[n++] = murk_tally_read(&w.ledger->escaped[c]);
        o->account[n++] = murk_tally_read(&w.ledger->lost[c]);
        for (size_t m = 0; m < setup->n_media; ++m) {
            o->account[n++] = murk_ledger_by_medium(w.ledger, c, m);
        }
        for (size_t m = 0; m < setup->n_materials; ++m) {
            o->account[n++] = murk_ledger_by_material(w.ledger, c, m);
        }
    }
    for (size_t t = 0, k = 0; given.has_tallies && t < DESCS; ++t) {
        const double packet_w[CHANNELS_MAX] = {1, 2, 3, 4, 5, 6};
        for (size_t c = 0; c < murk_tally_cells(&descs[t]); ++c) {
            const murk_estimate e = murk_tallies_read(
                trace.tallies, t, 0, c, w.ledger->emitted, packet_w);
            o->tally[k++] = e.value;
            o->tally[k++] = e.standard_error;
        }
    }
    murk_tallies_destroy(trace.tallies);
    test_world_unmade(&w);
    CHECK(o->account[0] == (given.takes_back ? 0 : (int64_t)photons) &&
          o->account[2] == 0);
    return o;
}

/* Every instruction set and one or two threads against one by one. */
static void compare(const char *name, const test_setup *setup, run given)
{
    given.lanes = "off";
    given.threads = 1;
    outcome *one_by_one = traced(setup, given);
    CHECK(given.takes_back || setup->n_media == 0 ||
          one_by_one->account[1] > 0);
    for (size_t s = 0; s < MURK_LANE_SETS; ++s) {
        given.lanes = murk_lane_set_name((murk_lane_set)s);
        if (!test_lane_set_forced((murk_lane_set)s)) {
            continue;
        }
        for (given.threads = 1; given.threads <= 2; ++given.threads) {
            outcome *side_by_side = traced(setup, given);
            if (memcmp(one_by_one, side_by_side, sizeof *one_by_one) != 0) {
                fprintf(stderr, "%s, %s, %u threads\n", name, given.lanes,
                        given.threads);
                CHECK(false);
            }
            free(side_by_side);
        }
    }
    free(one_by_one);
}

static void compare_runs(const char *name, const test_setup *setup)
{
    const double weight[] = {1, 0.3, 0.001};
    for (size_t i = 0; i < 3; ++i) {
        for (int watched = 0; watched < 4; ++watched) {
            const run given = {.least_weight = weight[i],
                               .events_max = 100000,
                               .has_tallies = watched & 1,
                               .has_sink = watched & 2};
            compare(name, setup, given);
        }
    }
    /* Photons that are lost after few events, and sinks that skip events. */
    run given = {.least_weight = 0.001, .events_max = 4, .has_sink = true};
    compare(name, setup, given);
    given.events_max = 100000;
    given.skips_surfaces = true;
    compare(name, setup, given);
    given.skips_surfaces = false;
    given.skips_media = true;
    compare(name, setup, given);
    given.skips_media = false;
    given.skips_ends = true;
    compare(name, setup, given);
}

static const murk_domain domain = {{{0, 0, 0}, {4, 4, 4}}, false};

static void test_media(void)
{
    /* Media with phase functions of several kinds, and one without extinction.
     */
    const murk_source lamp[] = {
        test_point(murk_vec(1, 2, 0.5)),
        test_beam(murk_vec(2, 2, 0), murk_vec(0, 0, 1))};
    murk_medium fog = test_medium(3, 0.9, 0.8);
    murk_medium haze = test_medium(1, 0.5, 0);
    murk_medium air = test_medium(2, 0.95, 0);
    air.phase[0] = murk_phase_rayleigh();
    murk_medium clear = test_medium(0, 0.5, 0);
    const murk_medium media[] = {fog, haze, air, clear};
    const murk_region everywhere = test_everywhere(0);
    const murk_region around =
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(4, 4, 4));
    const murk_region part =
        test_box_region(0, murk_vec(0, 0, 1), murk_vec(4, 3, 3));
    const murk_region of_air = test_everywhere(2);
    const murk_region several[] = {test_everywhere(1), part,
                                   test_ball_region(2, murk_vec(2, 2, 2), 1)};
    murk_region replaced[3] = {test_everywhere(1), part,
                               test_ball_region(0, murk_vec(2, 2, 2), 1)};
    replaced[1].shape = MURK_REGION_BELOW;
    replaced[1].below_z_m = 2;
    replaced[1].medium = 2;
    replaced[2].replaces = true;
    murk_region many[9];
    for (size_t k = 0; k < 9; ++k) {
        many[k] = test_ball_region(k % 3, murk_vec(2, 2, (double)k / 2), 1);
        many[k].replaces = k == 3 || k == 6;
    }
    /* One region or several; one lamp or two. */
    const struct {
        const char *name;
        const murk_region *region;
        size_t n;
    } worlds[] = {{"everywhere", &everywhere, 1},
                  {"a box around the domain", &around, 1},
                  {"a box in the domain", &part, 1},
                  {"Rayleigh", &of_air, 1},
                  {"two", &replaced[1], 2},
                  {"several", several, 3},
                  {"replaced", replaced, 3},
                  {"as many as fit", many, 8},
                  {"more regions than fit", many, 9}};
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; ++i) {
        const test_setup setup = {.domain = domain,
                                  .lights = lamp,
                                  .n_lights = 1 + i % 2,
                                  .media = media,
                                  .n_media = 4,
                                  .regions = worlds[i].region,
                                  .n_regions = worlds[i].n};
        compare_runs(worlds[i].name, &setup);
    }
}

/* A grid of noise with a gap, 0.1 m from voxel to voxel, in the middle of the
 * domain. */
static murk_grid *noise(void)
{
    enum { NX = 33, NY = 20, NZ = 27 };
    static float density[NX * NY * NZ];
    for (size_t i = 0; i < sizeof density / sizeof *density; ++i) {
        const double u = murk_random(1, MURK_TEST, i, 0, 0).u[0];
        const bool is_gap = i % NX < 8 && i / NX % NY < 8;
        density[i] = is_gap ? 0 : (float)(2 * u);
    }
    const size_t size[3] = {NX, NY, NZ};
    const murk_affine to_world =
        murk_affine_place(murk_vec(0, 0, 10), 0.1, murk_vec(0.5, 0.4, 0.6));
    murk_grid *grid = NULL;
    CHECK(
        !murk_grid_from_samples(&grid, size, density, &to_world, "test", NULL));
    return grid;
}

/* A grid alone, in parts, and among other regions. */
static void test_grids(void)
{
    const murk_source lamp[] = {
        test_point(murk_vec(1, 2, 0.5)),
        test_beam(murk_vec(2, 2, 0), murk_vec(0, 0, 1))};
    murk_grid *grid = noise();
    murk_medium media[] = {test_medium(3, 0.9, 0.6), test_medium(0.4, 0.8, 0),
                           test_medium(2, 0.95, 0)};
    media[0].grid = grid;
    media[2].phase[0] = murk_phase_rayleigh();
    murk_region smoke = test_everywhere(0);
    smoke.shape = MURK_REGION_GRID;
    smoke.to_world = murk_affine_identity();
    const murk_region in_a_ball = test_ball_region(0, murk_vec(2, 2, 2), 1.2);
    murk_region among[] = {test_everywhere(1), smoke,
                           test_ball_region(2, murk_vec(2, 2, 2), 0.5),
                           test_everywhere(1)};
    among[2].replaces = true;
    among[3].shape = MURK_REGION_BELOW;
    among[3].below_z_m = 1.5;
    murk_region replaces[] = {test_everywhere(1), smoke};
    replaces[1].replaces = true;
    /* Photon by photon: a region that is filled only in part and replaces
     * others. */
    murk_region in_part[] = {test_everywhere(1), in_a_ball};
    in_part[1].replaces = true;
    const struct {
        const char *name;
        const murk_region *region;
        size_t n;
    } worlds[] = {{"a grid", &smoke, 1},
                  {"a grid in a ball", &in_a_ball, 1},
                  {"a grid among others", among, 4},
                  {"a grid that replaces", replaces, 2},
                  {"a grid in part", in_part, 2}};
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; ++i) {
        const test_setup setup = {.domain = domain,
                                  .lights = lamp,
                                  .n_lights = 1 + i % 2,
                                  .media = media,
                                  .n_media = 3,
                                  .regions = worlds[i].region,
                                  .n_regions = worlds[i].n};
        compare_runs(worlds[i].name, &setup);
    }
    murk_grid_destroy(grid);
}

/* Photons with more contributions to tallies than their lists hold, and photons
 * that are taken back. */
static void test_long_photons(void)
{
    const murk_source lamp = test_point(murk_vec(2, 2, 2));
    const murk_medium milk = test_medium(40, 0.99999, 0);
    const murk_region everywhere = test_everywhere(0);
    const test_setup setup = {.domain = domain,
                              .lights = &lamp,
                              .n_lights = 1,
                              .media = &milk,
                              .n_media = 1,
                              .regions = &everywhere,
                              .n_regions = 1};
    run given = {.least_weight = 0.5,
                 .events_max = 20000,
                 .photons = 40,
                 .has_tallies = true};
    compare("long photons", &setup, given);
    given.takes_back = true;
    compare("taken back", &setup, given);
}

static void test_periodic_domain(void)
{
    const murk_source lamp = test_point(murk_vec(1, 2, 0.5));
    const murk_medium fog = test_medium(.5, 0.9, 0.8);
    const murk_region everywhere = test_everywhere(0);
    const test_setup setup = {.domain = {domain.box, true},
                              .lights = &lamp,
                              .n_lights = 1,
                              .media = &fog,
                              .n_media = 1,
                              .regions = &everywhere,
                              .n_regions = 1};
    compare_runs("periodic", &setup);
}

/* A furnished room of materials of all kinds in clear air and in media, in a
 * domain with open or periodic sides: a lamp on the ceiling, one in the air,
 * one inside the glass, and light that enters through the sides. */
static void test_surfaces(void)
{
    const murk_material materials[] = {
        test_material(0, 0, 0, 0),       test_material(0.8, 0, 0, 0),
        test_material(0.3, 0.4, 0, 0),   test_material(0.1, 0, 0.7, 0),
        test_material(0, 0.5, 0.5, 1.5), test_material(1, 0, 0, 0)};
    const murk_vec3 x = {4, 0, 0}, y = {0, 4, 0}, z = {0, 0, 3};
    const murk_surface_desc surfaces[] = {
        test_rect(murk_vec(0, 0, 0), x, y, 1), /* the floor, in the side */
        test_rect(murk_vec(0, 0, 3), x, y, 1), /* the ceiling */
        test_rect(murk_vec(1, 1, 0), murk_vec(2, 0, 0), murk_vec(0, 2.5, 0),
                  2), /* a carpet in the plane of the floor */
        test_rect(murk_vec(0, 0, 0), x, z, 2), /* two of the walls, glossy */
        test_rect(murk_vec(0, 3.5, 0), x, z, 5),
        test_rect(murk_vec(1, 0, 0), murk_vec(0, 2, 0), z, 3), /* a sheet */
        test_box(murk_vec(2, 1, 0.5), murk_vec(3, 2, 1), 1),   /* a table */
        test_box(murk_vec(2.2, 1.2, 1), murk_vec(2.4, 1.4, 1.2), 0),
        test_sphere(murk_vec(3, 3, 1.5), 0.4, 4), /* glass */
        test_sphere(murk_vec(0.5, 3, 1), 0.3, 1)};
    murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                       .direction = {1, 0.2, -0.4},
                       .power_w = {{1}},
                       .where = "sun"};
    const murk_source lights[] = {test_point(murk_vec(2, 2, 3)),
                                  test_point(murk_vec(3, 1.5, 2)),
                                  test_point(murk_vec(3.1, 3, 1.5)), sun};
    murk_medium air = test_medium(0.4, 0.95, 0);
    air.phase[0] = murk_phase_rayleigh();
    murk_grid *grid = noise();
    murk_medium smoke = test_medium(3, 0.9, 0.6);
    smoke.grid = grid;
    const murk_medium media[] = {test_medium(0.3, 0.9, 0.5),
                                 test_medium(3, 0.7, 0.8), air, smoke};
    const murk_region everywhere = test_everywhere(0);
    const murk_region of_air = test_everywhere(2);
    murk_region several[] = {
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(4, 3.5, 3)),
        test_ball_region(1, murk_vec(2, 2, 1), 1),
        test_ball_region(2, murk_vec(0.5, 3, 1), 0.5)};
    several[2].replaces = true;
    murk_region of_smoke[] = {test_everywhere(0), test_everywhere(3)};
    of_smoke[1].shape = MURK_REGION_GRID;
    of_smoke[1].to_world = murk_affine_identity();
    const struct {
        const char *name;
        const murk_region *region;
        size_t n;
    } worlds[] = {{"surfaces in clear air", NULL, 0},
                  {"surfaces in an even medium", &everywhere, 1},
                  {"surfaces in Rayleigh's air", &of_air, 1},
                  {"surfaces in several regions", several, 3},
                  {"surfaces in smoke", of_smoke, 2}};
    for (size_t i = 0; i < 2 * (sizeof worlds / sizeof *worlds); ++i) {
        const test_setup setup = {.domain = {domain.box, i % 2},
                                  .lights = lights,
                                  .n_lights = 4,
                                  .surfaces = surfaces,
                                  .n_surfaces =
                                      sizeof surfaces / sizeof *surfaces,
                                  .materials = materials,
                                  .n_materials = 6,
                                  .media = media,
                                  .n_media = worlds[i / 2].n ? 4 : 0,
                                  .regions = worlds[i / 2].region,
                                  .n_regions = worlds[i / 2].n};
        compare_runs(worlds[i / 2].name, &setup);
    }
    murk_grid_destroy(grid);
}

/* Light enters a long domain far, in units of the rounding of surfaces, before
 * the side, close to a black wall that stands in the side. */
static void test_long_domain(void)
{
    const murk_material black = test_material(0, 0, 0, 0);
    const murk_surface_desc wall = test_rect(
        murk_vec(0.001, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 4), 0);
    const murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                             .direction = {1, 0, 0},
                             .power_w = {{1}},
                             .where = "sun"};
    const murk_medium fog = test_medium(20, 0.9, 0.5);
    const murk_region everywhere = test_everywhere(0);
    const test_setup setup = {.domain = {{{0, 0, 0}, {1000, 4, 4}}, false},
                              .lights = &sun,
                              .n_lights = 1,
                              .surfaces = &wall,
                              .n_surfaces = 1,
                              .materials = &black,
                              .n_materials = 1,
                              .media = &fog,
                              .n_media = 1,
                              .regions = &everywhere,
                              .n_regions = 1};
    compare_runs("a long domain", &setup);
}

int main(void)
{
    test_media();
    test_grids();
    test_surfaces();
    test_long_domain();
    test_long_photons();
    test_periodic_domain();
    return check_done();
}
