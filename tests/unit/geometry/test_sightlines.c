/* A sightline's answer depends on its two ends alone: asked together with
 * others, in any order, in any subset, it is that of the single call, bit for
 * bit, also for rays aimed at edges and vertices. No randomness in the
 * verdict: seeds are fixed and every pair must agree. */
#include "check.h"
#include "geometry/surfaces.h"
#include "geometry/walk.h"
#include "random_mesh.h"

#include <stdlib.h>

#define SEED   21
#define POINTS 4000
#define EYES   60

static const murk_material MATERIALS[2] = {
    {.name = "default"},
    {.name = "film", .transmit = {{0.5}}},
};

static murk_surfaces *create(const murk_surface_desc *desc, size_t n)
{
    murk_surfaces *s = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&s, desc, n, MATERIALS, 2, &err) == MURK_OK);
    return s;
}

/* Points behind the mesh as seen from the eye, every other one exactly in line
 * with a vertex or with a point of an edge. */
static void aim(murk_vec3 *to, const murk_mesh *m, murk_vec3 eye, uint32_t seed)
{
    for (size_t i = 0; i < POINTS; ++i) {
        to[i] = murk_scale(1.5, random_point(seed, i));
        if (i % 2 == 0) {
            const murk_random4 r = murk_random(seed, MURK_TEST, i, 2, 0);
            const size_t k = (size_t)(r.u[0] * (double)m->triangles);
            const float *a = m->vertex_m + 9 * k, *b = a + 3;
            const murk_vec3 va = {(double)a[0], (double)a[1], (double)a[2]};
            const murk_vec3 vb = {(double)b[0], (double)b[1], (double)b[2]};
            const double share = i % 4 == 0 ? 0 : r.u[1];
            const murk_vec3 edge = murk_along(va, share, murk_sub(vb, va));
            to[i] = murk_along(eye, 1 + r.u[2], murk_sub(edge, eye));
        }
    }
}

static void shuffle(murk_vec3 *p, bool *with, size_t n, uint32_t seed)
{
    for (size_t i = n; i-- > 1;) {
        uint32_t word[4];
        murk_random_words(seed, MURK_TEST, i, 3, 0, word);
        const size_t j = murk_random_below(word[0], (uint32_t)i + 1);
        const murk_vec3 swapped_p = p[i];
        const bool swapped_with = with[i];
        p[i] = p[j];
        with[i] = with[j];
        p[j] = swapped_p;
        with[j] = swapped_with;
    }
}

static void check_mesh(double size, size_t triangles, bool film)
{
    /* Random triangles and a sphere, of opaque material or of a film. */
    murk_mesh *m = random_mesh(triangles, size, SEED);
    const murk_surface_desc desc[2] = {{.shape = MURK_SHAPE_MESH,
                                        .mesh = m,
                                        .to_world = murk_affine_identity(),
                                        .material = film},
                                       {.shape = MURK_SHAPE_SPHERE,
                                        .center = {0.2, 0.1, 0},
                                        .radius_m = 0.2,
                                        .to_world = murk_affine_identity()}};
    murk_surfaces *s = create(desc, 2);
    /* Points for each eye, and the answer for each sightline alone. */
    murk_vec3 *from = malloc(POINTS * sizeof *from);
    bool *single = malloc(POINTS), *many = malloc(POINTS);
    size_t differ = 0, blocked = 0;
    for (uint64_t e = 0; e < EYES; ++e) {
        const murk_vec3 eye = random_point(SEED + 30, e);
        aim(from, m, eye, (uint32_t)(SEED + 40 + e));
        for (size_t i = 0; i < POINTS; ++i) {
            single[i] = murk_surfaces_blocked(s, from[i], eye, e % 2 == 0);
            blocked += single[i];
        }
        /* Ask for all points at once: in two orders, and for a part of
         * them. */
        for (int turn = 0; turn < 3; ++turn) {
            const size_t n = turn == 2 ? POINTS / 3 : POINTS;
            murk_surfaces_blocked_many(s, from, n, eye, e % 2 == 0, many);
            for (size_t i = 0; i < n; ++i) {
                differ += many[i] != single[i];
            }
            shuffle(from, single, POINTS, (uint32_t)(SEED + e));
        }
    }
    /* Both answers are equal, and some sightlines are free. */
    CHECK(differ == 0);
    CHECK(blocked > EYES * POINTS / 50 && blocked < EYES * POINTS);
    free(many);
    free(single);
    free(from);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* Both ends on walls: they do not block themselves, however the line grazes. */
static void test_ends_on_surfaces_do_not_block(void)
{
    const murk_surface_desc walls = {.shape = MURK_SHAPE_BOX,
                                     .box = {{0, 0, 0}, {7, 5, 3}},
                                     .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&walls, 1);
    size_t blocked = 0, asked = 0;
    for (uint64_t i = 0; i < 100000; ++i) {
        murk_vec3 end[2];
        murk_hit hit[2];
        for (uint64_t k = 0; k < 2; ++k) {
            const murk_vec3 d = random_direction(SEED, 2 * i + k);
            const murk_vec3 middle = {3, 2, 1};
            CHECK(murk_surfaces_hit(s, middle, d, INFINITY, &hit[k]));
            end[k] = murk_surfaces_leave(
                s, murk_along(middle, hit[k].distance_m, d), hit[k].normal);
        }
        if (hit[0].triangle / 2 == hit[1].triangle / 2) {
            continue; /* one wall does not face itself */
        }
        ++asked;
        blocked += murk_surfaces_blocked(s, end[0], end[1], true);
    }
    CHECK(asked > 50000);
    CHECK(blocked == 0);
    murk_surfaces_destroy(s);
}

/* Two points just above one wall see each other, at any slope down to 0. */
static void test_grazing_lines_along_a_wall_are_open(void)
{
    const murk_surface_desc floor = {.shape = MURK_SHAPE_RECT,
                                     .corner = {-3, -2, 0},
                                     .edge1 = {7, 1, 0.3},
                                     .edge2 = {-1, 5, 0.7},
                                     .to_world = murk_affine_identity()};
    murk_surfaces *s = create(&floor, 1);
    const murk_vec3 up = murk_unit(murk_cross(floor.edge1, floor.edge2));
    size_t blocked = 0;
    for (uint64_t i = 0; i < 100000; ++i) {
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 5, 0);
        murk_vec3 end[2];
        for (int k = 0; k < 2; ++k) {
            end[k] = murk_surfaces_leave(
                s,
                murk_along(murk_along(floor.corner, r.u[2 * k], floor.edge1),
                           r.u[2 * k + 1], floor.edge2),
                up);
        }
        blocked += murk_surfaces_blocked(s, end[0], end[1], true);
    }
    CHECK(blocked == 0);
    murk_surfaces_destroy(s);
}

static murk_surface_desc pane(double x, int material)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_RECT,
                               .corner = {x, -1, -1},
                               .edge1 = {0, 2, 0},
                               .edge2 = {0, 0, 2},
                               .to_world = murk_affine_identity(),
                               .material = material};
}

static void test_sheets_dim_and_do_not_block(void)
{
    const murk_surface_desc desc[3] = {pane(0, 1), pane(0.01, 1), pane(3, 0)};
    murk_surfaces *s = create(desc, 3);
    const murk_vec3 a = {-1, 0.1, 0.2}, b = {1, 0.1, 0.2}, c = {4, 0, 0};
    CHECK(!murk_surfaces_blocked(s, a, b, true));
    CHECK(murk_surfaces_blocked(s, a, b, false));
    CHECK(murk_surfaces_blocked(s, a, c, true));
    CHECK(murk_surfaces_sheet_transmittance(s, a, b, 0) == 0.25);
    CHECK(murk_surfaces_sheet_transmittance(s, b, a, 0) == 0.25);
    CHECK(murk_surfaces_sheet_transmittance(s, a, b, 1) == 0);
    CHECK(murk_surfaces_sheet_transmittance(s, a, murk_vec(-0.5, 0.1, 0.2),
                                            0) == 1);
    /* Through the diagonal, where two triangles of each pane meet. */
    CHECK(murk_surfaces_sheet_transmittance(s, murk_vec(-1, 0, 0),
                                            murk_vec(1, 0, 0), 0) == 0.25);
    CHECK(murk_surfaces_describe(s).sheets == 4);
    murk_surfaces_destroy(s);
}

/* The simple version: every sightline is walked. */
static double walked_transmittance(const murk_surfaces *s, murk_vec3 from,
                                   murk_vec3 to)
{
    const murk_vec3 along = murk_sub(to, from);
    const double length = murk_length(along);
    murk_walk w;
    if (!murk_walk_begin(&w, s, from, murk_scale(1 / length, along), length,
                         MURK_MASK(MURK_FACE_SHEET))) {
        return 1;
    }
    double transmittance = 1, last = s->leave_m;
    while (murk_walk_next(&w)) {
        murk_vec3 normal;
        const double distance = murk_walk_locate(
            &w, murk_primitive_of(&s->soup, &w.ray.hit), &normal);
        if (distance > last && distance < length - s->leave_m) {
            transmittance *= 0.5;
            last = distance + s->leave_m;
        }
    }
    return transmittance;
}

/* Sheets in few planes, one of them oblique, in more planes than are listed,
 * and a curved sheet. Lines end anywhere, within float steps of a plane, or on
 * the line through a point of the rim of a sheet; others run along a plane. */
static void check_sheets(size_t sheets, bool has_sphere)
{
    /* The sheets. */
    murk_surface_desc desc[41];
    for (size_t i = 0; i < sheets; ++i) {
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 7, 0);
        desc[i] = pane(floor(3 * r.u[0]), 1);
        desc[i].to_world =
            murk_affine_place(murk_vec(0, 0,
                                       sheets > 20  ? 9 * (double)i
                                       : i % 3 == 0 ? 37
                                                    : 0),
                              0.3, murk_vec(0, r.u[1], r.u[2]));
    }
    if (has_sphere) {
        desc[sheets++] = (murk_surface_desc){.shape = MURK_SHAPE_SPHERE,
                                             .radius_m = 0.4,
                                             .to_world = murk_affine_identity(),
                                             .material = 1};
    }
    murk_surfaces *s = create(desc, sheets);
    /* Lines from and to places that a random triangle gives. */
    size_t differ = 0, dimmed = 0;
    for (uint64_t i = 0; i < 200000; ++i) {
        const murk_random4 r = murk_random(SEED, MURK_TEST, i, 8, 0);
        const size_t k =
            (size_t)(r.u[0] * (double)s->soup.first_triangle[MURK_FACES]);
        const murk_triangle t = murk_soup_placed_triangle(&s->soup, k);
        const murk_vec3 normal = murk_unit(murk_triangle_normal(&t));
        const murk_vec3 rim = murk_along(t.a, r.u[1], murk_sub(t.b, t.a));
        const murk_vec3 in_plane =
            murk_along(rim, 2 * r.u[2] - 0.8, murk_sub(t.c, t.b));
        const double steps = floor(160 * r.u[3] - 80) * s->unit_m;
        const murk_vec3 from = random_point(SEED + 1, i);
        const murk_vec3 to[4] = {
            random_point(SEED + 2, i), murk_along(in_plane, steps, normal),
            murk_along(from, 1 + r.u[3], murk_sub(rim, from)),
            murk_along(murk_along(from, -murk_dot(murk_sub(from, rim), normal),
                                  normal),
                       steps, normal)};
        const murk_vec3 begin =
            i % 4 == 3 ? murk_along(in_plane, -steps, normal) : from;
        const double filtered =
            murk_surfaces_sheet_transmittance(s, begin, to[i % 4], 0);
        differ += filtered != walked_transmittance(s, begin, to[i % 4]);
        dimmed += filtered < 1;
    }
    CHECK(differ == 0);
    CHECK(dimmed > 5000 && dimmed < 195000);
    murk_surfaces_destroy(s);
}

int main(void)
{
    check_mesh(0.3, 268, false);
    check_mesh(0.05, 3000, false);
    check_mesh(0.3, 268, true);
    test_ends_on_surfaces_do_not_block();
    test_grazing_lines_along_a_wall_are_open();
    test_sheets_dim_and_do_not_block();
    check_sheets(12, false);
    check_sheets(40, false);
    check_sheets(12, true);
    return check_done();
}
