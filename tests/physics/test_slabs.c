/* Reflectance and transmittance of slabs of fog against published and computed
 * tables, lit straight on and diffusely, in a periodic domain and in a wide
 * open one, with the fog whole and in two overlapping halves.
 *
 * Sources: van de Hulst, Multiple Light Scattering (1980), table 35, by way of
 * Wang and Jacques, Comput. Methods Programs Biomed. 47 (1995) 131, table 1;
 * the other rows by adding-doubling (van de Hulst 1980, ch. 4) with 64 to 120
 * nodes a hemisphere, good to the last digit.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 20000
#define Z_TESTS 32

typedef struct slab {
    double albedo, g, tau;
    double reflected, transmitted;                 /* lit straight on */
    double diffuse_reflected, diffuse_transmitted; /* by cosine law */
} slab;

static const slab slabs[] = {
    {.9, .75, 2, .09739, .66096, NAN, NAN}, /* van de Hulst */
    {.5, 0, 1, .099119, .446058, .134165, .306709},
    {.99, .5, 1, .170728, .814516, .292879, .687422},
    {1, .75, 5, .371879, .628121, .501683, .498317},
    {.99, .875, 5, .175206, .748437, .313252, .593710},
    {.9, .75, 5, .151689, .303021, .239308, .206218},
};

typedef struct ends {
    double back, through;
} ends;

static void count_end(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    ends *e = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        e->back += event->position.z == 0;
        e->through += event->position.z == 1;
    }
}

typedef struct set_up {
    double half_width_m;
    bool is_periodic, is_diffuse, in_halves;
} set_up;

static const set_up narrow = {.half_width_m = 0.5, .is_periodic = true};

/* The slab is 1 m thick, so the extinction per metre is tau. */
static ends traced(const slab *s, set_up how, uint32_t seed)
{
    /* A beam along the normal, or diffuse light from the whole bottom. */
    const double w = how.half_width_m;
    murk_source light = test_beam(murk_vec(0.1, 0.2, 0), murk_vec(0, 0, 1));
    if (how.is_diffuse) {
        light.type = MURK_SOURCE_RECT;
        light.position = murk_vec(-w, -w, 0);
        light.edge1 = murk_vec(2 * w, 0, 0);
        light.edge2 = murk_vec(0, 2 * w, 0);
    }
    /* One medium, or two of half the extinction that lie over each other. */
    const int n = how.in_halves ? 2 : 1;
    const murk_medium medium = test_medium(s->tau / n, s->albedo, s->g);
    const murk_medium media[2] = {medium, medium};
    const murk_region regions[2] = {
        test_everywhere(0),
        test_box_region(1, murk_vec(-2 * w, -2 * w, -1), murk_vec(w, w, 1.5))};
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-w, -w, 0}, {w, w, 1}}, how.is_periodic},
                      .lights = &light,
                      .n_lights = 1,
                      .media = media,
                      .n_media = (size_t)n,
                      .regions = regions,
                      .n_regions = (size_t)n});
    /* Each photon is absorbed or leaves below or above. */
    ends out = {0};
    test_world_trace(&world, PHOTONS, seed, count_end, &out);
    CHECK(test_photons(&world, world.ledger->lost) == 0);
    CHECK(out.back + out.through +
              test_photons(&world, world.ledger->absorbed_media) ==
          PHOTONS);
    test_world_unmade(&world);
    return out;
}

static double off(double count, double share)
{
    return sigmas_off(count / PHOTONS, share,
                      sqrt(share * (1 - share) / PHOTONS));
}

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static void check_share(double count, double share)
{
    CHECK_WITHIN(limit(), count / PHOTONS, share,
                 sqrt(share * (1 - share) / PHOTONS));
}

static void test_published_slabs(uint32_t seed)
{
    for (size_t i = 0; i < sizeof slabs / sizeof *slabs; ++i) {
        const ends e = traced(&slabs[i], narrow, seed + (uint32_t)i);
        check_share(e.back, slabs[i].reflected);
        check_share(e.through, slabs[i].transmitted);
    }
}

static void test_diffuse_light(uint32_t seed)
{
    set_up how = narrow;
    how.is_diffuse = true;
    for (size_t i = 1; i < sizeof slabs / sizeof *slabs; ++i) {
        const ends e = traced(&slabs[i], how, seed + (uint32_t)i);
        check_share(e.back, slabs[i].diffuse_reflected);
        check_share(e.through, slabs[i].diffuse_transmitted);
    }
}

static void test_wide_and_open_is_the_same(uint32_t seed)
{
    const set_up wide = {.half_width_m = 1e4};
    const ends e = traced(&slabs[0], wide, seed);
    check_share(e.back, slabs[0].reflected);
    check_share(e.through, slabs[0].transmitted);
}

static void test_overlapping_halves_are_the_whole(uint32_t seed)
{
    set_up how = narrow;
    how.in_halves = true;
    const ends e = traced(&slabs[0], how, seed);
    check_share(e.back, slabs[0].reflected);
    check_share(e.through, slabs[0].transmitted);
}

/* Teeth: a little less forward, a little thicker, an albedo 2 % lower. */
static void test_would_notice_wrong_fog(uint32_t seed)
{
    slab wrong = slabs[0];
    wrong.g = .70;
    CHECK(off(traced(&wrong, narrow, seed).back, .09739) > limit());
    wrong = slabs[0];
    wrong.tau = 2.2;
    CHECK(off(traced(&wrong, narrow, seed).through, .66096) > limit());
    wrong = slabs[0];
    wrong.albedo = .88;
    CHECK(off(traced(&wrong, narrow, seed).through, .66096) > limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_published_slabs(seed);
    test_diffuse_light(seed);
    test_wide_and_open_is_the_same(seed);
    test_overlapping_halves_are_the_whole(seed);
    test_would_notice_wrong_fog(seed);
    return check_done();
}
