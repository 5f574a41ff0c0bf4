/* Where sensors may stand when lamps are in glass. Deterministic: never cries
 * wolf. */
#include "candidates_box.h"

/* ---- lamps in glass ---- */

static murk_reach by_lamp_at(const murk_vec3 *place)
{
    return (murk_reach){.lamps = place, .n_lamps = 1, .domain = interior};
}

static murk_surface_desc a_globe(murk_vec3 center, double radius_m,
                                 int material)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_SPHERE,
                               .center = center,
                               .radius_m = radius_m,
                               .material = material,
                               .to_world = murk_affine_identity(),
                               .where = "globe"};
}

/* How many of the points of half_metres() are usable in a room with these
 * solids; -1 if none is. */
static long usable_in_glass(const murk_surface_desc *more, size_t n_more,
                            double specular, double transmit, murk_vec3 place)
{
    /* The room, and solids of glass with these properties. */
    const murk_material materials[2] = {
        {.name = "default", .diffuse = murk_spectrum_flat(0.5, 2)},
        {.name = "glass",
         .specular = murk_spectrum_flat(specular, 1),
         .transmit = murk_spectrum_flat(transmit, 1),
         .ior = 1.5}};
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    for (size_t i = 0; i < n_more; ++i) {
        d[n++] = more[i];
    }
    murk_surfaces *surfaces = NULL;
    murk_candidates *c = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, d, n, materials, 2, &err) == MURK_OK);
    /* Candidates on a grid, reached from the lamp. */
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp_at(&place);
    const murk_status status =
        murk_candidates_create(&c, &(murk_candidate_desc){.grid = grid},
                               surfaces, &reach, 1, "here", &err);
    CHECK(status == MURK_OK || status == MURK_BAD_VALUE);
    /* The number of usable candidates. */
    const long usable = c ? (long)c->usable : -1;
    murk_candidates_destroy(c);
    murk_surfaces_destroy(surfaces);
    return usable;
}

static const long all_points = 19 * 19 * 7;

static void test_a_lamp_in_glass_lights_what_is_around(void)
{
    /* Between the points of the grid, which it holds none of. */
    const murk_vec3 at = {5.25, 5.25, 2.25};
    const murk_surface_desc globe = a_globe(at, 0.2, GLASS);
    CHECK(usable_in_glass(&globe, 1, 0, 0.9, at) == all_points);
    CHECK(usable_in_glass(&globe, 1, 0.9, 0, at) == all_points);
    murk_surface_desc block =
        a_box(murk_vec(5.1, 5.1, 2.1), murk_vec(5.4, 5.4, 2.4));
    block.material = GLASS;
    CHECK(usable_in_glass(&block, 1, 0, 0.9, at) == all_points);

    /* A bulb in a globe, and a globe by the wall. */
    const murk_surface_desc nested[2] = {a_globe(at, 0.05, GLASS), globe};
    CHECK(usable_in_glass(nested, 2, 0, 0.9, at) == all_points);
    const murk_vec3 aside = {0.2, 5.25, 2.25};
    const murk_surface_desc by_wall = a_globe(aside, 0.2, GLASS);
    CHECK(usable_in_glass(&by_wall, 1, 0, 0.9, aside) == all_points);

    /* Teeth: black glass, a black globe, and a globe in a closed crate let
     * nothing out. */
    CHECK(usable_in_glass(&globe, 1, 0, 0, at) == -1);
    const murk_surface_desc black = a_globe(at, 0.2, WALL);
    CHECK(usable_in_glass(&black, 1, 0, 0.9, at) == -1);
    const murk_surface_desc crated[2] = {
        globe, a_box(murk_vec(5.01, 5.01, 2.01), murk_vec(5.49, 5.49, 2.49))};
    CHECK(usable_in_glass(crated, 2, 0, 0.9, at) == -1);
}

/* The globe is one mesh of two closed boundary surfaces. */
static void test_a_lamp_in_a_hollow_globe_too(void)
{
    /* Two cubes around the lamp, one inside the other. */
    static const int quad[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    const murk_vec3 at = {5.25, 5.25, 2.25};
    float vertex[2 * 8 * 3];
    uint32_t corner[2 * 36], material[24] = {0};
    char name[1][MURK_NAME_SIZE] = {"glass"};
    for (int v = 0; v < 16; ++v) {
        const float half = v < 8 ? 0.15f : 0.2f;
        vertex[3 * v] = 5.25f + (v & 1 ? half : -half);
        vertex[3 * v + 1] = 5.25f + (v >> 1 & 1 ? half : -half);
        vertex[3 * v + 2] = 2.25f + (v >> 2 & 1 ? half : -half);
    }
    for (int t = 0; t < 24; ++t) {
        for (int k = 0; k < 3; ++k) {
            const int pick = t % 2 ? (int[]){0, 2, 3}[k] : k;
            corner[3 * t + k] = (uint32_t)(t / 12 * 8 + quad[t % 12 / 2][pick]);
        }
    }
    /* Both are one mesh of glass. */
    const murk_mesh mesh = {
        .vertices = 16,
        .triangles = 24,
        .materials = 1,
        .vertex_m = vertex,
        .corner = corner,
        .material = material,
        .material_name = name,
        .bounds_m = {{5.05, 5.05, 2.05}, {5.45, 5.45, 2.45}}};
    const murk_surface_desc globe = {.shape = MURK_SHAPE_MESH,
                                     .mesh = &mesh,
                                     .material = GLASS,
                                     .to_world = murk_affine_identity(),
                                     .where = "globe"};
    /* Clear glass lets the lamp reach all points, black glass none. */
    CHECK(usable_in_glass(&globe, 1, 0, 0.9, at) == all_points);
    CHECK(usable_in_glass(&globe, 1, 0, 0, at) == -1);
}

/* Only what the lamp stands in is passed: of another body of glass, the inside
 * stays out. */
static void test_other_glass_still_blocks(void)
{
    const murk_vec3 at = {5.25, 5.25, 2.25};
    murk_surface_desc d[2] = {
        a_globe(at, 0.2, GLASS),
        a_box(murk_vec(7.25, 4.25, 0.25), murk_vec(9.25, 6.25, 2.75))};
    d[1].material = GLASS;
    CHECK(usable_in_glass(d, 2, 0, 0.9, at) == all_points - 4 * 4 * 5);
    CHECK(usable_in_glass(d + 1, 1, 0, 0.9, at) == all_points - 4 * 4 * 5);
}

int main(void)
{
    test_a_lamp_in_glass_lights_what_is_around();
    test_a_lamp_in_a_hollow_globe_too();
    test_other_glass_still_blocks();
    return check_done();
}
