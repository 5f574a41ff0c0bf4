/* Regions of interest: who lies in them, what they weigh, how much of them is
 * in view and with what error.
 *
 * The repetitions: 2 z-tests share a chance of 1e-6 of a false alarm per seed
 * (Sidak); the seed is fixed, so the verdict repeats. */
#include "base/rng.h"
#include "closed_mesh.h"
#include "sensing/weights.h"
#include "world.h"

#define CHECKS 2
#define BUDGET 1e-6

static uint32_t seed = 3;

static const murk_vec3 none = {0, 0, 0}, up = {0, 0, 1}, east = {1, 0, 0};

/* ---- membership ---- */

#define SLACK 1e-5

static uint64_t regions_of(const murk_interest_region *region, size_t n,
                           const murk_boundary_meshes *boundary_meshes,
                           murk_photon photon)
{
    const murk_interest interest = {region, n, boundary_meshes, 1};
    return murk_interest_at(&interest, &photon, SLACK);
}

static murk_interest_region a_region(murk_region_shape shape)
{
    return (murk_interest_region){.name = "r",
                                  .weight = 1,
                                  .shape = shape,
                                  .material = -1,
                                  .medium = -1,
                                  .where = "r"};
}

static void test_shapes_are_closed(void)
{
    murk_interest_region r[2] = {a_region(MURK_REGION_BOX),
                                 a_region(MURK_REGION_SPHERE)};
    r[0].box = (murk_box){{-1, -1, -1}, {0.1, 1, 1}};
    r[1].center = murk_vec(3, 0, 0);
    r[1].radius_m = 0.7;
    /* 0.1 in single precision is a little more than 0.1. */
    const murk_vec3 wall = {0.1, 0, 0}, beyond = {0.1 + 3 * SLACK, 0, 0};
    CHECK(regions_of(r, 2, NULL, a_photon(wall, east, 0)) == 1);
    CHECK(regions_of(r, 2, NULL, a_photon(beyond, east, 0)) == 0);
    CHECK(regions_of(r, 2, NULL, a_photon(beyond, none, 0)) == 0);
    CHECK(regions_of(r, 2, NULL, a_photon(none, none, 0)) == 1);
    const murk_vec3 in = {3, 0.6, 0}, rim = {3, 0, 0.7}, out = {3, 0, 0.71};
    CHECK(regions_of(r, 2, NULL, a_photon(in, none, 0)) == 2);
    CHECK(regions_of(r, 2, NULL, a_photon(rim, up, 0)) == 2);
    CHECK(regions_of(r, 2, NULL, a_photon(out, up, 0)) == 0);
}

/* The faces of a cube lie in the region of the cube, whichever side the
 * light came from. The floor under the cube does, too, but no surface a
 * little farther away. */
static void test_a_mesh_holds_its_own_faces(void)
{
    /* A cube as a mesh that stands on z = 0. */
    const double square[4][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
    const uint32_t cut[6] = {0, 1, 2, 0, 2, 3};
    murk_mesh *mesh = closed_prism(square, 4, cut, 0, 1);
    const murk_boundary_mesh_desc desc = {.region = 1,
                                          .mesh = mesh,
                                          .to_world = murk_affine_identity(),
                                          .where = "mesh"};
    murk_boundary_meshes *boundary_meshes = NULL;
    murk_error err = {0};
    CHECK(murk_boundary_meshes_create(&boundary_meshes, &desc, 1, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    if (!boundary_meshes) {
        return;
    }
    /* Bit 0 stands for everywhere, bit 1 for the mesh. */
    const murk_interest_region r[2] = {a_region(MURK_REGION_EVERYWHERE),
                                       a_region(MURK_REGION_MESH)};
    const murk_vec3 top = {1.3, 1.6, 1}, side = {2, 1.3, 0.4},
                    floor = {1.3, 1.6, 0}, beside = {2.1, 1.3, 0},
                    down = {0, 0, -1}, middle = {1.4, 1.6, 0.5},
                    above = {1.4, 1.6, 1.01};
    /* Records on the faces are in the mesh, records on the floor only under
     * the cube. */
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(top, up, 0)) == 3);
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(top, down, 0)) == 3);
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(side, east, 0)) == 3);
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(floor, up, 0)) == 3);
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(beside, up, 0)) == 1);
    /* Volume records are in the mesh only between the faces. */
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(middle, none, 0)) == 3);
    CHECK(regions_of(r, 2, boundary_meshes, a_photon(above, none, 0)) == 1);
    murk_boundary_meshes_destroy(boundary_meshes);
    murk_mesh_destroy(mesh);
}

/* Material 1 and medium 1 are different things. */
static void test_materials_and_media(void)
{
    murk_interest_region r[3] = {a_region(MURK_REGION_EVERYWHERE),
                                 a_region(MURK_REGION_EVERYWHERE),
                                 a_region(MURK_REGION_BOX)};
    r[0].material = 1;
    r[1].medium = 1;
    r[2].box = (murk_box){{0, 0, 0}, {1, 1, 1}};
    r[2].material = 1;
    murk_photon wall = a_photon(murk_vec(0.5, 0.5, 0), up, 0);
    murk_photon air = a_photon(murk_vec(0.5, 0.5, 0.5), none, 0);
    CHECK(regions_of(r, 3, NULL, wall) == 0 &&
          regions_of(r, 3, NULL, air) == 0);
    wall.material = air.material = 1;
    CHECK(regions_of(r, 3, NULL, wall) == 5);
    CHECK(regions_of(r, 3, NULL, air) == 2);
    wall.position_m[0] = 1.5f;
    CHECK(regions_of(r, 3, NULL, wall) == 1);
}

static void test_factors_multiply(void)
{
    murk_interest_region r[3] = {a_region(MURK_REGION_EVERYWHERE),
                                 a_region(MURK_REGION_EVERYWHERE),
                                 a_region(MURK_REGION_EVERYWHERE)};
    r[0].weight = 3;
    r[1].weight = 0.5;
    r[2].weight = 0;
    const murk_interest interest = {r, 3, NULL, 0.25};
    CHECK(murk_interest_factor(&interest, 0) == 0.25);
    CHECK(murk_interest_factor(&interest, 1) == 3);
    CHECK(murk_interest_factor(&interest, 3) == 1.5);
    CHECK(murk_interest_factor(&interest, 5) == 0);
}

/* ---- a hall with a wall across at x = 5, and what is seen in it ---- */

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_map_weights balanced = {.balanced = true};
static const murk_map_weights plain_count = {.surface = 1, .volume = 1};

typedef struct world {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

static world build(const murk_photon *surface, size_t n_surface,
                   const murk_photon *volume, size_t n_volume, uint64_t emitted,
                   murk_map_weights weights, const murk_interest *interest,
                   unsigned threads)
{
    /* A wall, clear air and both maps. */
    const murk_surface_desc wall =
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL);
    world w = {.surfaces = surfaces_of(&wall, 1),
               .media = clear_air(&hall),
               .surface_map = map_of(surface, n_surface),
               .volume_map = map_of(volume, n_volume)};
    /* A sight with the regions of interest. */
    const murk_sensor_type far = all_round(100);
    const murk_sight_desc desc = {.surfaces = w.surfaces,
                                  .media = w.media,
                                  .domain = hall,
                                  .surface_map = w.surface_map,
                                  .volume_map = w.volume_map,
                                  .photons_emitted = emitted,
                                  .type = &far,
                                  .types = 1,
                                  .through_sheets = true,
                                  .weights = weights,
                                  .interest = interest,
                                  .threads = threads};
    murk_error err = {0};
    CHECK(murk_sight_create(&w.sight, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return w;
}

/* By one sensor west of the wall. */
static murk_coverage_result measure(world *w)
{
    const murk_vec3 sensor = {1, 4, 3};
    murk_coverage_result c = {0};
    murk_error err = {0};
    CHECK(murk_coverage_result_measure(&c, w->sight, partial_at(&sensor, 1), 1,
                                       &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->media);
    murk_surfaces_destroy(w->surfaces);
    return c;
}

/* West of the wall 6 surface photons, east 2; west 1 volume photon, east 3. All
 * north of y = 4 are of interest: 1 of each map west, and the east. */
static void test_by_hand(void)
{
    murk_photon s[8], v[4];
    for (uint32_t i = 0; i < 8; ++i) {
        s[i] = a_photon(murk_vec(i < 6 ? 2 : 8, i < 5 ? 2 : 6, 1), up, i);
    }
    for (uint32_t i = 0; i < 4; ++i) {
        v[i] = a_photon(murk_vec(i < 1 ? 2 : 8, 6, 1), none, 10 + i);
    }
    murk_interest_region r[2] = {a_region(MURK_REGION_BOX),
                                 a_region(MURK_REGION_BOX)};
    r[0].box = (murk_box){{0, 4, 0}, {10, 8, 4}};
    r[0].weight = 5;
    r[1].box = (murk_box){{0, 0, 0}, {10, 4, 4}};
    murk_interest interest = {r, 2, NULL, 1};
    world w = build(s, 8, v, 4, 100, plain_count, &interest, 1);
    CHECK(murk_sight_regions(w.sight, 0) != 0);
    murk_coverage_result c = measure(&w);
    CHECK(c.region[0].photons == 7 && c.region[1].photons == 5);
    CHECK_NEAR(c.region[0].coverage.value, 2.0 / 7, 1e-15);
    CHECK_NEAR(c.region[1].coverage.value, 1, 1e-15);
    CHECK_NEAR(c.region[1].coverage.standard_error, 0, 1e-15);
    CHECK_NEAR(c.total.value, (5 + 5 * 2) / (5 + 5 * 7.0), 1e-9);
    CHECK_NEAR(c.surface.value, (5 + 5 * 1) / (5 + 5 * 3.0), 1e-15);
    CHECK_NEAR(c.volume.value, 1.0 / 4, 1e-15);
    murk_coverage_result_release(&c);

    w = build(s, 8, v, 4, 100, balanced, &interest, 1);
    c = measure(&w);
    CHECK_NEAR(c.region[0].coverage.value, (1.0 / 3 + 1.0 / 4) / 2, 1e-15);
    CHECK_NEAR(c.region[1].coverage.value, 1, 1e-15);
    murk_coverage_result_release(&c);

    interest.elsewhere = 0;
    interest.n = 1;
    w = build(s, 8, v, 4, 100, balanced, &interest, 1);
    c = measure(&w);
    CHECK_NEAR(c.total.value, (1.0 / 3 + 1.0 / 4) / 2, 1e-9);
    murk_coverage_result_release(&c);

    r[0].weight = 0; /* in view all the same */
    interest.elsewhere = 1;
    w = build(s, 8, v, 4, 100, balanced, &interest, 1);
    c = measure(&w);
    CHECK_NEAR(c.total.value, 1, 1e-9);
    CHECK(isnan(c.volume.value));
    CHECK_NEAR(c.region[0].coverage.value, (1.0 / 3 + 1.0 / 4) / 2, 1e-15);
    murk_coverage_result_release(&c);
}

/* ---- many photons ---- */

#define RECORDS 4000
#define EMITTED 400

typedef struct sample {
    murk_photon surface[RECORDS], volume[RECORDS];
    size_t n_surface, n_volume;
} sample;

static void store(sample *out, bool is_volume, murk_vec3 p, uint32_t emitted,
                  float power_w)
{
    murk_photon *photon = is_volume ? &out->volume[out->n_volume++]
                                    : &out->surface[out->n_surface++];
    *photon = a_photon(p, is_volume ? none : up, emitted);
    photon->power_w = power_w;
}

/* A photon goes west with chance 0.4 and north with 0.5, and stays there: west
 * it stores 1 record of either map, east 3 on surfaces and 5 in the volume,
 * each north or south as a coin falls. */
#define WEST    0.4
#define SURFACE (WEST * 1 / (WEST * 1 + (1 - WEST) * 3))
#define VOLUME  (WEST * 1 / (WEST * 1 + (1 - WEST) * 5))

static void draw(sample *out, uint32_t repetition)
{
    out->n_surface = out->n_volume = 0;
    for (uint32_t e = 0; e < EMITTED; ++e) {
        const bool west =
            murk_random(seed, MURK_TEST, e, repetition, 0).u[0] < WEST;
        const uint32_t n = west ? 2 : 8;
        for (uint32_t k = 0; k < n; ++k) {
            const murk_random4 q =
                murk_random(seed, MURK_TEST, e, repetition, 1 + k);
            const murk_vec3 p = {west ? 2 : 8, 0.1 + 7.8 * q.u[0], 1};
            store(out, k >= (west ? 1u : 3u), p, e, (float)(0.5 + q.u[1]));
        }
    }
}

static murk_coverage_result of_sample(const sample *s, murk_map_weights weights,
                                      const murk_interest *interest,
                                      unsigned threads)
{
    world w = build(s->surface, s->n_surface, s->volume, s->n_volume, EMITTED,
                    weights, interest, threads);
    return measure(&w);
}

/* What holds all there is has the coverage of the total, error and all, in the
 * maps' weights, whatever it weighs itself. */
static void test_the_region_of_all_is_the_total(void)
{
    static sample s;
    draw(&s, 1000);
    murk_interest_region r[2] = {a_region(MURK_REGION_BOX),
                                 a_region(MURK_REGION_EVERYWHERE)};
    r[0].box = hall.box;
    r[0].weight = 7;
    r[1].material = 200;
    const murk_interest interest = {r, 2, NULL, 1};
    const murk_map_weights weights[4] = {
        balanced, plain_count, {false, 2, 0.25}, {false, 0, 1}};
    for (int k = 0; k < 4; ++k) {
        murk_coverage_result with = of_sample(&s, weights[k], &interest, 2);
        murk_coverage_result plain = of_sample(&s, weights[k], NULL, 1);
        const murk_estimate all = with.region[0].coverage;
        /* Whole-number weights round by less than 2^-20 of the mean. */
        CHECK_NEAR(all.value, plain.total.value, 0x1p-20);
        CHECK_NEAR(all.standard_error, plain.total.standard_error, 0x1p-20);
        CHECK_NEAR(with.total.value, plain.total.value, 0x1p-20);
        CHECK_NEAR(with.surface.value, plain.surface.value, 1e-12);
        CHECK(plain.total.standard_error > 0x1p-10);
        CHECK(plain.region == NULL);
        CHECK(with.region[1].photons == 0);
        CHECK(isnan(with.region[1].coverage.value));
        murk_coverage_result_release(&with);
        murk_coverage_result_release(&plain);
    }
}

#define REPETITIONS 400

/* A squared pull has mean 1 and variance 2. */
static void test_the_error_is_the_spread(void)
{
    static sample s;
    murk_interest_region r = a_region(MURK_REGION_BOX);
    r.box = (murk_box){{0, 4, 0}, {10, 8, 4}};
    r.weight = 3;
    const murk_interest interest = {&r, 1, NULL, 1};
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const double sigma = sqrt(2.0 / REPETITIONS);
    double balance = 0, count = 0, binomial = 0, shifted = 0;
    for (uint32_t k = 0; k < REPETITIONS; ++k) {
        draw(&s, k);
        murk_coverage_result c = of_sample(&s, balanced, &interest, 1);
        murk_estimate got = c.region[0].coverage;
        const double want = (SURFACE + VOLUME) / 2;
        const double pull = (got.value - want) / got.standard_error;
        const double n = (double)c.region[0].photons;
        balance += pull * pull / REPETITIONS;
        shifted +=
            pow((got.value - 0.9 * want) / got.standard_error, 2) / REPETITIONS;
        binomial += (got.value - want) * (got.value - want) /
                    (got.value * (1 - got.value) / n) / REPETITIONS;
        murk_coverage_result_release(&c);
        c = of_sample(&s, plain_count, &interest, 1);
        got = c.region[0].coverage;
        const double all = WEST * 2 / (WEST * 2 + (1 - WEST) * 8);
        count += pow((got.value - all) / got.standard_error, 2) / REPETITIONS;
        murk_coverage_result_release(&c);
    }
    CHECK_WITHIN(limit, balance, 1, sigma);
    CHECK_WITHIN(limit, count, 1, sigma);
    /* Teeth: a coverage off by a tenth of itself, and records taken as
     * independent, must both be noticed. */
    CHECK(shifted > 1 + limit * sigma);
    CHECK(binomial > 1 + limit * sigma);
}

static void test_threads_change_nothing(void)
{
    static sample s;
    draw(&s, 2000);
    murk_interest_region r[2] = {a_region(MURK_REGION_BOX),
                                 a_region(MURK_REGION_SPHERE)};
    r[0].box = (murk_box){{0, 4, 0}, {10, 8, 4}};
    r[1].center = murk_vec(8, 4, 1);
    r[1].radius_m = 2;
    r[1].weight = 4;
    const murk_interest interest = {r, 2, NULL, 1};
    murk_coverage_result one = of_sample(&s, balanced, &interest, 1);
    murk_coverage_result five = of_sample(&s, balanced, &interest, 5);
    CHECK(memcmp(one.region, five.region, 2 * sizeof *one.region) == 0);
    CHECK(memcmp(&one.total, &five.total, sizeof one.total) == 0);
    murk_coverage_result_release(&one);
    murk_coverage_result_release(&five);
}

int main(int argc, char **argv)
{
    seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : seed;
    test_shapes_are_closed();
    test_a_mesh_holds_its_own_faces();
    test_materials_and_media();
    test_factors_multiply();
    test_by_hand();
    test_the_region_of_all_is_the_total();
    test_the_error_is_the_spread();
    test_threads_change_nothing();
    return check_done();
}
