/* A table of a patch of the sky as seen by a plane entry face, from which
 * directions are drawn in proportion to the cosine at the face. For use inside
 * src/source only.
 *
 * The patch is cut into cells of equal solid angle: 1.5 degrees wide for
 * patches of base/daylight_parts.h at the horizon, up to 5 degrees near the
 * zenith. In a cell the cosine is bilinear between the corners, where it is 0
 * behind the face. */
#ifndef MURK_SOURCE_PATCH_TABLE_H
#define MURK_SOURCE_PATCH_TABLE_H

#include "source/dome.h"

#define MURK_PATCH_CELLS 8 /* along each side of the patch */

typedef struct murk_patch_table {
    murk_sky_patch patch;
    murk_vec3 outward; /* unit vector from the face to the sky */
    double irradiance; /* integral of the cosine over the patch */
    double cosine[MURK_PATCH_CELLS + 1][MURK_PATCH_CELLS + 1]; /* [up][around]
                                                                * at corners */
    double end[MURK_PATCH_CELLS * MURK_PATCH_CELLS]; /* cumulative shares of the
                                                      * cells */
} murk_patch_table;

/* Fills the table; the patch must have a solid angle. */
void murk_patch_table_fill(murk_patch_table *out, const murk_sky_patch *patch,
                           murk_vec3 outward);

/* Draws a unit direction that points from the face to the sky, from three of
 * four uniform numbers in (0, 1). The irradiance must be above 0. */
murk_vec3 murk_patch_table_draw(const murk_patch_table *table,
                                const double u[4]);

/* Draws a number in (0, 1), from the uniform number u, with a density that is
 * linear and proportional to `from` at 0 and to `to` at 1. */
double murk_draw_slanted(double from, double to, double u);

/* The unit direction at two shares, 0..1, of the sine of the elevation and of
 * the azimuth. */
murk_vec3 murk_sky_patch_at(const murk_sky_patch *patch, double up,
                            double around);

/* The solid angle [sr]. */
double murk_sky_patch_sr(const murk_sky_patch *patch);

#endif
