/* Observations of the weather: the empty observation, and the class of the sky
 * by its clearness. */
#include "weather/observation.h"

#include <math.h>

murk_observation murk_observation_empty(void)
{
    return (murk_observation){.direct_w_per_m2 = NAN,
                              .diffuse_w_per_m2 = NAN,
                              .global_w_per_m2 = NAN,
                              .sky_cover = NAN,
                              .visibility_m = NAN,
                              .temperature_c = NAN,
                              .dew_point_c = NAN,
                              .pressure_hpa = NAN};
}

bool murk_is_of_air(double temperature_c)
{
    return temperature_c >= MURK_COLDEST_C && temperature_c <= MURK_HOTTEST_C;
}

double murk_rain_of_class(bool is_drizzle, int intensity)
{
    /* The header has the source. */
    static const double rain[] = {1.25, 5, 15}, drizzle[] = {.12, .37, 1};
    return is_drizzle ? drizzle[intensity] : rain[intensity];
}

int murk_sky_clearness(double direct_w_per_m2, double diffuse_w_per_m2,
                       double sun_zenith_rad)
{
    /* Lower limits of the classes 2 to 8, and the constant by which the
     * dependence on the zenith angle is removed (Perez et al. 1990). */
    static const double limit[] = {1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2};
    const double per_cube = 1.041;
    const double z = fmin(sun_zenith_rad, acos(0));
    const double k = per_cube * z * z * z;
    int class = 1;
    if (!(diffuse_w_per_m2 > 0)) {
        return direct_w_per_m2 > 0 ? 8 : 1;
    }
    const double clearness =
        ((diffuse_w_per_m2 + direct_w_per_m2) / diffuse_w_per_m2 + k) / (1 + k);
    while (class < 8 && clearness >= limit[class - 1]) {
        ++class;
    }
    return class;
}

int murk_sky_cie_type(int clearness)
{
    /* Overcast skies without a sun (1: steep, 3: moderate gradation), then
     * partly cloudy ones that brighten towards the sun (7, 8), then the
     * white-blue (11) and the clear sky (12). */
    static const int type[] = {1, 3, 7, 7, 8, 11, 12, 12};
    return type[clearness - 1];
}
