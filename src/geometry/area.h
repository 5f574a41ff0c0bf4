/* Points on surfaces, evenly by area: where a plan's targets lie that no light
 * chose.
 *
 * Immutable after creation: any number of threads may ask. */
#ifndef MURK_GEOMETRY_AREA_H
#define MURK_GEOMETRY_AREA_H

#include "geometry/surfaces.h"

typedef struct murk_area murk_area;

/* Of the materials wanted[murk_surfaces_materials()]; NULL: of all. Borrows the
 * surfaces. *out is the caller's: murk_area_destroy(). Fails with
 * MURK_BAD_VALUE at `where` when there is no area, or MURK_NO_MEMORY. */
murk_status murk_area_create(murk_area **out, const murk_surfaces *surfaces,
                             const bool *wanted, const char *where,
                             murk_error *err);
void murk_area_destroy(murk_area *area); /* NULL is fine */

double murk_area_m2(const murk_area *area);

typedef struct murk_area_point {
    murk_vec3 place;
    murk_vec3 normal; /* unit, to either side */
    uint8_t material;
} murk_area_point;

/* Evenly distributed over all the area when u[3] are independent and uniform in
 * (0, 1). Triangles of less than 2^-32 of it may never be met. */
murk_area_point murk_area_at(const murk_area *area, const double u[3]);

#endif
