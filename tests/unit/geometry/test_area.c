/* Points on surfaces are even by area: over shapes, and within each.
 *
 * Counts are binomial and means of coordinates have known variances: CHECKS
 * z-tests share a chance of 1e-6 of a false alarm per seed (Sidak); the seed is
 * fixed, so the verdict repeats. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "geometry/area.h"

#include <stdlib.h>

#define CHECKS 9
#define BUDGET 1e-6
#define POINTS 100000

static uint32_t seed = 11;

/* A slanting triangle pair of 6 m2 (a parallelogram) far from the origin, a
 * sphere of radius 1 and a cube of 1 m, of three materials. */
static const murk_vec3 corner = {1000, 2000, 30}, edge1 = {3, 0, 0},
                       edge2 = {1, 2, 0}, center = {1005, 2000, 30};

static murk_surfaces *make(void)
{
    /* A rectangle, a sphere and a box, each of a material of its own. */
    const murk_affine still = murk_affine_identity();
    const murk_surface_desc desc[3] = {
        {.shape = MURK_SHAPE_RECT,
         .corner = corner,
         .edge1 = edge1,
         .edge2 = edge2,
         .material = 0,
         .to_world = still,
         .where = "rect"},
        {.shape = MURK_SHAPE_SPHERE,
         .center = center,
         .radius_m = 1,
         .material = 1,
         .to_world = still,
         .where = "sphere"},
        {.shape = MURK_SHAPE_BOX,
         .box = {{1000, 2010, 30}, {1001, 2011, 31}},
         .material = 2,
         .to_world = still,
         .where = "box"}};
    /* The last material has no surface. */
    const murk_material material[4] = {
        {.name = "default"}, {.name = "ball"}, {.name = "box"}, {.name = "no"}};
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, desc, 3, material, 4, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return surfaces;
}

static murk_area_point draw(const murk_area *area, uint64_t i)
{
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 0, 0);
    return murk_area_at(area, r.u);
}

static void test_even_over_shapes(const murk_surfaces *surfaces)
{
    murk_area *area = NULL;
    murk_error err = {0};
    CHECK(murk_area_create(&area, surfaces, NULL, "here", &err) == MURK_OK);
    const double ball = 4 * MURK_PI, all = 6 + ball + 6;
    CHECK_NEAR(murk_area_m2(area), all, 1e-3 * all); /* of float corners */
    CHECK_NEAR(murk_area_m2(area), murk_surfaces_describe(surfaces).area_m2,
               1e-9 * all);
    double count[3] = {0};
    for (uint64_t i = 0; i < POINTS; ++i) {
        ++count[draw(area, i).material];
    }
    const double limit = murk_sidak_limit(BUDGET, CHECKS), n = POINTS;
    const double share[3] = {6 / all, ball / all, 6 / all};
    for (int k = 0; k < 3; ++k) {
        const double sigma = sqrt(share[k] * (1 - share[k]) / n);
        CHECK_WITHIN(limit, count[k] / n, share[k], sigma);
    }
    /* Teeth: shapes by number of triangles would not pass, nor a sphere by its
     * disc. */
    CHECK(fabs(count[0] / n - 2.0 / 15) > 2 * limit * sqrt(0.25 / n));
    CHECK(fabs(count[1] / n - MURK_PI / (12 + MURK_PI)) >
          2 * limit * sqrt(0.25 / n));
    murk_area_destroy(area);
}

/* Along the edges of a parallelogram even numbers have mean 1/2 and variance
 * 1/12, and do not go together; so has the height on a sphere. */
static void test_even_within_a_shape(const murk_surfaces *surfaces)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS), n = POINTS;
    const bool rect[4] = {true, false, false, false};
    const bool ball[4] = {false, true, false, false};
    murk_area *area = NULL;
    murk_error err = {0};
    CHECK(murk_area_create(&area, surfaces, rect, "here", &err) == MURK_OK);
    double a = 0, b = 0, ab = 0, squares = 0;
    for (uint64_t i = 0; i < POINTS; ++i) {
        const murk_area_point p = draw(area, i);
        const murk_vec3 at = murk_sub(p.place, corner);
        const double v = at.y / 2, u = (at.x - v) / 3;
        a += u / n;
        b += v / n;
        ab += (u - 0.5) * (v - 0.5) / n;
        squares += (u - 0.5) * (u - 0.5) / n;
        if (i < 100) {
            CHECK_NEAR(at.z, 0, 1e-5);
            CHECK_NEAR(fabs(p.normal.z), 1, 1e-9);
            CHECK(p.material == 0);
        }
    }
    CHECK_WITHIN(limit, a, 0.5, sqrt(1.0 / 12 / n));
    CHECK_WITHIN(limit, b, 0.5, sqrt(1.0 / 12 / n));
    CHECK_WITHIN(limit, ab, 0, 1.0 / 12 / sqrt(n));
    /* of u^2 about its mean: 1/80 - 1/144 = 1/180 */
    CHECK_WITHIN(limit, squares, 1.0 / 12, sqrt(1.0 / 180 / n));
    /* Teeth: one triangle of the two would have a mean of 1/3. */
    CHECK(fabs(a - 1.0 / 3) > 2 * limit * sqrt(1.0 / 12 / n));
    murk_area_destroy(area);

    CHECK(murk_area_create(&area, surfaces, ball, "here", &err) == MURK_OK);
    double z = 0, z2 = 0;
    for (uint64_t i = 0; i < POINTS; ++i) {
        const murk_area_point p = draw(area, i);
        const murk_vec3 at = murk_sub(p.place, center);
        z += at.z / n;
        z2 += at.z * at.z / n;
        if (i < 100) {
            CHECK_NEAR(murk_length(at), 1, 1e-4);
            CHECK_NEAR(murk_length(murk_sub(p.normal, at)), 0, 1e-4);
        }
    }
    CHECK_WITHIN(limit, z, 0, sqrt(1.0 / 3 / n));
    CHECK_WITHIN(limit, z2, 1.0 / 3, sqrt(4.0 / 45 / n));
    murk_area_destroy(area);
}

static void test_no_area_is_refused(const murk_surfaces *surfaces)
{
    const bool none[4] = {false, false, false, true};
    murk_area *area = NULL;
    murk_error err = {0};
    CHECK(murk_area_create(&area, surfaces, none, "here", &err) ==
          MURK_BAD_VALUE);
    CHECK(area == NULL);
    CHECK_TEXT(err.text, "no surface is of such a material");
}

int main(int argc, char **argv)
{
    seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : seed;
    murk_surfaces *surfaces = make();
    test_even_over_shapes(surfaces);
    test_even_within_a_shape(surfaces);
    test_no_area_is_refused(surfaces);
    murk_surfaces_destroy(surfaces);
    return check_done();
}
