/* Surfaces of known shape give the hits, blocks and facts that geometry says.
 * Nothing here is random but points whose answers are known exactly. */
#include "base/rng.h"
#include "check.h"
#include "geometry/surfaces.h"

#define SEED 1

static const murk_material GREY = {.name = "default"};

static murk_surface_desc box(double x0, double y0, double z0, double x1,
                             double y1, double z1)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_BOX,
                               .box = {{x0, y0, z0}, {x1, y1, z1}},
                               .to_world = murk_affine_identity()};
}

static murk_surfaces *create(const murk_surface_desc *desc, size_t n)
{
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, desc, n, &GREY, 1, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return surfaces;
}

static void test_box_from_inside_and_outside(void)
{
    const murk_surface_desc desc = box(0, 0, 0, 4, 6, 3);
    murk_surfaces *s = create(&desc, 1);
    murk_hit hit;
    CHECK(murk_surfaces_hit(s, murk_vec(1, 2, 1), murk_vec(1, 0, 0), INFINITY,
                            &hit));
    CHECK_NEAR(hit.distance_m, 3, 1e-14);
    CHECK_NEAR(hit.normal.x, -1, 1e-14);
    CHECK(murk_surfaces_hit(s, murk_vec(9, 2, 1), murk_vec(-1, 0, 0), INFINITY,
                            &hit));
    CHECK_NEAR(hit.distance_m, 5, 1e-14);
    CHECK_NEAR(hit.normal.x, 1, 1e-14);
    CHECK(!murk_surfaces_hit(s, murk_vec(1, 2, 1), murk_vec(1, 0, 0), 2.999,
                             &hit));
    CHECK(!murk_surfaces_hit(s, murk_vec(9, 2, 1), murk_vec(1, 0, 0), INFINITY,
                             &hit));
    CHECK(murk_surfaces_blocked(s, murk_vec(9, 2, 1), murk_vec(1, 2, 1), true));
    CHECK(
        !murk_surfaces_blocked(s, murk_vec(3, 2, 1), murk_vec(1, 2, 1), true));
    const murk_surfaces_facts facts = murk_surfaces_describe(s);
    CHECK(facts.triangles == 12);
    CHECK_NEAR(facts.area_m2, 2 * (24 + 12 + 18), 1e-12);
    murk_surfaces_destroy(s);
}

/* A quarter of a step of murk_surfaces_leave() above the foot of a wall, the
 * hit is moved back by 8 steps, here checked to 4; 4 steps above it is exact.
 */
static void test_hits_in_corners_are_moved_back(void)
{
    const murk_surface_desc desc = box(0, 0, 0, 4, 6, 3);
    murk_surfaces *s = create(&desc, 1);
    const double step_m = murk_surfaces_leave_step_m(s);
    const murk_vec3 from = {1, 2, 1};
    for (int is_clear = 0; is_clear < 2; ++is_clear) {
        const murk_vec3 to = {4, 3, is_clear ? 4 * step_m : step_m / 4};
        const murk_vec3 offset = murk_sub(to, from);
        murk_hit hit;
        CHECK(murk_surfaces_hit(s, from, murk_unit(offset), INFINITY, &hit));
        CHECK_NEAR(murk_length(offset) - hit.distance_m,
                   is_clear ? 0 : 8 * step_m, is_clear ? 1e-14 : 4 * step_m);
    }
    murk_surfaces_destroy(s);
}

static void test_sphere_is_exact_from_inside(void)
{
    const murk_surface_desc desc = {.shape = MURK_SHAPE_SPHERE,
                                    .center = {1, 2, 3},
                                    .radius_m = 0.7,
                                    .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&desc, 1);
    murk_hit hit;
    CHECK(murk_surfaces_hit(s, murk_vec(1, 2, 3), murk_vec(0, 0, 1), INFINITY,
                            &hit));
    CHECK_NEAR(hit.distance_m, 0.7, 1e-14);
    CHECK_NEAR(hit.normal.z, -1, 1e-14);
    CHECK(murk_surfaces_hit(s, murk_vec(-9, 2, 3), murk_vec(1, 0, 0), INFINITY,
                            &hit));
    CHECK_NEAR(hit.distance_m, 9.3, 1e-14);
    CHECK_NEAR(hit.normal.x, -1, 1e-14);
    murk_surfaces_destroy(s);
}

/* Names of meshes match exactly, else without regard to case, else without
 * regard to blanks. */
static void test_materials_are_found_by_name(void)
{
    /* Names, and the materials that they find; the default material is the
     * answer for unknown names. */
    static const struct {
        const char *name;
        size_t material;
        bool is_named;
    } want[] = {{"wall paint", 1, true}, {"Wall Paint", 1, true},
                {"WALL PAINT", 2, true}, {"wallpaint", 1, true},
                {" floor_1", 3, true},   {"floor_1", 3, true},
                {"floor\t_1 ", 3, true}, {"floor_", 0, false},
                {"floor_11", 0, false},  {"", 0, false},
                {"default", 0, true},    {"Default", 0, true}};
    /* Two names that differ in case only, and one with a blank at the end. */
    const murk_material material[] = {{.name = "default"},
                                      {.name = "wall paint"},
                                      {.name = "WALL PAINT"},
                                      {.name = "Floor_1 "}};
    murk_surfaces *s = NULL;
    CHECK(murk_surfaces_create(&s, NULL, 0, material, 4, NULL) == MURK_OK);
    for (size_t i = 0; i < sizeof want / sizeof *want; ++i) {
        bool is_named = !want[i].is_named;
        CHECK(murk_surfaces_material_named(s, want[i].name, &is_named) ==
              want[i].material);
        CHECK(is_named == want[i].is_named);
    }
    murk_surfaces_destroy(s);
}

int main(void)
{
    test_materials_are_found_by_name();
    test_box_from_inside_and_outside();
    test_hits_in_corners_are_moved_back();
    test_sphere_is_exact_from_inside();
    return check_done();
}
