/* Pictures of a floor that is lit through what bends light: the surface of
 * water, and a plate of glass. No shadow ray passes either, so a path that goes
 * on and meets the lamp has all of its light, whatever shadow rays have a share
 * in elsewhere. And the errors that the maps say under water.
 *
 * The irradiance is an integral over the angle of what arrives, by Snell's and
 * Fresnel's laws. A mean is right within chance and a small allowance for what
 * the integral leaves out; 3 % more or less is refused. The z-tests share a
 * 1e-6 chance of a false alarm (Sidak). */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "photonmap/map.h"
#include "pictures.h"
#include "render/render.h"
#include "worlds.h"

#include <stdlib.h>

#define CASES   2
#define DIFFUSE 0.5
#define STEPS   20000 /* of the integrals, which are then known to 1e-5 */

/* The floor is a patch of 4 cm, which is lit a little less at its rim. */
#define ALLOWED 1e-3

/* The lamp: a square of that half side above the patch, of radiance 1. */
#define HALF_M 1.0

static murk_source lamp_at(double z)
{
    return (murk_source){.type = MURK_SOURCE_RECT,
                         .position = {-HALF_M, -HALF_M, z},
                         .edge1 = {0, 2 * HALF_M, 0},
                         .edge2 = {2 * HALF_M, 0, 0},
                         .power_w = {{4 * HALF_M * HALF_M * MURK_PI}}};
}

static murk_image *taken(const test_world *world, const murk_render *wanted)
{
    murk_render render = *wanted;
    render.threads = 2;
    return picture_of_world(render, world);
}

/* Share of the azimuths at which a circle of that radius about the middle of
 * the lamp lies in it. */
static double share_in_lamp(double radius)
{
    return radius <= HALF_M ? 1
           : radius >= HALF_M * sqrt(2.0)
               ? 0
               : 1 - 4 / MURK_PI * acos(HALF_M / radius);
}

/* Reflectance of unpolarised light that arrives at that cosine in index n1 and
 * leaves at cosine c2 in n2: the mean of Fresnel's two. */
static double reflected(double n1, double c1, double n2, double c2)
{
    const double s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    const double p = (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1);
    return (s * s + p * p) / 2;
}

/* Checks the radiance of a patch of floor below the lamp, seen from near,
 * for a given irradiance. */
static void check_patch(const char *name, const test_setup *wanted,
                        double irradiance)
{
    /* The patch on the floor, in the world that the caller gives. */
    const murk_surface_desc patch = test_rect(
        murk_vec(-.02, -.02, 0), murk_vec(.04, 0, 0), murk_vec(0, .04, 0), 0);
    murk_surface_desc surface[2] = {patch};
    const murk_material material[2] = {test_material(DIFFUSE, 0, 0, 0),
                                       test_material(0, 0, 1, 1.5)};
    test_setup setup = *wanted;
    for (size_t i = 0; i < wanted->n_surfaces; ++i) {
        surface[1 + i] = wanted->surfaces[i];
    }
    setup.domain = (murk_domain){{{-4, -4, -1}, {4, 4, 5}}, false};
    setup.surfaces = surface;
    setup.n_surfaces = 1 + wanted->n_surfaces;
    setup.materials = material;
    setup.n_materials = 2;
    setup.n_lights = 1;
    test_world world = test_world_made(&setup);
    /* A picture of the patch from 0.5 m above. */
    murk_image *p =
        taken(&world, &(murk_render){.camera = murk_camera_aimed(
                                         murk_vec(0, 0, 0.5), murk_vec(0, 0, 0),
                                         murk_vec(0, 1, 0), 0.002, 8, 8),
                                     .samples = 4000,
                                     .method = MURK_BY_PATHS});
    /* The radiance is right, and a deviation of 3 % would be noticed. */
    const double limit = murk_sidak_limit(1e-6, CASES);
    const double want = DIFFUSE / MURK_PI * irradiance;
    printf("%s: %.6g +- %.2g, is %.6g\n", name, p->mean[0], p->mean_error[0],
           want);
    const double max = limit * p->mean_error[0] + ALLOWED * want;
    CHECK(fabs(p->mean[0] - want) < max);
    CHECK(max < 0.03 / 1.03 * want);
    CHECK(p->lost == 0);
    murk_image_destroy(p);
    test_world_unmade(&world);
}

/* The patch and the camera 1 m under water, the lamp 0.5 m above it. In the
 * water radiance is n^2 times as much, less what the surface reflects. */
static void test_a_lamp_above_the_water(void)
{
    const double n = 1.34, deep_m = 1, above_m = 0.5;
    double irradiance = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double sine = (i + 0.5) / STEPS; /* in air */
        const double in_water = sine / n;
        const double cosine = sqrt(1 - sine * sine);
        const double down = sqrt(1 - in_water * in_water);
        const double radius =
            deep_m * in_water / down + above_m * sine / cosine;
        /* n^2 L cos sin dtheta in water is L sin d(sin) in air */
        irradiance += 2 * MURK_PI / STEPS * sine *
                      (1 - reflected(1, cosine, n, down)) *
                      share_in_lamp(radius);
    }
    const murk_source lamp = lamp_at(deep_m + above_m);
    const murk_medium clear = test_medium(0, 0, 0);
    const murk_region water = {.shape = MURK_REGION_BELOW,
                               .below_z_m = deep_m,
                               .ior = n,
                               .replaces = true,
                               .where = "water"};
    check_patch("a lamp above the water",
                &(test_setup){.lights = &lamp,
                              .media = &clear,
                              .n_media = 1,
                              .regions = &water,
                              .n_regions = 1},
                irradiance);
}

/* A plate of glass, 0.3 m thick, between the patch and the lamp. Light that
 * is reflected to and fro within the plate comes from farther aside each
 * time. */
static void test_a_lamp_behind_a_plate_of_glass(void)
{
    /* Integrate over angles in air and over the passes through the glass. */
    const double n = 1.5, thick_m = 0.3, high_m = 1.6;
    double irradiance = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double sine = (i + 0.5) / STEPS;
        const double in_glass = sine / n;
        const double cosine = sqrt(1 - sine * sine);
        const double down = sqrt(1 - in_glass * in_glass);
        const double back = reflected(1, cosine, n, down);
        double share = (1 - back) * (1 - back);
        for (int passes = 1; passes < 20; passes += 2, share *= back * back) {
            const double radius = (high_m - thick_m) * sine / cosine +
                                  passes * thick_m * in_glass / down;
            irradiance +=
                2 * MURK_PI / STEPS * sine * share * share_in_lamp(radius);
        }
    }
    /* The same plate as a box of glass. */
    const murk_source lamp = lamp_at(high_m);
    const murk_surface_desc plate =
        test_box(murk_vec(-3.5, -3.5, 1), murk_vec(3.5, 3.5, 1 + thick_m), 1);
    check_patch(
        "a lamp behind glass",
        &(test_setup){.lights = &lamp, .surfaces = &plate, .n_surfaces = 1},
        irradiance);
}

/* ---- maps ---- */

#define RECORDS 3000

/* Records all over a floor, of three photons each. */
static murk_photon_map *records(void)
{
    murk_photon *photons = calloc(RECORDS, sizeof *photons);
    for (uint32_t i = 0; i < RECORDS; ++i) {
        const murk_random4 u = murk_random(1, MURK_TEST, i, 0, 0);
        photons[i] = (murk_photon){
            .position_m = {(float)(4 * u.u[0] - 2), (float)(4 * u.u[1] - 2), 0},
            .direction = murk_direction_pack(murk_vec(0, 0, -1)),
            .normal = murk_direction_pack(murk_vec(0, 0, 1)),
            .power_w = (float)u.u[2],
            .emitted = i / 3,
            .kind = murk_photon_kind(false, 2)};
    }
    murk_photon_map *map = NULL;
    murk_error err = {0};
    CHECK(murk_photon_map_create(&map, photons, RECORDS, 1, &err) == MURK_OK);
    return map;
}

/* A picture of a floor that the maps alone light, in a medium of the given
 * index all over the domain. */
static murk_image *by_maps(const murk_photon_map *map,
                           const murk_photon_map *none, double index)
{
    /* A floor and a region with the index over the whole domain. */
    const murk_surface_desc floor =
        test_rect(murk_vec(-3, -3, 0), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 0);
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    const murk_medium clear = test_medium(0, 0, 0);
    const murk_source lamp = test_point(murk_vec(0, 0, 2));
    const murk_region all = {.shape = MURK_REGION_BELOW,
                             .below_z_m = 10,
                             .ior = index,
                             .replaces = true,
                             .where = "water"};
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &floor,
                      .n_surfaces = 1,
                      .materials = &paint,
                      .n_materials = 1,
                      .media = &clear,
                      .n_media = 1,
                      .regions = &all,
                      .n_regions = 1});
    /* A picture of the floor by the maps alone. */
    murk_image *p =
        taken(&world, &(murk_render){.camera = murk_camera_aimed(
                                         murk_vec(0, 0, 1), murk_vec(0, 0, 0),
                                         murk_vec(0, 1, 0), 0.6, 6, 4),
                                     .samples = 8,
                                     .method = MURK_BY_MAPS_ONLY,
                                     .surface = map,
                                     .volume = none});
    test_world_unmade(&world);
    return p;
}

/* Where all is under water the index changes nothing: a record's watt is a
 * watt. So neither radiance nor error depends on it. */
static void test_the_index_changes_no_error_of_maps(void)
{
    murk_photon_map *map = records(), *none = NULL;
    murk_error err = {0};
    CHECK(murk_photon_map_create(&none, NULL, 0, 1, &err) == MURK_OK);
    murk_image *air = by_maps(map, none, 1);
    murk_image *water = by_maps(map, none, 1.34);
    /* of half a watt a record, over 16 m2 */
    const double want = RECORDS * 0.5 / 16 / MURK_PI;
    CHECK(fabs(air->mean[0] / want - 1) < 0.2);
    CHECK(air->mean_error[0] > 0.01 * want);
    CHECK_NEAR(water->mean[0] / air->mean[0], 1, 1e-12);
    CHECK_NEAR(water->mean_error[0] / air->mean_error[0], 1, 1e-12);
    for (size_t i = 0; i < air->width * air->height; ++i) {
        CHECK_NEAR((double)(water->radiance[0][i] / air->radiance[0][i]), 1,
                   1e-6);
        CHECK_NEAR((double)(water->error[0][i] / air->error[0][i]), 1, 1e-6);
        CHECK_NEAR((double)(water->rgb_error[1][i] / air->rgb_error[1][i]), 1,
                   1e-6);
    }
    murk_image_destroy(air);
    murk_image_destroy(water);
    murk_photon_map_destroy(map);
    murk_photon_map_destroy(none);
}

int main(void)
{
    test_a_lamp_above_the_water();
    test_a_lamp_behind_a_plate_of_glass();
    test_the_index_changes_no_error_of_maps();
    return check_done();
}
