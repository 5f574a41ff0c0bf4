/* Light in media that are described in two ways is the same light: two halves
 * of different albedo as one grid and as two boxes; a layered medium as a
 * profile and as a stack of thin boxes; the same puff by nearest voxels and
 * trilinear on a grid so fine that it does not matter.
 *
 * Compared are, photon by photon: absorbed, escaped upwards, and the fluence
 * of either half by collisions (sum of weight leaving / scattering
 * coefficient, as from the volume map). The z-tests of a run share a 1e-6
 * chance of a false alarm (Sidak). Teeth: albedos off by 0.1 and 0.05, and a
 * profile turned upside down, must fail. */
#include "base/stats.h"
#include "check.h"
#include "medium/grid_write.h"
#include "worlds.h"

#include <stdlib.h>
#include <unistd.h>

#define PHOTONS  60000
#define MEASURES 4
#define Z_TESTS  (3 * MEASURES)

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

/* ---- what is counted ---- */

typedef struct counts {
    double *measure[MEASURES]; /* by photon */
    double middle;             /* between the halves, along x */
} counts;

static void count(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    const counts *c = context;
    if (event->kind == MURK_EVENT_MEDIUM && event->leaving == 0) {
        c->measure[0][event->photon] += event->weight;
    }
    if (event->kind == MURK_EVENT_ESCAPED && event->direction_in.z > 0) {
        c->measure[1][event->photon] += event->weight;
    }
    if (event->kind == MURK_EVENT_MEDIUM && event->leaving > 0) {
        const int half = event->position.x < c->middle ? 2 : 3;
        c->measure[half][event->photon] +=
            event->leaving / event->scattering_per_m;
    }
}

typedef struct answer {
    murk_estimate measure[MEASURES];
} answer;

static answer traced(const murk_medium *media, size_t n_media,
                     const murk_region *regions, size_t n_regions,
                     uint32_t seed)
{
    /* Trace these media around one point source; scores are kept by photon. */
    const murk_source light = test_point(murk_vec(1.1, 0.4, 0.3));
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {3, 2, 2}}, false},
                      .lights = &light,
                      .n_lights = 1,
                      .media = media,
                      .n_media = n_media,
                      .regions = regions,
                      .n_regions = n_regions});
    counts c = {.middle = 1};
    for (int i = 0; i < MEASURES; ++i) {
        c.measure[i] = calloc(PHOTONS, sizeof *c.measure[i]);
    }
    test_world_trace(&w, PHOTONS, seed, count, &c);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    /* Mean and standard error of each score; the ledger confirms the
     * absorbed share. */
    answer out;
    for (int i = 0; i < MEASURES; ++i) {
        out.measure[i] = murk_mean_estimate(c.measure[i], PHOTONS);
        free(c.measure[i]);
    }
    CHECK_NEAR(test_photons(&w, w.ledger->absorbed_media) / PHOTONS,
               out.measure[0].value, 1e-9);
    test_world_unmade(&w);
    return out;
}

/* The largest distance between two answers, in their standard errors. */
static double deviation(const answer *a, const answer *b)
{
    double max = 0;
    for (int i = 0; i < MEASURES; ++i) {
        const murk_estimate *x = &a->measure[i], *y = &b->measure[i];
        max =
            fmax(max, sigmas_off(x->value, y->value,
                                 hypot(x->standard_error, y->standard_error)));
    }
    return max;
}

static void check_same(const answer *a, const answer *b)
{
    for (int i = 0; i < MEASURES; ++i) {
        const murk_estimate *x = &a->measure[i], *y = &b->measure[i];
        CHECK(x->value > 0);
        CHECK_WITHIN(limit(), x->value, y->value,
                     hypot(x->standard_error, y->standard_error));
    }
}

/* ---- two halves of different albedo ---- */

static void write_halves(const char *path)
{
    const size_t size[3] = {8, 4, 4}; /* voxels of 0.25 m */
    float density[128], albedo[128];
    for (int i = 0; i < 128; ++i) {
        density[i] = 1;
        albedo[i] = i % 8 < 4 ? 0.9F : 0.3F;
    }
    const murk_grid_field fields[] = {{"density", density, NULL},
                                      {"albedo", albedo, NULL}};
    const murk_affine place = murk_affine_place(murk_vec(0, 0, 0), 0.25,
                                                murk_vec(0.125, 0.125, 0.125));
    murk_error err = {0};
    CHECK(murk_grid_write(path, fields, 2, size, &place, &err) == MURK_OK);
}

static void test_two_halves(uint32_t seed)
{
    /* Write a grid with two fields, density and albedo, and read both. */
    char path[] = "/tmp/murk_halves_XXXXXX";
    const int fd = mkstemp(path);
    CHECK(fd >= 0);
    close(fd);
    write_halves(path);
    murk_grid *grid = NULL, *albedo = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, "density", "test", &err) == MURK_OK);
    CHECK(murk_grid_read_albedo(&albedo, path, "albedo", "test", &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    unlink(path);

    /* The same light in one grid and in two boxes. */
    murk_medium one = test_medium(4, 0, 0.5);
    one.grid = grid;
    one.albedo_grid = albedo;
    const murk_region lies = {.shape = MURK_REGION_GRID,
                              .to_world = murk_affine_identity()};
    murk_medium two[] = {test_medium(4, 0.9, 0.5), test_medium(4, 0.3, 0.5)};
    const murk_region halves[] = {
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(1, 1, 1)),
        test_box_region(1, murk_vec(1, 0, 0), murk_vec(2, 1, 1))};
    const answer by_grid = traced(&one, 1, &lies, 1, seed);
    const answer by_regions = traced(two, 2, halves, 2, seed + 1000);
    check_same(&by_grid, &by_regions);
    /* Teeth: a wrong albedo in one half is seen. */
    two[1] = test_medium(4, 0.4, 0.5);
    const answer wrong = traced(two, 2, halves, 2, seed + 1000);
    CHECK(deviation(&by_grid, &wrong) > 2 * limit());
    murk_grid_destroy(grid);
    murk_grid_destroy(albedo);
}

/* ---- layers ---- */

#define LAYERS MURK_REGIONS_MAX

/* Layers of 1/64 m, each of one extinction, approximate the slopes of a
 * profile: the optical depth through each layer is the same, and a free
 * flight is off by less than one layer, some 1e-4 in optical depth. */
static void test_layers(uint32_t seed)
{
    /* One medium with a profile that has a step. */
    const double z_m[] = {0, 0.5, 0.5, 1};
    const murk_spectrum per_m[] = {
        murk_spectrum_flat(0, 1), murk_spectrum_flat(8, 1),
        murk_spectrum_flat(3, 1), murk_spectrum_flat(1, 1)};
    const murk_profile profile = {4, z_m, per_m};
    murk_medium layered = test_medium(1, 0.8, 0.2);
    layered.profile = &profile;
    murk_region box = test_box_region(0, murk_vec(0, 0, -1), murk_vec(2, 1, 2));
    /* A stack of boxes, each with the extinction in its middle. */
    murk_medium media[LAYERS];
    murk_region regions[LAYERS];
    for (int i = 0; i < LAYERS; ++i) {
        const double low = (double)i / LAYERS, high = (i + 1.0) / LAYERS;
        const double z = (low + high) / 2;
        media[i] = test_medium(z < 0.5 ? 16 * z : 3 - 4 * (z - 0.5), 0.8, 0.2);
        regions[i] = test_box_region((size_t)i, murk_vec(0, 0, low),
                                     murk_vec(2, 1, high));
    }
    /* Both give the same light. */
    const answer by_profile = traced(&layered, 1, &box, 1, seed);
    const answer by_regions =
        traced(media, LAYERS, regions, LAYERS, seed + 1000);
    check_same(&by_profile, &by_regions);
    /* Teeth: the profile upside down is seen. */
    box.to_world = murk_affine_place(murk_vec(180, 0, 0), 1, murk_vec(0, 1, 1));
    const answer wrong = traced(&layered, 1, &box, 1, seed);
    CHECK(deviation(&wrong, &by_regions) > 2 * limit());
}

/* ---- interpolation ---- */

/* A Gaussian of 0.25 m in voxels of 0.02 m: nearest and linear are each off
 * by less than h^2/8 max|f''| = 1e-3 of the peak on average over a path,
 * far below the error of this many photons. */
static void test_nearest_and_linear(uint32_t seed)
{
    /* Sample the Gaussian in the middle of the world. */
    enum { N = 80 };
    const size_t size[3] = {N, N, N};
    float *density = malloc((size_t)N * N * N * sizeof *density);
    for (size_t i = 0; i < (size_t)N * N * N; ++i) {
        const double x = 0.02 * ((double)(i % N) - (N - 1) / 2.0);
        const double y = 0.02 * ((double)(i / N % N) - (N - 1) / 2.0);
        const double z = 0.02 * ((double)(i / N / N) - (N - 1) / 2.0);
        density[i] = (float)exp(-(x * x + y * y + z * z) / (2 * 0.0625));
    }
    const murk_affine place = murk_affine_place(
        murk_vec(0, 0, 0), 0.02,
        murk_vec(1 - 0.02 * (N - 1) / 2.0, 0.5 - 0.02 * (N - 1) / 2.0,
                 0.5 - 0.02 * (N - 1) / 2.0));
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_from_samples(&grid, size, density, &place, "test", &err) ==
          MURK_OK);
    free(density);
    /* Both interpolations give the same light. */
    murk_medium puff = test_medium(6, 0.7, 0.5);
    puff.grid = grid;
    const murk_region lies = {.shape = MURK_REGION_GRID,
                              .to_world = murk_affine_identity()};
    const answer nearest = traced(&puff, 1, &lies, 1, seed);
    puff.interpolation = MURK_LINEAR;
    const answer linear = traced(&puff, 1, &lies, 1, seed + 1000);
    check_same(&nearest, &linear);
    /* Teeth: a wrong albedo is seen. */
    puff.albedo = murk_spectrum_flat(0.75, 1);
    const answer wrong = traced(&puff, 1, &lies, 1, seed + 1000);
    CHECK(deviation(&nearest, &wrong) > 2 * limit());
    murk_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_two_halves(seed);
    test_layers(seed);
    test_nearest_and_linear(seed);
    return check_done();
}
