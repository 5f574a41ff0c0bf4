/* What a record's kernel weighs: against areas and volumes that are known, and
 * against what it holds.
 *
 * Masses are probed in patterns turned by chance, so their mean over many
 * records is held against the truth by its own spread. The z-tests share a 1e-6
 * chance of a false alarm (Sidak). */
#include "render/kernel.h"

#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#define ZTESTS  6
#define RECORDS 300

static double limit;

static murk_photon record_at(murk_vec3 place, murk_vec3 normal)
{
    const bool is_volume = !(murk_length(normal) > 0);
    return (murk_photon){
        .position_m = {(float)place.x, (float)place.y, (float)place.z},
        .normal = murk_direction_pack(normal),
        .power_w = 1,
        .kind = murk_photon_kind(is_volume, 2)};
}

typedef struct weighed {
    double mean, error;
    bool any_cut, all_cut;
} weighed;

static weighed weigh(const murk_scenery *scenery, murk_vec3 place,
                     murk_vec3 normal, double radius_m)
{
    weighed w = {.all_cut = true};
    const murk_photon record = record_at(place, normal);
    const murk_probing probing = murk_probing_of(scenery, 1);
    double squares = 0;
    for (uint64_t i = 0; i < RECORDS; ++i) {
        const murk_kernel k = murk_kernel_of(&probing, &record, radius_m, i);
        CHECK(k.radius_m == radius_m);
        w.mean += k.mass / RECORDS;
        squares += k.mass * k.mass / RECORDS;
        w.any_cut |= k.is_cut;
        w.all_cut &= k.is_cut;
    }
    w.error = sqrt(fmax(0, squares - w.mean * w.mean) / (RECORDS - 1));
    return w;
}

/* Share of the kernel of a disc (2) or ball (3 dimensions) of radius 1 before
 * a plane at that distance, by a midpoint sum over slices across it. */
static double share_before(double distance, int dimensions)
{
    const int n = 20000;
    double part = 0, whole = 0;
    for (int i = 0; i < n; ++i) {
        const double x = 2 * (i + 0.5) / n - 1, rest = 1 - x * x;
        /* over the slice: (rest - y^2) of a chord, of a disc */
        const double slice =
            dimensions == 2 ? 4.0 / 3 * rest * sqrt(rest) : rest * rest;
        whole += slice;
        part += x < distance ? slice : 0;
    }
    return part / whole;
}

static test_world box_world(const murk_medium *media,
                            const murk_region *regions, size_t n_regions)
{
    static const murk_material paint = {.name = "default", .diffuse = {{0.5}}};
    const murk_surface_desc shapes[] = {
        test_box(murk_vec(0, 0, 0), murk_vec(4, 4, 4), 0),
        /* a wall across, and a ball */
        test_rect(murk_vec(2, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 4), 0),
        test_sphere(murk_vec(3, 3, 2), 0.5, 0)};
    const murk_source lamp = test_point(murk_vec(1, 1, 1));
    return test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {5, 5, 5}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = shapes,
                      .n_surfaces = 3,
                      .materials = &paint,
                      .n_materials = 1,
                      .media = media,
                      .n_media = n_regions,
                      .regions = regions,
                      .n_regions = n_regions});
}

static void test_discs_end_at_walls(void)
{
    test_world world = box_world(NULL, NULL, 0);
    murk_scenery scenery;
    CHECK(murk_scenery_prepare(&scenery, &world.world, NULL) == MURK_OK);
    const murk_vec3 up = {0, 0, 1};
    const double r = 0.4, whole = MURK_PI / 2 * r * r;
    weighed w = weigh(&scenery, murk_vec(1, 1, 0), up, r);
    CHECK(!w.any_cut);
    CHECK_NEAR(w.mean, whole, 1e-9);
    w = weigh(&scenery, murk_vec(1.8, 1, 0), up, r); /* beside the wall */
    CHECK(w.all_cut);
    CHECK_WITHIN(limit, w.mean, whole * share_before(0.5, 2), w.error);
    CHECK(sigmas_off(w.mean, whole * share_before(0.53, 2), w.error) > limit);
    /* on a ball, the cap within a chord d has pi d^2 */
    w = weigh(&scenery, murk_vec(3, 3, 2.5), up, 0.3);
    CHECK_NEAR(w.mean, MURK_PI / 2 * 0.09, 0.005 * MURK_PI / 2 * 0.09);
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

static void test_balls_weigh_what_scatters_in_sight(void)
{
    const murk_medium media[] = {test_medium(0.5, 0.8, 0),
                                 test_medium(1.5, 0.4, 0)};
    const murk_region regions[] = {
        test_box_region(0, murk_vec(-1, -1, -1), murk_vec(5, 5, 2)),
        test_box_region(1, murk_vec(-1, -1, -1), murk_vec(5, 5, 1))};
    test_world world = box_world(media, regions, 2);
    murk_scenery scenery;
    CHECK(murk_scenery_prepare(&scenery, &world.world, NULL) == MURK_OK);
    const murk_vec3 none = {0, 0, 0};
    const double r = 0.4, whole = 8 * MURK_PI / 15 * r * r * r;
    weighed w = weigh(&scenery, murk_vec(1, 1, 1.5), none, r);
    CHECK(!w.any_cut);
    CHECK_NEAR(w.mean, 0.4 * whole, 1e-9);
    w = weigh(&scenery, murk_vec(1, 1, 1.9), none, r); /* under the border */
    CHECK_WITHIN(limit, w.mean, 0.4 * whole * share_before(0.25, 3), w.error);
    CHECK(sigmas_off(w.mean, 0.4 * whole * share_before(0.3, 3), w.error) >
          limit);
    w = weigh(&scenery, murk_vec(1, 1, 1.1), none, r); /* in thin and thick */
    CHECK_WITHIN(limit, w.mean, whole * (0.4 + 0.6 * share_before(-0.25, 3)),
                 w.error);
    w = weigh(&scenery, murk_vec(1.8, 1, 1.5), none, r); /* beside the wall */
    CHECK(w.all_cut);
    CHECK_WITHIN(limit, w.mean, 0.4 * whole * share_before(0.5, 3), w.error);
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

/* In a slit a disc sees next to nothing of itself and becomes small. */
static void test_discs_shrink_into_slits(void)
{
    const murk_surface_desc plank = test_rect(
        murk_vec(0, 0, 0), murk_vec(4, 0, 0), murk_vec(0, 0.01, 0), 0);
    const murk_material paint = test_material(0.5, 0, 0, 0);
    const murk_source lamp = test_point(murk_vec(1, 1, 1));
    test_world world = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {5, 5, 5}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &plank,
                      .n_surfaces = 1,
                      .materials = &paint,
                      .n_materials = 1});
    murk_scenery scenery;
    CHECK(murk_scenery_prepare(&scenery, &world.world, NULL) == MURK_OK);
    const murk_photon record =
        record_at(murk_vec(2, 0.005, 0), murk_vec(0, 0, 1));
    const murk_probing probing = murk_probing_of(&scenery, 1);
    const murk_kernel k = murk_kernel_of(&probing, &record, 1, 0);
    CHECK(k.radius_m < 0.1 && k.mass > 0);
    /* of the strip, half of k.radius_m or more wide: 4/3 r * 0.01 at most */
    CHECK(k.mass < 4.0 / 3 * k.radius_m * 0.01 * 1.2);
    CHECK(murk_kernel_holds(&scenery, &record, &k, murk_vec(2.01, 0.004, 0),
                            murk_vec(0, 0, 1), 1));
    CHECK(!murk_kernel_holds(&scenery, &record, &k, murk_vec(2.01, 0.004, 0),
                             murk_vec(0, 0, -1), 1)); /* from below */
    murk_scenery_release(&scenery);
    test_world_unmade(&world);
}

int main(void)
{
    limit = murk_sidak_limit(1e-6, ZTESTS);
    test_discs_end_at_walls();
    test_balls_weigh_what_scatters_in_sight();
    test_discs_shrink_into_slits();
    return check_done();
}
