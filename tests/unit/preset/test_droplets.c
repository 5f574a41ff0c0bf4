/* Droplets of many sizes: moments, limits, refusals, and the sum over sizes
 * against a plain one. */
#include "check.h"
#include "preset/droplets.h"
#include "preset/refraction.h"

#include <stdlib.h>

#define PI 3.141592653589793

static const murk_droplets C1 = {6, 1.5, 1}, HAZE_L = {2, 15.1186, .5};

/* For c = 1: effective radius (a + 3) / b, variance 1 / (a + 3). */
static void test_shape(void)
{
    CHECK_NEAR(murk_droplets_effective_radius_um(&C1), 6, 1e-12);
    CHECK_NEAR(murk_droplets_effective_variance(&C1), 1. / 9, 1e-12);
    /* 4/3 pi <r^3> = 625.5 um3 a droplet */
    CHECK_NEAR(murk_droplets_water_g_per_m3(&C1) * 100, .0625525, 1e-6);
    CHECK_NEAR(murk_droplets_effective_radius_um(&HAZE_L), .4813, 1e-4);
}

/* The plain twin: the definition, in 40,000 equal steps of ln r. */
static double plain_scattering(const murk_droplets *shape, double nm,
                               murk_mie_index index)
{
    murk_mie *mie = NULL;
    CHECK(murk_mie_create(&mie, 2000, NULL) == MURK_OK);
    double sum = 0, number = 0;
    const double step = log(30 / .002) / 40000;
    for (int i = 0; i < 40000; ++i) {
        const double r = .002 * exp((i + .5) * step);
        const double n = pow(r, shape->a) * exp(-shape->b * pow(r, shape->c));
        const murk_mie_sphere one =
            murk_mie_solve(mie, 2 * PI * r * 1000 / nm, index);
        sum += n * PI * r * r * one.scattering * r;
        number += r >= MURK_COUNTED_FROM_UM ? n * r : 0;
    }
    murk_mie_destroy(mie);
    return sum / number;
}

static void test_sum_over_sizes(void)
{
    const murk_mie_index index = {1.329, 3e-7};
    const double want = plain_scattering(&HAZE_L, 850, index);
    murk_droplet_optics got;
    CHECK(murk_droplets_solve(&got, &HAZE_L, 850, index, 1e-4, 0, NULL, NULL,
                              NULL) == MURK_OK);
    CHECK_NEAR(got.scattering_um2 / want, 1, 2e-4);
    CHECK(got.radii >= 500 && got.radii < 20000);
    /* teeth: counting from the first droplet on would be 2.2 % less */
    CHECK(fabs(got.scattering_um2 / want - 1.0226) > 2e-2);
}

/* Absorption in proportion to k where it is faint. */
static void test_faint_absorption(void)
{
    murk_droplet_optics clear, faint, more;
    const double nm = 550;
    murk_droplets_solve(&clear, &C1, nm, (murk_mie_index){1.333, 0}, 1e-3, 0,
                        NULL, NULL, NULL);
    murk_droplets_solve(&faint, &C1, nm, (murk_mie_index){1.333, 1e-9}, 1e-3, 0,
                        NULL, NULL, NULL);
    murk_droplets_solve(&more, &C1, nm, (murk_mie_index){1.333, 4e-9}, 1e-3, 0,
                        NULL, NULL, NULL);
    CHECK(clear.absorption_um2 == 0);
    CHECK_NEAR(more.absorption_um2 / faint.absorption_um2, 4, 1e-9);
}

/* The angles carry the phase function: straight between them it integrates to
 * 1 and has the mean cosine of the sum over sizes. */
static void test_angles_carry_the_phase(void)
{
    static const murk_droplets shapes[] = {
        {6, 1.5, 1}, {3, .3, 1}, {2, 15.1186, .5}};
    double angle[MURK_DROPLET_ANGLES_MAX], mu[MURK_DROPLET_ANGLES_MAX];
    double phase[MURK_DROPLET_ANGLES_MAX];
    const size_t n = murk_droplet_angles(angle);
    CHECK(angle[0] == 0 && angle[n - 1] == 180);
    for (size_t i = 0; i < n; ++i) {
        mu[i] = cos(angle[i] * PI / 180);
    }
    for (size_t s = 0; s < 3; ++s) {
        murk_droplet_optics got;
        CHECK(murk_droplets_solve(&got, &shapes[s], 850,
                                  murk_water_refraction(850), 2e-3, n, mu,
                                  phase, NULL) == MURK_OK);
        double sum = 0, turned = 0;
        for (size_t i = 1; i < n; ++i) {
            const double step = (angle[i] - angle[i - 1]) * PI / 180;
            for (int k = 0; k < 8; ++k) { /* log-log between the rows */
                const double at = (k + .5) / 8;
                const double w =
                    i > 1 ? log1p(at * (angle[i] / angle[i - 1] - 1)) /
                                log(angle[i] / angle[i - 1])
                          : at;
                const double theta = angle[i - 1] * PI / 180 + at * step;
                const double value =
                    pow(phase[i - 1], 1 - w) * pow(phase[i], w);
                sum += value * sin(theta) * step / 8;
                turned += value * sin(theta) * cos(theta) * step / 8;
            }
        }
        CHECK_NEAR(2 * PI * sum, 1, 4e-3);
        CHECK_NEAR(turned / sum, got.mean_cosine, 2e-3);
    }
}

static void test_absurd_shapes_are_refused(void)
{
    static const struct {
        murk_droplets shape;
        const char *says;
    } bad[] = {{{-1, 1, 1}, "power of r is -1"},
               {{NAN, 1, 1}, "power of r is nan"},
               {{6, 1.5, 0}, "exponential is 0"},
               {{6, 0, 1}, "factor in the exponential is 0"},
               {{6, INFINITY, 1}, "factor in the exponential is inf"},
               {{6, .01, 1}, "effective radius of 900"},
               {{6, 1e9, 1}, "effective radius"},
               {{40, 1e-300, 6}, "effective radius"},
               {{0, 30, .2}, "of the droplets above"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        murk_error err = {0};
        CHECK(murk_droplets_check(&bad[i].shape, "fog", &err) ==
              MURK_BAD_VALUE);
        CHECK_MENTIONS(err.text, bad[i].says);
    }
    CHECK(murk_droplets_check(&C1, "fog", NULL) == MURK_OK);
    CHECK(murk_droplets_check(&HAZE_L, "haze", NULL) == MURK_OK);
}

/* Hale & Querry's n and Segelstein's k at wavelengths they list, and between.
 */
static void test_refraction(void)
{
    CHECK_NEAR(murk_water_refraction(550).n, 1.333, 1e-12);
    CHECK_NEAR(murk_water_refraction(1500).n, 1.319, 1e-12);
    CHECK_NEAR(murk_water_refraction(1000).k, 3.000e-6, 1e-9);
    CHECK_NEAR(murk_water_refraction(1448.77).k, 3.637e-4, 1e-7);
    CHECK(murk_water_refraction(300).n == 1.349);
    CHECK(murk_water_refraction(2500).k > 1.8e-3);
    for (double nm = 300; nm < 2500; nm += 1) {
        const murk_mie_index at = murk_water_refraction(nm);
        CHECK(at.n > 1.25 && at.n < 1.35 && at.k > 1e-10 && at.k < 3e-3);
    }
}

int main(void)
{
    test_shape();
    test_sum_over_sizes();
    test_faint_absorption();
    test_angles_carry_the_phase();
    test_absurd_shapes_are_refused();
    test_refraction();
    return check_done();
}
