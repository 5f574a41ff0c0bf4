/* Which lights and images shadow rays go to: chances that add up to 1, draws
 * that follow them, and no ray to what cannot light the place.
 *
 * The test of frequencies has a 1e-6 chance of a false alarm (Sidak). */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "pictures.h"
#include "render/choice.h"
#include "worlds.h"

#define DRAWS  200000
#define REACH  60 /* images to either side whose chances are added up */
#define SEEN   3  /* images to either side whose frequencies are tested */
#define ZTESTS ((2 * SEEN + 1) * (2 * SEEN + 1))

static murk_source lamp_at(double x, double y, double z)
{
    return (murk_source){.type = MURK_SOURCE_RECT,
                         .position = {x - 0.5, y - 0.5, z},
                         .edge1 = {0, 1, 0},
                         .edge2 = {1, 0, 0}, /* it shines downwards */
                         .power_w = {{1}}};
}

/* The image in the middle of those that are weighed is the nearest one, along
 * sides of different lengths. */
static void test_the_nearest_image_is_in_the_middle(void)
{
    const murk_source lamp = lamp_at(1, 2, 4);
    test_world world =
        test_world_made(&(test_setup){.domain = {{{0, 0, 0}, {7, 3, 6}}, true},
                                      .lights = &lamp,
                                      .n_lights = 1});
    murk_scenery scenery = scenery_of_world(&world);
    for (double x = 0.1; x < 7; x += 0.3) {
        for (double y = 0.1; y < 3; y += 0.3) {
            const murk_source_images m =
                murk_images_of(&scenery, 0, murk_vec(x, y, 1));
            CHECK(m.period_m[0] == 7 && m.period_m[1] == 3);
            for (int axis = 0; axis < 2; ++axis) {
                CHECK(
                    fabs(m.away_m[axis] + m.nearest[axis] * m.period_m[axis]) <=
                    0.5 * m.period_m[axis] + 1e-12);
            }
        }
    }
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* The chances of all images add up to 1: what is beyond REACH is the solid
 * angle outside of a square about the place, at most height / (nearest side of
 * the square). */
static void check_images(murk_vec3 place, double *beyond)
{
    const murk_source lamp = lamp_at(1, 3, 4);
    test_world world =
        test_world_made(&(test_setup){.domain = {{{0, 0, 0}, {5, 4, 6}}, true},
                                      .lights = &lamp,
                                      .n_lights = 1});
    murk_scenery scenery = scenery_of_world(&world);
    const murk_source_images images = murk_images_of(&scenery, 0, place);
    double sum = 0;
    for (int i = -REACH; i <= REACH; ++i) {
        for (int j = -REACH; j <= REACH; ++j) {
            sum += murk_images_chance(&images, (const double[2]){i, j});
        }
    }
    CHECK(sum < 1 && sum > 1 - images.height_m / (REACH * 4.0));
    *beyond = 1 - sum;
    /* draws follow the chances */
    static uint32_t count[2 * SEEN + 1][2 * SEEN + 1];
    for (int i = 0; i <= 2 * SEEN; ++i) {
        for (int j = 0; j <= 2 * SEEN; ++j) {
            count[i][j] = 0;
        }
    }
    for (uint64_t n = 0; n < DRAWS; ++n) {
        const murk_random4 u = murk_random(1, MURK_SHINE, n, 0, 0);
        double periods[2];
        const double chance = murk_images_draw(&images, u.u, periods);
        CHECK(chance == murk_images_chance(&images, periods) && chance > 0);
        if (fabs(periods[0]) <= SEEN && fabs(periods[1]) <= SEEN) {
            ++count[(int)periods[0] + SEEN][(int)periods[1] + SEEN];
        }
    }
    const double limit = murk_sidak_limit(1e-6, 2 * ZTESTS);
    for (int i = -SEEN; i <= SEEN; ++i) {
        for (int j = -SEEN; j <= SEEN; ++j) {
            const double p =
                murk_images_chance(&images, (const double[2]){i, j});
            CHECK_WITHIN(limit, (double)count[i + SEEN][j + SEEN], DRAWS * p,
                         sqrt(DRAWS * p * (1 - p)));
        }
    }
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

static void test_images_are_drawn_by_their_chances(void)
{
    double low, level;
    check_images(murk_vec(2, 1, 0.5), &low);
    check_images(murk_vec(4.9, 0.1, 4), &level);
    CHECK(low > level); /* from far below, far images are seen better */
}

/* Ten lamps in a row: rays to them add up to what is sent, most go to the
 * nearest, none to lamps that shine away or lie below the surface. */
static void test_rays_go_to_lamps_that_light_the_place(void)
{
    murk_source lamp[10];
    for (int i = 0; i < 10; ++i) {
        lamp[i] = lamp_at(2 * i + 1, 2, i < 9 ? 4 : 0.5);
    }
    test_world world = test_world_made(
        &(test_setup){.domain = {{{0, 0, 0}, {20, 4, 5}}, false},
                      .lights = lamp,
                      .n_lights = 10});
    murk_scenery scenery = scenery_of_world(&world);
    murk_shading_point outlook = {.position = {5, 2, 1}, .normal = {0, 0, 1}};
    double rays[MURK_SOURCES_MAX], sum = 0;
    murk_choice_rays(&scenery, &outlook, rays);
    for (int i = 0; i < 10; ++i) {
        sum += rays[i];
    }
    CHECK_NEAR(sum, MURK_LIGHTS_AT_ONCE, 1e-12);
    CHECK(rays[2] > rays[1] && rays[1] > rays[4] && rays[4] > rays[8]);
    CHECK_NEAR(rays[1], rays[3], 1e-12);
    /* the one below has but the blind share of even draws */
    CHECK(rays[9] > 0 && rays[9] < 0.25 * MURK_LIGHTS_AT_ONCE / 10 * 1.001);
    /* no more lights than rays: one to each */
    scenery.n_lit[0] = 3;
    murk_choice_rays(&scenery, &outlook, rays);
    CHECK(rays[0] == 1 && rays[1] == 1 && rays[2] == 1);
    scenery.n_lit[0] = 10;
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* Shadow rays to point sources in clear air, in closed form: a quarter is
 * spread evenly, the rest by 1 / distance^2, in a periodic domain to the
 * nearest image. */
static void test_rays_to_points_go_by_distance(bool is_periodic)
{
    enum { POINTS = 7 };
    /* Point sources in a row, and 1 / distance^2 to each source or to the
     * nearest image of the source. */
    const double width = 20, here = 2;
    murk_source point[POINTS];
    double due[POINTS], sum = 0;
    for (int i = 0; i < POINTS; ++i) {
        point[i] = test_point(murk_vec(2.5 * i + 3, 2, 3));
        const double straight = 2.5 * i + 3 - here;
        const double away =
            is_periodic ? fmin(straight, width - straight) : straight;
        due[i] = 1 / (away * away + 4);
        sum += due[i];
    }
    /* Shadow rays from one point among the sources. */
    test_world world = test_world_made(
        &(test_setup){.domain = {{{0, 0, 0}, {width, 4, 5}}, is_periodic},
                      .lights = point,
                      .n_lights = POINTS});
    murk_scenery scenery = scenery_of_world(&world);
    const murk_phase haze = murk_phase_hg(0);
    const murk_shading_point outlook = {.position = {here, 2, 1},
                                        .phase = &haze};
    double rays[MURK_SOURCES_MAX];
    murk_choice_rays(&scenery, &outlook, rays);
    /* A quarter of the rays is spread evenly, the rest by distance. */
    for (int i = 0; i < POINTS; ++i) {
        CHECK_NEAR(rays[i],
                   MURK_LIGHTS_AT_ONCE * (0.75 * due[i] / sum + 0.25 / POINTS),
                   1e-9);
    }
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* An upright lamp in a periodic domain lights what lies close behind it by its
 * image in the next period; a lamp that looks down has its images in its own
 * plane, and lights nothing above: it has the blind share alone. */
static void test_images_light_what_lies_behind(void)
{
    murk_source lamp[6];
    for (int i = 0; i < 5; ++i) {
        lamp[i] = lamp_at(1, 2, 2);
    }
    lamp[5] = (murk_source){.type = MURK_SOURCE_RECT,
                            .position = {3, 1.5, 1.8},
                            .edge1 = {0, 1, 0},
                            .edge2 = {0, 0, 1}, /* it shines along x */
                            .power_w = {{1}}};
    test_setup setup = {.domain = {{{0, 0, 0}, {4, 4, 6}}, true},
                        .lights = lamp,
                        .n_lights = 6};
    const murk_phase haze = murk_phase_hg(0);
    const murk_shading_point behind = {.position = {2.7, 2, 2.3},
                                       .phase = &haze};
    const double blind = 0.25 * MURK_LIGHTS_AT_ONCE / 6;
    double rays[MURK_SOURCES_MAX];
    for (int is_periodic = 1; is_periodic >= 0; --is_periodic) {
        setup.domain.is_periodic = is_periodic;
        test_world world = test_world_made(&setup);
        murk_scenery scenery = scenery_of_world(&world);
        murk_choice_rays(&scenery, &behind, rays);
        CHECK_NEAR(rays[0], is_periodic ? blind : MURK_LIGHTS_AT_ONCE / 6.0,
                   1e-12);
        CHECK_NEAR(rays[5], MURK_LIGHTS_AT_ONCE - 5 * rays[0], 1e-12);
        murk_scenery_release(&scenery);
        test_world_unmade(&world);
    }
}

int main(void)
{
    test_the_nearest_image_is_in_the_middle();
    test_rays_to_points_go_by_distance(false);
    test_rays_to_points_go_by_distance(true);
    test_images_light_what_lies_behind();
    test_images_are_drawn_by_their_chances();
    test_rays_go_to_lamps_that_light_the_place();
    return check_done();
}
