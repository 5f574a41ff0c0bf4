/* A point is in a zone when it is in its box, sphere or closed mesh as moved;
 * open meshes, too many and flattened ones are refused by name. Points whose
 * answers are known exactly; nothing here is random. */
#include "check.h"
#include "closed_mesh.h"
#include "geometry/zones.h"

static murk_zone box_zone(murk_vec3 min, murk_vec3 max)
{
    return (murk_zone){.shape = MURK_REGION_BOX,
                       .box = {min, max},
                       .to_world = murk_affine_identity(),
                       .where = "here"};
}

static murk_zones *create(const murk_zone *zone, size_t n)
{
    murk_zones *zones = NULL;
    murk_error err = {0};
    CHECK(murk_zones_create(&zones, zone, n, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return zones;
}

static void check_refused(const murk_zone *zone, size_t n, const char *text)
{
    murk_zones *zones = NULL;
    murk_error err = {0};
    CHECK(murk_zones_create(&zones, zone, n, &err) == MURK_BAD_VALUE);
    CHECK(zones == NULL);
    CHECK_TEXT(err.where, "here");
    CHECK_MENTIONS(err.text, text);
}

static void test_none_hold_nothing(void)
{
    murk_zones *zones = create(NULL, 0);
    CHECK(!murk_zones_contain(zones, murk_vec(0, 0, 0)));
    murk_zones_destroy(zones);
    murk_zones_destroy(NULL);
}

static void test_zones_hold_their_boundary(void)
{
    const murk_zone zone[2] = {box_zone(murk_vec(1, 1, 1), murk_vec(2, 3, 4)),
                               {.shape = MURK_REGION_SPHERE,
                                .center = {10, 0, 0},
                                .radius_m = 2,
                                .to_world = murk_affine_identity()}};
    murk_zones *zones = create(zone, 2);
    CHECK(murk_zones_contain(zones, murk_vec(1.5, 2, 3)));
    CHECK(murk_zones_contain(zones, murk_vec(1, 1, 1)));
    CHECK(murk_zones_contain(zones, murk_vec(2, 3, 4)));
    CHECK(!murk_zones_contain(zones, murk_vec(2 + 1e-12, 3, 4)));
    CHECK(murk_zones_contain(zones, murk_vec(8, 0, 0)));
    CHECK(!murk_zones_contain(zones, murk_vec(8 - 1e-12, 0, 0)));
    murk_zones_destroy(zones);
}

/* Turned by 90 degrees about z, doubled and moved, [0, 1] x [0, 3] x [0, 1]
 * lies at [-6, 0] x [0, 2] x [0, 2] + [10, 0, 5]. */
static void test_moves_come_in_their_order(void)
{
    murk_zone zone = box_zone(murk_vec(0, 0, 0), murk_vec(1, 3, 1));
    zone.to_world =
        murk_affine_place(murk_vec(0, 0, 90), 2, murk_vec(10, 0, 5));
    murk_zones *zones = create(&zone, 1);
    CHECK(murk_zones_contain(zones, murk_vec(4.01, .01, 5.01)));
    CHECK(murk_zones_contain(zones, murk_vec(9.99, 1.99, 6.99)));
    CHECK(!murk_zones_contain(zones, murk_vec(3.99, 1, 6)));
    CHECK(!murk_zones_contain(zones, murk_vec(10.01, 1, 6)));
    CHECK(!murk_zones_contain(zones, murk_vec(7, 2.01, 6)));
    murk_zones_destroy(zones);
}

/* An L: the corner that is left out of its box is outside. */
static void test_meshes_hold_their_inside(void)
{
    const double at[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const uint32_t cut[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5};
    murk_mesh *mesh = closed_prism(at, 6, cut, 0, 1);
    closed_mesh_mix_winding(mesh, 5);
    const murk_zone zone[2] = {
        {.shape = MURK_REGION_MESH,
         .mesh = mesh,
         .to_world = murk_affine_place(murk_vec(0, 0, 0), 1, murk_vec(5, 0, 0)),
         .where = "here"},
        box_zone(murk_vec(-1, -1, -1), murk_vec(-.5, -.5, -.5))};
    murk_zones *zones = create(zone, 2);
    CHECK(murk_zones_contain(zones, murk_vec(5.5, 1.5, .5)));
    CHECK(murk_zones_contain(zones, murk_vec(6.5, .5, .5)));
    CHECK(!murk_zones_contain(zones, murk_vec(6.5, 1.5, .5)));
    CHECK(!murk_zones_contain(zones, murk_vec(5.5, .5, 1.01)));
    CHECK(murk_zones_contain(zones, murk_vec(-.75, -.75, -.75)));
    murk_zones_destroy(zones);
    murk_mesh_destroy(mesh);
}

static void test_bad_zones_are_named(void)
{
    murk_mesh *mesh = closed_box(murk_vec(0, 0, 0), murk_vec(1, 1, 1));
    murk_zone zone[MURK_ZONE_MESHES_MAX + 1];
    for (size_t i = 0; i <= MURK_ZONE_MESHES_MAX; ++i) {
        zone[i] = (murk_zone){.shape = MURK_REGION_MESH,
                              .mesh = mesh,
                              .to_world = murk_affine_identity(),
                              .where = "here"};
    }
    check_refused(zone, MURK_ZONE_MESHES_MAX + 1, "at most 64");
    --mesh->triangles;
    check_refused(zone, 1, "3 ");
    murk_mesh_destroy(mesh);
    murk_zone flat = box_zone(murk_vec(0, 0, 0), murk_vec(1, 1, 1));
    flat.to_world.matrix[1][1] = 0;
    check_refused(&flat, 1, "nothing is left");
}

int main(void)
{
    test_none_hold_nothing();
    test_zones_hold_their_boundary();
    test_moves_come_in_their_order();
    test_meshes_hold_their_inside();
    test_bad_zones_are_named();
    return check_done();
}
