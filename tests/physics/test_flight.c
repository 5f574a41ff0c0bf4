/* Free flight by march and by delta tracking: both follow the exponential law
 * of the exact optical depth, and each other, through every kind of grid; a
 * bound twice as high costs time alone, a bound 20 % too low is noticed.
 *
 * The law (Beer and Lambert) says P(flight > d) = exp(-tau(d)); delta tracking
 * after Woodcock et al., ANL-7050 (1965) 557. All checks of a run share a 1e-6
 * chance of a false alarm: half of it the distances of Kolmogorov and Smirnov,
 * half the z-tests (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "flights.h"
#include "medium/delta.h"
#include "medium/grid_internal.h"
#include "medium/tree.h"
#include "worlds.h"

#include <stdlib.h>

#define FLIGHTS       40000
#define WORLDS        13
#define MEDIA         4 /* at most, of a world */
#define DISTANCES     (3 * WORLDS + 4)
#define Z_TESTS       (MEDIA * WORLDS + WORLDS + 8)
#define HALF_A_BUDGET 0.5e-6

static const murk_box DOMAIN = {{-500, -500, -500}, {500, 500, 500}};

static double distance_limit(void)
{
    return test_flights_limit(HALF_A_BUDGET, DISTANCES);
}

static double z_limit(void)
{
    return murk_sidak_limit(HALF_A_BUDGET, Z_TESTS);
}

/* ---- grids ---- */

typedef float (*fill)(double u, double v, size_t i, size_t j, size_t k);

static float noise(double u, double v, size_t i, size_t j, size_t k)
{
    (void)v, (void)i, (void)j, (void)k;
    return (float)u;
}

static float sparse(double u, double v, size_t i, size_t j, size_t k)
{
    (void)i, (void)j, (void)k;
    return v < 0.03 ? (float)(20 * u) : 0;
}

static float tiles(double u, double v, size_t i, size_t j, size_t k)
{
    (void)v;
    return i < 16 && j >= 8 && j < 24 ? 0.7f
           : k < 8                    ? 0
           : j >= 32                  ? (float)(u < 0.2)
                                      : (float)(i + k) / 80;
}

/* One voxel that makes a thousand null collisions of nearly every flight past
 * it: those march on. */
static float spike(double u, double v, size_t i, size_t j, size_t k)
{
    (void)v;
    return i == 20 && j == 16 && k == 12 ? 1e7f : (float)u;
}

static float blob(double u, double v, size_t i, size_t j, size_t k)
{
    (void)u, (void)v;
    const double x = (double)i - 20, y = (double)j - 16, z = (double)k - 12;
    return (float)exp(-(x * x + y * y + z * z) / 60);
}

static murk_grid *grid_of(fill value, size_t nx, size_t ny, size_t nz,
                          const murk_affine *index_to_world, uint32_t seed)
{
    const size_t size[3] = {nx, ny, nz};
    const murk_affine identity = murk_affine_identity();
    float *density = calloc(nx * ny * nz, sizeof *density);
    CHECK(density != NULL);
    for (size_t n = 0; density && n < nx * ny * nz; ++n) {
        const murk_random4 r = murk_random(seed, MURK_TEST, n, 200, 0);
        density[n] = value(r.u[0], r.u[1], n % nx, n / nx % ny, n / (nx * ny));
    }
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_make(&grid, size, density,
                         index_to_world ? index_to_world : &identity, true,
                         "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    free(density);
    return grid;
}

/* ---- worlds ---- */

/* 1/m by height: two slopes and a jump. */
static const double heights_m[] = {-5, 2, 6, 6, 10};
static const murk_spectrum extinctions[] = {
    {{0}}, {{0.1}}, {{0.01}}, {{0.06}}, {{0.005}}};
static const murk_profile layers = {5, heights_m, extinctions};

typedef struct scene {
    const char *name;
    murk_grid *grid[2];
    murk_medium medium[MEDIA];
    murk_region region[MEDIA];
    size_t n;
    murk_box box; /* where the flights go */
} scene;

static void add(scene *s, murk_region_shape shape, murk_grid *grid,
                double extinction_per_m, double albedo)
{
    murk_medium *medium = &s->medium[s->n];
    *medium = test_medium(extinction_per_m, albedo, 0);
    medium->grid = grid;
    s->region[s->n] = (murk_region){.medium = s->n,
                                    .shape = shape,
                                    .to_world = murk_affine_identity(),
                                    .where = s->name};
    ++s->n;
}

static scene scene_made(int number, uint32_t seed)
{
    /* Each case adds grids and regions; a box is larger if its grid is. */
    static const murk_box box = {{0, 0, 0}, {40, 32, 24}};
    scene s = {.box = box};
    murk_affine own;
    switch (number) {
    case 0:
        s.name = "dense noise";
        s.grid[0] = grid_of(noise, 40, 32, 24, NULL, seed);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.08, 0.9);
        break;
    case 1:
        s.name = "sparse";
        s.grid[0] = grid_of(sparse, 70, 32, 24, NULL, seed);
        s.box.max.x = 70;
        add(&s, MURK_REGION_GRID, s.grid[0], 0.1, 0.5);
        break;
    case 2:
        s.name = "tiles";
        s.grid[0] = grid_of(tiles, 40, 40, 24, NULL, seed);
        s.box.max.y = 40;
        add(&s, MURK_REGION_GRID, s.grid[0], 0.1, 1);
        break;
    case 3:
        s.name = "moved, turned, grown, voxels that are no cubes";
        own = murk_affine_place(murk_vec(10, 20, 30), 1, murk_vec(-4, 1, -3));
        for (int row = 0; row < 3; ++row) {
            own.matrix[row][0] *= 0.5;
        }
        s.grid[0] = grid_of(noise, 40, 32, 24, &own, seed);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.08, 0.9);
        s.region[0].to_world =
            murk_affine_place(murk_vec(-70, 15, 200), 2, murk_vec(20, -8, 3));
        break;
    case 4:
        s.name = "two grids that overlap, haze, and a sphere";
        own = murk_affine_place(murk_vec(0, 0, 45), 0.8, murk_vec(15, -5, 2));
        s.grid[0] = grid_of(blob, 40, 32, 24, NULL, seed);
        s.grid[1] = grid_of(noise, 40, 32, 24, &own, seed);
        add(&s, MURK_REGION_EVERYWHERE, NULL, 0.005, 0.3);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.3, 0.9);
        add(&s, MURK_REGION_GRID, s.grid[1], 0.05, 0.6);
        add(&s, MURK_REGION_SPHERE, NULL, 0.1, 1);
        s.region[3].center = murk_vec(20, 20, 10);
        s.region[3].radius_m = 8;
        break;
    case 5:
        s.name = "a box that replaces part of a grid, a grid after it";
        s.grid[0] = grid_of(noise, 40, 32, 24, NULL, seed);
        s.grid[1] = grid_of(sparse, 30, 32, 24, NULL, seed + 1);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.15, 0.9);
        add(&s, MURK_REGION_BOX, NULL, 0.02, 0.6);
        add(&s, MURK_REGION_GRID, s.grid[1], 0.1, 0.8);
        s.region[1].box = (murk_box){{10, 5, -3}, {28, 40, 18}};
        s.region[1].replaces = true;
        break;
    case 6:
        s.name = "a grid that replaces a sphere and haze";
        s.grid[0] = grid_of(blob, 40, 32, 24, NULL, seed);
        add(&s, MURK_REGION_EVERYWHERE, NULL, 0.02, 0.6);
        add(&s, MURK_REGION_SPHERE, NULL, 0.1, 1);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.3, 0.9);
        s.region[1].center = murk_vec(40, 20, 10);
        s.region[1].radius_m = 10;
        s.region[2].replaces = true;
        break;
    case 7:
        s.name = "dense noise, linear";
        s.grid[0] = grid_of(noise, 40, 32, 24, NULL, seed);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.08, 0.9);
        s.medium[0].interpolation = MURK_LINEAR;
        break;
    case 8:
        s.name = "tiles, linear and moved, over sparse, linear";
        own = murk_affine_place(murk_vec(0, 0, 45), 0.8, murk_vec(15, -5, 2));
        s.grid[0] = grid_of(tiles, 40, 40, 24, &own, seed);
        s.grid[1] = grid_of(sparse, 40, 32, 24, NULL, seed + 1);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.1, 0.9);
        add(&s, MURK_REGION_GRID, s.grid[1], 0.15, 0.6);
        s.medium[0].interpolation = s.medium[1].interpolation = MURK_LINEAR;
        break;
    case 9:
        s.name = "linear over nearest, layers and haze";
        s.grid[0] = grid_of(blob, 40, 32, 24, NULL, seed);
        s.grid[1] = grid_of(noise, 30, 40, 24, NULL, seed + 1);
        add(&s, MURK_REGION_EVERYWHERE, NULL, 0.005, 0.3);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.3, 0.9);
        add(&s, MURK_REGION_GRID, s.grid[1], 0.05, 0.6);
        add(&s, MURK_REGION_EVERYWHERE, NULL, 1, 0.5);
        s.medium[1].interpolation = MURK_LINEAR;
        s.medium[3].profile = &layers;
        break;
    case 10:
        s.name = "grids within a ball and a box, one of which replaces";
        s.grid[0] = grid_of(noise, 40, 32, 24, NULL, seed);
        s.grid[1] = grid_of(noise, 40, 32, 24, NULL, seed + 1);
        add(&s, MURK_REGION_EVERYWHERE, NULL, 0.01, 0.6);
        add(&s, MURK_REGION_SPHERE, s.grid[0], 0.2, 0.9);
        add(&s, MURK_REGION_BOX, s.grid[1], 0.1, 0.5);
        s.region[1].center = murk_vec(30, 20, 15);
        s.region[1].radius_m = 16;
        s.region[2].box = (murk_box){{-9, 2, 3}, {35, 21, 40}};
        s.region[2].replaces = true;
        s.medium[2].interpolation = MURK_LINEAR;
        break;
    case 11:
        s.name = "noise with a spike";
        s.grid[0] = grid_of(spike, 40, 32, 24, NULL, seed);
        add(&s, MURK_REGION_GRID, s.grid[0], 0.08, 0.9);
        break;
    default:
        s.name = "no grid";
        add(&s, MURK_REGION_EVERYWHERE, NULL, 0.02, 0.6);
        add(&s, MURK_REGION_SPHERE, NULL, 0.1, 1);
        s.region[1].center = murk_vec(20, 20, 10);
        s.region[1].radius_m = 10;
        break;
    }
    return s;
}

/* The media, with bounds times a factor in bricks of that edge. */
static murk_media *media_of(const scene *s, int32_t edge, double factor)
{
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, s->medium, s->n, s->region, s->n, &DOMAIN,
                            &err) == MURK_OK);
    CHECK(murk_delta_prepare(media, edge, factor, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

/* Where the flights go: the bounded regions. */

static void scene_unmade(scene *s)
{
    murk_grid_destroy(s->grid[0]);
    murk_grid_destroy(s->grid[1]);
}

/* ---- laws ---- */

/* Two counts of n flights each. */
static double sigmas_between(double a, double b)
{
    const double p = (a + b) / (2. * FLIGHTS);
    return a == b ? 0 : fabs(a - b) / sqrt(2. * FLIGHTS * p * (1 - p));
}

static void test_march_and_delta_follow_the_law(int number, uint32_t seed)
{
    /* Fly through the media of one scene by marching and by delta tracking. */
    scene s = scene_made(number, seed);
    murk_media *media = media_of(&s, 8 << seed % 3, 1);
    s.box = murk_media_bounds(media);
    const int failures = check_failures;
    test_flights march = test_fly(media, &s.box, FLIGHTS, seed, false);
    test_flights delta = test_fly(media, &s.box, FLIGHTS, seed, true);
    /* Both follow the exponential law, and collide equally often with each
     * medium. */
    CHECK(test_flights_off_law(&march) < distance_limit());
    CHECK(test_flights_off_law(&delta) < distance_limit());
    CHECK(test_flights_distance(&march, &delta) < distance_limit());
    CHECK(sigmas_between(march.collided, delta.collided) < z_limit());
    for (size_t i = 0; i < s.n; ++i) {
        CHECK(march.partner[i] > 0.002 * FLIGHTS);
        CHECK(sigmas_between(march.partner[i], delta.partner[i]) < z_limit());
    }
    /* No collision states values other than those of the media at the
     * place, and the scene is neither too clear nor too dense for a test. */
    CHECK(march.wrong == 0 && delta.wrong == 0);
    CHECK(march.collided > 0.2 * FLIGHTS && march.collided < 0.95 * FLIGHTS);
    if (check_failures > failures) {
        printf("  in the world of %s\n", s.name);
    }
    test_flights_free(&march);
    test_flights_free(&delta);
    murk_media_destroy(media);
    scene_unmade(&s);
}

static void test_a_spike_is_marched_past(uint32_t seed)
{
    scene s = scene_made(11, seed);
    murk_media *media = media_of(&s, 8, 1);
    const murk_address address = {seed, MURK_TEST, 0, 300};
    murk_flight_randoms dice = {.address = &address};
    murk_collision c;
    murk_delta_fly(media, 0, 0, murk_vec(-5, 17, 12), murk_vec(1, 0, 0), 50, 20,
                   0.5, &dice, &c);
    CHECK(dice.nulls == MURK_NULLS_MAX + 1);
    murk_media_destroy(media);
    scene_unmade(&s);
}

/* What was tried, over flights, and its variance. */
static double tried_mean(const test_flights *f)
{
    return f->tried / FLIGHTS;
}

static double tried_variance_of_mean(const test_flights *f)
{
    const double mean = tried_mean(f);
    return (f->tried_squared / FLIGHTS - mean * mean) / FLIGHTS;
}

/* Collisions tried, real and null, are as many as the bound's optical depth
 * along the flight: twice the bound, twice the tries; twice the same flights.
 */
static void test_twice_the_bound_changes_nothing_but_time(uint32_t seed)
{
    scene s = scene_made(0, seed);
    murk_media *once = media_of(&s, 16, 1), *twice = media_of(&s, 16, 2);
    test_flights a = test_fly(once, &s.box, FLIGHTS, seed, true);
    test_flights b = test_fly(twice, &s.box, FLIGHTS, seed + 1, true);
    CHECK(test_flights_off_law(&b) < distance_limit());
    CHECK(sigmas_between(a.collided, b.collided) < z_limit());
    const double sigma =
        sqrt(4 * tried_variance_of_mean(&a) + tried_variance_of_mean(&b));
    CHECK_WITHIN(z_limit(), tried_mean(&b), 2 * tried_mean(&a), sigma);
    /* Teeth: not as many, nor three times as many. */
    CHECK(sigmas_off(tried_mean(&b), tried_mean(&a), sigma) > z_limit());
    CHECK(sigmas_off(tried_mean(&b), 3 * tried_mean(&a), sigma) > z_limit());
    test_flights_free(&a);
    test_flights_free(&b);
    murk_media_destroy(once);
    murk_media_destroy(twice);
    scene_unmade(&s);
}

/* Teeth: a bound 20 % too low lets light through. */
static void test_would_notice_a_low_bound(uint32_t seed)
{
    static const int worlds[] = {0, 2, 2};
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; ++i) {
        scene s = scene_made(worlds[i], seed);
        s.medium[0].interpolation = i == 2 ? MURK_LINEAR : MURK_NEAREST;
        murk_media *low = media_of(&s, 16, 0.8);
        test_flights f = test_fly(low, &s.box, 4 * FLIGHTS, seed, true);
        CHECK(test_flights_off_law(&f) > distance_limit());
        test_flights_free(&f);
        murk_media_destroy(low);
        scene_unmade(&s);
    }
}

typedef struct ends {
    double back, through;
} ends;

static void count_end(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    ends *e = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        e->back += event->position.z == -0.5;
        e->through += event->position.z == 23.5;
    }
}

typedef struct slab_run {
    ends ends;
    double absorbed, collisions;
} slab_run;

/* Sends a beam from below into a slab of noise that is periodic sideways. */
static slab_run run_slab(const murk_grid *grid, double extinction_per_m,
                         bool by_delta, uint32_t seed)
{
    /* The slab fills the periodic domain in x and y. */
    murk_medium smoke = test_medium(extinction_per_m, 0.9, 0.5);
    smoke.grid = grid;
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity(),
                                .where = "slab"};
    const murk_source beam =
        test_beam(murk_vec(11.2, 7.4, -0.5), murk_vec(0.6, 0, 0.8));
    test_world w = test_world_made(&(test_setup){
        .domain = {{{-0.5, -0.5, -0.5}, {39.5, 31.5, 23.5}}, true},
        .lights = &beam,
        .n_lights = 1,
        .media = &smoke,
        .n_media = 1,
        .regions = &region,
        .n_regions = 1});
    /* Trace by the chosen kind of free flight. */
    murk_error err = {0};
    CHECK(murk_media_prepare_delta(w.media, &err) == MURK_OK);
    slab_run run = {{0}, 0, 0};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = FLIGHTS;
    trace.by_delta = by_delta;
    trace.sink = count_end;
    trace.context = &run.ends;
    murk_trace_run(&trace, w.ledger);
    /* Each photon is absorbed or leaves below or above. */
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    run.absorbed = test_photons(&w, w.ledger->absorbed_media);
    run.collisions = (double)murk_tally_read(&w.ledger->collisions);
    CHECK(run.absorbed + run.ends.back + run.ends.through == FLIGHTS);
    test_world_unmade(&w);
    return run;
}

/* Reflected, through, absorbed: the same under both, and each collision in the
 * ledger is real: a tenth of them absorbs (nearly Poisson, given how many). */
static void test_a_slab_of_noise(uint32_t seed)
{
    murk_grid *grid = grid_of(noise, 40, 32, 24, NULL, seed);
    const slab_run a = run_slab(grid, 0.3, false, seed);
    const slab_run b = run_slab(grid, 0.3, true, seed + 1);
    CHECK(sigmas_between(a.ends.back, b.ends.back) < z_limit());
    CHECK(sigmas_between(a.ends.through, b.ends.through) < z_limit());
    CHECK(sigmas_between(a.absorbed, b.absorbed) < z_limit());
    CHECK_WITHIN(z_limit(), a.absorbed, a.collisions / 10,
                 sqrt(a.collisions / 10));
    CHECK_WITHIN(z_limit(), b.absorbed, b.collisions / 10,
                 sqrt(b.collisions / 10));
    /* Teeth: 10 % less extinction. */
    const slab_run c = run_slab(grid, 0.27, true, seed + 2);
    CHECK(sigmas_between(a.ends.through, c.ends.through) > z_limit());
    murk_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    for (int number = 0; number < WORLDS; ++number) {
        test_march_and_delta_follow_the_law(number, seed);
    }
    test_a_spike_is_marched_past(seed);
    test_twice_the_bound_changes_nothing_but_time(seed);
    test_would_notice_a_low_bound(seed);
    test_a_slab_of_noise(seed);
    return check_done();
}
