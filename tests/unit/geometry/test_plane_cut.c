/* Cuts of surfaces by a plane have the lengths, areas and radii that geometry
 * says, also where the plane passes through vertices and faces. Nothing here is
 * random. */
#include "check.h"
#include "geometry/plane_cut.h"

static const murk_material GREY = {.name = "default"};

static murk_surfaces *create(const murk_surface_desc *desc)
{
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, desc, 1, &GREY, 1, &err) == MURK_OK);
    return surfaces;
}

static murk_surfaces *unit_cube(void)
{
    const murk_surface_desc cube = {.shape = MURK_SHAPE_BOX,
                                    .box = {{0, 0, 0}, {1, 1, 1}},
                                    .to_world = murk_affine_identity()};
    return create(&cube);
}

static murk_plane_cut cut(const murk_surfaces *surfaces, murk_vec3 point,
                          murk_vec3 normal)
{
    const murk_cut_plane plane = {point, murk_unit(normal)};
    murk_plane_cut out;
    murk_error err = {0};
    CHECK(murk_plane_cut_surfaces(&out, surfaces, &plane, &err) == MURK_OK);
    return out;
}

static double length_of(const murk_plane_cut *c)
{
    double sum = 0;
    for (size_t i = 0; i < c->segments; ++i) {
        sum += murk_length(murk_sub(c->segment[i].to, c->segment[i].from));
    }
    return sum;
}

/* The area of a convex outline around a point inside it: triangles from that
 * point to each segment. */
static double area_about(const murk_plane_cut *c, murk_vec3 inside)
{
    double sum = 0;
    for (size_t i = 0; i < c->segments; ++i) {
        sum +=
            0.5 * murk_length(murk_cross(murk_sub(c->segment[i].from, inside),
                                         murk_sub(c->segment[i].to, inside)));
    }
    return sum;
}

/* Each end of a segment is the end of an even number of segments. */
static bool is_closed(const murk_plane_cut *c)
{
    for (size_t i = 0; i < 2 * c->segments; ++i) {
        const murk_cut_segment *s = &c->segment[i / 2];
        const murk_vec3 end = i % 2 ? s->to : s->from;
        size_t there = 0;
        for (size_t k = 0; k < c->segments; ++k) {
            there += murk_length(murk_sub(c->segment[k].from, end)) == 0;
            there += murk_length(murk_sub(c->segment[k].to, end)) == 0;
        }
        if (there % 2 != 0) {
            return false;
        }
    }
    return true;
}

static void test_cube_gives_a_square(void)
{
    murk_surfaces *s = unit_cube();
    murk_plane_cut c = cut(s, murk_vec(0, 0, 0.25), murk_vec(0, 0, 1));
    CHECK(c.segments == 8 && c.circles == 0); /* two triangles a side */
    CHECK_NEAR(length_of(&c), 4, 1e-14);
    CHECK_NEAR(area_about(&c, murk_vec(0.5, 0.5, 0.25)), 1, 1e-14);
    CHECK(is_closed(&c));
    for (size_t i = 0; i < c.segments; ++i) {
        CHECK_NEAR(c.segment[i].from.z, 0.25, 1e-15);
        CHECK(c.segment[i].triangle < 12);
    }
    murk_plane_cut_release(&c);
    /* The diagonal plane through four vertices: sides 1 and sqrt(2). */
    c = cut(s, murk_vec(0, 0, 0), murk_vec(1, -1, 0));
    CHECK_NEAR(length_of(&c), 2 + 2 * sqrt(2), 1e-14);
    CHECK(is_closed(&c));
    murk_plane_cut_release(&c);
    /* The plane through the middles of six edges: a regular hexagon. */
    c = cut(s, murk_vec(0.5, 0.5, 0.5), murk_vec(1, 1, 1));
    CHECK_NEAR(length_of(&c), 6 * sqrt(0.5), 1e-14);
    CHECK_NEAR(area_about(&c, murk_vec(0.5, 0.5, 0.5)), 3 * sqrt(3) / 4, 1e-14);
    CHECK(is_closed(&c));
    murk_plane_cut_release(&c);
    murk_surfaces_destroy(s);
}

static void test_plane_in_a_face(void)
{
    murk_surfaces *s = unit_cube();
    /* The cube lies below the plane: the outline of its upper face. */
    murk_plane_cut c = cut(s, murk_vec(0, 0, 1), murk_vec(0, 0, 1));
    CHECK_NEAR(length_of(&c), 4, 0);
    CHECK(is_closed(&c));
    murk_plane_cut_release(&c);
    /* The cube lies above the plane, or beside it: nothing. */
    c = cut(s, murk_vec(0, 0, 0), murk_vec(0, 0, 1));
    CHECK(c.segments == 0);
    murk_plane_cut_release(&c);
    c = cut(s, murk_vec(0, 0, 1.5), murk_vec(0, 0, 1));
    CHECK(c.segments == 0);
    murk_plane_cut_release(&c);
    /* A vertex alone touches the plane: nothing, from either side. */
    c = cut(s, murk_vec(1, 1, 1), murk_vec(1, 1, 1));
    CHECK(c.segments == 0);
    murk_plane_cut_release(&c);
    c = cut(s, murk_vec(1, 1, 1), murk_vec(-1, -1, -1));
    CHECK(c.segments == 0);
    murk_plane_cut_release(&c);
    murk_surfaces_destroy(s);
}

static void test_triangle_with_an_edge_in_the_plane(void)
{
    const murk_cut_plane level = {{0, 0, 0}, {0, 0, 1}};
    murk_vec3 corner[3] = {{0, 0, 0}, {3, 4, 0}, {1, 1, -2}}, end[2];
    CHECK(murk_plane_cut_triangle(&level, corner, end));
    CHECK(murk_length(murk_sub(end[1], end[0])) == 5);
    corner[2].z = 2; /* above: the edge belongs to the side of the normal */
    CHECK(!murk_plane_cut_triangle(&level, corner, end));
    corner[2].z = 0; /* in the plane */
    CHECK(!murk_plane_cut_triangle(&level, corner, end));
    corner[0].z = NAN; /* no number is on no side */
    corner[2].z = 1;
    CHECK(!murk_plane_cut_triangle(&level, corner, end));
}

static void test_sphere_gives_a_circle(void)
{
    const murk_surface_desc ball = {.shape = MURK_SHAPE_SPHERE,
                                    .center = {1, 2, 3},
                                    .radius_m = 5,
                                    .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&ball);
    murk_plane_cut c = cut(s, murk_vec(0, 0, 6), murk_vec(0, 0, 1));
    CHECK(c.segments == 0 && c.circles == 1);
    CHECK_NEAR(c.circle[0].radius_m, 4, 1e-14);
    CHECK_NEAR(c.circle[0].center.x, 1, 1e-15);
    CHECK_NEAR(c.circle[0].center.y, 2, 1e-15);
    CHECK_NEAR(c.circle[0].center.z, 6, 1e-15);
    CHECK(c.circle[0].sphere == 0);
    murk_plane_cut_release(&c);
    c = cut(s, murk_vec(0, 0, 8), murk_vec(0, 0, 1)); /* touched */
    CHECK(c.circles == 0);
    murk_plane_cut_release(&c);
    murk_surfaces_destroy(s);
}

static void test_no_surfaces(void)
{
    murk_surfaces *s = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&s, NULL, 0, &GREY, 1, &err) == MURK_OK);
    murk_plane_cut c = cut(s, murk_vec(0, 0, 0), murk_vec(0, 0, 1));
    CHECK(c.segments == 0 && c.circles == 0);
    murk_plane_cut_release(&c);
    murk_surfaces_destroy(s);
}

int main(void)
{
    test_cube_gives_a_square();
    test_plane_in_a_face();
    test_triangle_with_an_edge_in_the_plane();
    test_sphere_gives_a_circle();
    test_no_surfaces();
    return check_done();
}
