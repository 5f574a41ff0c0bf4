/* Evaluates the piecewise cubic polynomials of twilight (source/twilight.h),
 * shifted linearly within each piece so that they join without a step. */
#include "source/twilight.h"

#include <math.h>
#include <stddef.h>

/* log10 of lux = c[0] + c[1] x + c[2] x^2 + c[3] x^3 with x = elevation / 90,
 * from `low` degrees up to `low` of the previous piece, or up to 0 degrees. */
typedef struct piece {
    double low;
    double c[4];
} piece;

/* U.S. Naval Observatory Circular 171. */
static const piece pieces[] = {
    {-0.8, {2.88, 22.26, -207.64, 1034.30}},
    {-5, {2.88, 21.81, -258.11, -858.36}},
    {-12, {2.70, 12.17, -431.69, -1899.83}},
    {MURK_TWILIGHT_END_DEG, {13.84, 262.72, 1447.42, 2797.93}},
};
#define PIECES (sizeof pieces / sizeof *pieces)

static double cubic(const piece *p, double elevation_deg)
{
    const double x = elevation_deg / 90;
    return p->c[0] + x * (p->c[1] + x * (p->c[2] + x * p->c[3]));
}

/* Half of the difference between a neighbour and piece k at the common end. */
static double half_gap(size_t k, size_t neighbour, double at_deg)
{
    return (cubic(&pieces[neighbour], at_deg) - cubic(&pieces[k], at_deg)) / 2;
}

static double logarithm(double elevation_deg)
{
    size_t k = 0;
    while (k + 1 < PIECES && elevation_deg < pieces[k].low) {
        ++k;
    }
    const double high = k ? pieces[k - 1].low : 0;
    const double low = pieces[k].low;
    const double at_high = k ? half_gap(k, k - 1, high) : 0;
    const double at_low = k + 1 < PIECES ? half_gap(k, k + 1, low) : 0;
    const double t = (elevation_deg - low) / (high - low);
    return cubic(&pieces[k], elevation_deg) + t * at_high + (1 - t) * at_low;
}

double murk_twilight_lux(double sun_elevation_deg)
{
    if (!(sun_elevation_deg > MURK_TWILIGHT_END_DEG)) {
        return 0;
    }
    return pow(10, logarithm(fmin(sun_elevation_deg, 0))) -
           pow(10, logarithm(MURK_TWILIGHT_END_DEG));
}
