/* The angular distribution of sky radiance (CIE standard general sky) against
 * published ratios of radiances, and the irradiance on a horizontal plane,
 * integrated by the midpoint rule, against closed forms. */
#include "source/dome.h"
#include "library/library.h"

#include <math.h>

#define STEPS 400

/* Level irradiance over the radiance at the zenith, by midpoints. */
static double level_over_zenith(int type, double sun_deg)
{
    const double up = sun_deg * MURK_PI / 180;
    const murk_dome dome = murk_dome_cie(type, murk_vec(cos(up), 0, sin(up)));
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double mu = sqrt((i + .5) / STEPS);
        for (int j = 0; j < STEPS; ++j) {
            const double phi = 2 * MURK_PI * (j + .5) / STEPS;
            const double across = sqrt(1 - mu * mu);
            sum += murk_dome_radiance(
                &dome, murk_vec(across * cos(phi), across * sin(phi), mu));
        }
    }
    return MURK_PI * sum / STEPS / STEPS /
           murk_dome_radiance(&dome, murk_vec(0, 0, 1));
}

static double radiance(int type, double sun_deg, double elevation_deg,
                       double azimuth_deg)
{
    const double sun = sun_deg * MURK_PI / 180,
                 up = elevation_deg * MURK_PI / 180,
                 around = azimuth_deg * MURK_PI / 180;
    const murk_dome dome = murk_dome_cie(type, murk_vec(cos(sun), 0, sin(sun)));
    return murk_dome_radiance(
        &dome, murk_vec(cos(up) * cos(around), cos(up) * sin(around), sin(up)));
}

void murk_library_dome(murk_library *library)
{
    murk_library_title(library, "Distribution of the sky's light",
                       "CIE standard general sky.");
    murk_library_row(library, "overcast (type 1), zenith over horizon", "", 3,
                     radiance(1, 30, 90, 0) / radiance(1, 30, 0, 0), .03,
                     "1 %: two laws of one sky", "Moon and Spencer 1942");
    murk_library_row(library, "overcast (type 1), level over zenith", "sr",
                     7 * MURK_PI / 9, level_over_zenith(1, 30),
                     .02 * 7 * MURK_PI / 9, "2 %: two laws of one sky",
                     "Moon and Spencer 1942");
    murk_library_row(library, "even (type 5), level over zenith", "sr", MURK_PI,
                     level_over_zenith(5, 30), 1e-9, "exact", "Lambert's law");
    murk_library_row(
        library, "clear (type 12), indicatrix 30 degrees from the sun", "",
        3.3264628, radiance(12, 0, 30, 0) / (1 - exp(-.32 / sin(MURK_PI / 6))),
        1e-7, "last digit printed", "colour 0.4.7, computed");
}
