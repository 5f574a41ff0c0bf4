/* Where light has scattered often it spreads as heat does, with transport
 * theory's own constants.
 *
 * - A thick slab that only scatters, isotropically, lit by cosine law lets
 *   through (4/3) / (tau + 2 * .7104461) (Milne's extrapolation length; Hopf,
 *   Mathematical Problems of Radiative Equilibrium, 1934; for any g, each more
 *   depth adds 3/4 (1 - g) to 1 / T: van de Hulst, Multiple Light Scattering,
 *   1980, ch. 5). Where tau is 8, what the law leaves out is exp(-8) of it.
 * - Far from a point lamp the fluence rate falls as exp(-k r) / r, k the root
 *   of albedo * artanh(k) = k (Case, de Hoffmann and Placzek 1953), not the
 *   sqrt(3 (1 - albedo)) of diffusion, which it goes to as albedo goes to 1. At
 *   7 mean free paths and more, with albedo .9, the rest is less than .2 %.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "chords.h"
#include "worlds.h"

#include <stdlib.h>

#define Z_TESTS      4
#define MILNE        0.7104460895598
#define SLAB_PHOTONS 150000
#define LAMP_PHOTONS 300000

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static void count_through(void *context, uint64_t batch,
                          const murk_event *event)
{
    (void)batch;
    double *n = context;
    *n += event->kind == MURK_EVENT_ESCAPED && event->position.z == 1;
}

/* 1 / transmittance with its error; the slab is 1 m thick. */
static murk_estimate resistance(double tau, double g, uint32_t seed)
{
    const murk_source lamp = {.type = MURK_SOURCE_RECT,
                              .position = {-.5, -.5, 0},
                              .edge1 = {1, 0, 0},
                              .edge2 = {0, 1, 0},
                              .power_w = {{1}},
                              .where = "lamp"};
    const murk_medium medium = test_medium(tau, 1, g);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-50, -50, 0}, {50, 50, 1}}, true},
                      .lights = &lamp,
                      .n_lights = 1,
                      .media = &medium,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    double through = 0;
    test_world_trace(&w, SLAB_PHOTONS, seed, count_through, &through);
    test_world_unmade(&w);
    const double t = through / SLAB_PHOTONS;
    return (murk_estimate){1 / t, sqrt((1 - t) / t / SLAB_PHOTONS) / t};
}

static void test_thick_slabs(uint32_t seed)
{
    const murk_estimate thin = resistance(8, 0, seed);
    const murk_estimate thick = resistance(16, 0, seed + 1);
    CHECK_WITHIN(limit(), thin.value, .75 * (8 + 2 * MILNE),
                 thin.standard_error);
    CHECK_WITHIN(limit(), thick.value, .75 * (16 + 2 * MILNE),
                 thick.standard_error);
    /* Teeth: an extrapolation length of .5 each. */
    CHECK(sigmas_off(thin.value, .75 * (8 + 2 * .5), thin.standard_error) >
          limit());
    const murk_estimate forward[] = {resistance(20, .6, seed + 2),
                                     resistance(40, .6, seed + 3)};
    const double slope = (forward[1].value - forward[0].value) / 20;
    const double sigma =
        hypot(forward[0].standard_error, forward[1].standard_error) / 20;
    CHECK_WITHIN(limit(), slope, .75 * (1 - .6), sigma);
    CHECK(sigmas_off(slope, .75 * (1 - .5), sigma) > limit());
}

/* The root of albedo * artanh(k) = k. */
static double decay(double albedo)
{
    double low = 1e-9, high = 1 - 1e-12;
    for (int i = 0; i < 100; ++i) {
        const double k = .5 * (low + high);
        *(albedo * atanh(k) > k ? &high : &low) = k;
    }
    return low;
}

/* The integral of r exp(-k r), which is what the light of a shell goes by. */
static double boundary(double k, double r0, double r1)
{
    return (r0 / k + 1 / (k * k)) * exp(-k * r0) -
           (r1 / k + 1 / (k * k)) * exp(-k * r1);
}

/* Lengths that each photon flies in the inner and in the outer shell. */
typedef struct far_away {
    chords balls; /* the two shells' inner and outer radii */
    double inner[LAMP_PHOTONS], outer[LAMP_PHOTONS];
} far_away;

static void note_shells(void *context, uint64_t batch, const murk_event *event)
{
    far_away *f = context;
    chords_note(&f->balls, batch, event);
    f->inner[event->photon] = f->balls.now[1] - f->balls.now[0];
    f->outer[event->photon] = f->balls.now[3] - f->balls.now[2];
}

static void test_far_from_a_lamp(uint32_t seed)
{
    const double albedo = .9, radius[] = {7, 8.5, 10.5, 13};
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_medium medium = test_medium(1, albedo, 0);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-60, -60, -60}, {60, 60, 60}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .media = &medium,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    far_away *f = calloc(1, sizeof *f);
    f->balls.n = 4;
    for (size_t i = 0; i < 4; ++i) {
        f->balls.place[i] = chord_ball(lamp.position, radius[i]);
    }
    test_world_trace(&w, LAMP_PHOTONS, seed, note_shells, f);
    const murk_estimate got =
        murk_ratio_estimate(f->outer, f->inner, LAMP_PHOTONS, LAMP_PHOTONS);
    const double k = decay(albedo), diffusion = sqrt(3 * (1 - albedo));
    CHECK_WITHIN(limit(), got.value,
                 boundary(k, radius[2], radius[3]) /
                     boundary(k, radius[0], radius[1]),
                 got.standard_error);
    /* Teeth: diffusion's own constant. */
    CHECK(sigmas_off(got.value,
                     boundary(diffusion, radius[2], radius[3]) /
                         boundary(diffusion, radius[0], radius[1]),
                     got.standard_error) > limit());
    free(f);
    test_world_unmade(&w);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_thick_slabs(seed);
    test_far_from_a_lamp(seed);
    return check_done();
}
