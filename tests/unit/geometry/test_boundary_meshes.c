/* Closed meshes as boundaries of regions: what is inside, where rays go in and
 * out, which meshes are refused.
 *
 * No false alarms: all is compared with a twin in plain double arithmetic, or
 * known exactly. */
#include "base/log.h"
#include "check.h"
#include "closed_mesh.h"
#include "geometry/boundary_meshes.h"
#include "plain_rays.h"
#include "random_mesh.h"

#define SEED 71

static const murk_affine PLACED = {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}},
                                   {3, -2, 1}};

static murk_boundary_meshes *create(murk_mesh *const *mesh, size_t n,
                                    const murk_affine *to_world)
{
    murk_boundary_mesh_desc desc[MURK_BOUNDARY_MESHES_MAX];
    for (size_t i = 0; i < n; ++i) {
        desc[i] = (murk_boundary_mesh_desc){
            .region = (int)(7 * i), .mesh = mesh[i], .to_world = *to_world};
    }
    murk_boundary_meshes *b = NULL;
    murk_error err = {0};
    CHECK(murk_boundary_meshes_create(&b, desc, n, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return b;
}

static murk_boundary_meshes *create_one(murk_mesh *mesh, murk_affine to_world)
{
    return create(&mesh, 1, &to_world);
}

/* ---- the twin: every triangle in turn ---- */

static murk_vec3 vertex_of(const murk_mesh *m, uint32_t i)
{
    const float *v = m->vertex_m + 3 * (size_t)i;
    return murk_vec((double)v[0], (double)v[1], (double)v[2]);
}

/* Distances at which a ray meets the mesh, in order; at most 256. */
static size_t plain_crossings(const murk_mesh *m, murk_vec3 o, murk_vec3 d,
                              double *at)
{
    size_t n = 0;
    for (size_t i = 0; i < m->triangles && n < 256; ++i) {
        double edge;
        const uint32_t *c = m->corner + 3 * i;
        const double t = plain_triangle(vertex_of(m, c[0]), vertex_of(m, c[1]),
                                        vertex_of(m, c[2]), o, d, &edge);
        if (t < INFINITY) {
            size_t k = n++;
            for (; k > 0 && at[k - 1] > t; --k) {
                at[k] = at[k - 1];
            }
            at[k] = t;
        }
    }
    return n;
}

static bool plain_inside(const murk_mesh *m, murk_vec3 p)
{
    double at[256];
    return plain_crossings(m, p, murk_unit(murk_vec(0.2, 0.9, -0.4)), at) % 2;
}

/* ---- tests ---- */

static void check_points(murk_mesh *m, double reach)
{
    const murk_affine placed = PLACED, still = murk_affine_identity();
    murk_boundary_meshes *moved = create_one(m, placed);
    murk_boundary_meshes *b = create_one(m, still);
    size_t wrong = 0, inside = 0;
    for (uint64_t i = 0; i < 4000; ++i) {
        const murk_vec3 p = murk_scale(reach, random_point(SEED, i));
        const uint64_t want = plain_inside(m, p) ? 1 : 0;
        inside += want;
        wrong += murk_boundary_meshes_at(b, p) != want;
        wrong += murk_boundary_meshes_at(moved,
                                         murk_affine_point(&placed, p)) != want;
    }
    CHECK(wrong == 0);
    CHECK(inside > 100 && inside < 3900);
    murk_boundary_meshes_destroy(moved);
    murk_boundary_meshes_destroy(b);
}

static void test_points_are_inside_as_the_twin_says(void)
{
    murk_mesh *ball = closed_star(murk_vec(0, 0, 0), 1, 0, 12, SEED);
    check_points(ball, 1.2);
    murk_mesh_destroy(ball);

    murk_mesh *star = closed_star(murk_vec(0.1, 0, 0), 1, 0.6, 10, SEED);
    closed_mesh_mix_winding(star, SEED);
    check_points(star, 1.2);
    murk_mesh_destroy(star);

    /* A cavity with a kernel in it. */
    murk_mesh *nested = closed_mesh_join(
        closed_star(murk_vec(0, 0, 0), 1, 0.1, 6, SEED),
        closed_mesh_join(
            closed_star(murk_vec(0, 0, 0), 0.7, 0.2, 8, SEED),
            closed_box(murk_vec(-0.2, -0.2, -0.2), murk_vec(0.2, 0.3, 0.2))));
    check_points(nested, 1.2);
    closed_mesh_mix_winding(nested, SEED);
    check_points(nested, 1.2);
    murk_mesh_destroy(nested);
}

/* The list of changes along a ray is the list of crossings of the plain
 * twin. */
static void check_rays(murk_mesh *m)
{
    /* Rays of random origin and direction, around the mesh and within. */
    murk_boundary_meshes *b = create_one(m, murk_affine_identity());
    const double step = murk_boundary_meshes_tolerance_m(b);
    size_t wrong = 0, met = 0;
    for (uint64_t i = 0; i < 3000; ++i) {
        const murk_vec3 o = murk_scale(1.5, random_point(SEED + 1, i));
        const murk_vec3 d = random_direction(SEED + 2, i);
        /* The twin gives all crossings; from the origin the ray is inside
         * if they are odd in number. */
        double at[256];
        const size_t n = plain_crossings(m, o, d, at);
        uint64_t inside = murk_boundary_meshes_at(b, o);
        /* Each crossing is the next of the twin, changes side, and has a
         * normal against the ray. */
        murk_crossing c;
        size_t k = 0;
        for (double from = 0;
             murk_boundary_meshes_next(b, o, d, from, INFINITY, &inside, &c);
             from = c.distance_m + step) {
            wrong += k >= n || !(fabs(c.distance_m - at[k]) < 1e-5) ||
                     inside != (n - k) % 2 || c.inside != (n - k - 1) % 2 ||
                     !(murk_dot(c.normal, d) < 0) || c.changed != 1;
            inside = c.inside;
            ++k;
        }
        wrong += k != n;
        met += n;
    }
    CHECK(wrong == 0);
    CHECK(met > 1000);
    murk_boundary_meshes_destroy(b);
}

static void test_rays_cross_as_the_twin_says(void)
{
    murk_mesh *star = closed_star(murk_vec(0.1, 0, 0), 1, 0.6, 10, SEED);
    closed_mesh_mix_winding(star, SEED);
    check_rays(star);
    murk_mesh_destroy(star);
    const double at[8][2] = {{-1, -1}, {1, -1},   {1, 1},    {0.5, 1},
                             {0.5, 0}, {-0.5, 0}, {-0.5, 1}, {-1, 1}};
    const uint32_t cut[18] = {0, 1, 5, 1, 4, 5, 1, 2, 4,
                              2, 3, 4, 0, 5, 7, 5, 6, 7};
    murk_mesh *u = closed_prism(at, 8, cut, -0.5, 0.5);
    check_rays(u);
    murk_mesh_destroy(u);
}

/* A wrong belief about where the ray starts is put right by what lies ahead. */
static void test_belief_is_corrected(void)
{
    murk_mesh *box = closed_box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1));
    murk_boundary_meshes *b = create_one(box, murk_affine_identity());
    const murk_vec3 x = {1, 0.1, 0.05};
    murk_crossing c;
    uint64_t inside = 0;
    CHECK(murk_boundary_meshes_next(b, murk_vec(0, 0, 0), murk_unit(x), 0,
                                    INFINITY, &inside, &c));
    CHECK(inside == 1 && c.inside == 0);
    inside = 1;
    CHECK(murk_boundary_meshes_next(b, murk_vec(-2, 0, 0), murk_unit(x), 0,
                                    INFINITY, &inside, &c));
    CHECK(inside == 0 && c.inside == 1);
    inside = 1;
    CHECK(!murk_boundary_meshes_next(b, murk_vec(-2, 0, 0), murk_unit(x), 0,
                                     0.9, &inside, &c));
    CHECK(inside == 1); /* nothing met: as believed */
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(box);
}

/* A ray aimed at corners and edges, at which a triangle more or less may be
 * met, starts outside and is outside in the end. One in a thousand of these
 * rays may slip out unseen, just at a corner, which Embree leaves open. */
static void test_edges_and_corners_do_not_leak(void)
{
    /* A star whose triangles have mixed winding. */
    murk_mesh *m = closed_star(murk_vec(0, 0, 0), 1, 0.3, 8, SEED);
    closed_mesh_mix_winding(m, SEED);
    const murk_affine placed = PLACED;
    murk_boundary_meshes *b = create_one(m, placed);
    const double step = murk_boundary_meshes_tolerance_m(b);
    size_t wrong = 0, first_wrong = 0;
    for (uint64_t i = 0; i < 20000; ++i) {
        /* Aim from far outside at a corner, or at a point of an edge. */
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 7, 0);
        const size_t t = (size_t)(r.u[0] * (double)m->triangles);
        const murk_vec3 p = vertex_of(m, m->corner[3 * t]);
        const murk_vec3 q = vertex_of(m, m->corner[3 * t + 1]);
        const double share = i % 2 ? 0 : r.u[1];
        const murk_vec3 aim =
            murk_affine_point(&placed, murk_along(p, share, murk_sub(q, p)));
        const murk_vec3 o = murk_affine_point(
            &placed, murk_scale(3, random_direction(SEED + 3, i)));
        const murk_vec3 d = murk_unit(murk_sub(aim, o));
        /* Follow the ray to the end; the first crossing must find the ray
         * outside. */
        uint64_t inside = 0;
        murk_crossing c;
        bool was_right = true;
        for (double from = 0;
             murk_boundary_meshes_next(b, o, d, from, INFINITY, &inside, &c);
             from = c.distance_m + step) {
            was_right &= inside == 0 || from > 0;
            inside = c.inside;
        }
        wrong += inside != 0;
        first_wrong += !was_right;
    }
    CHECK(wrong <= 20);
    CHECK(first_wrong == 0);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(m);
}

/* A walk of many short segments, each begun at the end of the one before,
 * always knows the regions around the point. */
static void test_a_long_walk_keeps_count(void)
{
    /* A star and a box that overlap; the walk starts inside both. */
    murk_mesh *mesh[2] = {
        closed_star(murk_vec(0, 0, 0), 1, 0.3, 8, SEED),
        closed_box(murk_vec(-0.3, -0.3, -2), murk_vec(0.3, 0.3, 2))};
    const murk_affine placed = PLACED;
    murk_boundary_meshes *b = create(mesh, 2, &placed);
    const double step = murk_boundary_meshes_tolerance_m(b);
    murk_vec3 p = placed.shift;
    uint64_t inside = murk_boundary_meshes_at(b, p);
    CHECK(inside == 129);
    size_t wrong = 0, crossed = 0;
    for (uint64_t i = 0; i < 100000; ++i) {
        /* A random direction, or back to the middle from far away. */
        murk_vec3 d = random_direction(SEED + 4, i);
        if (murk_length(murk_sub(p, placed.shift)) > 2) {
            d = murk_unit(murk_sub(placed.shift, p));
        }
        const double length =
            -0.5 * log(murk_random(SEED, MURK_TEST, i, 9, 0).u[0]);
        /* Walk over all crossings of the segment, and compare with a query
         * at the end. */
        murk_crossing c;
        for (double from = 0;
             murk_boundary_meshes_next(b, p, d, from, length, &inside, &c);
             from = c.distance_m + step) {
            inside = c.inside;
            ++crossed;
        }
        p = murk_along(p, length, d);
        wrong += inside != murk_boundary_meshes_at(b, p);
    }
    CHECK(wrong == 0);
    CHECK(crossed > 20000);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(mesh[0]);
    murk_mesh_destroy(mesh[1]);
}

/* Regions that share a face change in one crossing. */
static void test_shared_faces_are_one_crossing(void)
{
    /* Two boxes side by side, turned together. */
    murk_mesh *mesh[2] = {
        closed_box(murk_vec(0, 0, 0), murk_vec(1, 1, 1)),
        closed_box(murk_vec(1, 0, 0), murk_vec(2, 1, 1)),
    };
    const murk_affine placed = PLACED;
    murk_boundary_meshes *b = create(mesh, 2, &placed);
    const double step = murk_boundary_meshes_tolerance_m(b);
    size_t wrong = 0;
    for (uint64_t i = 0; i < 1000; ++i) {
        /* A ray through both boxes. */
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 3, 0);
        const murk_vec3 from = murk_affine_point(
            &placed, murk_vec(-0.5, 0.1 + 0.8 * r.u[0], 0.1 + 0.8 * r.u[1]));
        const murk_vec3 to = murk_affine_point(
            &placed, murk_vec(2.5, 0.1 + 0.8 * r.u[2], 0.1 + 0.8 * r.u[3]));
        const murk_vec3 d = murk_unit(murk_sub(to, from));
        /* Three crossings: into the first, from the first into the second,
         * and out. */
        static const uint64_t after[3] = {1, 128, 0},
                              changed[3] = {1, 129, 128};
        uint64_t inside = 0;
        murk_crossing c;
        size_t k = 0;
        for (double at = 0;
             murk_boundary_meshes_next(b, from, d, at, INFINITY, &inside, &c);
             at = c.distance_m + step) {
            wrong += k > 2 || c.inside != after[k] || c.changed != changed[k];
            inside = c.inside;
            ++k;
        }
        wrong += k != 3;
    }
    CHECK(wrong == 0);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(mesh[0]);
    murk_mesh_destroy(mesh[1]);
}

static size_t warnings;

static void count_warning(const char *where, const char *text)
{
    (void)where;
    warnings += strstr(text, "twice inside counts as outside") != NULL;
}

/* Where parts of one mesh overlap, twice inside is outside, and a warning says
 * so. */
static void test_a_mesh_that_crosses_itself_counts(void)
{
    murk_mesh *m = closed_mesh_join(
        closed_box(murk_vec(-1, -1, -1), murk_vec(0.2, 1, 1)),
        closed_box(murk_vec(-0.2, -0.8, -0.9), murk_vec(1, 0.8, 1.1)));
    murk_warn_to(count_warning);
    check_points(m, 1.3);
    check_rays(m);
    CHECK(warnings == 3);
    murk_boundary_meshes *b = create_one(m, murk_affine_identity());
    murk_warn_to(murk_warn_to_stderr);
    CHECK(murk_boundary_meshes_at(b, murk_vec(0, 0, 0)) == 0);
    CHECK(murk_boundary_meshes_at(b, murk_vec(0.5, 0, 0)) == 1);
    CHECK(murk_boundary_meshes_describe(b, 0).crossings > 0);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(m);
}

/* Listed twice is listed once. */
static void test_copies_count_once(void)
{
    murk_mesh *m =
        closed_mesh_join(closed_star(murk_vec(0, 0, 0), 1, 0.4, 6, SEED),
                         closed_star(murk_vec(0, 0, 0), 1, 0.4, 6, SEED));
    murk_mesh *once = closed_star(murk_vec(0, 0, 0), 1, 0.4, 6, SEED);
    closed_mesh_mix_winding(m, SEED);
    murk_boundary_meshes *b = create_one(m, murk_affine_identity());
    size_t wrong = 0;
    for (uint64_t i = 0; i < 2000; ++i) {
        const murk_vec3 p = random_point(SEED, i);
        wrong +=
            murk_boundary_meshes_at(b, p) != (plain_inside(once, p) ? 1 : 0);
    }
    CHECK(wrong == 0);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(once);
    murk_mesh_destroy(m);
}

static void test_open_meshes_are_refused_with_their_edges(void)
{
    murk_mesh *m = closed_box(murk_vec(0, 0, 0), murk_vec(1, 1, 1));
    murk_boundary_mesh_desc desc = {.mesh = m,
                                    .to_world = murk_affine_identity(),
                                    .where = "sea.yaml:9:5: regions.0"};
    murk_boundary_meshes *b = NULL;
    murk_error err = {0};
    --m->triangles;
    CHECK(murk_boundary_meshes_create(&b, &desc, 1, &err) == MURK_BAD_VALUE);
    CHECK(b == NULL);
    CHECK_TEXT(err.where, "sea.yaml:9:5: regions.0");
    CHECK_TEXT(err.text,
               "the mesh is open: 3 of its edges belong to an odd number of "
               "its 11 triangles, must be 0 open edges to bound a region");
    m->triangles = 6;
    err = (murk_error){0};
    CHECK(murk_boundary_meshes_create(&b, &desc, 1, &err) == MURK_BAD_VALUE);
    murk_mesh_destroy(m);
}

static bool meet(murk_mesh *one, murk_mesh *other)
{
    murk_mesh *mesh[2] = {one, other};
    const murk_affine placed = PLACED;
    murk_boundary_meshes *b = create(mesh, 2, &placed);
    murk_vec3 place;
    const bool they_do = murk_boundary_meshes_meet(b, 0, 7, &place);
    CHECK(murk_boundary_meshes_meet(b, 7, 0, &place) == they_do);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(one);
    murk_mesh_destroy(other);
    return they_do;
}

static murk_mesh *box(double x0, double y0, double z0, double x1, double y1,
                      double z1)
{
    return closed_box(murk_vec(x0, y0, z0), murk_vec(x1, y1, z1));
}

static murk_mesh *ball(double x, double radius)
{
    return closed_star(murk_vec(x, 0, 0), radius, 0, 10, SEED);
}

static void test_crossing_boundaries_are_distinguished_from_nested_ones(void)
{
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(2, 0, 0, 3, 1, 1)));
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(0.2, 0.2, 0.2, 0.8, 0.8, 0.8)));
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 2, 1, 1)));   /* a face */
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(0, 0, 0, 1, 1, 0.5))); /* in it */
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(0, 0, 0, 1, 1, 1)));
    CHECK(!meet(ball(0, 1), ball(0.3, 0.5)));
    CHECK(!meet(ball(0, 1), ball(2.5, 1)));
    CHECK(meet(box(0, 0, 0, 1, 1, 1), box(0.5, 0, 0, 1.5, 1, 1))); /* aligned */
    CHECK(meet(box(0, 0, 0, 1, 1, 1), box(0.5, 0.5, 0.5, 2, 2, 2)));
    /* Through the middle of faces, no corner of either in the other. */
    CHECK(meet(box(-3, -0.2, -0.2, 3, 0.2, 0.2), box(-1, -1, -1, 1, 1, 1)));
    CHECK(meet(box(-3, -0.2, -2, 3, 0.2, 2), box(-1, -2, -1, 1, 2, 1)));
    CHECK(meet(ball(0, 1), ball(1, 0.5)));
    CHECK(meet(ball(0, 1), box(0.9, -3, -3, 5, 3, 3)));
    /* The slack: a millionth of the size is touching, a thousandth is not. */
    CHECK(!meet(box(0, 0, 0, 1, 1, 1), box(1 - 1e-6, 0, 0, 2, 1, 1)));
    CHECK(meet(box(0, 0, 0, 1, 1, 1), box(1 - 1e-3, 0, 0, 2, 1, 1)));
}

static bool meets_plain(murk_mesh *mesh, murk_region_shape plain, murk_box box,
                        double radius_m)
{
    const murk_affine still = murk_affine_identity(), placed = PLACED;
    const murk_plain_shape shape = {
        .shape = plain, .box = box, .radius_m = radius_m, .to_world = placed};
    const murk_plain_shape below = {.shape = plain, .box = box};
    const bool is_below = plain == MURK_REGION_BELOW;
    murk_boundary_meshes *b = create_one(mesh, is_below ? still : placed);
    murk_vec3 place;
    const bool they_do = murk_boundary_meshes_meet_plain(
        b, 0, is_below ? &below : &shape, &place);
    murk_boundary_meshes_destroy(b);
    murk_mesh_destroy(mesh);
    return they_do;
}

static murk_box cube(double half)
{
    return (murk_box){{-half, -half, -half}, {half, half, half}};
}

static void test_crossings_with_other_shapes(void)
{
    const murk_box level = {{0, 0, 0}, {0, 0, 0.5}};
    const murk_region_shape below = MURK_REGION_BELOW, in_box = MURK_REGION_BOX,
                            in_ball = MURK_REGION_SPHERE;
    CHECK(meets_plain(ball(0, 1), below, level, 0));
    CHECK(!meets_plain(ball(0, 0.5), below, level, 0)); /* touches */
    CHECK(!meets_plain(box(0, 0, 0.5, 1, 1, 1), below, level, 0));

    CHECK(!meets_plain(ball(0, 1), in_ball, cube(0), 1.1));
    CHECK(!meets_plain(ball(0, 1), in_ball, cube(0), 0.9));
    CHECK(!meets_plain(ball(3, 1), in_ball, cube(0), 1));
    CHECK(meets_plain(ball(1, 1), in_ball, cube(0), 1));
    /* Only the middles of faces reach into the ball. */
    CHECK(meets_plain(box(-1, -1, -1, 1, 1, 1), in_ball, cube(0), 1.05));
    CHECK(!meets_plain(box(-1, -1, -1, 1, 1, 1), in_ball, cube(0), 1));
    CHECK(!meets_plain(box(-1, -1, -1, 1, 1, 1), in_ball, cube(0), 1.8));

    CHECK(!meets_plain(box(-1, -1, -1, 1, 1, 1), in_box, cube(1), 0));
    CHECK(!meets_plain(box(-1, -1, -1, 1, 1, 1), in_box, cube(1.5), 0));
    CHECK(!meets_plain(box(-1, -1, -1, 1, 1, 1), in_box, cube(0.5), 0));
    CHECK(!meets_plain(box(1, -1, -1, 2, 1, 1), in_box, cube(1), 0));
    CHECK(meets_plain(box(0.9, -1, -1, 2, 1, 1), in_box, cube(1), 0));
    /* No corner of either in the other, and only by an edge. */
    CHECK(meets_plain(box(-2, -.2, -.2, 2, .2, .2), in_box, cube(1), 0));
    CHECK(meets_plain(ball(1.5, 0.6), in_box, cube(1), 0));
    CHECK(!meets_plain(ball(1.5, 0.4), in_box, cube(1), 0));
}

int main(void)
{
    test_points_are_inside_as_the_twin_says();
    test_rays_cross_as_the_twin_says();
    test_belief_is_corrected();
    test_edges_and_corners_do_not_leak();
    test_a_long_walk_keeps_count();
    test_shared_faces_are_one_crossing();
    test_a_mesh_that_crosses_itself_counts();
    test_copies_count_once();
    test_open_meshes_are_refused_with_their_edges();
    test_crossing_boundaries_are_distinguished_from_nested_ones();
    test_crossings_with_other_shapes();
    return check_done();
}
