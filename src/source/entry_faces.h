/* The entry faces of distant light: the faces of the domain (of a periodic
 * domain, the top only) or, if the light is aimed at portals, the portals. For
 * use inside src/source only.
 *
 * The power of a face is the irradiance on the plane of the face times the
 * area. A photon draws a face by power, a point of the face uniformly, and a
 * direction by radiance times cosine. Together, the rays through all faces are
 * therefore distributed by radiance alone. A ray through several portals is
 * drawn with equal density from each of them, and is marked with is_spent
 * (source/source.h) unless it is drawn from the first portal on the ray. */
#ifndef MURK_SOURCE_ENTRY_FACES_H
#define MURK_SOURCE_ENTRY_FACES_H

#include "base/status.h"
#include "source/source.h"

typedef struct murk_entry_faces murk_entry_faces;

/* Creates the entry faces of a directional light or a dome that has been
 * checked; the direction of the light is a unit vector. Without portals, the
 * faces of the domain are used. The caller destroys *out. Fails with
 * MURK_BAD_VALUE if the sky has an invalid radiance, or with MURK_NO_MEMORY. */
murk_status murk_entry_faces_create(murk_entry_faces **out,
                                    const murk_source *light,
                                    const murk_domain *domain, murk_error *err);
void murk_entry_faces_destroy(murk_entry_faces *entry_faces); /* NULL is fine */

/* The power that enters for an irradiance of 1 W/m2, through all faces, and
 * through face or portal `which`. 0 if no light enters. The irradiance of a
 * dome is that on a level plane, that of directional light is on a plane at
 * right angles to the light. */
double murk_entry_faces_area_m2(const murk_entry_faces *entry_faces);
double murk_entry_faces_one_m2(const murk_entry_faces *entry_faces,
                               size_t which);

/* The integral of the relative radiance of a dome times cosine on a level
 * plane; 0 for directional light. */
double murk_entry_faces_level(const murk_entry_faces *entry_faces);

#define MURK_ENTRY_FACES_NUMBERS 8 /* two draws of four; at most 7 used */

/* The start of a photon on the boundary of the domain, from uniform numbers.
 * murk_entry_faces_area_m2() must be above 0. */
murk_ray murk_entry_faces_emit(const murk_entry_faces *entry_faces,
                               const double u[MURK_ENTRY_FACES_NUMBERS]);

#endif
