/* Luminous solids: light leaves uniformly over the silhouette, which a grid of
 * parallel rays measures; draws from a place are points that the place meets,
 * uniform over their area.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak); the numbers are
 * fixed. */
#include "source/luminous_solid.h"

#include "base/rng.h"
#include "base/stats.h"
#include "check.h"

#define SAMPLES UINT64_C(40000)
#define STEPS   400 /* of the grid of rays along each side */
#define Z_TESTS 30

static const murk_luminous_solid solid[] = {
    {.half = {0.3, 0.7, 0.2}},
    {.half = {0, 0, 0.45}, .radius = 0.35},
};
enum { SOLIDS = sizeof solid / sizeof *solid };

static murk_vec3 direction_of(double gamma, double c)
{
    return murk_vec(sin(gamma) * cos(c), sin(gamma) * sin(c), cos(gamma));
}

/* What a grid of rays along a direction meets: the area, and of the points that
 * are met the mean and the mean square of z and of x. */
typedef struct measured {
    double area, z, z2, x, x2;
} measured;

static measured measure(const murk_luminous_solid *s, murk_vec3 d)
{
    const murk_vec3 e = murk_unit(murk_cross(d, murk_vec(0.6, 0.1, 0.3)));
    const murk_vec3 f = murk_cross(d, e);
    const double side = 2.2; /* larger than any silhouette */
    measured m = {0};
    double n = 0;
    for (int i = 0; i < STEPS * STEPS; ++i) {
        const double u = side * ((i % STEPS + 0.5) / STEPS - 0.5);
        const double v = side * ((i / STEPS + 0.5) / STEPS - 0.5);
        /* The ray comes from ahead, against the light. */
        const murk_vec3 from =
            murk_along(murk_along(murk_scale(5, d), u, e), v, f);
        murk_luminous_point at;
        double distance;
        if (murk_luminous_meet(s, from, murk_scale(-1, d), &at, &distance)) {
            CHECK(murk_dot(at.normal, d) > 0);
            n += 1;
            m.z += at.point.z;
            m.z2 += at.point.z * at.point.z;
            m.x += at.point.x;
            m.x2 += at.point.x * at.point.x;
        }
    }
    m.area = n * side * side / STEPS / STEPS;
    m.z /= n;
    m.z2 /= n;
    m.x /= n;
    m.x2 /= n;
    return m;
}

static void test_light_leaves_over_the_silhouette(void)
{
    static const double gamma[] = {0.2, 1.2, 2.5}, c[] = {0.3, 2.1, 4.4};
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    for (int i = 0; i < SOLIDS; ++i) {
        for (int k = 0; k < 3; ++k) {
            const murk_vec3 d = direction_of(gamma[k], c[k]);
            const measured m = measure(&solid[i], d);
            const double area = murk_luminous_silhouette(&solid[i], d);
            /* The edge of the silhouette is known to a step of the grid. */
            CHECK_NEAR(m.area / area, 1, 0.01);
            CHECK(fabs(m.area / (1.05 * area) - 1) > 0.03); /* teeth */
            double z = 0, x = 0;
            for (uint64_t p = 0; p < SAMPLES; ++p) {
                const murk_random4 r = murk_random(7, MURK_TEST, p, 0, 0);
                const murk_vec3 at = murk_luminous_leave(&solid[i], d, r.u);
                z += at.z / (double)SAMPLES;
                x += at.x / (double)SAMPLES;
                /* A ray that comes back along the light meets the point. */
                murk_luminous_point met;
                double distance = 0;
                const bool meets =
                    murk_luminous_meet(&solid[i], murk_along(at, 2, d),
                                       murk_scale(-1, d), &met, &distance);
                CHECK(meets && fabs(distance - 2) < 1e-9);
            }
            const double n = (double)SAMPLES;
            CHECK_WITHIN(limit, z, m.z, sqrt((m.z2 - m.z * m.z) / n) + 1e-3);
            CHECK_WITHIN(limit, x, m.x, sqrt((m.x2 - m.x * m.x) / n) + 1e-3);
            /* Teeth: light from the face across z alone leaves elsewhere. */
            const double flat = copysign(solid[i].half[2], d.z);
            CHECK(k != 1 || sigmas_off(flat, m.z, 1e-3) > 2 * limit);
        }
    }
}

/* Points that a place draws are uniform over the faces that it sees: their mean
 * normal is the sum of the areas times normals over the area. */
static void test_draws_from_a_place(void)
{
    static const murk_vec3 place[] = {
        {2, 0.1, 0.1}, {1, -2, 3}, {0.1, 0, -4}, {-1, 1, -1}};
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    for (int i = 0; i < SOLIDS; ++i) {
        for (size_t k = 0; k < sizeof place / sizeof *place; ++k) {
            double caps = 0, area = 0;
            for (uint64_t p = 0; p < SAMPLES; ++p) {
                const murk_random4 r = murk_random(8, MURK_TEST, p, 0, 0);
                murk_luminous_point from, met;
                double distance = 0;
                CHECK(murk_luminous_draw(&solid[i], place[k], r.u, &from));
                const murk_vec3 to = murk_sub(from.point, place[k]);
                CHECK(murk_dot(to, from.normal) < 0);
                CHECK(murk_luminous_meet(&solid[i], place[k], murk_unit(to),
                                         &met, &distance) ||
                      fabs(murk_dot(murk_unit(to), from.normal)) < 1e-6);
                CHECK_NEAR(distance, murk_length(to), 1e-6);
                CHECK(met.area == from.area);
                caps += fabs(from.normal.z) > 0.5 ? 1 / (double)SAMPLES : 0;
                area = from.area;
            }
            const murk_luminous_solid *s = &solid[i];
            const double cap = fabs(place[k].z) <= s->half[2] ? 0
                               : s->radius > 0 ? MURK_PI * s->radius * s->radius
                                               : 4 * s->half[0] * s->half[1];
            const double share = cap / area;
            CHECK_WITHIN(limit, caps, share,
                         sqrt(share * (1 - share) / (double)SAMPLES) + 1e-12);
        }
    }
    /* Inside nothing is seen. */
    const double u[2] = {0.3, 0.6};
    murk_luminous_point from;
    double distance;
    for (int i = 0; i < SOLIDS; ++i) {
        const murk_vec3 in = {0.1, -0.1, 0.1};
        CHECK(!murk_luminous_draw(&solid[i], in, u, &from));
        CHECK(!murk_luminous_meet(&solid[i], in, murk_vec(0, 0, 1), &from,
                                  &distance));
    }
}

int main(void)
{
    test_light_leaves_over_the_silhouette();
    test_draws_from_a_place();
    return check_done();
}
