/* What distant light enters by: the lit faces of the domain or, where the light
 * is aimed, portals. Private to this room.
 *
 * An opening takes its power, irradiance on its plane times its area; a photon
 * draws an opening by power, a place on it evenly, and a direction by radiance
 * times cosine there. So the rays through all openings together are dealt by
 * radiance alone, and a ray through several portals comes as often from each of
 * them: it is kept where it is drawn from the first. */
#ifndef MURK_SOURCE_ENTRY_FACES_H
#define MURK_SOURCE_ENTRY_FACES_H

#include "source/sources.h"

typedef struct murk_entry_faces murk_entry_faces;

/* The openings of a directional light or a dome that has been checked; the
 * light's direction is unit. Without portals, the faces of the domain. *out is
 * the caller's. Fails on what is wrong with portals or with the sky. */
murk_status murk_entry_faces_create(murk_entry_faces **out,
                                    const murk_source *light,
                                    const murk_domain *domain, murk_error *err);
void murk_entry_faces_destroy(murk_entry_faces *entry_faces); /* NULL is fine */

/* Watts that enter for each W/m2 of the light's irradiance; 0: none. */
double murk_entry_faces_area_m2(const murk_entry_faces *entry_faces);
double murk_entry_faces_one_m2(const murk_entry_faces *entry_faces,
                               size_t which);

/* Of a dome: the integral of its relative radiance times cosine that a level
 * plane sees. */
double murk_entry_faces_level(const murk_entry_faces *entry_faces);

#define MURK_ENTRY_FACES_NUMBERS 8

/* A photon's start, on the domain's boundary, for uniform numbers. The area
 * must be above 0. */
murk_ray murk_entry_faces_emit(const murk_entry_faces *entry_faces,
                               const double u[MURK_ENTRY_FACES_NUMBERS]);

#endif
