/* Closed rooms hold their light, solids know their inside, and distances from
 * points are those of geometry.
 *
 * No false alarms: a closed room may not leak once, and the other answers are
 * known exactly. */
#include "base/log.h"
#include "check.h"
#include "geometry/surfaces.h"
#include "random_mesh.h"

#define SEED 31

static const murk_material MATERIALS[3] = {
    {.name = "default"},
    {.name = "glass", .transmit = {{0.9}}, .ior = 1.5},
    {.name = "film", .transmit = {{0.9}}}};

static murk_surface_desc box(murk_vec3 min, murk_vec3 max, int material)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_BOX,
                               .box = {min, max},
                               .to_world = murk_affine_identity(),
                               .material = material};
}

static murk_surfaces *create(const murk_surface_desc *desc, size_t n)
{
    murk_surfaces *s = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&s, desc, n, MATERIALS, 3, &err) == MURK_OK);
    return s;
}

/* Counts escapes of diffuse bounces in a box; with `aimed`, every other ray
 * starts from a point near the middle and goes exactly at an edge (1) or a
 * corner (2). */
static size_t escapes(const murk_surface_desc *walls, uint64_t bounces,
                      int aimed)
{
    /* The first ray starts in the middle. */
    murk_surfaces *s = create(walls, 1);
    const murk_box *b = &walls->box;
    const murk_vec3 middle = murk_affine_point(
        &walls->to_world, murk_along(b->min, 0.47, murk_sub(b->max, b->min)));
    murk_vec3 p = middle, d = {0, 0, 1};
    size_t lost = 0;
    for (uint64_t i = 0; i < bounces; ++i) {
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 0, 0);
        /* Aim at a corner, or at a point of the edge along x. */
        if (aimed > 0 && i % 2 == 0) {
            const murk_random4 q = murk_random(SEED, MURK_TEST, i, 1, 0);
            murk_vec3 to = {q.u[0] < 0.5 ? b->min.x : b->max.x,
                            q.u[1] < 0.5 ? b->min.y : b->max.y,
                            q.u[2] < 0.5 ? b->min.z : b->max.z};
            if (aimed == 1) {
                to.x = b->min.x + q.u[3] * (b->max.x - b->min.x);
            }
            p = murk_along(middle, 0.3, random_point(SEED, i));
            d = murk_unit(murk_sub(murk_affine_point(&walls->to_world, to), p));
        }
        /* A ray that meets no wall has escaped; else bounce by the cosine
         * law. */
        murk_hit hit;
        if (!murk_surfaces_hit(s, p, d, INFINITY, &hit)) {
            ++lost;
            p = middle;
            continue;
        }
        p = murk_surfaces_leave(s, murk_along(p, hit.distance_m, d),
                                hit.normal);
        d = murk_about(hit.normal, sqrt(r.u[0]), 2 * MURK_PI * r.u[1]);
    }
    murk_surfaces_destroy(s);
    return lost;
}

static void test_a_closed_box_does_not_leak(void)
{
    const murk_vec3 far = {1e4, -1e4, 100};
    murk_surface_desc walls =
        box(murk_vec(0, 0.1, 0), murk_vec(4.3, 6.1, 2.7), 0);
    CHECK(escapes(&walls, 1000000, 0) == 0);
    CHECK(escapes(&walls, 200000, 1) == 0);
    CHECK(escapes(&walls, 200000, 2) == 0);
    walls.to_world = murk_affine_place(murk_vec(10, 20, 33), 1, far);
    CHECK(escapes(&walls, 300000, 0) == 0);
    CHECK(escapes(&walls, 200000, 1) == 0);
    CHECK(escapes(&walls, 200000, 2) == 0);
}

/* A crack of a tenth of a millimetre does leak: the test above can fail. */
static void test_a_cracked_box_leaks(void)
{
    murk_surface_desc wall[6];
    for (int i = 0; i < 6; ++i) {
        const double at = i % 2 ? 1 : -1, half = i == 0 ? 0.9999 : 1;
        const murk_vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const murk_vec3 a = axis[(i / 2 + 1) % 3], b = axis[(i / 2 + 2) % 3];
        wall[i] = (murk_surface_desc){
            .shape = MURK_SHAPE_RECT,
            .corner = murk_along(
                murk_along(murk_scale(at, axis[i / 2]), -half, a), -1, b),
            .edge1 = murk_scale(2 * half, a),
            .edge2 = murk_scale(2, b),
            .to_world = murk_affine_identity()};
    }
    murk_surfaces *s = create(wall, 6);
    size_t lost = 0;
    for (uint64_t i = 0; i < 200000; ++i) {
        murk_hit hit;
        lost += !murk_surfaces_hit(s, murk_vec(0, 0, 0),
                                   random_direction(SEED, i), INFINITY, &hit);
    }
    CHECK(lost > 0);
    murk_surfaces_destroy(s);
}

/* A hit on the diagonal of a flat wall is not drawn back from it. */
static void test_a_flat_wall_is_met_exactly_on_its_diagonal(void)
{
    const murk_surface_desc walls =
        box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 0);
    murk_surfaces *s = create(&walls, 1);
    murk_hit hit;
    CHECK(murk_surfaces_hit(s, murk_vec(0, 0, 0), murk_vec(0, 0, 1), INFINITY,
                            &hit));
    CHECK_NEAR(hit.distance_m, 1, 1e-15);
    murk_surfaces_destroy(s);
}

static void test_solids_know_their_inside(void)
{
    /* Two solids, and two boxes of materials that make no solid. */
    const murk_surface_desc desc[4] = {
        box(murk_vec(0, 0, 0), murk_vec(1, 1, 1), 1),
        box(murk_vec(-9, -9, -9), murk_vec(9, 9, 9), 0),
        box(murk_vec(3, 0, 0), murk_vec(4, 1, 1), 2),
        {.shape = MURK_SHAPE_SPHERE,
         .center = {-3, 0, 0},
         .radius_m = 1,
         .to_world = murk_affine_identity(),
         .material = 1}};
    murk_surfaces *s = create(desc, 4);
    CHECK(murk_surfaces_describe(s).solids == 2);
    CHECK(murk_surfaces_describe(s).sheets == 12);
    /* Single points: in each solid, between them, and in a box that is no
     * solid. */
    const uint16_t in_box = murk_surfaces_solid_at(s, murk_vec(0.5, 0.5, 0.5));
    const uint16_t in_ball = murk_surfaces_solid_at(s, murk_vec(-3, 0.1, 0));
    CHECK(in_box > 0 && in_ball > 0 && in_box != in_ball);
    CHECK(murk_surfaces_solid_at(s, murk_vec(1.5, 0.5, 0.5)) == 0);
    CHECK(murk_surfaces_solid_at(s, murk_vec(3.5, 0.5, 0.5)) == 0);
    /* Random points against the formulas of box and ball. */
    size_t wrong = 0;
    for (uint64_t i = 0; i < 20000; ++i) {
        const murk_vec3 p = murk_scale(4, random_point(SEED, i));
        const murk_vec3 q = murk_sub(p, murk_vec(-3, 0, 0));
        const bool is_in_box =
            p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 1;
        const uint16_t want = is_in_box            ? in_box
                              : murk_dot(q, q) < 1 ? in_ball
                                                   : 0;
        wrong += murk_surfaces_solid_at(s, p) != want;
    }
    CHECK(wrong == 0);
    /* A hit from within names the solid; a sightline through the solid is
     * blocked. */
    murk_hit hit;
    CHECK(murk_surfaces_hit(s, murk_vec(0.5, 0.4, 0.3), murk_vec(0, 0, 1),
                            INFINITY, &hit) &&
          hit.solid == in_box && hit.material == 1);
    CHECK(murk_surfaces_blocked(s, murk_vec(0.5, 0.4, -1),
                                murk_vec(0.5, 0.4, 2), true));
    murk_surfaces_destroy(s);
}

static int warnings;

static void count_warning(const char *where, const char *text)
{
    (void)where, (void)text;
    ++warnings;
}

/* A pane with an ior is open: a sheet, and it is said. A hollow cube of two
 * shells is one solid with nothing in its cavity. */
static void test_open_and_hollow_shapes(void)
{
    murk_warn_to(count_warning);
    const murk_surface_desc pane = {.shape = MURK_SHAPE_RECT,
                                    .edge1 = {1, 0, 0},
                                    .edge2 = {0, 1, 0},
                                    .to_world = murk_affine_identity(),
                                    .material = 1};
    murk_surfaces *s = create(&pane, 1);
    CHECK(warnings == 1);
    CHECK(murk_surfaces_describe(s).solids == 0);
    CHECK(murk_surfaces_describe(s).sheets == 2);
    murk_surfaces_destroy(s);

    static const uint32_t face[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
                                      0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                      0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    float vertex[2 * 36 * 3];
    uint32_t corner[2 * 36], material[24] = {0};
    char name[1][MURK_NAME_SIZE] = {"glass"};
    for (uint32_t i = 0; i < 72; ++i) { /* no vertex shared: welding is ours */
        const uint32_t v = face[i % 36];
        const float half = i < 36 ? 2 : 1;
        for (uint32_t k = 0; k < 3; ++k) {
            vertex[3 * i + k] = v >> k & 1 ? half : -half;
        }
        corner[i] = i;
    }
    const murk_mesh hollow = {.vertices = 72,
                              .triangles = 24,
                              .materials = 1,
                              .vertex_m = vertex,
                              .corner = corner,
                              .material = material,
                              .material_name = name};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = &hollow,
                                    .to_world = murk_affine_identity(),
                                    .material = -1};
    s = create(&desc, 1);
    CHECK(warnings == 1);
    CHECK(murk_surfaces_describe(s).solids == 1);
    CHECK(murk_surfaces_solid_at(s, murk_vec(1.5, 0, 0)) == 1);
    CHECK(murk_surfaces_solid_at(s, murk_vec(0, 0, 0)) == 0);
    murk_surfaces_destroy(s);
    murk_warn_to(murk_warn_to_stderr);
}

static void test_near_is_the_distance_to_the_nearest_surface(void)
{
    /* A box and a sphere. */
    const murk_surface_desc desc[2] = {
        box(murk_vec(0, 0, 0), murk_vec(1, 1, 1), 0),
        {.shape = MURK_SHAPE_SPHERE,
         .center = {3, 0, 0},
         .radius_m = 0.5,
         .to_world = murk_affine_identity()}};
    murk_surfaces *s = create(desc, 2);
    for (uint64_t i = 0; i < 5000; ++i) {
        /* Distance to the box, from outside or from inside. */
        const murk_vec3 p = murk_scale(4, random_point(SEED + 3, i));
        const double x = fmax(0, fmax(-p.x, p.x - 1));
        const double y = fmax(0, fmax(-p.y, p.y - 1));
        const double z = fmax(0, fmax(-p.z, p.z - 1));
        double to_box = murk_length(murk_vec(x, y, z));
        if (to_box == 0) {
            to_box = fmin(fmin(fmin(p.x, 1 - p.x), fmin(p.y, 1 - p.y)),
                          fmin(p.z, 1 - p.z));
        }
        /* Distance to the sphere. */
        const double to_ball =
            fabs(murk_length(murk_sub(p, murk_vec(3, 0, 0))) - 0.5);
        const double distance = fmin(to_box, to_ball);
        /* A surface is near within slightly more than the distance, and not
         * within slightly less. */
        CHECK(murk_surfaces_near(s, p, distance + 1e-9));
        CHECK(!murk_surfaces_near(s, p, distance - 1e-9));
    }
    CHECK(murk_surfaces_near(s, murk_vec(0.5, 0.5, 0.5), INFINITY));
    murk_surfaces_destroy(s);
}

static void test_nothing_at_all(void)
{
    murk_surfaces *s = create(NULL, 0);
    murk_hit hit;
    const murk_vec3 o = {0, 0, 0}, x = {1, 0, 0};
    CHECK(!murk_surfaces_hit(s, o, x, INFINITY, &hit));
    CHECK(!murk_surfaces_blocked(s, o, x, false));
    CHECK(!murk_surfaces_near(s, o, 1e9));
    CHECK(murk_surfaces_solid_at(s, o) == 0);
    CHECK(murk_surfaces_describe(s).triangles == 0);
    murk_surfaces_destroy(s);
}

static void check_refused(murk_surface_desc desc, const char *part)
{
    murk_surfaces *s = NULL;
    murk_error err = {0};
    desc.where = "a.yaml:1:1";
    CHECK(murk_surfaces_create(&s, &desc, 1, MATERIALS, 3, &err) ==
          MURK_BAD_VALUE);
    CHECK(s == NULL);
    CHECK_TEXT(err.where, "a.yaml:1:1");
    CHECK_MENTIONS(err.text, part);
}

static void test_impossible_shapes_are_refused(void)
{
    check_refused(box(murk_vec(0, 0, 0), murk_vec(1, 0, 1), 0), "maximum");
    check_refused(box(murk_vec(0, NAN, 0), murk_vec(1, 1, 1), 0), "maximum");
    check_refused(box(murk_vec(0, 0, 0), murk_vec(1e30, 1, 1), 0), "within");
    for (int axis = 0; axis < 3; ++axis) { /* flat, and a little inside out */
        for (int k = 0; k < 2; ++k) {
            murk_vec3 top = {2, 2, 2};
            double *const high[3] = {&top.x, &top.y, &top.z};
            *high[axis] = k ? 0.99 : 1;
            check_refused(box(murk_vec(1, 1, 1), top, 0), "maximum");
        }
    }
    murk_surface_desc shape = {.shape = MURK_SHAPE_SPHERE,
                               .radius_m = 0,
                               .to_world = murk_affine_identity()};
    check_refused(shape, "radius is 0 m");
    shape.radius_m = 1.01e9;
    check_refused(shape, "at most 1e+09");
    shape.radius_m = 1;
    shape.to_world.matrix[0][0] = 2;
    check_refused(shape, "scaled alike");
    shape = (murk_surface_desc){.shape = MURK_SHAPE_RECT,
                                .edge1 = {1, 0, 0},
                                .edge2 = {2, 0, 0},
                                .to_world = murk_affine_identity()};
    check_refused(shape, "no area");
}

int main(void)
{
    test_a_closed_box_does_not_leak();
    test_a_cracked_box_leaks();
    test_a_flat_wall_is_met_exactly_on_its_diagonal();
    test_solids_know_their_inside();
    test_open_and_hollow_shapes();
    test_near_is_the_distance_to_the_nearest_surface();
    test_nothing_at_all();
    test_impossible_shapes_are_refused();
    return check_done();
}
