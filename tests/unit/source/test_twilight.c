/* The law of twilight: its ends, its joints, its fall. Nothing is random. */
#include "source/twilight.h"

#include "check.h"

static void test_ends(void)
{
    CHECK(murk_twilight_lux(-18) == 0);
    CHECK(murk_twilight_lux(-30) == 0);
    CHECK(murk_twilight_lux(NAN) == 0);
    CHECK(murk_twilight_lux(0) == murk_twilight_lux(12));
}

/* The dark limit of civil twilight is 3.4 lux to its last figure. The teeth:
 * a tenth of a degree more or less is refused. */
static void test_civil_twilight_ends_at_3_4_lux(void)
{
    CHECK_NEAR(murk_twilight_lux(-6), 3.4, 0.05);
    CHECK(fabs(murk_twilight_lux(-6.1) - 3.4) > 0.3);
    CHECK(fabs(murk_twilight_lux(-5.9) - 3.4) > 0.3);
}

/* No step anywhere: in a thousandth of a degree it never changes by more than
 * the steepest piece does, which is 2.6 e-folds a degree below 17 degrees
 * where it goes to nothing, and never grows. */
static void test_falls_without_a_step(void)
{
    double before = murk_twilight_lux(0.5);
    for (int i = 1; i < 18500; ++i) {
        const double elevation = 0.5 - i * 1e-3;
        const double now = murk_twilight_lux(elevation);
        CHECK(now <= before);
        CHECK(before - now <= 1.5e-3 * before + 5e-7);
        before = now;
    }
}

int main(void)
{
    test_ends();
    test_civil_twilight_ends_at_3_4_lux();
    test_falls_without_a_step();
    return check_done();
}
