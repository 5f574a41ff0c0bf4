/* Integrates and samples the cosine at a plane over a disc. If the cosine is
 * positive on the whole disc, the integral is the cosine at the center, and
 * points are drawn in closed form. If the plane cuts the disc, points are drawn
 * by bisection of the distribution function along the tilt of the plane. */
#include "source/disc.h"

/* Halvings of an interval in the bisection: one for each digit of a double. */
#define HALVINGS 53

/* Lengths are in units of the radius of the disc, and x points along the
 * projection of the normal of the plane on the disc, along which the cosine
 * rises. The cosine is proportional to max(0, edge + x), where `edge` is the
 * cosine at the center divided by the rise of the cosine over one radius, and
 * -1 < edge < 1. Returns an antiderivative of (edge + x) sqrt(1 - x^2): for
 * -edge <= x, cut_integral(edge, x) - cut_integral(edge, -edge) is half of the
 * integral of edge + x over the part of the disc between -edge and x. */
static double cut_integral(double edge, double x)
{
    const double rest = sqrt(fmax(0, (1 - x) * (1 + x)));
    return edge / 2 * (x * rest + asin(x)) - rest * rest * rest / 3;
}

double murk_disc_cosine(murk_vec3 direction, double radius, murk_vec3 inward)
{
    const double middle = murk_dot(direction, inward);
    const double tilt = radius * murk_length(murk_cross(direction, inward));
    if (middle >= tilt) {
        return middle;
    }
    if (!(middle > -tilt)) {
        return 0;
    }
    const double edge = middle / tilt;
    return tilt * 2 / MURK_PI *
           (cut_integral(edge, 1) - cut_integral(edge, -edge));
}

/* Draws the coordinate x of cut_integral() between -edge and 1, with a density
 * proportional to (edge + x) sqrt(1 - x^2). */
static double cut_draw(double edge, double u)
{
    const double min = cut_integral(edge, -edge);
    const double wanted = min + u * (cut_integral(edge, 1) - min);
    double low = -edge, high = 1;
    for (int i = 0; i < HALVINGS; ++i) {
        const double x = (low + high) / 2;
        if (cut_integral(edge, x) < wanted) {
            low = x;
        } else {
            high = x;
        }
    }
    return (low + high) / 2;
}

murk_vec3 murk_disc_draw(murk_vec3 direction, double radius, murk_vec3 inward,
                         const double u[3])
{
    if (!(radius > 0)) {
        return direction;
    }
    const double middle = murk_dot(direction, inward);
    const murk_vec3 aside = murk_along(inward, -middle, direction);
    const double sine = murk_length(aside), tilt = radius * sine;
    /* A frame with t along the tilt of the plane. */
    murk_vec3 t, b;
    murk_frame(direction, &t, &b);
    if (tilt > 0) {
        t = murk_scale(1 / sine, aside);
        b = murk_cross(direction, t);
    }
    /* A point of the disc with density proportional to the cosine. */
    double x, y;
    if (middle >= tilt) {
        const double rho = sqrt(u[0]), phi = 2 * MURK_PI * u[1];
        x = rho * cos(phi);
        y = rho * sin(phi);
        /* Mirror the point, from x to -x, with the probability that makes the
         * density proportional to the cosine middle + x tilt. */
        if (u[2] > (1 + x * tilt / middle) / 2) {
            x = -x;
        }
    } else {
        x = cut_draw(middle / tilt, u[0]);
        y = sqrt(fmax(0, (1 - x) * (1 + x))) * (2 * u[1] - 1);
    }
    const murk_vec3 d = murk_along(direction, radius * x, t);
    return murk_unit(murk_along(d, radius * y, b));
}
