/* The transverse Mercator projection by the series of Krueger, as Karney (2011)
 * gives it (terrain/local_frame.h).
 *
 * A geographic position becomes a conformal latitude, a position on the sphere
 * of the Gauss-Schreiber projection, and a position on the ellipsoid by a sum
 * of sines; the inverse goes the same way back. */
#include "terrain/local_frame.h"

#include "base/vector.h"

#include <math.h>

/* The ellipsoid of WGS84: NIMA TR8350.2 (2000). */
#define SEMI_MAJOR_M 6378137.0
#define FLATTENING   (1 / 298.257223563)

#define ORDER 6 /* of the series: the highest that Karney (2011) prints */

/* Steps of Newton's method for the latitude: two reach double precision
 * (Karney 2011, eq. 21); the third is in reserve. */
#define STEPS 3

/* Coefficients of the third flattening n, n^2, ... n^6 in alpha_1 to alpha_6
 * (Karney 2011, eq. 35). */
static const double forward[ORDER][ORDER] = {
    {1. / 2, -2. / 3, 5. / 16, 41. / 180, -127. / 288, 7891. / 37800},
    {0, 13. / 48, -3. / 5, 557. / 1440, 281. / 630, -1983433. / 1935360},
    {0, 0, 61. / 240, -103. / 140, 15061. / 26880, 167603. / 181440},
    {0, 0, 0, 49561. / 161280, -179. / 168, 6601661. / 7257600},
    {0, 0, 0, 0, 34729. / 80640, -3418889. / 1995840},
    {0, 0, 0, 0, 0, 212378941. / 319334400}};

/* The same in beta_1 to beta_6 (eq. 36). */
static const double backward[ORDER][ORDER] = {
    {1. / 2, -2. / 3, 37. / 96, -1. / 360, -81. / 512, 96199. / 604800},
    {0, 1. / 48, 1. / 15, -437. / 1440, 46. / 105, -1118711. / 3870720},
    {0, 0, 17. / 480, -37. / 840, -209. / 4480, 5569. / 90720},
    {0, 0, 0, 4397. / 161280, -11. / 504, -830251. / 7257600},
    {0, 0, 0, 0, 4583. / 161280, -108847. / 3991680},
    {0, 0, 0, 0, 0, 20648693. / 638668800}};

static double third_flattening(void)
{
    return FLATTENING / (2 - FLATTENING);
}

static double eccentricity(void)
{
    return sqrt(FLATTENING * (2 - FLATTENING));
}

/* The radius of the circle that is as long as a meridian (eq. 14). */
static double rectifying_radius_m(void)
{
    const double n = third_flattening(), n2 = n * n;
    return SEMI_MAJOR_M / (1 + n) *
           (1 + n2 / 4 + n2 * n2 / 64 + n2 * n2 * n2 / 256);
}

static double coefficient(const double row[ORDER])
{
    const double n = third_flattening();
    double sum = 0;
    for (int k = ORDER; k-- > 0;) {
        sum = (sum + row[k]) * n;
    }
    return sum;
}

/* Adds the series to (xi, eta), with the sign +1 forward and -1 backward. */
static void add_series(const double table[ORDER][ORDER], double sign,
                       double *xi, double *eta)
{
    const double x = *xi, y = *eta;
    for (int j = 1; j <= ORDER; ++j) {
        const double a = sign * coefficient(table[j - 1]);
        *xi += a * sin(2 * j * x) * cosh(2 * j * y);
        *eta += a * cos(2 * j * x) * sinh(2 * j * y);
    }
}

/* The tangent of the conformal latitude from that of the latitude (eq. 7 to
 * 9). */
static double conformal(double tau)
{
    const double e = eccentricity(), root = hypot(1, tau),
                 sigma = sinh(e * atanh(e * tau / root));
    return tau * hypot(1, sigma) - sigma * root;
}

/* The inverse of conformal() by Newton's method (eq. 19 to 21). */
static double geodetic(double wanted)
{
    const double e2 = eccentricity() * eccentricity();
    double tau = wanted / (1 - e2);
    for (int i = 0; i < STEPS; ++i) {
        const double now = conformal(tau);
        tau += (wanted - now) / hypot(1, now) * (1 + (1 - e2) * tau * tau) /
               ((1 - e2) * hypot(1, tau));
    }
    return tau;
}

/* Coordinates on the sphere and then on the ellipsoid, in radians, of a
 * latitude and a longitude from the meridian. */
static void project(double latitude, double longitude, double *xi, double *eta)
{
    const double tau = conformal(tan(latitude));
    *xi = atan2(tau, cos(longitude));
    *eta = asinh(sin(longitude) / hypot(tau, cos(longitude)));
    add_series(forward, 1, xi, eta);
}

murk_local_frame murk_local_frame_at(double latitude_deg, double longitude_deg,
                                     double north_x, double north_y)
{
    const double length = hypot(north_x, north_y);
    murk_local_frame frame = {.latitude_deg = latitude_deg,
                              .longitude_deg = longitude_deg,
                              .north = {north_x / length, north_y / length}};
    double eta;
    project(latitude_deg * MURK_PI / 180, 0, &frame.origin, &eta);
    return frame;
}

bool murk_local_from_geographic(const murk_local_frame *frame,
                                double latitude_deg, double longitude_deg,
                                double at_m[2])
{
    const double longitude =
        remainder(longitude_deg - frame->longitude_deg, 360) * MURK_PI / 180;
    /* Beyond a right angle from the meridian is the other side of the earth. */
    if (!(fabs(latitude_deg) <= 90 && fabs(longitude) < MURK_PI / 2)) {
        return false;
    }
    double xi, eta;
    project(latitude_deg * MURK_PI / 180, longitude, &xi, &eta);
    const double east = rectifying_radius_m() * eta,
                 north = rectifying_radius_m() * (xi - frame->origin);
    /* East is 90 degrees clockwise of north. */
    at_m[0] = east * frame->north[1] + north * frame->north[0];
    at_m[1] = north * frame->north[1] - east * frame->north[0];
    return fabs(at_m[0]) <= MURK_LOCAL_MAX_M &&
           fabs(at_m[1]) <= MURK_LOCAL_MAX_M;
}

void murk_geographic_from_local(const murk_local_frame *frame,
                                const double at_m[2], double *latitude_deg,
                                double *longitude_deg)
{
    const double radius = rectifying_radius_m(), *n = frame->north,
                 east = at_m[0] * n[1] - at_m[1] * n[0],
                 north = at_m[0] * n[0] + at_m[1] * n[1];
    double xi = north / radius + frame->origin, eta = east / radius;
    add_series(backward, -1, &xi, &eta);
    const double tau = geodetic(sin(xi) / hypot(sinh(eta), cos(xi)));
    *latitude_deg = atan(tau) * 180 / MURK_PI;
    *longitude_deg = remainder(
        frame->longitude_deg + atan2(sinh(eta), cos(xi)) * 180 / MURK_PI, 360);
}
