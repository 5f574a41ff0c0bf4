/* Pictures by paths of small worlds whose radiance has a closed form: lamps
 * over a floor, all under water and across its surface, light scattered once,
 * and the images of lamps in periodic domains.
 *
 * Each case asks that the mean is the closed form's within chance and a small
 * allowance for what the form leaves out, and that a form 3 % off is refused.
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "pictures.h"
#include "render/render.h"
#include "worlds.h"

#define CASES 16

/* A mean over few square centimetres instead of a point, shadow rays that start
 * beside the floor, floats: 1e-4 of the radiance at most. */
#define ALLOWED 1e-4

static murk_image *taken(const test_world *world, murk_camera camera,
                         size_t samples)
{
    return picture_of_world((murk_render){.camera = camera,
                                          .samples = samples,
                                          .method = MURK_BY_PATHS,
                                          .threads = 2},
                            world);
}

/* Looks with a hair's breadth of view. */
static murk_camera narrow_camera(murk_vec3 from, murk_vec3 to)
{
    const murk_vec3 offset = murk_sub(to, from);
    const murk_vec3 up = fabs(offset.z) > fabs(offset.x) + fabs(offset.y)
                             ? murk_vec(0, 1, 0)
                             : murk_vec(0, 0, 1);
    return murk_camera_aimed(from, to, up, 0.002, 8, 8);
}

static bool is_met(const murk_image *p, double want, double allowed)
{
    const double limit = murk_sidak_limit(1e-6, CASES);
    return fabs(p->mean[0] - want) < limit * p->mean_error[0] + allowed * want;
}

/* Tells the error of the mean, as a share. */
static double check_case(const char *name, const test_setup *setup,
                         murk_camera camera, size_t samples, double want,
                         double allowed)
{
    test_world world = test_world_made(setup);
    murk_image *p = taken(&world, camera, samples);
    printf("%s: %.6g +- %.2g, is %.6g\n", name, p->mean[0], p->mean_error[0],
           want);
    CHECK(is_met(p, want, allowed));
    CHECK(!is_met(p, 1.03 * want, allowed));
    CHECK(!is_met(p, want / 1.03, allowed));
    CHECK(p->lost == 0);
    /* what came from surfaces and from media last is all there is */
    for (size_t i = 0; i < p->width * p->height; ++i) {
        const double parts = (double)p->surface[0][i] + (double)p->volume[0][i];
        CHECK(fabs(parts - (double)p->radiance[0][i]) <= 1e-6 * parts);
        CHECK(setup->n_media > 0 || p->volume[0][i] == 0);
    }
    const double share = p->mean_error[0] / p->mean[0];
    murk_image_destroy(p);
    test_world_unmade(&world);
    return share;
}

/* ---- in the open, and under water ---- */

#define DIFFUSE 0.5

/* Radiance of a floor at z = 0 below point lamps of a watt. */
static double floor_radiance(const murk_source *lamp, size_t n, murk_vec3 at)
{
    double irradiance = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 offset = murk_sub(lamp[i].position, at);
        const double r = murk_length(offset);
        irradiance += offset.z / (4 * MURK_PI * r * r * r);
    }
    return DIFFUSE / MURK_PI * irradiance;
}

/* Twelve lamps, so that shadow rays are shared out; a watt each. */
static void test_a_floor_below_many_lamps(void)
{
    murk_source lamp[12];
    for (int i = 0; i < 12; ++i) {
        lamp[i] = test_point(murk_vec(i % 4 - 1.5, i / 4 - 1, 1 + 0.2 * i));
    }
    const murk_surface_desc floor =
        test_rect(murk_vec(-3, -3, 0), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 0);
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    check_case("a floor below twelve lamps",
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = lamp,
                             .n_lights = 12,
                             .surfaces = &floor,
                             .n_surfaces = 1,
                             .materials = &paint,
                             .n_materials = 1},
               narrow_camera(murk_vec(0.3, 0.2, 0.5), murk_vec(0.3, 0.2, 0)),
               600, floor_radiance(lamp, 12, murk_vec(0.3, 0.2, 0)), ALLOWED);
}

/* From above all lamps, and clipped below them: the light stays. */
static void test_an_orthographic_floor(void)
{
    murk_source lamp[12];
    for (int i = 0; i < 12; ++i) {
        lamp[i] = test_point(murk_vec(i % 4 - 1.5, i / 4 - 1, 1 + 0.2 * i));
    }
    const murk_surface_desc floor =
        test_rect(murk_vec(-3, -3, 0), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 0);
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    murk_camera camera =
        murk_camera_parallel(murk_vec(0.3, 0.2, 9), murk_vec(0.3, 0.2, 0),
                             murk_vec(0, 1, 0), 1e-3, 1, 1);
    camera.clip = (murk_clip){true, {0, 0, 0.5}, {0, 0, 1}};
    check_case("an orthographic picture of a floor",
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = lamp,
                             .n_lights = 12,
                             .surfaces = &floor,
                             .n_surfaces = 1,
                             .materials = &paint,
                             .n_materials = 1},
               camera, 600, floor_radiance(lamp, 12, murk_vec(0.3, 0.2, 0)),
               ALLOWED);
}

/* Checks the radiance in a box of 8 m with water up to `level` over a floor
 * at z = 0 that reflects `diffuse`, by the light of one lamp. */
static void check_water(const char *name, murk_source lamp, double level,
                        double diffuse, murk_camera camera, size_t samples,
                        double want)
{
    /* The floor, and clear water of index 1.34 up to the level. */
    const murk_surface_desc floor =
        test_rect(murk_vec(-3, -3, 0), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 0);
    const murk_material paint = test_material(diffuse, 0, 0, 0);
    const murk_medium clear = test_medium(0, 0, 0);
    const murk_region water = {.shape = MURK_REGION_BELOW,
                               .below_z_m = level,
                               .ior = 1.34,
                               .replaces = true,
                               .where = "water"};
    /* The radiance in the view of the camera. */
    check_case(name,
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = &lamp,
                             .n_lights = 1,
                             .surfaces = &floor,
                             .n_surfaces = 1,
                             .materials = &paint,
                             .n_materials = 1,
                             .media = &clear,
                             .n_media = 1,
                             .regions = &water,
                             .n_regions = 1},
               camera, samples, want, ALLOWED);
}

/* Where camera and lamp are both under water the index changes nothing: a watt
 * is a watt. From water into air radiance falls by n^2, but for what the
 * surface reflects. */
static void test_the_square_of_the_index(void)
{
    const double n = 1.34, back = (n - 1) / (n + 1) * (n - 1) / (n + 1);
    const murk_source point = test_point(murk_vec(1, 0.5, 2));
    const murk_vec3 at = {0.3, 0.2, 0};
    check_water("floor, camera and lamp under water", point, 10, DIFFUSE,
                narrow_camera(murk_vec(0.3, 0.2, 0.5), at), 4,
                floor_radiance(&point, 1, at));
    const murk_source ball = {.type = MURK_SOURCE_SPHERE,
                              .position = {0, 0, 2},
                              .radius_m = 0.5,
                              .power_w = {{1}}};
    const double bright = 1 / (4 * MURK_PI * MURK_PI * 0.25);
    check_water("a lamp seen under water", ball, 10, 0,
                narrow_camera(murk_vec(0, 0, 0.5), murk_vec(0, 0, 2)), 4,
                bright);
    check_water("a lamp seen from above the water", ball, 3, 0,
                narrow_camera(murk_vec(0, 0, 4), murk_vec(0, 0, 2)), 4000,
                bright * (1 - back) / (n * n));
    /* the floor's light is of a lamp in the same water */
    const murk_source sheet = {.type = MURK_SOURCE_SPHERE,
                               .position = {1, 0.5, 2},
                               .radius_m = 0.1,
                               .power_w = {{1}}};
    const murk_source middle = test_point(murk_vec(1, 0.5, 2));
    check_water("a floor seen by a ball's light under water", sheet, 10,
                DIFFUSE, narrow_camera(murk_vec(0.3, 0.2, 0.5), at), 300,
                floor_radiance(&middle, 1, at));
}

/* A patch below a shining ball beside a mirror: the image of the ball lights
 * the patch, too, and only paths that continue find the image. A ball that is
 * all in view gives the irradiance of a point in its middle. */
static void test_a_mirror_doubles_the_lamp(void)
{
    /* The ball, and two points in place of the ball and of its mirror
     * image. */
    const murk_source ball = {.type = MURK_SOURCE_SPHERE,
                              .position = {0, 0, 2.5},
                              .radius_m = 1,
                              .power_w = {{1}}};
    const murk_source both[2] = {test_point(murk_vec(0, 0, 2.5)),
                                 test_point(murk_vec(4, 0, 2.5))};
    /* The patch, and a mirror at x = 2 m. */
    const murk_surface_desc surface[2] = {
        test_rect(murk_vec(0.28, 0.18, 0), murk_vec(0.04, 0, 0),
                  murk_vec(0, 0.04, 0), 0),
        test_rect(murk_vec(2, -3.5, 0), murk_vec(0, 7, 0), murk_vec(0, 0, 4.5),
                  1)};
    const murk_material material[2] = {test_material(DIFFUSE, 0, 0, 0),
                                       test_material(0, 1, 0, 0)};
    /* The patch is as bright as below both points. */
    const murk_vec3 at = {0.3, 0.2, 0};
    check_case("a ball and its mirror image",
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = &ball,
                             .n_lights = 1,
                             .surfaces = surface,
                             .n_surfaces = 2,
                             .materials = material,
                             .n_materials = 2},
               narrow_camera(murk_vec(0.3, 0.2, 0.5), at), 8000,
               floor_radiance(both, 2, at), ALLOWED);
}

/* Two thin sheets between lamp and floor let half of the light through each. */
static void test_sheets_dim_one_after_the_other(void)
{
    const murk_source point = test_point(murk_vec(1, 0.5, 2));
    const murk_surface_desc surface[3] = {
        test_rect(murk_vec(-3, -3, 0), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 0),
        test_rect(murk_vec(-3, -3, 1), murk_vec(6, 0, 0), murk_vec(0, 6, 0), 1),
        test_rect(murk_vec(-3, -3, 1.5), murk_vec(6, 0, 0), murk_vec(0, 6, 0),
                  1)};
    const murk_material material[2] = {test_material(DIFFUSE, 0, 0, 0),
                                       test_material(0, 0, 0.5, 0)};
    const murk_vec3 at = {0.3, 0.2, 0};
    check_case("a floor below two sheets",
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = &point,
                             .n_lights = 1,
                             .surfaces = surface,
                             .n_surfaces = 3,
                             .materials = material,
                             .n_materials = 2},
               narrow_camera(murk_vec(0.3, 0.2, 0.5), at), 4,
               0.25 * floor_radiance(&point, 1, at), ALLOWED);
}

/* A ray through soot meets the lamp behind it with chance q, so the
 * variance of a sample is q (1 - q) times the square of the radiance of the
 * lamp. With 4 samples in each of 4096 pixels this is known to some 1 %;
 * the allowed 5 % exclude a division by 4 in place of 3. */
static void test_the_mean_knows_its_error(void)
{
    /* A lamp behind soot, which absorbs a ray or lets it pass. */
    const double q = exp(-0.7);
    const murk_source sheet = {.type = MURK_SOURCE_RECT,
                               .position = {2, -1, -1},
                               .edge1 = {0, 0, 2},
                               .edge2 = {0, 2, 0},
                               .power_w = {{4 * MURK_PI}}};
    const murk_medium soot = test_medium(0.35, 0, 0);
    const murk_region all = test_everywhere(0);
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                      .lights = &sheet,
                      .n_lights = 1,
                      .media = &soot,
                      .n_media = 1,
                      .regions = &all,
                      .n_regions = 1});
    /* Four samples in each of 4096 pixels. */
    const murk_camera camera = murk_camera_aimed(
        murk_vec(0, 0, 0), murk_vec(1, 0, 0), murk_vec(0, 0, 1), 0.01, 64, 64);
    murk_image *p = taken(&world, camera, 4);
    /* The standard error of the mean is that of as many independent rays. */
    const double want = sqrt(q * (1 - q) / (4 * 64 * 64));
    printf("error of the mean: %.4g, is %.4g\n", p->mean_error[0], want);
    CHECK(fabs(p->mean_error[0] / want - 1) < 0.05);
    murk_image_destroy(p);
    test_world_unmade(&world);
}

/* ---- light scattered once ---- */

/* The sun from above, a level line of sight through 3 m of a medium that
 * scatters little, at a metre's depth:
 *   L = E albedo p(90 degrees) exp(-s * 1) (1 - exp(-s * 3)).
 * Scattered again is less than the albedo's share of it. */
static void test_light_scattered_once(void)
{
    const double s = 0.4, g = 0.5, albedo = 1e-3;
    const double p = (1 - g * g) / (4 * MURK_PI * pow(1 + g * g, 1.5));
    const murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                             .direction = {0, 0, -1},
                             .power_w = {{1000}}};
    const murk_medium smoke = test_medium(s, albedo, g);
    const murk_region box =
        test_box_region(0, murk_vec(0, -3, 0), murk_vec(3, 3, 2));
    check_case("scattered once",
               &(test_setup){.domain = {{{-1, -4, -1}, {4, 4, 3}}, false},
                             .lights = &sun,
                             .n_lights = 1,
                             .media = &smoke,
                             .n_media = 1,
                             .regions = &box,
                             .n_regions = 1},
               narrow_camera(murk_vec(-0.5, 0, 1), murk_vec(3, 0, 1)), 1200,
               1000 * albedo * p * exp(-s) * (1 - exp(-3 * s)), albedo);
}

/* A lamp beside a line of sight of 6 m, all in water that scatters little
 * and evenly. The reference is the integral over the line of sight by the
 * midpoint rule. */
static void test_light_scattered_once_under_water(void)
{
    /* Water with an albedo so small that light scatters once at most. */
    const double s = 0.3, albedo = 1e-3;
    const murk_source point = test_point(murk_vec(1, 1.5, 2));
    const murk_medium murky = test_medium(s, albedo, 0);
    const murk_region water = {.shape = MURK_REGION_BELOW,
                               .below_z_m = 10,
                               .ior = 1.34,
                               .replaces = true,
                               .where = "water"};
    /* Light that is scattered once on the line of sight, in steps of a
     * millimetre. */
    double sum = 0;
    for (int i = 0; i < 6000; ++i) {
        const double x = (i + 0.5) * 1e-3, r = hypot(x - 3, 1.5);
        sum += 1e-3 * exp(-s * (x + r)) / (4 * MURK_PI * r * r);
    }
    /* Light that is scattered twice is within a share of the albedo. */
    check_case("scattered once, under water",
               &(test_setup){.domain = {{{-4, -4, -1}, {4, 4, 5}}, false},
                             .lights = &point,
                             .n_lights = 1,
                             .media = &murky,
                             .n_media = 1,
                             .regions = &water,
                             .n_regions = 1},
               narrow_camera(murk_vec(-2, 0, 2), murk_vec(4, 0, 2)), 1200,
               s * albedo / (4 * MURK_PI) * sum, albedo);
}

/* As above, told by where it came from: all of it from the medium. */
static void test_scattered_light_is_of_the_medium(void)
{
    const murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                             .direction = {0, 0, -1},
                             .power_w = {{1000}}};
    const murk_medium smoke = test_medium(0.4, 0.5, 0.5);
    const murk_region box =
        test_box_region(0, murk_vec(0, -3, 0), murk_vec(3, 3, 2));
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-1, -4, -1}, {4, 4, 3}}, false},
                      .lights = &sun,
                      .n_lights = 1,
                      .media = &smoke,
                      .n_media = 1,
                      .regions = &box,
                      .n_regions = 1});
    murk_image *p = taken(
        &world, narrow_camera(murk_vec(-0.5, 0, 1), murk_vec(3, 0, 1)), 16);
    CHECK(p->volume[0][20] > 0 && p->surface[0][20] == 0);
    murk_image_destroy(p);
    test_world_unmade(&world);
}

/* ---- images ---- */

#define SIDE   5.0
#define ABSORB 0.15

static const murk_domain periodic = {{{0, 0, -0.1}, {SIDE, SIDE, 6}}, true};

/* A floor at z = 0 of a periodic domain with soot, below one lamp. */
static test_setup over_floor(const murk_source *lamp,
                             const murk_surface_desc *floor,
                             const murk_material *paint,
                             const murk_medium *soot, const murk_region *all)
{
    return (test_setup){.domain = periodic,
                        .lights = lamp,
                        .n_lights = 1,
                        .surfaces = floor,
                        .n_surfaces = 1,
                        .materials = paint,
                        .n_materials = 1,
                        .media = soot,
                        .n_media = 1,
                        .regions = all,
                        .n_regions = 1};
}

/* What a place on the floor gets from all images of a point of a lamp, with
 * cosine `power` at the lamp: of a watt (isotropic) or a square metre's
 * radiance 1. */
static double from_images(murk_vec3 lamp, murk_vec3 at, int cosines)
{
    double sum = 0;
    for (int i = -40; i <= 40; ++i) {
        for (int j = -40; j <= 40; ++j) {
            const murk_vec3 offset = murk_sub(
                murk_vec(lamp.x + i * SIDE, lamp.y + j * SIDE, lamp.z), at);
            const double r = murk_length(offset);
            sum += pow(offset.z / r, cosines) / (r * r) * exp(-ABSORB * r);
        }
    }
    return sum;
}

static void test_images_of_lamps_light_a_floor(void)
{
    const murk_surface_desc floor = test_rect(
        murk_vec(0, 0, 0), murk_vec(SIDE, 0, 0), murk_vec(0, SIDE, 0), 0);
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    const murk_medium soot = test_medium(ABSORB, 0, 0);
    const murk_region all = test_everywhere(0);
    const murk_vec3 at = {0.5, 4, 0}; /* near a side */
    const murk_camera camera = narrow_camera(murk_vec(0.5, 4, 0.5), at);
    const double seen = exp(-ABSORB * 0.5) * DIFFUSE / MURK_PI;
    const murk_source point = test_point(murk_vec(4, 1, 2));
    test_setup setup = over_floor(&point, &floor, &paint, &soot, &all);
    check_case("images of a point", &setup, camera, 1500,
               seen * from_images(point.position, at, 1) / (4 * MURK_PI),
               ALLOWED);
    /* 2 x 3 m of radiance 1 / (6 pi), in strips of a tenth */
    const murk_source sheet = {.type = MURK_SOURCE_RECT,
                               .position = {2.5, 0.5, 3},
                               .edge1 = {0, 3, 0},
                               .edge2 = {2, 0, 0},
                               .power_w = {{1}}};
    double sum = 0;
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 30; ++j) {
            sum += 0.01 * from_images(murk_vec(2.5 + (i + 0.5) * 0.1,
                                               0.5 + (j + 0.5) * 0.1, 3),
                                      at, 2);
        }
    }
    setup.lights = &sheet;
    check_case("images of a rectangle", &setup, camera, 1500,
               seen * sum / (6 * MURK_PI), 1e-3);
}

/* Floor and ceiling reflect and shine alike, fog between them only scatters:
 * with all images one radiance everywhere, M / (pi (1 - d)). */
static void test_a_periodic_furnace(void)
{
    const murk_surface_desc plane[2] = {
        test_rect(murk_vec(0, 0, 0), murk_vec(SIDE, 0, 0), murk_vec(0, SIDE, 0),
                  0),
        test_rect(murk_vec(0, 0, 6), murk_vec(SIDE, 0, 0), murk_vec(0, SIDE, 0),
                  0)};
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    const murk_medium fog = test_medium(0.2, 1, 0.6);
    const murk_region all = test_everywhere(0);
    const murk_source lamp[2] = {{.type = MURK_SOURCE_RECT,
                                  .position = {0, 0, 0},
                                  .edge1 = {SIDE, 0, 0},
                                  .edge2 = {0, SIDE, 0},
                                  .power_w = {{SIDE * SIDE}}},
                                 {.type = MURK_SOURCE_RECT,
                                  .position = {0, 0, 6},
                                  .edge1 = {0, SIDE, 0},
                                  .edge2 = {SIDE, 0, 0},
                                  .power_w = {{SIDE * SIDE}}}};
    const size_t samples = 300;
    const double share =
        check_case("a periodic furnace",
                   &(test_setup){.domain = {{{0, 0, 0}, {SIDE, SIDE, 6}}, true},
                                 .lights = lamp,
                                 .n_lights = 2,
                                 .surfaces = plane,
                                 .n_surfaces = 2,
                                 .materials = &paint,
                                 .n_materials = 1,
                                 .media = &fog,
                                 .n_media = 1,
                                 .regions = &all,
                                 .n_regions = 1},
                   murk_camera_aimed(murk_vec(1, 2, 2), murk_vec(4, 3, 2.5),
                                     murk_vec(0, 0, 1), 1, 16, 12),
                   samples, 1 / (MURK_PI * (1 - DIFFUSE)), ALLOWED);
    /* the noise of one sample a pixel */
    CHECK(share * sqrt((double)samples) < 0.0707);
}

/* A domain 1000 km high with a period of 50 m. The lamp under the top is
 * seen through haze by the law of Beer along the slant. The lamp and its
 * periodic images are an endless sheet that lights the floor, which is seen
 * from 2 m. */
static void test_a_tall_domain_is_done_soon(void)
{
    /* A periodic domain with a lamp 1 km below the top, thin haze and a
     * floor. */
    const double side = 50, top = 1e6, haze = 3e-7;
    const murk_source sheet = {.type = MURK_SOURCE_RECT,
                               .position = {0, 0, top - 1000},
                               .edge1 = {0, side, 0},
                               .edge2 = {side, 0, 0},
                               .power_w = {{MURK_PI * side * side}}};
    const murk_surface_desc floor = test_rect(
        murk_vec(0, 0, 0), murk_vec(side, 0, 0), murk_vec(0, side, 0), 0);
    const murk_material paint = test_material(DIFFUSE, 0, 0, 0);
    murk_medium air = test_medium(haze, 0, 0);
    const murk_region all = test_everywhere(0);
    test_setup setup = {.domain = {{{0, 0, -10}, {side, side, top}}, true},
                        .lights = &sheet,
                        .n_lights = 1,
                        .surfaces = &floor,
                        .n_surfaces = 1,
                        .materials = &paint,
                        .n_materials = 1,
                        .media = &air,
                        .n_media = 1,
                        .regions = &all,
                        .n_regions = 1};
    /* The lamp through haze, aslant. */
    check_case("a lamp far up, aslant", &setup,
               narrow_camera(murk_vec(3, 4, 2), murk_vec(6, 8, 7)), 400,
               exp(-haze * (top - 1002) * sqrt(2)), 5e-4);
    /* Distance and optical depth are those of the slant through the domain, up
     * to its top and not to the lamp 1 km below. The four pixels around the
     * axis of the camera look past it by equal angles, so the linear part of
     * these angles cancels in the mean, and 1e-8 of the slant is left. */
    test_world world = test_world_made(&setup);
    murk_image *p =
        taken(&world, narrow_camera(murk_vec(3, 4, 2), murk_vec(6, 8, 7)), 1);
    const double slant = (top - 2) * sqrt(2);
    static const int around_axis[4] = {27, 28, 35, 36};
    double distance = 0, depth = 0;
    for (int k = 0; k < 4; ++k) {
        distance += (double)p->distance_m[around_axis[k]] / 4;
        depth += (double)p->depth[0][around_axis[k]] / 4;
    }
    CHECK_NEAR(distance / slant, 1, 1e-6);
    CHECK_NEAR(depth / (haze * slant), 1, 1e-6);
    murk_image_destroy(p);
    test_world_unmade(&world);
    /* The floor, in clear air. */
    air = test_medium(0, 0, 0);
    check_case("a floor far below its lamp", &setup,
               narrow_camera(murk_vec(3, 4, 2), murk_vec(3, 4, 0)), 2000,
               DIFFUSE, 5e-4);
}

int main(void)
{
    test_an_orthographic_floor();
    test_a_floor_below_many_lamps();
    test_the_square_of_the_index();
    test_a_mirror_doubles_the_lamp();
    test_sheets_dim_one_after_the_other();
    test_the_mean_knows_its_error();
    test_light_scattered_once();
    test_light_scattered_once_under_water();
    test_scattered_light_is_of_the_medium();
    test_images_of_lamps_light_a_floor();
    test_a_periodic_furnace();
    test_a_tall_domain_is_done_soon();
    return check_done();
}
