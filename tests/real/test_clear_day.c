/* The first of January 2016 at Alamosa, Colorado (SURFRAD), 2317 m high, a
 * clear day but for half an hour of cloud after sunrise, against the clear-sky
 * model with one turbidity.
 *
 * All minutes count that have the sun up and good flags, the cloudy ones too.
 * What is asked: root mean square differences of global and direct irradiance
 * under 10 % of their means. Diffuse is reported: the model has 20 W/m2
 * of 46; in clean air over a high place it leaves the sky little. The teeth:
 * with a clock an hour wrong it is not met. Nothing is random. */
#include "check.h"
#include "clear_day.h"

#include <math.h>

static void print_misfit(const char *name, const clear_misfit *m)
{
    printf("%-8s mean %6.1f W/m2: rms %5.2f %%, mean absolute %5.2f %%, bias "
           "%+.2f %%\n",
           name, m->mean_w_per_m2, 100 * m->rms, 100 * m->absolute,
           100 * m->bias);
}

/* The station states the apparent zenith angle, to .01 degrees, by an ephemeris
 * of its own, and its place to .01 degrees. Lower down it takes another air
 * for refraction. */
static void test_the_sun_stands_where_the_station_says(const clear_day *day)
{
    double max = 0;
    for (size_t i = 0; i < day->n; ++i) {
        if (day->minute[i].stated_zenith_deg < 80) {
            max = fmax(max, fabs(day->minute[i].stated_zenith_deg -
                                 day->minute[i].apparent_zenith_deg));
        }
    }
    printf("zenith angles: %.4f degrees off at most\n", max);
    CHECK(max < 0.05);
}

int main(void)
{
    static clear_day day, other;
    if (!clear_day_read(&day, 0)) {
        check_skip("no " CLEAR_DAY_FILE);
    }
    const clear_fit fit = clear_day_fit(&day);
    printf("%zu minutes, Linke turbidity %.2f\n", day.n, fit.linke);
    print_misfit("global", &fit.global);
    print_misfit("direct", &fit.direct);
    print_misfit("diffuse", &fit.diffuse);
    CHECK(day.n > 500);
    test_the_sun_stands_where_the_station_says(&day);
    CHECK(fit.global.rms < 0.10);
    CHECK(fit.direct.rms < 0.10);

    clear_day_read(&other, 3600);
    const clear_fit late = clear_day_fit(&other);
    CHECK(late.global.rms > 0.10 || late.direct.rms > 0.10);
    return check_done();
}
