/* Spectra of lamps: Planck's law against Wien's displacement law and published
 * luminous efficacies, tables against integrals by hand. */
#include "check.h"
#include "luminaire/lamp_spectrum.h"

#include <stdlib.h>

static murk_lamp_spectrum *body(double temperature_k)
{
    murk_lamp_spectrum *out = NULL;
    murk_error err = {0};
    CHECK(!murk_lamp_spectrum_create(&out, temperature_k, 0, NULL, NULL, "a",
                                     &err));
    return out;
}

/* The maximum lies at 2897.771955 um K / T (CODATA 2018). */
static void test_wien(void)
{
    static const double kelvin[] = {500, 2856, 6500, 100000};
    for (size_t i = 0; i < sizeof kelvin / sizeof *kelvin; ++i) {
        murk_lamp_spectrum *s = body(kelvin[i]);
        const double peak = 2897771.955 / kelvin[i];
        const double top = murk_lamp_spectrum_at(s, peak);
        CHECK(top > 0 && isfinite(top));
        CHECK(murk_lamp_spectrum_at(s, peak * 1.001) < top);
        CHECK(murk_lamp_spectrum_at(s, peak / 1.001) < top);
        murk_lamp_spectrum_destroy(s);
    }
}

/* Lumens per watt over all wavelengths: 95 lm/W at 7000 K (published to that
 * many digits; Wikipedia, Luminous efficacy), by the ratio of two integrals. */
static void test_efficacy_of_a_black_body(void)
{
    murk_lamp_spectrum *s = body(7000);
    const double all = murk_lamp_spectrum_integral(s, 50, 15000) +
                       murk_lamp_spectrum_integral(s, 15000, 1e6);
    const double got = murk_lamp_spectrum_lumens(s) / all;
    printf("7000 K: %.3f lm/W\n", got);
    CHECK_NEAR(got, 95, 0.5);
    murk_lamp_spectrum_destroy(s);
}

/* The luminance of a black body at the temperature at which platinum freezes,
 * 2042 K, is 60 cd/cm^2: the definition of the candela from 1948 to 1979. */
static void test_the_old_candela(void)
{
    const double kelvin = 2042, h = 6.62607015e-34, c = 299792458,
                 k = 1.380649e-23, m = 555e-9;
    const double per_nm =
        2 * h * c * c / pow(m, 5) / expm1(h * c / (m * k * kelvin)) * 1e-9;
    murk_lamp_spectrum *s = body(kelvin);
    const double luminance = murk_lamp_spectrum_lumens(s) * per_nm;
    printf("platinum: %.4g cd/m2\n", luminance);
    CHECK_NEAR(luminance / 6e5, 1, 5e-3);
    murk_lamp_spectrum_destroy(s);
}

/* The integral over all wavelengths grows as T^4 (Stefan and Boltzmann), once
 * the scale at 555 nm is taken out. */
static void test_stefan_boltzmann(void)
{
    double total[2];
    const double kelvin[2] = {3000, 6000}, c2 = 1.438776877e7;
    for (int i = 0; i < 2; ++i) {
        murk_lamp_spectrum *s = body(kelvin[i]);
        total[i] = murk_lamp_spectrum_integral(s, 50, 15000) +
                   murk_lamp_spectrum_integral(s, 15000, 3e6);
        total[i] /= expm1(c2 / (555 * kelvin[i]));
        murk_lamp_spectrum_destroy(s);
    }
    CHECK_NEAR(total[1] / total[0], 16, 16e-4);
}

static void test_table(void)
{
    static const double at[] = {400, 500, 600}, value[] = {0, 2, 1};
    double *nm = malloc(sizeof at), *power = malloc(sizeof value);
    memcpy(nm, at, sizeof at);
    memcpy(power, value, sizeof value);
    murk_lamp_spectrum *s = NULL;
    murk_error err = {0};
    CHECK(!murk_lamp_spectrum_create(&s, 0, 3, nm, power, "a", &err));
    CHECK(murk_lamp_spectrum_at(s, 399) == 0);
    CHECK(murk_lamp_spectrum_at(s, 450) == 1);
    CHECK(murk_lamp_spectrum_at(s, 600) == 1);
    CHECK(murk_lamp_spectrum_at(s, 601) == 0);
    CHECK_NEAR(murk_lamp_spectrum_integral(s, 100, 900), 250, 1e-12);
    CHECK_NEAR(murk_lamp_spectrum_integral(s, 450, 550), 75 + 87.5, 1e-12);
    CHECK(murk_lamp_spectrum_integral(s, 700, 800) == 0);
    murk_lamp_spectrum_destroy(murk_lamp_spectrum_share(s));
    CHECK(murk_lamp_spectrum_at(s, 500) == 2);
    murk_lamp_spectrum_destroy(s);
}

int main(void)
{
    test_wien();
    test_efficacy_of_a_black_body();
    test_the_old_candela();
    test_stefan_boltzmann();
    test_table();
    return check_done();
}
