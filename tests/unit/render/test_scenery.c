/* Straight segments through periodic domains: thin sheets and surfaces stand in
 * every period, media go on, and a segment is as long as it is. No
 * randomness. */
#include "pictures.h"
#include "render/scenery.h"

#include "check.h"
#include "worlds.h"

#define SIDE   5.0
#define SOOT   0.1
#define PASSES 0.5 /* a sheet */
#define OTHER  0.7 /* another one */

/* A periodic domain with two upright surfaces and nothing else but soot. */
static test_setup with_two(const murk_surface_desc upright[2],
                           const murk_material paint[3],
                           const murk_medium *soot, const murk_region *all)
{
    static const murk_source lamp = {
        .type = MURK_SOURCE_POINT, .position = {1, 2, 5}, .power_w = {{1}}};
    return (test_setup){.domain = {{{0, 0, 0}, {SIDE, SIDE, 6}}, true},
                        .lights = &lamp,
                        .n_lights = 1,
                        .surfaces = upright,
                        .n_surfaces = 2,
                        .materials = paint,
                        .n_materials = 3,
                        .media = soot,
                        .n_media = 1,
                        .regions = all,
                        .n_regions = 1};
}

/* x and y, or the other way round. */
static murk_vec3 turned(bool is_turned, double along, double aside, double z)
{
    return is_turned ? murk_vec(aside, along, z) : murk_vec(along, aside, z);
}

/* From side to side, up to that height. */
static murk_surface_desc upright_at(bool is_turned, double along, double top,
                                    int material)
{
    return test_rect(turned(is_turned, along, 0, 0),
                     turned(is_turned, 0, SIDE, 0), murk_vec(0, 0, top),
                     material);
}

/* Segments across the sheets, from one period into the third: each sheet that
 * is passed takes its part, once. */
static void test_every_sheet_of_a_segment_takes_its_part(bool is_turned)
{
    const murk_surface_desc sheet[2] = {upright_at(is_turned, 1, 6, 1),
                                        upright_at(is_turned, 4, 6, 2)};
    const murk_material glass[3] = {test_material(0, 0, 0, 0),
                                    test_material(0, 0, PASSES, 0),
                                    test_material(0, 0, OTHER, 0)};
    const murk_medium soot = test_medium(SOOT, 0, 0);
    const murk_region all = test_everywhere(0);
    const test_setup setup = with_two(sheet, glass, &soot, &all);
    test_world world = test_world_made(&setup);
    murk_scenery scenery = scenery_of_world(&world);
    const murk_vec3 ahead = turned(is_turned, 1, 0, 0);
    const struct {
        double from_m, length_m;
        int first, second; /* how often each sheet is passed */
    } segment[] = {{0.5, 0.4, 0, 0}, {0.5, 1, 1, 0},  {0.5, 4, 1, 1},
                   {2, 1.5, 0, 0},   {2, 4.5, 1, 1},  {2, 7.5, 1, 2},
                   {2, 12.6, 2, 3},  {4.5, 10, 2, 2}, {0.5, 5.2, 1, 1}};
    for (size_t i = 0; i < sizeof segment / sizeof *segment; ++i) {
        const double l = segment[i].length_m, end = segment[i].from_m + l;
        const double want = pow(PASSES, segment[i].first) *
                            pow(OTHER, segment[i].second) * exp(-SOOT * l);
        const murk_vec3 from = turned(is_turned, segment[i].from_m, 2.5, 3);
        CHECK_NEAR(murk_scenery_through(&scenery, 0, from, ahead, l, true),
                   want, 1e-6 * want);
        CHECK_NEAR(murk_scenery_depth(&scenery, 0, from, ahead, l), SOOT * l,
                   1e-6);
        /* where sheets are not to be passed they stand in the way */
        const bool is_clear = segment[i].first + segment[i].second == 0;
        CHECK_NEAR(murk_scenery_through(&scenery, 0, from, ahead, l, false),
                   is_clear ? want : 0, 1e-6);
        /* the reverse segment is the same */
        const murk_vec3 there =
            turned(is_turned, end - SIDE * floor(end / SIDE), 2.5, 3);
        CHECK_NEAR(murk_scenery_through(&scenery, 0, there,
                                        murk_scale(-1, ahead), l, true),
                   want, 1e-6 * want);
    }
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* A low wall hides what lies behind it from a low place, in the next period as
 * in its own. The segments rise by one in four. */
static void test_walls_stand_in_every_period(bool is_turned)
{
    const murk_surface_desc wall[2] = {upright_at(is_turned, 1, 2, 0),
                                       upright_at(is_turned, 4, 2, 0)};
    const murk_material black[3] = {test_material(0, 0, 0, 0),
                                    test_material(0, 0, 0, 0),
                                    test_material(0, 0, 0, 0)};
    const murk_medium soot = test_medium(SOOT, 0, 0);
    const murk_region all = test_everywhere(0);
    const test_setup setup = with_two(wall, black, &soot, &all);
    test_world world = test_world_made(&setup);
    murk_scenery scenery = scenery_of_world(&world);
    const murk_vec3 direction = murk_unit(turned(is_turned, 4, 0, 1));
    const murk_vec3 low = turned(is_turned, 4.5, 2.5, 1);
    const murk_vec3 high = turned(is_turned, 4.5, 2.5, 2);
    /* the next period's wall is 1.5 m ahead, where the segment is .375 m
     * higher */
    CHECK(murk_scenery_through(&scenery, 0, low, direction, 3, true) == 0);
    CHECK_NEAR(murk_scenery_through(&scenery, 0, low, direction, 1.4, true),
               exp(-1.4 * SOOT), 1e-6);
    CHECK_NEAR(murk_scenery_through(&scenery, 0, high, direction, 3, true),
               exp(-3 * SOOT), 1e-6);
    /* looking finds its copy within the domain */
    const murk_scenery_end end =
        murk_scenery_find_end(&scenery, low, direction);
    const murk_vec3 there = turned(is_turned, 1, 2.5, 1.375);
    CHECK(end.is_surface);
    CHECK_NEAR(end.distance_m, 1.5 * sqrt(17) / 4, 1e-5);
    CHECK_NEAR(murk_length(murk_sub(end.position, there)), 0, 1e-5);
    CHECK(murk_dot(end.normal, direction) < -0.9);
    /* from the high place the segment leads out through the top, 4 m up */
    const murk_scenery_end top =
        murk_scenery_find_end(&scenery, high, direction);
    CHECK(!top.is_surface);
    CHECK_NEAR(top.distance_m, 4 * sqrt(17), 1e-4);
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* Level segments in clear air: what has crossed the domain thousands of times
 * is taken for lost. */
static void test_endless_segments_are_lost(void)
{
    const murk_surface_desc wall[2] = {upright_at(false, 1, 2, 0),
                                       upright_at(false, 4, 2, 0)};
    const murk_material black[3] = {test_material(0, 0, 0, 0),
                                    test_material(0, 0, 0, 0),
                                    test_material(0, 0, 0, 0)};
    const murk_medium clear = test_medium(0, 0, 0);
    const murk_region all = test_everywhere(0);
    const test_setup setup = with_two(wall, black, &clear, &all);
    test_world world = test_world_made(&setup);
    murk_scenery scenery = scenery_of_world(&world);
    const murk_vec3 from = {2.5, 2.5, 1.9}, direction = {0, 1, 0};
    CHECK(murk_scenery_through(&scenery, 0, from, direction, 1000 * SIDE,
                               true) == 1);
    CHECK(murk_scenery_through(&scenery, 0, from, direction, 1e5 * SIDE,
                               true) == 0);
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

int main(void)
{
    for (int k = 0; k < 2; ++k) {
        test_every_sheet_of_a_segment_takes_its_part(k == 1);
        test_walls_stand_in_every_period(k == 1);
    }
    test_endless_segments_are_lost();
    return check_done();
}
