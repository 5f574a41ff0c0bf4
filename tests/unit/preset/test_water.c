/* Water's laws against the figures of their sources. No randomness: nothing
 * here cries wolf. Full tables are rows of the media library's own checks. */
#include "check.h"
#include "preset/case_1.h"
#include "preset/water_contents.h"
#include "preset/water_kd.h"
#include "preset/water_pure.h"

#include <math.h>

static void test_absorption_is_pope_and_frys(void)
{
    CHECK_NEAR(murk_water_absorption(380), .01137, 1e-12);
    CHECK_NEAR(murk_water_absorption(417.5), .00442, 1e-12);
    CHECK_NEAR(murk_water_absorption(525), .0417, 1e-12);
    CHECK_NEAR(murk_water_absorption(727.5), 1.678, 1e-12);
    /* linear between rows */
    CHECK_NEAR(murk_water_absorption(601), .2224 + .4 * (.247 - .2224), 1e-12);
}

/* Zhang & Hu, Opt. Express 17 (2009) 1671, doi:10.1364/OE.17.001671, table 1:
 * scattering at 90 degrees of fresh water at 20 degrees C. */
static double at_90(double nm, double depolarisation)
{
    const double d = depolarisation;
    return murk_water_scattering(nm, 20, 0) * 3 / (8 * 3.14159265358979324) *
           (1 + d) / (2 + d);
}

static void test_scattering_is_zhangs(void)
{
    CHECK_NEAR(at_90(366, MURK_WATER_DEPOLARISATION), 4.500e-4, 4.5e-7);
    CHECK_NEAR(at_90(578, MURK_WATER_DEPOLARISATION), .650e-4, 1.3e-7);
    /* computed by the authors' own program, 20 degrees C */
    CHECK_NEAR(murk_water_scattering(450, 20, 0), .003050, 5e-7);
    CHECK_NEAR(murk_water_scattering(450, 20, 35), .003980, 5e-7);
    CHECK_NEAR(murk_water_scattering(750, 20, 35), .000470, 5e-7);
    /* teeth: Morel's depolarisation would be seen */
    CHECK(fabs(at_90(366, .09) - 4.500e-4) > 10 * 4.5e-7);
}

/* What temperature and salt do: less than 1 % from 10 to 30 degrees C in the
 * blue (the authors' figure 4), and some 30 % from fresh to 38.4 psu. */
static void test_scattering_follows_temperature_and_salt(void)
{
    const double cold = murk_water_scattering(450, 10, 0);
    const double warm = murk_water_scattering(450, 30, 0);
    CHECK(warm < cold);
    CHECK(cold / warm < 1.06);
    const double salt = murk_water_scattering(546, 20, 38.4) /
                        murk_water_scattering(546, 20, 0);
    CHECK(salt > 1.25 && salt < 1.4);
}

static void test_morels_scattering(void)
{
    /* Morel & Prieur, Limnol. Oceanogr. 22 (1977) 709: to half a digit */
    CHECK_NEAR(murk_water_scattering_morel(400, 0), .0058, 5e-5);
    CHECK_NEAR(murk_water_scattering_morel(500, 0), .0022, 5e-5);
    CHECK_NEAR(murk_water_scattering_morel(600, 0), .00101, 5e-6);
    CHECK_NEAR(murk_water_scattering_morel(700, 0), .00052, 5e-6);
    CHECK_NEAR(murk_water_scattering_morel(500, 37) /
                   murk_water_scattering_morel(500, 0),
               1.3, 1e-12);
}

/* Half of what molecules scatter goes backward, so the law is even. */
static void test_molecules_turn_light_evenly(void)
{
    CHECK_NEAR(murk_water_phase(.3), murk_water_phase(-.3), 0);
    CHECK_NEAR(murk_water_phase(1) / murk_water_phase(0), 1 + .961 / 1.039,
               1e-12);
}

static void test_chlorophyll(void)
{
    CHECK_NEAR(murk_chlorophyll_absorption(440, 1), .052019, 1e-9);
    CHECK_NEAR(murk_chlorophyll_absorption(674, 1), .020655, 1e-9);
    CHECK_NEAR(murk_chlorophyll_absorption(440, .1), .052019 * pow(.1, .634965),
               1e-9);
    CHECK_NEAR(murk_chlorophyll_scattering(550, 1), .416, 1e-12);
    CHECK_NEAR(murk_chlorophyll_scattering(550, 10), .416 * pow(10, .766),
               1e-12);
    /* blue scatters more where there is little, alike above 2 mg/m3 */
    CHECK(murk_chlorophyll_scattering(440, .05) >
          1.15 * murk_chlorophyll_scattering(550, .05));
    CHECK_NEAR(murk_chlorophyll_scattering(440, 5),
               murk_chlorophyll_scattering(550, 5), 1e-12);
    CHECK_NEAR(murk_chlorophyll_backward(1), .007, 1e-12);
    CHECK(murk_chlorophyll_absorption(440, 0) == 0);
    CHECK(murk_chlorophyll_scattering(440, 0) == 0);
}

static void test_dissolved_matter_and_sediment(void)
{
    CHECK_NEAR(murk_cdom_absorption(440, .3, MURK_CDOM_SLOPE), .3, 1e-12);
    CHECK_NEAR(murk_cdom_absorption(540, .3, MURK_CDOM_SLOPE), .3 * exp(-1.76),
               1e-12);
    CHECK_NEAR(murk_cdom_of_chlorophyll(1), .2 * (.00635 + .052019), 1e-9);
    CHECK_NEAR(murk_sediment_absorption(443, 2), .082, 1e-12);
    CHECK_NEAR(murk_sediment_scattering(555, 2), 1, 1e-12);
}

/* The observed attenuation at its own wavelengths (Morel & Maritorena 2001,
 * Morel et al. 2007), linear between them, and Lee's law by hand: 1.15 * .1 +
 * 4.18 * (1 - .52 exp(-1.08)) * .01. */
static void test_case_1_attenuation(void)
{
    CHECK_NEAR(murk_case_1_kd(490, 1), .0166 + .07242, 1e-12);
    CHECK_NEAR(murk_case_1_kd(490, 3), .0166 + .07242 * pow(3, .68955), 1e-12);
    CHECK_NEAR(murk_case_1_kd(412, .1), .007932 + .122858 * pow(.1, .65327),
               1e-12);
    CHECK_NEAR(murk_case_1_kd(443, 1), .00948 + .107212, 1e-12);
    CHECK_NEAR(murk_case_1_kd(555, 10), .06053 + .03996 * pow(10, .64204),
               1e-12);
    CHECK_NEAR(murk_case_1_kd(500, 1), (.0166 + .07242 + .03385 + .05943) / 2,
               1e-12);
    CHECK_NEAR(murk_case_1_kd_of(.1, .01, 30), .1494187, 1e-6);
}

/* At the law's wavelengths, absorption and backscattering give the observed
 * attenuation by Lee's law with the sun at 15 degrees; from 650 nm on,
 * absorption is that of particles and dissolved matter; in between it has no
 * step. */
static void test_case_1_absorption(void)
{
    static const double nm[] = {400, 412, 443, 490, 510, 555};
    for (double c = .3; c <= 10; c *= 1.8) {
        for (int i = 0; i < 6; ++i) {
            const double back = murk_water_scattering(nm[i], 20, 35) / 2 +
                                murk_chlorophyll_backward(c) *
                                    murk_chlorophyll_scattering(nm[i], c);
            const double a =
                murk_case_1_absorption(nm[i], c) + murk_water_absorption(nm[i]);
            CHECK_NEAR(murk_case_1_kd_of(a, back, 15) /
                           murk_case_1_kd(nm[i], c),
                       1, 1e-9);
            if (i > 0) {
                CHECK_NEAR(murk_case_1_absorption(nm[i] - 1e-6, c) /
                               murk_case_1_absorption(nm[i] + 1e-6, c),
                           1, 1e-6);
            }
        }
        CHECK_NEAR(murk_case_1_absorption(676, c),
                   murk_chlorophyll_absorption(676, c) +
                       murk_cdom_absorption(676, murk_cdom_of_chlorophyll(c),
                                            MURK_CDOM_SLOPE_OCEAN),
                   1e-12);
    }
    /* clear water at 555 nm absorbs what water absorbs */
    CHECK(murk_case_1_absorption(555, .03) == 0);
    CHECK(murk_case_1_absorption(490, 0) == 0);
}

/* Mobley's stand-in for Petzold's average particle: n 1.10, slope 3.5835 at a
 * backward share of .0183. */
static void test_phase_function_of_a_backward_share(void)
{
    double n, slope;
    murk_forand_of_backward(.0183, &n, &slope);
    CHECK_NEAR(n, 1.10, 1e-3);
    CHECK_NEAR(slope, 3.5835, 2e-3);
    double less_n, less_slope;
    murk_forand_of_backward(.005, &less_n, &less_slope);
    CHECK(less_n < n && less_slope < slope);
    murk_forand_of_backward(1e-9, &n, &slope);
    CHECK(slope > 3.2 && n > 1.001);
}

/* Kd = sqrt(a^2 + G b a) / m by preset/water_kd.h, with G = .473 m - .218 for
 * particles and 1.8 for molecules. */
static double kirks_kd(double a, double particles, double molecules, double m)
{
    const double gb = (.473 * m - .218) * particles + 1.8 * molecules;
    return sqrt(a * a + gb * a) / m;
}

static void test_attenuation_of_a_high_sun_is_kirks(void)
{
    /* Kirk, Aust. J. Mar. Freshw. Res. 32 (1981) 517: .256 for a sun in the
     * zenith */
    const double kd = sqrt(.1 * .1 + .256 * .1);
    CHECK_NEAR(kirks_kd(.1, 1, 0, 1), kd, 1e-3);
    CHECK_NEAR(murk_water_absorption_of_kd(kd, 1, 0, murk_water_sun_cosine(0)),
               .1, 1e-3);
    CHECK_NEAR(murk_water_sun_cosine(30), sqrt(1 - .25 / (1.34 * 1.34)), 1e-15);
}

static void test_absorption_of_an_attenuation_gives_it_back(void)
{
    const double cosine = murk_water_sun_cosine(30);
    for (double kd = .01; kd < 10; kd *= 1.7) {
        for (double b = 0; b < 10; b = 3 * b + .01) {
            const double a = murk_water_absorption_of_kd(kd, b, .002, cosine);
            CHECK(a > 0);
            CHECK_NEAR(kirks_kd(a, b, .002, cosine) / kd, 1, 1e-12);
        }
    }
    CHECK(murk_water_absorption_of_kd(0, 1, .002, cosine) == 0);
}

int main(void)
{
    test_absorption_is_pope_and_frys();
    test_scattering_is_zhangs();
    test_scattering_follows_temperature_and_salt();
    test_morels_scattering();
    test_molecules_turn_light_evenly();
    test_chlorophyll();
    test_dissolved_matter_and_sediment();
    test_case_1_attenuation();
    test_case_1_absorption();
    test_case_1_attenuation();
    test_case_1_absorption();
    test_phase_function_of_a_backward_share();
    test_attenuation_of_a_high_sun_is_kirks();
    test_absorption_of_an_attenuation_gives_it_back();
    return check_done();
}
