/* A table of the sky as seen by a plane entry face, from which directions are
 * drawn with a density of radiance times the cosine at the face. For use inside
 * src/source only.
 *
 * On the unit disc of the face (Nusselt's analogue: the projection of a
 * direction onto the plane) equal areas have equal integrals of the cosine over
 * solid angle, so only the radiance needs a table. On the disc, x is the
 * coordinate along the horizontal of the plane, and y the coordinate across the
 * horizontal; a = y / sqrt(1 - x^2) runs from the horizon to the upper edge of
 * the disc. The visible sky is therefore a rectangle in x and a at any tilt of
 * the face, without an edge inside. The table holds radiance times sqrt(1 -
 * x^2) at nodes with equal steps of angle, and is bilinear in between.
 * Directions are drawn exactly from this bilinear function, not from the sky
 * that it approximates. Cells are chosen by Walker's alias method (Vose, IEEE
 * Trans. Softw. Eng. 17 (1991) 972, doi:10.1109/32.92917). */
#ifndef MURK_SOURCE_DOME_TABLE_H
#define MURK_SOURCE_DOME_TABLE_H

#include "base/status.h"
#include "source/dome.h"

/* Cells along each axis: at most 1.4 degrees wide, so that irradiances of every
 * CIE type are right to 4e-4. */
#define MURK_DOME_CELLS 128

typedef struct murk_dome_table murk_dome_table;

/* Creates the table for a face with unit vector `outward` from the face to the
 * sky. The caller destroys *out. Fails at `where` with MURK_BAD_VALUE if the
 * radiance is negative or not finite at a node of the table, or with
 * MURK_NO_MEMORY. */
murk_status murk_dome_table_create(murk_dome_table **out, const murk_dome *dome,
                                   murk_vec3 outward, const char *where,
                                   murk_error *err);
void murk_dome_table_destroy(murk_dome_table *table); /* NULL is fine */

/* The integral of relative radiance times cosine over the visible sky: 0 for a
 * face that looks straight down. */
double murk_dome_table_irradiance(const murk_dome_table *table);

/* Draws a unit direction that points from the face to the sky; u has four
 * uniform numbers in (0, 1). murk_dome_table_irradiance() must be above 0. */
murk_vec3 murk_dome_table_draw(const murk_dome_table *table, const double u[4]);

#endif
