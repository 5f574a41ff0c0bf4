/* The nearest hit is the one that trying every triangle in double finds, and
 * sightlines agree with it.
 *
 * No false alarms: rays within a stated margin of an edge or of grazing are
 * left out (and counted, so that not all are), the others must agree to
 * double precision. */
#include "check.h"
#include "geometry/surfaces.h"
#include "plain_rays.h"
#include "random_mesh.h"

#define SEED      11
#define TRIANGLES 200
#define RAYS      20000

/* Inside by this share of the triangle: a few hundred float steps. */
#define CLEAR 1e-4

static const murk_material PLAIN = {.name = "default"};

static murk_surfaces *surfaces_of(const murk_mesh *mesh,
                                  const murk_affine *place)
{
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = mesh,
                                    .to_world = *place,
                                    .material = -1};
    murk_surfaces *s = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&s, &desc, 1, &PLAIN, 1, &err) == MURK_OK);
    return s;
}

/* Whether a slightly changed ray finds the same triangle: then no rounding in
 * float can find another. */
static bool is_clear(const murk_mesh *m, murk_vec3 o, murk_vec3 d, size_t which)
{
    const murk_vec3 nudge[4] = {{1e-5, 1e-5, 1e-5},
                                {-1e-5, -1e-5, 1e-5},
                                {1e-5, -1e-5, -1e-5},
                                {-1e-5, 1e-5, -1e-5}};
    for (int i = 0; i < 4; ++i) {
        size_t other = SIZE_MAX;
        double edge = 0;
        plain_hit(m->vertex_m, m->corner, m->triangles, murk_add(o, nudge[i]),
                  d, &other, &edge);
        if (other != which) {
            return false;
        }
    }
    return true;
}

static void test_hits_are_those_of_the_plain_twin(void)
{
    /* Random triangles. */
    murk_mesh *m = random_mesh(TRIANGLES, 0.3, SEED);
    const murk_affine here = murk_affine_identity();
    murk_surfaces *s = surfaces_of(m, &here);
    size_t compared = 0, hits = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        /* Skip rays that pass close to an edge, for which rounding decides. */
        const murk_vec3 o = random_point(SEED + 5, i);
        const murk_vec3 d = random_direction(SEED + 6, i);
        size_t which = SIZE_MAX;
        double edge = 0;
        const double t = plain_hit(m->vertex_m, m->corner, m->triangles, o, d,
                                   &which, &edge);
        if (!is_clear(m, o, d, which)) {
            continue;
        }
        /* The hit is that of the twin: triangle, distance and a unit normal
         * against the ray. */
        murk_hit hit;
        const bool met = murk_surfaces_hit(s, o, d, INFINITY, &hit);
        ++compared;
        CHECK(met == (t < INFINITY));
        if (met && t < INFINITY) {
            ++hits;
            CHECK(hit.triangle == which);
            CHECK(fabs(hit.distance_m - t) <= 1e-9 * (1 + t));
            CHECK(murk_dot(hit.normal, d) < 0);
            CHECK_NEAR(murk_length(hit.normal), 1, 1e-14);
            /* A ray that ends before the hit meets nothing as far away; a
             * sightline is blocked beyond the hit only. */
            CHECK(!murk_surfaces_hit(s, o, d, t - 1e-5, &hit) ||
                  hit.distance_m < t);
            CHECK(
                !murk_surfaces_blocked(s, o, murk_along(o, t - 1e-4, d), true));
            CHECK(
                murk_surfaces_blocked(s, o, murk_along(o, t + 1e-3, d), true) ||
                edge < CLEAR);
        }
    }
    /* Enough rays were compared. */
    CHECK(compared > RAYS * 9 / 10);
    CHECK(hits > compared / 5);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* Winding means nothing. */
static void test_turning_triangles_over_changes_nothing(void)
{
    murk_mesh *m = random_mesh(TRIANGLES, 0.3, SEED);
    const murk_affine here = murk_affine_identity();
    murk_surfaces *s = surfaces_of(m, &here);
    for (size_t i = 0; i < m->triangles; i += 2) {
        const uint32_t swapped = m->corner[3 * i];
        m->corner[3 * i] = m->corner[3 * i + 1];
        m->corner[3 * i + 1] = swapped;
    }
    murk_surfaces *turned = surfaces_of(m, &here);
    size_t same = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        const murk_vec3 o = random_point(SEED + 7, i);
        const murk_vec3 d = random_direction(SEED + 8, i);
        murk_hit a = {0}, b = {0};
        const bool hit_a = murk_surfaces_hit(s, o, d, INFINITY, &a);
        const bool hit_b = murk_surfaces_hit(turned, o, d, INFINITY, &b);
        same += hit_a == hit_b && a.triangle == b.triangle &&
                fabs(a.distance_m - b.distance_m) < 1e-4 &&
                murk_dot(a.normal, b.normal) >= (hit_a ? 1 - 1e-12 : 0);
    }
    CHECK(same >= RAYS - 5); /* a few pass within rounding of an edge */
    murk_surfaces_destroy(turned);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* Far from the origin the same rays find the same things. */
static void test_moving_all_together_changes_nothing(void)
{
    murk_mesh *m = random_mesh(TRIANGLES, 0.3, SEED);
    const murk_vec3 far = {1e4, -2e4, 500};
    const murk_affine here = murk_affine_identity();
    const murk_affine there = murk_affine_place(murk_vec(0, 0, 0), 1, far);
    murk_surfaces *s = surfaces_of(m, &here);
    murk_surfaces *moved = surfaces_of(m, &there);
    size_t same = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        const murk_vec3 o = random_point(SEED + 9, i);
        const murk_vec3 d = random_direction(SEED + 10, i);
        murk_hit a = {0}, b = {0};
        const bool hit_a = murk_surfaces_hit(s, o, d, INFINITY, &a);
        const bool hit_b =
            murk_surfaces_hit(moved, murk_add(o, far), d, INFINITY, &b);
        same += hit_a == hit_b && a.triangle == b.triangle &&
                fabs(a.distance_m - b.distance_m) < 1e-5;
    }
    CHECK(same >= RAYS - 20);
    murk_surfaces_destroy(moved);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

static void test_rays_from_far_outside_still_meet_exactly(void)
{
    /* Random triangles within about a metre. */
    murk_mesh *m = random_mesh(TRIANGLES, 0.3, SEED);
    const murk_affine here = murk_affine_identity();
    murk_surfaces *s = surfaces_of(m, &here);
    size_t hits = 0;
    for (uint64_t i = 0; i < 2000; ++i) {
        /* Start 100 km away from a point near the triangles. */
        const murk_vec3 near = random_point(SEED + 11, i);
        const murk_vec3 d = random_direction(SEED + 12, i);
        const murk_vec3 o = murk_along(near, -1e5, d);
        size_t which = SIZE_MAX;
        double edge = 0;
        const double t = plain_hit(m->vertex_m, m->corner, m->triangles, o, d,
                                   &which, &edge);
        /* The hit is that of the twin, to 1e-7 m. */
        murk_hit hit;
        const bool met = murk_surfaces_hit(s, o, d, INFINITY, &hit);
        if (is_clear(m, o, d, which)) {
            CHECK(met == (t < INFINITY) && (!met || hit.triangle == which));
            CHECK(!met || fabs(hit.distance_m - t) < 1e-7);
            hits += met;
        }
    }
    CHECK(hits > 500);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

static void test_broken_rays_meet_nothing(void)
{
    murk_mesh *m = random_mesh(TRIANGLES, 0.3, SEED);
    const murk_affine here = murk_affine_identity();
    murk_surfaces *s = surfaces_of(m, &here);
    const murk_vec3 bad[4] = {
        {NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, -INFINITY}, {NAN, NAN, NAN}};
    murk_hit hit;
    for (int i = 0; i < 4; ++i) {
        CHECK(!murk_surfaces_hit(s, bad[i], murk_vec(0, 0, 1), INFINITY, &hit));
        CHECK(!murk_surfaces_hit(s, murk_vec(0, 0, 0), bad[i], INFINITY, &hit));
        CHECK(!murk_surfaces_blocked(s, bad[i], murk_vec(0, 0, 0), true));
        CHECK(!murk_surfaces_blocked(s, murk_vec(0, 0, 0), bad[i], true));
        CHECK(!murk_surfaces_near(s, bad[i], 0.1));
        CHECK(murk_surfaces_solid_at(s, bad[i]) == 0);
        CHECK(murk_surfaces_sheet_transmittance(s, bad[i], murk_vec(0, 0, 0),
                                                0) == 1);
    }
    CHECK(!murk_surfaces_hit(s, murk_vec(0, 0, 0), murk_vec(0, 0, 0), INFINITY,
                             &hit));
    CHECK(
        !murk_surfaces_hit(s, murk_vec(0, 0, 0), murk_vec(0, 0, 1), NAN, &hit));
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

int main(void)
{
    test_hits_are_those_of_the_plain_twin();
    test_turning_triangles_over_changes_nothing();
    test_moving_all_together_changes_nothing();
    test_rays_from_far_outside_still_meet_exactly();
    test_broken_rays_meet_nothing();
    return check_done();
}
