/* Fresnel reflectance at normal incidence, at Brewster's angle, at grazing
 * incidence and at total reflection, for which the values are known in closed
 * form. Nothing here is random. */
#include "base/vector.h"
#include "check.h"
#include "medium/fresnel.h"

static void test_fresnel_at_known_angles(void)
{
    double t;
    CHECK_NEAR(murk_fresnel(1, 1.5, 1, &t), 0.04, 1e-15);
    CHECK_NEAR(t, 1, 0);
    CHECK_NEAR(murk_fresnel(1.5, 1, 1, &t), 0.04, 1e-15);
    /* Brewster's angle: only the s wave is reflected. */
    const double b = atan(1.5), r = pow(cos(2 * b), 2) / 2;
    CHECK_NEAR(murk_fresnel(1, 1.5, cos(b), &t), r, 1e-15);
    CHECK_NEAR(t, sin(b), 1e-15); /* the two angles make a right one */
    CHECK_NEAR(murk_fresnel(1, 1.5, 0, &t), 1, 0);
    CHECK_NEAR(murk_fresnel(1.33, 1.33, 0.3, &t), 0, 1e-30);
}

static void test_total_reflection(void)
{
    double t = 1;
    const double critical = asin(1 / 1.5);
    CHECK(murk_fresnel(1.5, 1, cos(critical + 1e-9), &t) == 1);
    CHECK(t == 0);
    CHECK(murk_fresnel(1.5, 1, cos(critical - 1e-3), &t) < 0.9);
    CHECK(t > 0);
}

/* A cosine is found back to a few roundings of 1 over itself. */
static void test_reversed_light_reflects_the_same(void)
{
    for (int i = 1; i < 50; ++i) {
        const double cosine = i / 50., rounding = 4e-15 / cosine;
        double t, back;
        const double r = murk_fresnel(1, 1.34, cosine, &t);
        CHECK_NEAR(murk_fresnel(1.34, 1, t, &back), r, rounding);
        CHECK_NEAR(back, cosine, rounding);
    }
}

int main(void)
{
    test_fresnel_at_known_angles();
    test_total_reflection();
    test_reversed_light_reflects_the_same();
    return check_done();
}
