/* Reflection and transmission at a surface: the roulette of transport/trace.h,
 * and at the boundary of a solid Snell's law with Fresnel reflectance. For use
 * inside src/transport only. */
#ifndef MURK_TRANSPORT_BOUNCE_H
#define MURK_TRANSPORT_BOUNCE_H

#include "transport/trace.h"

/* A random direction by the cosine law around the unit normal n; u_mu and u_phi
 * are random numbers in (0, 1). */
murk_vec3 murk_cosine_law(murk_vec3 n, double u_mu, double u_phi);

/* The result of an event at a surface. */
typedef struct murk_bounce {
    murk_outcome outcome;
    murk_vec3 direction; /* unit, leaving; zero when absorbed */
} murk_bounce;

/* At an interface between two indices: MURK_MIRRORED with the probability of
 * the Fresnel reflectance, else MURK_TRANSMITTED; u in (0, 1). Directions and
 * normal as for murk_surface_bounce(). */
murk_bounce murk_refract(double n_from, double n_to, murk_vec3 direction,
                         murk_vec3 normal, double u);

/* At a surface: unit direction of travel, unit normal on the side from which
 * the light came. n_from = n_to = 0 for a surface that does not refract. u:
 * four numbers in (0, 1). */
murk_bounce murk_surface_bounce(const murk_material *material, int band,
                                double n_from, double n_to, murk_vec3 direction,
                                murk_vec3 normal, const double u[4]);

#endif
