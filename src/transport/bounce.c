/* The outcome of a photon that meets a surface, drawn by Russian roulette
 * between diffuse reflection, mirror, transmission and absorption; at the
 * boundary of a solid by Snell and Fresnel (medium/fresnel.h). */
#include "transport/bounce.h"

#include "medium/fresnel.h"
#include "transport/turn.h"

murk_vec3 murk_cosine_law(murk_vec3 n, double u_mu, double u_phi)
{
    return murk_turned_direction(n, sqrt(u_mu), u_phi);
}

static murk_vec3 mirrored(murk_vec3 d, murk_vec3 normal)
{
    return murk_trimmed(murk_along(d, -2 * murk_dot(d, normal), normal));
}

murk_bounce murk_refract(double n_from, double n_to, murk_vec3 direction,
                         murk_vec3 normal, double u)
{
    const double cosine = fmin(1, fabs(murk_dot(direction, normal)));
    double refracted;
    if (u <= murk_fresnel(n_from, n_to, cosine, &refracted)) {
        return (murk_bounce){MURK_MIRRORED, mirrored(direction, normal)};
    }
    const double ratio = n_from / n_to;
    const murk_vec3 d = murk_along(murk_scale(ratio, direction),
                                   ratio * cosine - refracted, normal);
    return (murk_bounce){MURK_TRANSMITTED, murk_unit(d)};
}

murk_bounce murk_surface_bounce(const murk_material *material, int band,
                                double n_from, double n_to, murk_vec3 direction,
                                murk_vec3 normal, const double u[4])
{
    const double d = material->diffuse.band[band];
    const double s = material->specular.band[band];
    const double t = material->transmit.band[band];
    if (u[0] <= d) {
        return (murk_bounce){MURK_DIFFUSE, murk_cosine_law(normal, u[1], u[2])};
    }
    if (u[0] > d + s + t) {
        return (murk_bounce){MURK_ABSORBED, murk_vec(0, 0, 0)};
    }
    if (n_to > 0) {
        return murk_refract(n_from, n_to, direction, normal, u[3]);
    }
    if (u[0] <= d + s) {
        return (murk_bounce){MURK_MIRRORED, mirrored(direction, normal)};
    }
    return (murk_bounce){MURK_TRANSMITTED, direction};
}
