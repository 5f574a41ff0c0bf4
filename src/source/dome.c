/* The CIE standard general sky: table of the fifteen types and evaluation of
 * gradation and indicatrix (source/dome.h). */
#include "source/dome.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

/* Coefficients a, b, c, d, e of types 1..15 (CIE S 011). */
static const double TYPE[MURK_DOME_TYPES][5] = {
    {4.0, -0.70, 0, -1.0, 0},      {4.0, -0.70, 2, -1.5, 0.15},
    {1.1, -0.80, 0, -1.0, 0},      {1.1, -0.80, 2, -1.5, 0.15},
    {0, -1.00, 0, -1.0, 0},        {0, -1.00, 2, -1.5, 0.15},
    {0, -1.00, 5, -2.5, 0.30},     {0, -1.00, 10, -3.0, 0.45},
    {-1.0, -0.55, 2, -1.5, 0.15},  {-1.0, -0.55, 5, -2.5, 0.30},
    {-1.0, -0.55, 10, -3.0, 0.45}, {-1.0, -0.32, 10, -3.0, 0.45},
    {-1.0, -0.32, 16, -3.0, 0.30}, {-1.0, -0.15, 16, -3.0, 0.30},
    {-1.0, -0.15, 24, -2.8, 0.15},
};

murk_dome murk_dome_cie(int type, murk_vec3 towards)
{
    assert(type >= 1 && type <= MURK_DOME_TYPES);
    const double *k = TYPE[type - 1];
    return (murk_dome){.a = k[0],
                       .b = k[1],
                       .c = k[2],
                       .d = k[3],
                       .e = k[4],
                       .towards = towards};
}

/* The angle between unit vectors; acos() of the scalar product would lose half
 * of the digits near the sun. */
static double angle_between(murk_vec3 a, murk_vec3 b)
{
    return 2 * atan2(murk_length(murk_sub(a, b)), murk_length(murk_add(a, b)));
}

/* True if a direction lies in the patch; of an edge that two patches share, one
 * of them has it. */
static bool is_within(const murk_sky_patch *patch, murk_vec3 d)
{
    const double turn = 2 * MURK_PI;
    double azimuth = atan2(d.y, d.x);
    azimuth += azimuth < patch->from_rad ? turn : 0;
    azimuth += azimuth < patch->from_rad ? turn : 0;
    return d.z >= patch->low && (d.z < patch->high || patch->high >= 1) &&
           azimuth < patch->to_rad;
}

double murk_dome_radiance(const murk_dome *dome, murk_vec3 direction)
{
    if (!(direction.z >= 0)) {
        return 0;
    }
    if (dome->patch.high > 0) {
        return is_within(&dome->patch, direction) ? 1 : 0;
    }
    double radiance = 1;
    if (dome->a != 0) {
        /* For b < 0, the limit of exp(b / cos Z) at the horizon is 0. */
        radiance += direction.z > 0 ? dome->a * exp(dome->b / direction.z) : 0;
    }
    if (dome->c != 0 || dome->e != 0) {
        const double chi = angle_between(direction, dome->towards);
        const double cosine = murk_dot(direction, dome->towards);
        radiance *=
            1 + dome->c * (exp(dome->d * chi) - exp(dome->d * MURK_PI / 2)) +
            dome->e * cosine * cosine;
    }
    return radiance;
}
