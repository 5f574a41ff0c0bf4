/* What distant light enters by: the lit faces of the domain or, where the light
 * is aimed, portals. Private to this room.
 *
 * An opening takes its power, irradiance on its plane times its area; a photon
 * draws an opening by power, a place on it evenly, and a direction by radiance
 * times cosine there. So the rays through all openings together are dealt by
 * radiance alone, and a ray through several portals comes as often from each of
 * them: it is kept where it is drawn from the first. */
#ifndef MURK_LIGHT_OPENINGS_H
#define MURK_LIGHT_OPENINGS_H

#include "light/lights.h"

typedef struct murk_openings murk_openings;

/* The openings of a directional light or a dome that has been checked; the
 * light's direction is unit. Without portals, the faces of the domain. *out is
 * the caller's. Fails on what is wrong with portals or with the sky. */
murk_status murk_openings_create(murk_openings **out, const murk_light *light,
                                 const murk_domain *domain, murk_error *err);
void murk_openings_destroy(murk_openings *openings); /* NULL is fine */

/* Watts that enter for each W/m2 of the light's irradiance; 0: none. */
double murk_openings_area_m2(const murk_openings *openings);
double murk_openings_one_m2(const murk_openings *openings, size_t which);

/* Of a dome: the integral of its relative radiance times cosine that a level
 * plane sees. */
double murk_openings_level(const murk_openings *openings);

#define MURK_OPENINGS_NUMBERS 8

/* A photon's start, on the domain's boundary, for uniform numbers. The area
 * must be above 0. */
murk_ray murk_openings_emit(const murk_openings *openings,
                            const double u[MURK_OPENINGS_NUMBERS]);

#endif
