/* Tallies of traced worlds, where every number is known beforehand, and what is
 * refused. Few photons; nothing here depends on luck. */
#include "check.h"
#include "worlds.h"

static const murk_domain cube = {{{0, 0, 0}, {2, 2, 2}}, false};
static const murk_domain tile = {{{0, 0, 0}, {2, 2, 2}}, true};

static murk_tally_desc plane(double z, double normal_z)
{
    return (murk_tally_desc){.name = "plane",
                             .where = "x.yaml:1:1: tallies.0",
                             .type = MURK_TALLY_PLANE,
                             .point = {1, 1, z},
                             .normal = {0, 0, normal_z},
                             .bins = {1, 1},
                             .angle_bins = 1};
}

static murk_tally_desc grid_tally(void)
{
    return (murk_tally_desc){.name = "grid",
                             .where = "x.yaml:1:1: tallies.0",
                             .type = MURK_TALLY_GRID,
                             .box = {{0, 0, 0}, {2, 2, 2}},
                             .size = {2, 2, 2}};
}

static murk_tally_desc probe(void)
{
    return (murk_tally_desc){.name = "probe",
                             .where = "x.yaml:1:1: tallies.0",
                             .type = MURK_TALLY_SPHERE,
                             .center = {1, 1, 1},
                             .radius_m = 0.5};
}

/* ---- worlds ---- */

/* Quanta in the first n cells of one tally after a run. */
static void measured(const test_setup *setup, const murk_tally_desc *desc,
                     uint64_t photons, size_t n, double *out)
{
    test_world w = test_world_made(setup);
    murk_error err = {0};
    murk_tallies *tallies = NULL;
    CHECK(!murk_tallies_create(&tallies, desc, 1, &setup->domain,
                               setup->n_lights, 1, 2, INFINITY, &err));
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = 1;
    trace.last = photons;
    trace.threads = 2;
    trace.tallies = tallies;
    murk_trace_run(&trace, w.ledger);
    const double packet_w[2] = {(double)MURK_PACKET, (double)MURK_PACKET};
    for (size_t c = 0; c < n; ++c) {
        out[c] =
            murk_tallies_read(tallies, 0, 0, c, w.ledger->emitted, packet_w)
                .value /
            (double)MURK_PACKET;
    }
    murk_tallies_destroy(tallies);
    test_world_unmade(&w);
}

/* A beam from a side to the other, planes in both sides and beyond the lamp. */
static void test_planes_in_the_sides(void)
{
    murk_source light = {.type = MURK_SOURCE_DIRECTIONAL,
                         .direction = {0, 0, -1},
                         .power_w = {{1}},
                         .where = "light"};
    const test_setup setup = {.domain = cube, .lights = &light, .n_lights = 1};
    const double z[] = {0, 1, 2};
    for (int i = 0; i < 3; ++i) {
        double crossed[2];
        murk_tally_desc d = plane(z[i], 1);
        measured(&setup, &d, 10, 2, crossed);
        CHECK(crossed[0] == 0 && crossed[1] == 10);
        d = plane(z[i], -1);
        measured(&setup, &d, 10, 2, crossed);
        CHECK(crossed[0] == 10 && crossed[1] == 0);
    }
    light.direction = murk_vec(0, 1, 0);
    const murk_tally_desc across = plane(1, 1);
    double crossed[2];
    measured(&setup, &across, 10, 2, crossed);
    CHECK(crossed[0] == 0 && crossed[1] == 0);
}

/* Light that wraps: a plane in the side counts each turn once, one across it
 * never twice for the step over the side. */
static void test_planes_and_wraps(void)
{
    murk_source beam = test_beam(murk_vec(0.5, 1, 1.75), murk_vec(2, 0, -0.25));
    const test_setup setup = {.domain = tile, .lights = &beam, .n_lights = 1};
    /* down by 1/4 a turn: 7 times through each side, then out at the bottom */
    for (int side = 0; side < 2; ++side) {
        murk_tally_desc d = plane(1, 1);
        d.point.x = 2 * side;
        d.normal = murk_vec(1, 0, 0);
        double crossed[2];
        measured(&setup, &d, 3, 2, crossed);
        CHECK(crossed[0] == 3 * 7 && crossed[1] == 0);
    }
    for (int k = 0; k <= 8; ++k) { /* k odd: the side itself is passed there */
        const double z = 1.75 - (1.5 + k) / 8;
        const murk_tally_desc d = plane(fmax(z, 0), 1);
        double crossed[2];
        measured(&setup, &d, 3, 2, crossed);
        CHECK(crossed[0] == 0 && crossed[1] == 3);
    }
}

/* A mirror floor under a beam: counts of a plane in the floor with the
 * normal into the floor, in the floor with the normal out of it, and above
 * the floor. */
static void test_planes_in_a_floor(void)
{
    const double floors[] = {0, 0.3, 0.7};
    for (int i = 0; i < 3; ++i) {
        /* The floor at several heights, one of them the bottom of the
         * domain. */
        const murk_source beam =
            test_beam(murk_vec(0.9, 0.7, 1.9), murk_vec(0.1, 0.3, -1));
        const murk_material mirror = test_material(0, 1, 0, 0);
        const murk_surface_desc floor = test_rect(
            murk_vec(0, 0, floors[i]), murk_vec(2, 0, 0), murk_vec(0, 2, 0), 0);
        const test_setup setup = {.domain = cube,
                                  .lights = &beam,
                                  .n_lights = 1,
                                  .surfaces = &floor,
                                  .n_surfaces = 1,
                                  .materials = &mirror,
                                  .n_materials = 1};
        /* Each photon passes twice, or not at all if the normal points out
         * of the floor. */
        double crossed[2];
        murk_tally_desc d = plane(floors[i], -1);
        measured(&setup, &d, 20, 2, crossed);
        CHECK(crossed[0] == 20 && crossed[1] == 20);
        d = plane(floors[i], 1);
        measured(&setup, &d, 20, 2, crossed);
        CHECK(crossed[0] == 0 && crossed[1] == 0);
        d = plane(floors[i] + 0.001, 1);
        measured(&setup, &d, 20, 2, crossed);
        CHECK(crossed[0] == 20 && crossed[1] == 20);
    }
}

/* Light from both sides onto water: a plane in its surface counts what passes
 * just below with the normal up, just above with the normal down. */
static void test_planes_in_an_interface(void)
{
    const double levels[] = {1, 0.3, 1.7};
    const uint64_t n = 4000;
    for (int i = 0; i < 3; ++i) {
        const double level = levels[i];
        const murk_source lamps[2] = {
            test_beam(murk_vec(0.3, 1, level + 0.2), murk_vec(0.2, 0.1, -1)),
            test_beam(murk_vec(0.6, 1, level - 0.2), murk_vec(0.2, 0.1, 1))};
        const murk_medium clear = test_medium(0, 1, 0);
        murk_region water = test_everywhere(0);
        water.shape = MURK_REGION_BELOW;
        water.below_z_m = level;
        water.ior = 1.5;
        const test_setup setup = {.domain = cube,
                                  .lights = lamps,
                                  .n_lights = 2,
                                  .media = &clear,
                                  .n_media = 1,
                                  .regions = &water,
                                  .n_regions = 1};
        double below[2], above[2], under[2], over[2];
        murk_tally_desc d = plane(level, 1);
        measured(&setup, &d, n, 2, below);
        d = plane(level - 0.001, 1);
        measured(&setup, &d, n, 2, under);
        d = plane(level, -1);
        measured(&setup, &d, n, 2, above);
        d = plane(level + 0.001, -1);
        measured(&setup, &d, n, 2, over);
        CHECK(below[0] == under[0] && below[1] == under[1]);
        CHECK(above[0] == over[0] && above[1] == over[1]);
        /* each lamp's photons arrive, and as many pass below as above */
        CHECK(fabs(below[0] - (double)n / 2) < 5 &&
              below[0] + above[0] == (double)n);
        CHECK(below[0] - below[1] == above[1] - above[0]);
        CHECK(below[0] != above[1]); /* some are reflected */
    }
}

/* A lamp that lies in a plane sends out by its two sides as it shines. */
static void test_a_lamp_in_a_plane(void)
{
    const murk_source lamp = {.type = MURK_SOURCE_RECT,
                              .position = {0.5, 0.5, 1.7},
                              .edge1 = {0, 1, 0},
                              .edge2 = {1, 0, 0},
                              .power_w = {{1}},
                              .where = "lamp"};
    const test_setup setup = {.domain = cube, .lights = &lamp, .n_lights = 1};
    double crossed[2];
    murk_tally_desc d = plane(1.7, 1);
    measured(&setup, &d, 50, 2, crossed);
    CHECK(crossed[0] == 0 && crossed[1] == 50);
    d = plane(1.7, -1);
    measured(&setup, &d, 50, 2, crossed);
    CHECK(crossed[0] == 0 && crossed[1] == 0);
}

/* In fog, between mirrors, glass and water, in a periodic domain: what a plane
 * passes forward less backward is what ends beyond it less what starts there,
 * to the quantum. No photon starts below; half of the light absorbed lies
 * there. */
static void add_ends_below(void *context, uint64_t batch, const murk_event *e)
{
    (void)batch;
    double *below = context;
    const bool ends =
        e->kind == MURK_EVENT_LOST || e->kind == MURK_EVENT_ESCAPED ||
        ((e->kind == MURK_EVENT_SURFACE || e->kind == MURK_EVENT_MEDIUM) &&
         e->leaving < e->weight);
    if (ends && e->position.z < 1) {
        *below += e->weight -
                  (e->kind == MURK_EVENT_SURFACE || e->kind == MURK_EVENT_MEDIUM
                       ? e->leaving
                       : 0);
    }
}

static void test_nothing_is_lost_at_a_plane(double least_weight)
{
    const murk_source light = test_point(murk_vec(0.7, 1.1, 1.6));
    const murk_material materials[2] = {test_material(0.6, 0.1, 0.1, 0),
                                        test_material(0, 0, 0.95, 1.5)};
    const murk_surface_desc surfaces[3] = {
        test_rect(murk_vec(0, 0, 0), murk_vec(2, 0, 0), murk_vec(0, 2, 0), 0),
        test_rect(murk_vec(0, 0, 1), murk_vec(1, 0, 0.5), murk_vec(0, 2, 0), 0),
        test_sphere(murk_vec(1.2, 1, 1), 0.4, 1)};
    const murk_medium fog = test_medium(3, 0.95, 0.5);
    murk_region regions[2] = {
        test_everywhere(0),
        test_box_region(0, murk_vec(0.1, 0.2, 0.3), murk_vec(1.9, 0.9, 1.3))};
    regions[1].ior = 1.3;
    const test_setup setup = {.domain = tile,
                              .lights = &light,
                              .n_lights = 1,
                              .surfaces = surfaces,
                              .n_surfaces = 3,
                              .materials = materials,
                              .n_materials = 2,
                              .media = &fog,
                              .n_media = 1,
                              .regions = regions,
                              .n_regions = 2};
    test_world w = test_world_made(&setup);
    murk_error err = {0};
    murk_tallies *tallies = NULL;
    const murk_tally_desc d = plane(1, -1);
    CHECK(
        !murk_tallies_create(&tallies, &d, 1, &tile, 1, 1, 1, INFINITY, &err));
    double below = 0;
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = 3;
    trace.last = 3000;
    trace.tallies = tallies;
    trace.least_weight = least_weight;
    trace.sink = add_ends_below;
    trace.context = &below;
    murk_trace_run(&trace, w.ledger);
    const double one = 1;
    const murk_tally *emitted = w.ledger->emitted;
    const double forward =
        murk_tallies_read(tallies, 0, 0, 0, emitted, &one).value;
    const double backward =
        murk_tallies_read(tallies, 0, 0, 1, emitted, &one).value;
    CHECK(below > 100 && backward > 100);
    CHECK(forward - backward == below); /* dyadic numbers all: exact */

    /* the books by material and medium are the books */
    int64_t materials_sum = 0;
    for (size_t m = 0; m < 2; ++m) {
        CHECK(murk_ledger_by_material(w.ledger, 0, m) > 0);
        materials_sum += murk_ledger_by_material(w.ledger, 0, m);
    }
    CHECK(materials_sum == murk_tally_read(&w.ledger->absorbed_surfaces[0]));
    CHECK(murk_ledger_by_medium(w.ledger, 0, 0) ==
          murk_tally_read(&w.ledger->absorbed_media[0]));

    /* taken back, all is as if it had not been */
    trace.takes_back = true;
    trace.sink = NULL;
    murk_trace_run(&trace, w.ledger);
    const murk_tally some = MURK_PACKET * 2;
    CHECK(murk_tallies_read(tallies, 0, 0, 0, &some, &one).value == 0);
    CHECK(murk_tallies_read(tallies, 0, 0, 1, &some, &one).standard_error == 0);
    CHECK(murk_tally_read(&w.ledger->emitted[0]) == 0);
    CHECK(murk_tally_read(&w.ledger->collisions) == 0);
    CHECK(murk_ledger_by_material(w.ledger, 0, 1) == 0);
    CHECK(murk_ledger_by_medium(w.ledger, 0, 0) == 0);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    murk_tallies_destroy(tallies);
    test_world_unmade(&w);
}

/* Where copies of the sums for every thread would take too much, threads add
 * to the same: all cells are those of one thread. */
static void test_shared_sums(void)
{
    const murk_source light = test_point(murk_vec(0.7, 1.1, 1.6));
    const murk_medium fog = test_medium(3, 0.95, 0.5);
    const murk_region region = test_everywhere(0);
    const test_setup setup = {.domain = cube,
                              .lights = &light,
                              .n_lights = 1,
                              .media = &fog,
                              .n_media = 1,
                              .regions = &region,
                              .n_regions = 1};
    test_world w = test_world_made(&setup);
    murk_tally_desc d = grid_tally();
    d.size[0] = d.size[1] = d.size[2] = 110; /* 43 MB a copy */
    murk_tallies *tallies[2] = {NULL, NULL};
    for (unsigned i = 0; i < 2; ++i) {
        murk_error err = {0};
        const unsigned threads = i ? 4 : 1;
        CHECK(!murk_tallies_create(&tallies[i], &d, 1, &cube, 1, 1, threads,
                                   INFINITY, &err));
        murk_trace trace = murk_trace_defaults();
        trace.world = &w.world;
        trace.seed = 1;
        trace.last = 20 * MURK_BATCH_PHOTONS;
        trace.threads = threads;
        trace.tallies = tallies[i];
        murk_trace_run(&trace, w.ledger);
    }
    size_t lit = 0, other = 0;
    const double packet_w = 1;
    for (size_t c = 0; c < murk_tally_cells(&d); ++c) {
        const murk_estimate one = murk_tallies_read(
            tallies[0], 0, 0, c, w.ledger->emitted, &packet_w);
        const murk_estimate four = murk_tallies_read(
            tallies[1], 0, 0, c, w.ledger->emitted, &packet_w);
        lit += one.value > 0;
        other += one.value != four.value ||
                 one.standard_error != four.standard_error;
    }
    CHECK(lit > 400000 && other == 0);
    murk_tallies_destroy(tallies[0]);
    murk_tallies_destroy(tallies[1]);
    test_world_unmade(&w);
}

/* ---- refusals ---- */

static void refuses(const murk_tally_desc *descs, size_t n, const char *part)
{
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    CHECK(murk_tallies_create(&tallies, descs, n, &cube, 1, 1, 1, INFINITY,
                              &err) == MURK_BAD_VALUE);
    CHECK(tallies == NULL);
    CHECK_TEXT(err.where, "x.yaml:1:1: tallies.0");
    CHECK_MENTIONS(err.text, part);
}

/* In a domain from 1 to 2 m: what reaches a hundredth past a face, on each axis
 * and either side, is refused, and what ends at the face is not. */
static void test_each_face_of_the_domain_bounds(void)
{
    const murk_domain domain = {.box = {{1, 1, 1}, {2, 2, 2}}};
    for (int i = 0; i < 6; ++i) {
        const int axis = i / 2;
        const double face = 1 + i % 2, past = face + (i % 2 ? 0.01 : -0.01);
        for (int is_past = 0; is_past < 2; ++is_past) {
            const double at = is_past ? past : face;
            murk_tally_desc d[3] = {plane(1.5, 1), grid_tally(), probe()};
            d[0].point = d[2].center = murk_vec(1.5, 1.5, 1.5);
            d[1].box = (murk_box){{1.4, 1.4, 1.4}, {1.6, 1.6, 1.6}};
            d[2].radius_m = 0.1;
            const murk_vec3 to = {axis == 0, axis == 1, axis == 2};
            d[0].point = murk_along(d[0].point, at - 1.5, to);
            murk_vec3 *corner = i % 2 ? &d[1].box.max : &d[1].box.min;
            *corner = murk_along(*corner, at - (i % 2 ? 1.6 : 1.4), to);
            d[2].center =
                murk_along(d[2].center, at - 1.5 + (i % 2 ? -0.1 : 0.1), to);
            for (int k = 0; k < 3; ++k) {
                CHECK(murk_tallies_check(&d[k], 1, &domain, NULL) ==
                      (is_past ? MURK_BAD_VALUE : MURK_OK));
            }
        }
        /* turned inside out by a hundredth, and flat */
        murk_tally_desc d = grid_tally();
        d.box = domain.box;
        murk_vec3 *top = &d.box.max;
        double *const high[3] = {&top->x, &top->y, &top->z};
        *high[axis] = i % 2 ? 1 : 0.99;
        murk_error err = {0};
        CHECK(murk_tallies_check(&d, 1, &domain, &err) == MURK_BAD_VALUE);
        CHECK_MENTIONS(err.text, "min_m must be less than max_m");
    }
}

static void test_bad_tallies_are_named(void)
{
    /* Planes without a normal, outside of the domain, or with too many or
     * no bins. */
    murk_tally_desc d[MURK_TALLIES_MAX + 1] = {plane(1, 1)};
    d[0].normal = murk_vec(0, 0, 0);
    refuses(d, 1, "normal is [0, 0, 0], must point somewhere");
    d[0].normal.x = NAN;
    refuses(d, 1, "normal is [nan, 0, 0]");
    d[0] = plane(3, 1);
    refuses(d, 1,
            "point_m is outside the domain, which is [0, 0, 0] to [2, 2, 2] m");
    d[0] = plane(NAN, 1);
    refuses(d, 1, "outside the domain");
    d[0] = plane(1, 1);
    d[0].bins[0] = 1001;
    d[0].angle_bins = 1000;
    refuses(d, 1, "1001000 bins, must be 1..1000000");
    d[0].bins[0] = 0;
    refuses(d, 1, "0 bins");

    /* Grids outside of the domain, without a volume, or with too many or no
     * cells. */
    d[0] = grid_tally();
    d[0].box.max.z = 2.1;
    refuses(d, 1, "reaches outside the domain");
    d[0].box.max.z = 0;
    refuses(d, 1, "min_m must be less than max_m on each axis");
    d[0].box.max.z = NAN;
    refuses(d, 1, "min_m must be less than max_m on each axis");
    d[0] = grid_tally();
    d[0].size[1] = (size_t)1 << 40;
    refuses(d, 1, "cells, must be 1..2.14748365e+09");
    d[0].size[1] = 0;
    refuses(d, 1, "0 cells");

    /* Spheres without a radius or beyond the domain. */
    d[0] = probe();
    d[0].radius_m = 0;
    refuses(d, 1, "radius_m is 0, must be more than 0 m");
    d[0].radius_m = NAN;
    refuses(d, 1, "radius_m is nan");
    d[0].radius_m = 1.001;
    refuses(d, 1, "reaches outside the domain");

    /* Names that cannot be file names, or that two tallies share. */
    const char *const names[] = {"",   "a b", "../x",    ".x",
                                 "-x", "a/b", "\xc3\xa9"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        d[0] = probe();
        snprintf(d[0].name, sizeof d[0].name, "%s", names[i]);
        refuses(d, 1, "must be letters, digits, . _ -");
    }
    d[0] = d[1] = probe();
    refuses(d, 2, "name \"probe\" is also that of another tally");
    d[0] = d[1] = grid_tally();
    strcpy(d[1].name, "grid_error");
    refuses(d, 2,
            "name \"grid_error\": its files are also those of the tally "
            "\"grid\"");
    /* Too many cells in all, and too many tallies. */
    d[1].size[0] = (size_t)1 << 31;
    d[1].size[1] = d[1].size[2] = 1;
    strcpy(d[1].name, "huge");
    refuses(d, 2, "the tallies up to it have");
    for (int i = 0; i <= MURK_TALLIES_MAX; ++i) {
        d[i] = probe();
    }
    refuses(d, MURK_TALLIES_MAX + 1, "65 tallies, must be at most 64");
}

static void test_memory_is_said_before_it_is_taken(void)
{
    murk_tally_desc d[2] = {plane(1, 1), grid_tally()};
    d[1].where = "x.yaml:2:1: tallies.1";
    d[1].size[0] = d[1].size[1] = d[1].size[2] = 1000;
    const double bytes = murk_tallies_memory(d, 2, 6, 3, 2);
    CHECK_NEAR(bytes / 1e9, 6 * 32 + 2 * 12 + 3 * 16, 0.1);
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    CHECK(murk_tallies_create(&tallies, d, 2, &cube, 6, 3, 2, 8e9, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "x.yaml:2:1: tallies.1");
    CHECK_TEXT(err.text, "the tallies take 264 GB: 1000000000 cells in this "
                         "one, for each of 6 lights times bands; this machine "
                         "has 8 GB free");
    CHECK(tallies == NULL);
}

/* Touching a side is inside, whatever adding the radius rounds. */
static void test_a_sphere_may_touch(void)
{
    const murk_domain box = {{{0, 0, 0}, {0.3, 0.3, 0.3}}, false};
    murk_tally_desc d = probe();
    d.center = murk_vec(0.2, 0.1, 0.15);
    d.radius_m = 0.1;
    murk_error err = {0};
    CHECK(d.center.x + d.radius_m > 0.3);
    CHECK(!murk_tallies_check(&d, 1, &box, &err));
}

int main(void)
{
    test_planes_in_the_sides();
    test_planes_and_wraps();
    test_planes_in_a_floor();
    test_planes_in_an_interface();
    test_a_lamp_in_a_plane();
    test_nothing_is_lost_at_a_plane(1);
    test_nothing_is_lost_at_a_plane(1. / 1024);
    test_shared_sums();
    test_each_face_of_the_domain_bounds();
    test_bad_tallies_are_named();
    test_memory_is_said_before_it_is_taken();
    test_a_sphere_may_touch();
    return check_done();
}
