/* The formula of Kirk 1984 for diffuse attenuation, solved for the absorption,
 * and the direction of the sun in water; see preset/water_kd.h. */
#include "preset/water_kd.h"

#include <math.h>

#define INDEX       1.34 /* of water in the visible */
#define G_MOLECULES 1.8  /* preset/water_kd.h */

double murk_water_sun_cosine(double zenith_in_air_deg)
{
    const double sine = sin(zenith_in_air_deg * 3.14159265358979324 / 180);
    return sqrt(1 - sine * sine / (INDEX * INDEX));
}

/* G b, summed over both scatterers. */
static double turned(double particles, double molecules, double sun_cosine)
{
    return (.473 * sun_cosine - .218) * particles + G_MOLECULES * molecules;
}

double murk_water_absorption_of_kd(double kd_per_m, double particles_per_m,
                                   double molecules_per_m, double sun_cosine)
{
    const double k = kd_per_m * sun_cosine;
    const double half =
        turned(particles_per_m, molecules_per_m, sun_cosine) / 2;
    /* the positive root of a^2 + 2 half a - k^2, without cancellation */
    return k > 0 ? k * k / (half + hypot(half, k)) : 0;
}
