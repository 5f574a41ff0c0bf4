/* The sky as a plane opening sees it: a table from which directions are drawn
 * by radiance times the cosine at the opening. Private to this room.
 *
 * On the opening's unit disc (Nusselt's analogue: a direction's projection onto
 * the plane) that cosine is a constant. x runs along the horizontal in the
 * opening's plane, a = y / sqrt(1 - x^2) across it, from the horizon to the
 * plane itself: so the sky that the opening sees is a rectangle in x and a,
 * however it is tilted, and has no edge inside. The table holds radiance times
 * sqrt(1 - x^2) at nodes that are even in angle, and is bilinear between them:
 * that function, and not the sky behind it, is what is drawn from, exactly.
 * Cells are chosen by Walker's alias method (Vose, IEEE Trans. Softw. Eng. 17
 * (1991) 972, doi:10.1109/32.92917). */
#ifndef MURK_SOURCE_DOME_TABLE_H
#define MURK_SOURCE_DOME_TABLE_H

#include "base/status.h"
#include "source/dome.h"

/* Cells along each axis. Even in angle they are at most 1.4 degrees wide, so
 * that irradiances of every type are right to some 2e-4. */
#define MURK_DOME_CELLS 128

typedef struct murk_dome_table murk_dome_table;

/* outward: unit, from the opening to the sky. *out is the caller's. Fails where
 * the radiance is negative or not finite anywhere. */
murk_status murk_dome_table_create(murk_dome_table **out, const murk_dome *dome,
                                   murk_vec3 outward, const char *where,
                                   murk_error *err);
void murk_dome_table_destroy(murk_dome_table *table); /* NULL is fine */

/* Integral of relative radiance times cosine over what the opening sees: 0
 * where it faces straight down. */
double murk_dome_table_irradiance(const murk_dome_table *table);

/* A direction from the opening to the sky, unit, for four uniform numbers. The
 * irradiance must be above 0. */
murk_vec3 murk_dome_table_draw(const murk_dome_table *table, const double u[4]);

#endif
