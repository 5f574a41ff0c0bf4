/* Watts to lumens and photons against tables and definitions. Deterministic. */
#include "base/photometry.h"
#include "check.h"

/* lux_to_photons.csv: independently computed; V of 1924 where it is tabulated.
 */
static const struct {
    double nm, v, photons_per_watt, photons_per_lux, watt_per_lux;
} lines[] = {
    {450, 0.038000, 2.265352e+18, 8.728337e+16, 3.852971e-02},
    {500, 0.323000, 2.517058e+18, 1.140959e+16, 4.532907e-03},
    {520, 0.710000, 2.617741e+18, 5.398182e+15, 2.062153e-03},
    {555, 1.000000, 2.793935e+18, 4.090680e+15, 1.464129e-03},
    {600, 0.631000, 3.020470e+18, 7.008490e+15, 2.320331e-03},
    {650, 0.107000, 3.272176e+18, 4.477464e+16, 1.368345e-02},
};
#define LINES (sizeof lines / sizeof *lines)

static double per_watt(murk_quantity quantity, double nm)
{
    return murk_quantity_per_watt(quantity, nm, nm);
}

static void test_lines(void)
{
    for (size_t i = 0; i < LINES; ++i) {
        const double nm = lines[i].nm;
        CHECK_NEAR(murk_luminous_efficiency(nm), lines[i].v, 1e-12);
        const double photons = per_watt(MURK_PHOTONS, nm);
        const double lux = per_watt(MURK_PHOTOMETRIC, nm);
        CHECK_NEAR(photons, lines[i].photons_per_watt, 6e-7 * photons);
        CHECK_NEAR(photons / lux, lines[i].photons_per_lux,
                   6e-7 * photons / lux);
        CHECK_NEAR(1 / lux, lines[i].watt_per_lux, 6e-7 / lux);
        CHECK(per_watt(MURK_RADIOMETRIC, nm) == 1);
        CHECK_NEAR(per_watt(MURK_PAR, nm), photons / 6.02214076e17,
                   1e-12 * photons / 6.02214076e17);
    }
}

/* CIE's own table at 1 nm, between the values kept here. */
static void test_between_the_values(void)
{
    static const double nm[] = {486, 512, 532, 533, 548, 557, 572, 578, 589};
    static const double v[] = {0.1762431, 0.544512,  0.8849624,
                               0.8954936, 0.9903128, 0.9993046,
                               0.9384992, 0.8892048, 0.7691547};
    for (size_t i = 0; i < sizeof nm / sizeof *nm; ++i) {
        CHECK_NEAR(murk_luminous_efficiency(nm[i]), v[i], 2e-4);
    }
    /* at both ends, and between the last values, where they fall */
    CHECK_NEAR(murk_luminous_efficiency(380), 0.000039, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(385), 0.000064, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(765), 0.000042, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(770), 0.000030, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(775), 0.000021, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(780), 0.000015, 1e-12);
    for (double x = 381; x < 780; x += x < 384 ? 1 : x > 760 ? 1 : 376) {
        const double before = murk_luminous_efficiency(x - 1),
                     here = murk_luminous_efficiency(x);
        CHECK(x < 400 ? here > before : here < before);
    }
    /* by hand: t = 0.4 and 2.6 of the first and the last four values */
    CHECK_NEAR(murk_luminous_efficiency(382), 4.592e-05, 1e-12);
    CHECK_NEAR(murk_luminous_efficiency(778), 1.704e-05, 1e-12);
    CHECK(murk_luminous_efficiency(379.9) == 0);
    CHECK(murk_luminous_efficiency(780.1) == 0);
    CHECK(murk_luminous_efficiency(NAN) == 0);
    for (double x = 380; x <= 780; x += 0.37) {
        CHECK(murk_luminous_efficiency(x) >= 0 &&
              murk_luminous_efficiency(x) <= 1.0002);
    }
}

/* The integral of V is 106.857 nm, from CIE's table at 1 nm; so an even watt
 * over 380-780 has 683 * 106.857 / 400 lm. */
static void test_whole_band(void)
{
    const double lumens = murk_quantity_per_watt(MURK_PHOTOMETRIC, 380, 780);
    CHECK_NEAR(lumens, 683 * 106.857 / 400, 0.01);
    CHECK_NEAR(murk_quantity_per_watt(MURK_PHOTOMETRIC, 280, 4000),
               lumens * 400 / 3720, 1e-4 * lumens);
}

/* Photons of even light count as its middle wavelength's. */
static void test_photons_of_a_band(void)
{
    CHECK_NEAR(murk_quantity_per_watt(MURK_PHOTONS, 400, 700) /
                   murk_photons_per_joule(550),
               1, 1e-12);
    /* half of it is PAR, with the middle of that half */
    CHECK_NEAR(murk_quantity_per_watt(MURK_PAR, 600, 800) * 6.02214076e17 /
                   murk_photons_per_joule(650),
               0.5, 1e-12);
    CHECK(murk_quantity_per_watt(MURK_PAR, 700.5, 800) == 0);
    CHECK(murk_quantity_per_watt(MURK_PAR, 300, 399) == 0);
}

static double falling(const void *context, double nm)
{
    return *(const double *)context * (700 - nm);
}

static double none(const void *context, double nm)
{
    (void)context;
    return 0 * nm;
}

/* A spectrum that falls in a line from 400 to 700 has its mean at 500. */
static void test_shapes(void)
{
    const double scale = 17;
    CHECK_NEAR(
        murk_quantity_per_watt_of(MURK_PHOTONS, 400, 700, falling, &scale) /
            murk_photons_per_joule(500),
        1, 1e-5);
    CHECK(murk_quantity_per_watt_of(MURK_PHOTOMETRIC, 400, 700, none, NULL) ==
          murk_quantity_per_watt(MURK_PHOTOMETRIC, 400, 700));
}

/* Narrow bands together are the wide one. */
static void test_bands_add(void)
{
    for (int q = MURK_RADIOMETRIC; q <= MURK_PAR; ++q) {
        double sum = 0;
        for (int i = 0; i < 40; ++i) {
            sum += murk_quantity_per_watt((murk_quantity)q, 350 + 12.5 * i,
                                          362.5 + 12.5 * i) /
                   40;
        }
        const double whole = murk_quantity_per_watt((murk_quantity)q, 350, 850);
        CHECK_NEAR(sum / whole, 1, 1e-4);
    }
}

int main(void)
{
    test_lines();
    test_between_the_values();
    test_whole_band();
    test_photons_of_a_band();
    test_shapes();
    test_bands_add();
    return check_done();
}
