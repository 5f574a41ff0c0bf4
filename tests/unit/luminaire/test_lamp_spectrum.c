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

static murk_lamp_spectrum *table(size_t n, const double *at,
                                 const double *value)
{
    double *nm = malloc(n * sizeof *nm), *power = malloc(n * sizeof *power);
    murk_lamp_spectrum *s = NULL;
    murk_error err = {0};
    memcpy(nm, at, n * sizeof *nm);
    memcpy(power, value, n * sizeof *power);
    CHECK(!murk_lamp_spectrum_create(&s, 0, n, nm, power, "a", &err));
    return s;
}

/* The amount per watt of a quantity, by a plain sum over steps of .01 nm, of
 * which the wavelengths of the table are multiples. */
static double plain(const murk_lamp_spectrum *s, murk_quantity quantity,
                    double from, double to)
{
    const int steps = (int)lround((to - from) * 100);
    double power = 0, counted = 0;
    for (int i = 0; i < steps; ++i) {
        const double nm = from + (i + 0.5) * (to - from) / steps;
        const double p = murk_lamp_spectrum_at(s, nm);
        power += p;
        counted += p * murk_quantity_per_watt(quantity, nm, nm);
    }
    return counted / power;
}

/* A line narrower than 1 nm has the efficacy of its wavelength: sodium, 1,000
 * lm of which are 1.904 W, with V(589) by the table of V. Lines at any place,
 * with and without slopes to the same side, agree with a plain sum. */
static void test_narrow_lines(void)
{
    static const double sodium[] = {588.5, 589, 589.5}, peak[] = {0, 1, 0};
    murk_lamp_spectrum *s = table(3, sodium, peak);
    const double watts = murk_lamp_spectrum_integral(s, 1, 1e6);
    CHECK_NEAR(murk_lamp_spectrum_lumens(s),
               watts * 683 * murk_luminous_efficiency(589), 683 * 1e-4 * watts);
    CHECK_NEAR(1000 * watts / murk_lamp_spectrum_lumens(s), 1.904, 1e-3);
    murk_lamp_spectrum_destroy(s);
    for (int i = 0; i < 17; ++i) {
        /* two lines and a wide part, 0 and a jump at the ends */
        const double a = 400.1 + 17.3 * i;
        const double at[] = {a, a + .01, a + .3, a + .31, a + 1.7, a + 29};
        const double value[] = {9, 0, 0, 7, 0, 1};
        s = table(6, at, value);
        for (int q = MURK_PHOTOMETRIC; q <= MURK_PAR; ++q) {
            const double want = plain(s, (murk_quantity)q, 380, 780);
            const double got =
                murk_lamp_spectrum_per_watt(s, (murk_quantity)q, 380, 780);
            CHECK_NEAR(got / want, 1, 1e-4);
        }
        murk_lamp_spectrum_destroy(s);
    }
}

int main(void)
{
    test_wien();
    test_efficacy_of_a_black_body();
    test_the_old_candela();
    test_stefan_boltzmann();
    test_table();
    test_narrow_lines();
    return check_done();
}
