/* Flights and roulette in media: Beer's law (P. Bouguer 1729, A. Beer 1852)
 * from a lamp inside the fog, albedo exactly 0 and 1, fog that crosses a wall.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 20000
#define Z_TESTS 5

static const murk_domain hall = {{{-20, -20, -20}, {20, 20, 20}}, false};

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

typedef struct firsts {
    double n, sum, sum2;
} firsts;

static void note_first(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    firsts *f = context;
    if (event->kind == MURK_EVENT_MEDIUM && event->number == 1) {
        f->n += 1;
        f->sum += event->path_m;
        f->sum2 += event->path_m * event->path_m;
    }
}

/* Paths to the first collision: mean 1/s, mean square 2/s^2, with variances
 * 1/s^2 and 20/s^4. The walls are 20 optical depths away. */
static void test_lamp_in_fog(uint32_t seed)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_medium fog = test_medium(1, .5, .8);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(&(test_setup){.domain = hall,
                                                 .lights = &lamp,
                                                 .n_lights = 1,
                                                 .media = &fog,
                                                 .n_media = 1,
                                                 .regions = &region,
                                                 .n_regions = 1});
    firsts f = {0};
    test_world_trace(&w, PHOTONS, seed, note_first, &f);
    CHECK(f.n == PHOTONS);
    CHECK_WITHIN(limit(), f.sum / PHOTONS, 1, 1 / sqrt(PHOTONS));
    CHECK_WITHIN(limit(), f.sum2 / PHOTONS, 2, sqrt(20. / PHOTONS));
    /* Teeth: extinction 5 % off. */
    CHECK(sigmas_off(f.sum / PHOTONS, 1.05, 1.05 / sqrt(PHOTONS)) > limit());
    test_world_unmade(&w);
}

typedef struct kinds {
    double scattered, absorbed, later;
} kinds;

static void note_kind(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    kinds *k = context;
    if (event->kind == MURK_EVENT_MEDIUM) {
        k->scattered += event->outcome == MURK_SCATTERED;
        k->absorbed += event->outcome == MURK_ABSORBED;
        k->later += event->event_class != MURK_CLASS_FIRST;
    }
}

static test_world fog_box(double extinction, double albedo)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_medium fog = test_medium(extinction, albedo, 0);
    const murk_region region = test_everywhere(0);
    return test_world_made(&(test_setup){.domain = hall,
                                         .lights = &lamp,
                                         .n_lights = 1,
                                         .media = &fog,
                                         .n_media = 1,
                                         .regions = &region,
                                         .n_regions = 1});
}

static void test_albedo_exactly_0(uint32_t seed)
{
    test_world w = fog_box(0.05, 0);
    kinds k = {0};
    test_world_trace(&w, PHOTONS, seed, note_kind, &k);
    CHECK(k.scattered == 0);
    CHECK(k.later == 0);
    CHECK(k.absorbed > PHOTONS / 2);
    CHECK(k.absorbed == test_photons(&w, w.ledger->absorbed_media));
    CHECK(k.absorbed == (double)murk_tally_read(&w.ledger->collisions));
    test_world_unmade(&w);
}

static void test_albedo_exactly_1(uint32_t seed)
{
    test_world w = fog_box(0.2, 1);
    kinds k = {0};
    test_world_trace(&w, 2000, seed, note_kind, &k);
    CHECK(k.absorbed == 0);
    CHECK(k.scattered > 2000);
    CHECK(test_photons(&w, w.ledger->absorbed_media) == 0);
    CHECK(test_photons(&w, w.ledger->escaped) == 2000);
    test_world_unmade(&w);
}

/* Fog from x = 0 to 4, a black wall at x = 1 in it: of a beam from x = -1,
 * exp(-s) reaches the wall, and nothing goes on. */
static void test_fog_crosses_a_wall(uint32_t seed)
{
    const double s = 0.7;
    const murk_source beam =
        test_beam(murk_vec(-1, 0.3, 0.2), murk_vec(1, 0, 0));
    const murk_surface_desc wall = test_rect(
        murk_vec(1, -20, -20), murk_vec(0, 40, 0), murk_vec(0, 0, 40), 0);
    const murk_medium fog = test_medium(s, 0, 0);
    const murk_region region =
        test_box_region(0, murk_vec(0, -20, -20), murk_vec(4, 20, 20));
    test_world w = test_world_made(&(test_setup){.domain = hall,
                                                 .lights = &beam,
                                                 .n_lights = 1,
                                                 .surfaces = &wall,
                                                 .n_surfaces = 1,
                                                 .media = &fog,
                                                 .n_media = 1,
                                                 .regions = &region,
                                                 .n_regions = 1});
    test_world_trace(&w, PHOTONS, seed, NULL, NULL);
    const double reached = test_photons(&w, w.ledger->absorbed_surfaces);
    const double t = exp(-s);
    CHECK_WITHIN(limit(), reached / PHOTONS, t, sqrt(t * (1 - t) / PHOTONS));
    CHECK(reached + test_photons(&w, w.ledger->absorbed_media) == PHOTONS);
    /* Teeth: fog that began at the lamp. */
    const double wrong = exp(-2 * s);
    CHECK(sigmas_off(reached / PHOTONS, wrong,
                     sqrt(wrong * (1 - wrong) / PHOTONS)) > limit());
    test_world_unmade(&w);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_lamp_in_fog(seed);
    test_albedo_exactly_0(seed);
    test_albedo_exactly_1(seed);
    test_fog_crosses_a_wall(seed);
    return check_done();
}
