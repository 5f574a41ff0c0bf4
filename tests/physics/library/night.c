/* Light of the night against published levels and field readings: moonlight by
 * phase, twilight by the sun's depression, the dark sky. */
#include "library/library.h"
#include "night_field.h"
#include "source/moonlight.h"
#include "source/night_sky.h"
#include "source/twilight.h"

#include <math.h>

#define PI         3.14159265358979323846
#define MEAN_M     384400e3
#define TURBIDITY  3.0
#define SUNSET_DEG (-0.8333) /* the upper rim at the horizon, refracted */

/* Of a level plane below the whole clear sky, the moon half way up. */
static double moonlit_lux(double phase_angle_deg)
{
    const murk_moon moon = {phase_angle_deg, MEAN_M, 45};
    const murk_moonlight light =
        murk_moonlight_at(&moon, murk_visual_extinction(TURBIDITY, 0));
    return light.direct_lux * sin(PI / 4) + light.diffuse_lux;
}

/* A level that is known to its order of magnitude only. */
static void magnitude_row(murk_library *library, const char *quantity,
                          double reference_lux, double value_lux)
{
    murk_library_row(library, quantity, "log10 lux", log10(reference_lux),
                     log10(value_lux), 0.5, "half an order of magnitude",
                     "Wikipedia, Orders of magnitude (illuminance)");
}

static void compare_levels(murk_library *library)
{
    murk_library_title(
        library, "Light of the night",
        "Illuminance of a level plane under a clear sky of turbidity 3, the "
        "moon at its mean distance, 45 degrees high, a full one 3 degrees "
        "from opposition; the dark sky of 21.6 mag/arcsec2.");
    murk_library_row(library, "civil twilight's dark limit, sun 6 degrees down",
                     "lux", 3.4, murk_twilight_lux(-6), 0.05,
                     "last digit printed", "Wikipedia, Lux");
    magnitude_row(library, "clear sunset", 400, murk_twilight_lux(SUNSET_DEG));
    magnitude_row(library, "full moon", 0.25, moonlit_lux(3));
    magnitude_row(library, "quarter moon", 0.01, moonlit_lux(90));
    magnitude_row(library, "starlight with airglow", 0.002,
                  murk_night_sky_lux(MURK_NIGHT_SKY_MAGNITUDE,
                                     murk_visual_extinction(TURBIDITY, 0)));
    const murk_moon moon = {45, MEAN_M, 20};
    murk_library_row(library, "moonlit sky by Krisciunas and Schaefer",
                     "mag/arcsec2", 19.855,
                     murk_sky_magnitude(murk_moonlit_sky(&moon, 20, 50, 0.15)),
                     0.0005, "last digit printed",
                     "specsim 0.13, krisciunas_schaefer(), computed");
}

static void compare_field(murk_library *library, const night_field *field)
{
    const char *source = "O'Keeffe, Cloughleafin, April 2019";
    const night_fit fit = night_field_fit(field);
    murk_library_title(
        library, "Night brightness in the field",
        "Eleven nights of a meter at the zenith against scattered moonlight "
        "and one free level of the sky.");
    murk_library_row(library, "correlation of logarithms", "", 1,
                     fit.correlation, 0.20, "at least .80: required", source);
    murk_library_row(library, "five moon nights, out of order", "", 0,
                     (double)fit.out_of_order, 0, "in order: required", source);
}

void murk_library_night(murk_library *library)
{
    static night_field field;
    compare_levels(library);
    if (night_field_read(&field, 0)) {
        compare_field(library, &field);
    }
}
