/* What the pixels of a picture look at, as points for sensors. Nothing here is
 * random. */
#include "check.h"
#include "render/points.h"
#include "worlds.h"

#include <stdlib.h>

#define ROWS    6
#define COLUMNS 12

/* A light, since a world must have one. */
static test_world made(test_setup setup)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 3));
    setup.lights = &lamp;
    setup.n_lights = 1;
    return test_world_made(&setup);
}

/* All rows, found in two parts. */
static size_t found(const test_world *world, murk_camera camera,
                    murk_photon point[ROWS * COLUMNS])
{
    murk_scenery scenery = {0};
    murk_error err = {0};
    size_t all = 0;
    CHECK(murk_scenery_prepare(&scenery, &world->world, &err) == MURK_OK);
    for (size_t row = 0; row < ROWS; row += 4) {
        murk_photon *part = NULL;
        size_t n = 0;
        CHECK(murk_points_find(&part, &n, &scenery, &camera, row,
                               row ? ROWS - row : 4, 0, 2, &err) == MURK_OK);
        for (size_t i = 0; i < n; ++i) {
            point[all++] = part[i];
        }
        free(part);
    }
    murk_scenery_release(&scenery);
    return all;
}

/* A floor below and sky above: the lower half of the globe has points on
 * the floor, each with the number of its pixel and a normal that points up. */
static void test_sky_has_no_points(void)
{
    /* A floor, and a camera that sees the whole globe. */
    const murk_surface_desc floor =
        test_rect(murk_vec(-4, -4, 0), murk_vec(8, 0, 0), murk_vec(0, 8, 0), 0);
    test_world world =
        made((test_setup){.domain = {{{-4, -4, -1}, {4, 4, 4}}, false},
                          .surfaces = &floor,
                          .n_surfaces = 1});
    const murk_camera c = murk_camera_around(murk_vec(0, 0, 0.5),
                                             murk_vec(0, 1, 0), COLUMNS, ROWS);
    murk_photon point[ROWS * COLUMNS];
    const size_t n = found(&world, c, point);
    /* The lower half of the pixels has points. */
    CHECK(n == ROWS * COLUMNS / 2);
    for (size_t i = 0; i < n; ++i) {
        /* Each point lies on the floor, faces up, and has the number of the
         * pixel that shows it. */
        const murk_photon *p = &point[i];
        CHECK(p->emitted == ROWS * COLUMNS / 2 + i);
        CHECK(fabsf(p->position_m[2]) < 1e-6F);
        CHECK(murk_direction_unpack(p->normal).z == 1);
        CHECK(!murk_photon_is_volume(p));
        double x, y;
        const murk_vec3 offset = {(double)p->position_m[0],
                                  (double)p->position_m[1], -0.5};
        CHECK(murk_camera_find(&c, offset, &x, &y));
        CHECK((size_t)y * COLUMNS + (size_t)x == p->emitted);
    }
    test_world_unmade(&world);
}

/* Points are found up to an interface between two indices, not beyond it. */
static void test_water_hides_its_ground(void)
{
    /* A floor 1 m under water. */
    const murk_surface_desc floor = test_rect(
        murk_vec(-4, -4, -1), murk_vec(8, 0, 0), murk_vec(0, 8, 0), 0);
    const murk_medium water = test_medium(0, 0, 0);
    const murk_region sea = {.shape = MURK_REGION_BELOW,
                             .below_z_m = 0,
                             .ior = 1.34,
                             .replaces = true,
                             .where = "sea"};
    test_world world =
        made((test_setup){.domain = {{{-4, -4, -2}, {4, 4, 4}}, false},
                          .surfaces = &floor,
                          .n_surfaces = 1,
                          .media = &water,
                          .n_media = 1,
                          .regions = &sea,
                          .n_regions = 1});
    /* A camera above the water has no points on the floor. */
    murk_photon point[ROWS * COLUMNS];
    const murk_vec3 down = {0, 0, -1}, north = {0, 1, 0};
    const murk_camera above =
        murk_camera_aimed(murk_vec(0, 0, 1), down, north, 1, COLUMNS, ROWS);
    CHECK(found(&world, above, point) == 0);
    /* A camera under water has points in all pixels. */
    const murk_camera below =
        murk_camera_aimed(murk_vec(0, 0, -0.5), down, north, 1, COLUMNS, ROWS);
    CHECK(found(&world, below, point) == ROWS * COLUMNS);
    test_world_unmade(&world);
}

/* In a periodic domain points lie in it, however far off they are seen. */
static void test_points_lie_in_the_domain(void)
{
    const murk_surface_desc floor =
        test_rect(murk_vec(-1, -1, 0), murk_vec(2, 0, 0), murk_vec(0, 2, 0), 0);
    test_world world =
        made((test_setup){.domain = {{{-1, -1, -1}, {1, 1, 4}}, true},
                          .surfaces = &floor,
                          .n_surfaces = 1});
    const murk_camera c =
        murk_camera_aimed(murk_vec(0, 0, 1), murk_vec(6, 1, 0),
                          murk_vec(0, 0, 1), 0.2, COLUMNS, ROWS);
    murk_photon point[ROWS * COLUMNS];
    const size_t n = found(&world, c, point);
    CHECK(n == ROWS * COLUMNS);
    for (size_t i = 0; i < n; ++i) {
        const float *p = point[i].position_m;
        CHECK(p[0] >= -1 && p[0] <= 1 && p[1] >= -1 && p[1] <= 1);
    }
    test_world_unmade(&world);
}

/* A wall before another: a clip plane between them shows the other one at the
 * places of the pixels; a plane in the other one hides it, too. */
static void test_clipped_walls_are_not_hit(void)
{
    const murk_surface_desc walls[2] = {
        test_rect(murk_vec(-4, 1, -1), murk_vec(8, 0, 0), murk_vec(0, 0, 5), 0),
        test_rect(murk_vec(-4, 2, -1), murk_vec(8, 0, 0), murk_vec(0, 0, 5),
                  0)};
    test_world world =
        made((test_setup){.domain = {{{-4, -4, -1}, {4, 4, 4}}, false},
                          .surfaces = walls,
                          .n_surfaces = 2});
    /* 6 m wide: pixels of 0.5 m; from outside of the domain. */
    murk_camera c =
        murk_camera_parallel(murk_vec(0, -9, 1.5), murk_vec(0, 0, 1.5),
                             murk_vec(0, 0, 1), 6, COLUMNS, ROWS);
    const double clip_m[4] = {0.5, 1.5, 2, 2.5}, hit_m[4] = {1, 2, 0, 0};
    for (int i = -1; i < 4; ++i) {
        murk_photon point[ROWS * COLUMNS];
        if (i >= 0) {
            c.clip = (murk_clip){true, {0, clip_m[i], 0}, {0, 1, 0}};
        }
        const double want_m = i < 0 ? 1 : hit_m[i];
        const size_t n = found(&world, c, point);
        CHECK(n == (want_m > 0 ? ROWS * COLUMNS : 0));
        for (size_t k = 0; k < n; ++k) {
            const murk_vec3 at = murk_photon_place(&point[k]);
            CHECK_NEAR(at.x, -2.75 + 0.5 * (double)(k % COLUMNS), 1e-6);
            CHECK_NEAR(at.y, want_m, 1e-6);
            CHECK_NEAR(at.z, 2.75 - 0.5 * (double)(k / COLUMNS), 1e-6);
        }
    }
    test_world_unmade(&world);
}

int main(void)
{
    test_clipped_walls_are_not_hit();
    test_sky_has_no_points();
    test_water_hides_its_ground();
    test_points_lie_in_the_domain();
    return check_done();
}
