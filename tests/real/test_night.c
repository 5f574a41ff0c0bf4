/* Eleven April nights at Cloughleafin, Ireland, of a sky quality meter that
 * looks at the zenith, against moonlight scattered by a clear sky plus one free
 * level of the dark sky.
 *
 * No night is left out, cloudy ones neither; readings with the sun less than 15
 * degrees down are (twilight). What is free: the one level, by least squares of
 * magnitudes. What is asked: that the logarithms of measured and modelled
 * luminance correlate by at least .80, and that the meter puts the five nights
 * with the most moonlight in the same order. (The eleventh night has no moon
 * and is as bright as the fifth: clouds over towns.) The teeth: with
 * clocks an hour wrong it fits worse by a quarter at least. Nothing is
 * random. */
#include "check.h"
#include "night_field.h"
#include "source/night_sky.h"

static void print_nights(const night_field *f, const night_fit *x)
{
    printf("%zu readings of %zu nights, sun below %g degrees: level %.2f "
           "mag/arcsec2, correlation %.3f, rms %.2f mag\n",
           f->n, f->nights, NIGHT_FIELD_SUN_DEG, x->level_mag, x->correlation,
           x->rms_mag);
    for (size_t k = 0; k < f->nights; ++k) {
        printf("night %2zu: mean %.2f measured, %.2f modelled, moonlight %.2g "
               "of %.2g mcd/m2\n",
               k + 1, murk_sky_magnitude(x->measured[k]),
               murk_sky_magnitude(x->model[k]), 1e3 * x->moonlight[k],
               1e3 * x->model[k]);
    }
}

static void test_moonlight_explains_the_nights(const night_field *f,
                                               const night_fit *x)
{
    CHECK(f->nights >= 10 && f->n > 500);
    CHECK(x->correlation >= 0.80);
    CHECK(x->out_of_order == 0);
}

static void test_would_notice_a_wrong_clock(const night_fit *right)
{
    static night_field other;
    for (int hours = -1; hours <= 1; hours += 2) {
        night_field_read(&other, 3600.0 * hours);
        const night_fit x = night_field_fit(&other);
        printf("clock %+d h: correlation %.3f, rms %.2f mag\n", hours,
               x.correlation, x.rms_mag);
        CHECK(x.correlation < right->correlation);
        CHECK(x.rms_mag > 1.25 * right->rms_mag);
    }
}

int main(void)
{
    static night_field f;
    if (!night_field_read(&f, 0)) {
        check_skip("no nights at " NIGHT_FIELD_FILES);
    }
    const night_fit x = night_field_fit(&f);
    print_nights(&f, &x);
    test_moonlight_explains_the_nights(&f, &x);
    test_would_notice_a_wrong_clock(&x);
    return check_done();
}
