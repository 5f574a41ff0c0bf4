/* Path of light between two points on either side of a plane, by Newton's
 * method for Snell's law
 *
 *     r = h_rare t + h_dense t / sqrt(m^2 + (m^2 - 1) t^2).
 *
 * r is the distance of the points along the plane, h_rare and h_dense are the
 * distances of the points from the plane, m > 1 is the ratio of the refractive
 * indices, and t is the tangent of the angle to the normal on the side of the
 * smaller index. The right side increases with t >= 0 and is concave, so the
 * iteration from t = 0 approaches the root from below and cannot overshoot. The
 * crossing, the lengths and the angles follow from t without differences of
 * nearly equal numbers, so they are precise at grazing incidence, too. */
#include "sensing/snell.h"

#include "medium/fresnel.h"

/* Near the root each step of Newton's method doubles the number of correct
 * digits; at grazing incidence some ten steps are needed to come near. After
 * STEPS_MAX steps only rounding would still change t. */
#define STEPS_MAX 100

static double tangent_of(double r, double h_rare, double h_dense, double m)
{
    const double excess = m * m - 1;
    double t = 0;
    for (int step = 0; step < STEPS_MAX; ++step) {
        const double square = m * m + excess * t * t, root = sqrt(square);
        const double left = r - t * (h_rare + h_dense / root);
        const double slope = h_rare + h_dense * m * m / (square * root);
        const double next = t + left / slope;
        if (!(next > t)) {
            break;
        }
        t = next;
    }
    return t;
}

bool murk_snell_path(murk_vec3 sensor, murk_vec3 photon,
                     const murk_interface_plane *plane, const double n[2],
                     murk_snell *path)
{
    /* Heights over the plane; the points must lie on different sides. */
    const murk_vec3 offset = murk_sub(photon, sensor);
    const double up = murk_dot(murk_sub(sensor, plane->point), plane->normal);
    const double down = murk_dot(murk_sub(plane->point, photon), plane->normal);
    if (!(up * down > 0) || !isfinite(up + down) || !murk_is_finite(offset)) {
        return false;
    }
    /* Distance along the plane, and the tangent of the angle on the rare side.
     */
    const murk_vec3 along = murk_along(offset, up + down, plane->normal);
    const double r = murk_length(along), h[2] = {fabs(up), fabs(down)};
    const int rare = n[0] < n[1] ? 0 : 1, dense = 1 - rare;
    const double m = n[dense] / n[rare];
    const double t = tangent_of(r, h[rare], h[dense], m);
    /* Angles, lengths and the crossing follow from the tangent. */
    const double secant = sqrt(1 + t * t);
    const double root = sqrt(m * m + (m * m - 1) * t * t);
    const double aside[2] = {h[rare] * t, h[dense] * t / root};
    path->cosine[rare] = 1 / secant;
    path->cosine[dense] = root / (m * secant);
    path->length_m[rare] = h[rare] * secant;
    path->length_m[dense] = h[dense] / path->cosine[dense];
    const murk_vec3 foot = murk_along(sensor, -up, plane->normal);
    path->crossing =
        r > 0 ? murk_along(foot, aside[rare == 0 ? 0 : 1] / r, along) : foot;
    /* Transmittance, and the apparent distance from the two spreads. */
    double refracted;
    path->transmittance =
        1 - murk_fresnel(n[rare], n[dense], path->cosine[rare], &refracted);
    const double *d = path->length_m, *c = path->cosine, ratio = n[0] / n[1];
    const double sagittal = d[0] + d[1] * ratio;
    const double tangential = d[0] * c[1] / c[0] + d[1] * ratio * c[0] / c[1];
    path->apparent_m = sqrt(sagittal * tangential);
    return true;
}

/* Symbols as in sensing/snell.h. The points are at most d1 + d2 apart. With a =
 * d1 and b = d2 n1/n2 the square of the apparent distance is (a + b)(a / k + b
 * k), k = cos1/cos2.
 *
 * Into the denser side k <= 1. If a >= b, the second factor is at least a + b,
 * so a + b <= range and d1 + d2 <= range n2/n1. If a < b, the second factor is
 * at least 2 sqrt(a b), so range^4 >= 4 b^3 a; as a is the height or more, this
 * bounds b, and d1 + d2 < b (1 + n2/n1).
 *
 * Into the rarer side k >= 1. If b >= a, the second factor is at least a + b,
 * so d1 + d2 <= range. If b < a, d1 + d2 < a (1 + n2/n1), and by Snell's law d1
 * is below the height over the cosine of the critical angle. */
double murk_snell_reach(double range_m, double height_m, const double n[2])
{
    const double ratio = n[0] / n[1], spread = 1 + 1 / ratio;
    if (ratio < 1) {
        const double square = range_m * range_m;
        return fmax(range_m / ratio,
                    spread * cbrt(square * square / (4 * height_m)));
    }
    const double critical = sqrt(1 - 1 / (ratio * ratio));
    return fmax(range_m, spread * height_m / critical);
}
