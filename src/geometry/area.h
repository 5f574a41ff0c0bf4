/* Random points on surfaces, uniform by area: the places of a plan's targets
 * when the targets are given by material and not by light.
 *
 * A murk_area is immutable after creation, so any number of threads may use
 * it. */
#ifndef MURK_GEOMETRY_AREA_H
#define MURK_GEOMETRY_AREA_H

#include "geometry/surfaces.h"

typedef struct murk_area murk_area;

/* Prepares sampling of the surfaces whose material m has wanted[m] set;
 * wanted[] has murk_surfaces_materials() entries, and NULL selects all
 * materials. The surfaces are borrowed and must outlive *out. The caller
 * owns *out and releases it with murk_area_destroy(). Fails with
 * MURK_BAD_VALUE at `where` if the selected area is 0, or with
 * MURK_NO_MEMORY. */
murk_status murk_area_create(murk_area **out, const murk_surfaces *surfaces,
                             const bool *wanted, const char *where,
                             murk_error *err);
void murk_area_destroy(murk_area *area); /* NULL is fine */

/* Total selected area. */
double murk_area_m2(const murk_area *area);

typedef struct murk_area_point {
    murk_vec3 place;
    murk_vec3 normal; /* unit, to either side */
    uint8_t material;
} murk_area_point;

/* The point for three independent numbers u[3], uniform in (0, 1). Points are
 * uniform over the selected area. A triangle or sphere with less than 2^-32 of
 * the area may never be selected, because u[0] has 32 random bits. */
murk_area_point murk_area_at(const murk_area *area, const double u[3]);

#endif
