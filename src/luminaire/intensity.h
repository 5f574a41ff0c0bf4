/* Luminous intensity of a luminaire over directions: the table of a photometric
 * file, with evaluation, integral and exact sampling.
 *
 * Between the tabulated directions the intensity is bilinear in the two angles
 * of the table (degrees or radians alike); beyond the table it is 0. Flux,
 * lookup and sampling all belong to this one function: the flux is its integral
 * over the solid angle in closed form, and directions are drawn with exactly
 * the density intensity / flux, by inversion of the marginal distribution of
 * one angle and of the conditional distribution of the other.
 *
 * Directions are those of the lamp: x points to C = 0, y to C = 90 degrees, and
 * -z to gamma = 0, the photometric zero, so that the direction of (gamma, C) is
 * (sin gamma cos C, sin gamma sin C, -cos gamma). Tables of photometric types A
 * and B have a vertical angle V and a horizontal angle H, both 0 at -z: V rises
 * towards x, H towards -y (clockwise, seen from behind the photometric zero
 * with x up; IES LM-63). Type A: V is the latitude and H the longitude about x;
 * type B: H is the latitude and V the longitude about y. Immutable: any number
 * of threads may use a table. */
#ifndef MURK_LUMINAIRE_INTENSITY_H
#define MURK_LUMINAIRE_INTENSITY_H

#include "base/status.h"
#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Largest number of values in a table after symmetries are unfolded. */
#define MURK_INTENSITY_VALUES_MAX 4000000

/* Photometric types of goniometers (IES LM-75), numbered as LM-63 does. */
typedef enum murk_goniometer {
    MURK_GONIOMETER_C = 1,
    MURK_GONIOMETER_B = 2,
    MURK_GONIOMETER_A = 3
} murk_goniometer;

/* A table with symmetries unfolded. The value at (vertical v, horizontal h) is
 * scale * candela[plane[h] * verticals + v]. */
typedef struct murk_intensity_grid {
    murk_goniometer type;
    size_t verticals, horizontals; /* 2 or more each */
    const double *vertical_deg;    /* rising; type C: gamma, 0..180; types A and
                                    * B: V, -90..90 */
    const double *horizontal_deg;  /* rising; type C: C, one full turn from any
                                    * angle; types A and B: H, -90..90 */
    const size_t *plane;           /* [horizontals] */
    const double *candela;         /* 0 or more */
    double scale;                  /* above 0 */
} murk_intensity_grid;

typedef struct murk_intensity murk_intensity;

/* The caller owns *out. Fails at `where` with MURK_BAD_FILE if the integral is
 * 0 or not finite, and with MURK_NO_MEMORY. */
murk_status murk_intensity_create(murk_intensity **out,
                                  const murk_intensity_grid *grid,
                                  const char *where, murk_error *err);

/* Adds an owner, who also calls murk_intensity_destroy(); NULL is fine. */
murk_intensity *murk_intensity_share(const murk_intensity *table);
void murk_intensity_destroy(murk_intensity *table); /* NULL is fine */

/* A checksum of all angles and intensities: equal tables have equal ones. */
void murk_intensity_checksum(const murk_intensity *table, uint64_t out[2]);

/* The integral over the solid angle [lm]. */
double murk_intensity_lumens(const murk_intensity *table);
/* True if at least half of the flux has z <= 0, towards photometric zero. */
bool murk_intensity_points_to_zero(const murk_intensity *table);

double murk_intensity_max_candela(const murk_intensity *table);

/* The angles of the table, symmetries unfolded: of type C all planes of one
 * full turn. The arrays belong to the table. */
typedef struct murk_intensity_angles {
    size_t verticals, horizontals;
    const double *vertical_deg, *horizontal_deg;
} murk_intensity_angles;
murk_intensity_angles murk_intensity_angles_of(const murk_intensity *table);

/* The intensity [cd] in angles of the table [degrees]: exactly the value of the
 * file at tabulated angles. For type C any horizontal angle is accepted. */
double murk_intensity_at_angles(const murk_intensity *table,
                                double vertical_deg, double horizontal_deg);

/* The intensity [cd] in a unit direction of the lamp. */
double murk_intensity_candela(const murk_intensity *table, murk_vec3 direction);

/* Draws a unit direction with the density murk_intensity_candela() /
 * murk_intensity_lumens() per steradian from two numbers in (0, 1). */
murk_vec3 murk_intensity_draw(const murk_intensity *table, double u_polar,
                              double u_azimuth);

#endif
