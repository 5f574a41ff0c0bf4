/* Pictures of small worlds whose radiance is known.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "pictures.h"
#include "render/render.h"
#include "worlds.h"

#include <string.h>

#define ZTESTS 4

static murk_image *taken(const test_world *world, murk_camera camera,
                         size_t samples, unsigned threads)
{
    return picture_of_world((murk_render){.camera = camera,
                                          .samples = samples,
                                          .method = MURK_BY_PATHS,
                                          .threads = threads},
                            world);
}

static test_world hollow_ball(double diffuse)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_surface_desc ball = test_sphere(murk_vec(0, 0, 0), 1, 0);
    const murk_material paint = test_material(diffuse, 0, 0, 0);
    return test_world_made(
        &(test_setup){.domain = {{{-2, -2, -2}, {2, 2, 2}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &ball,
                      .n_surfaces = 1,
                      .materials = &paint,
                      .n_materials = 1});
}

/* A lamp of P in the middle of a ball of radius R: all of the wall is lit
 * alike, so its radiance is d / (1 - d) P / (4 pi^2 R^2). */
static double ball_radiance(double diffuse)
{
    return diffuse / (1 - diffuse) / (4 * MURK_PI * MURK_PI);
}

static void test_a_closed_ball_glows_evenly(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    test_world world = hollow_ball(0.7);
    const murk_camera camera =
        murk_camera_aimed(murk_vec(0.5, 0.1, 0), murk_vec(0, 1, 0.3),
                          murk_vec(0, 0, 1), 1.5, 20, 16);
    murk_image *p = taken(&world, camera, 64, 2);
    CHECK_WITHIN(limit, p->mean[0], ball_radiance(0.7), p->mean_error[0]);
    CHECK(sigmas_off(p->mean[0], ball_radiance(0.72), p->mean_error[0]) >
          2 * limit);
    CHECK(p->mean_error[0] < 0.01 * p->mean[0]);
    CHECK(p->lost == 0);
    /* one band is grey; nothing comes from media; the wall is where it is */
    const size_t middle = 8 * 20 + 10;
    CHECK(p->rgb[0][middle] == p->radiance[0][middle] &&
          p->rgb[2][middle] == p->radiance[0][middle]);
    CHECK(p->volume[0][middle] == 0 && p->depth[0][middle] == 0);
    const murk_vec3 there = {(double)p->position[0][middle],
                             (double)p->position[1][middle],
                             (double)p->position[2][middle]};
    CHECK_NEAR(murk_length(there), 1, 1e-5);
    murk_image_destroy(p);
    test_world_unmade(&world);
}

/* Under water, an even sky of radiance L is seen straight up as n^2 (1 - F)
 * L, F = ((n - 1) / (n + 1))^2. */
static void test_radiance_grows_by_the_square_of_the_index(void)
{
    /* An even sky over water. */
    const double limit = murk_sidak_limit(1e-6, ZTESTS), n = 1.34;
    const murk_source sky = {.type = MURK_SOURCE_SKY, .power_w = {{MURK_PI}}};
    const murk_medium water = test_medium(0, 0, 0);
    const murk_region sea = {.shape = MURK_REGION_BELOW,
                             .below_z_m = 0,
                             .ior = n,
                             .replaces = true,
                             .where = "sea"};
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                      .lights = &sky,
                      .n_lights = 1,
                      .media = &water,
                      .n_media = 1,
                      .regions = &sea,
                      .n_regions = 1});
    /* A camera 1 m under water looks straight up. */
    const murk_camera camera = murk_camera_aimed(
        murk_vec(0, 0, -1), murk_vec(0, 0, 1), murk_vec(0, 1, 0), 0.01, 8, 8);
    murk_image *p = taken(&world, camera, 256, 1);
    /* The radiance is right, and the radiance for an index of 1.33 would be
     * refused. */
    const double back = (n - 1) / (n + 1) * (n - 1) / (n + 1);
    CHECK_WITHIN(limit, p->mean[0], n * n * (1 - back), p->mean_error[0]);
    CHECK(sigmas_off(p->mean[0], 1.33 * 1.33 * (1 - back), p->mean_error[0]) >
          2 * limit);
    /* The distance is that to the surface of the water. */
    CHECK_NEAR((double)p->distance_m[0], 1, 1e-4);
    murk_image_destroy(p);
    test_world_unmade(&world);
}

/* A lamp seen through fog that only absorbs: radiance by Beer's law. */
static void test_a_lamp_dims_by_the_depth_before_it(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    const murk_source lamp = {.type = MURK_SOURCE_RECT,
                              .position = {3, -1, -1},
                              .edge1 = {0, 0, 2},
                              .edge2 = {0, 2, 0},
                              .power_w = {{4 * MURK_PI}}};
    const murk_medium soot = test_medium(0.5, 0, 0);
    const murk_region all = test_everywhere(0);
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .media = &soot,
                      .n_media = 1,
                      .regions = &all,
                      .n_regions = 1});
    const murk_camera camera = murk_camera_aimed(
        murk_vec(0, 0, 0), murk_vec(1, 0, 0), murk_vec(0, 0, 1), 0.01, 16, 16);
    murk_image *p = taken(&world, camera, 64, 1);
    CHECK_WITHIN(limit, p->mean[0], exp(-1.5), p->mean_error[0]);
    CHECK(sigmas_off(p->mean[0], exp(-1.7), p->mean_error[0]) > 2 * limit);
    CHECK_NEAR((double)p->depth[0][0], 0.5 * 4, 1e-3); /* to the side */
    murk_image_destroy(p);
    test_world_unmade(&world);
}

static void test_the_same_on_any_threads(void)
{
    test_world world = hollow_ball(0.7);
    const murk_camera camera =
        murk_camera_aimed(murk_vec(0.5, 0.1, 0), murk_vec(0, 1, 0.3),
                          murk_vec(0, 0, 1), 1.5, 50, 37);
    murk_image *one = taken(&world, camera, 2, 1);
    for (unsigned threads = 2; threads <= 5; threads += 3) {
        murk_image *more = taken(&world, camera, 2, threads);
        CHECK(memcmp(one->radiance[0], more->radiance[0],
                     (size_t)murk_image_bytes(50, 37, 1)) == 0);
        CHECK(memcmp(one->mean, more->mean, sizeof one->mean) == 0);
        murk_image_destroy(more);
    }
    murk_image_destroy(one);
    test_world_unmade(&world);
}

int main(void)
{
    test_a_closed_ball_glows_evenly();
    test_radiance_grows_by_the_square_of_the_index();
    test_a_lamp_dims_by_the_depth_before_it();
    test_the_same_on_any_threads();
    return check_done();
}
