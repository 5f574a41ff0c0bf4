/* The way of light between two points on either side of a plane that parts two
 * indices of refraction. Internal to the room.
 *
 * By Fermat there is always exactly one: the optical length n1 |s - x| + n2 |x
 * - p| is strictly convex in the point x of the plane. So nothing between two
 * points is ever totally reflected at a plane without end; light is where the
 * point of crossing lies beyond the end of a face.
 *
 * The apparent distance is that at which, without the plane and in the
 * sensor's own index, the photon's surroundings would fill as much solid angle
 * at the sensor: the square root of the product of the bundle's two spreads,
 *     sagittal     d1 + d2 n1/n2,
 *     tangential   d1 cos2/cos1 + d2 (n1/n2) cos1/cos2,
 * which straight through the plane is the apparent depth d1 + d2 n1/n2. Seen
 * from the other end it is n2/n1 times that (conservation of etendue).
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 3.3.3 (Fermat),
 * 4.6 (astigmatic pencils); the spreads are Coddington's equations for a
 * surface without curvature. */
#ifndef MURK_SENSING_SNELL_H
#define MURK_SENSING_SNELL_H

#include "base/vector.h"

#include <stdbool.h>

typedef struct murk_interface_plane {
    murk_vec3 point, normal; /* unit, to either side */
} murk_interface_plane;

typedef struct murk_snell {
    murk_vec3 crossing;
    double leg_m[2];      /* sensor to crossing, crossing to photon */
    double cosine[2];     /* of the angles to the normal, both above 0 */
    double transmittance; /* 1 - Fresnel's reflectance, unpolarised; the same
                             from both ends */
    double apparent_m;    /* as the sensor sees it */
} murk_snell;

/* False when the two do not lie on different sides of the plane, or a number
 * is not finite. n: both indices, sensor's first, different, > 0. */
bool murk_snell_path(murk_vec3 sensor, murk_vec3 photon,
                     const murk_interface_plane *plane, const double n[2],
                     murk_snell *path);

/* What lies farther [m] from a sensor at this height over the plane than that
 * appears farther than range_m through it. Where rays graze, light spreads
 * little and things appear near however far they are, so it can be many times
 * the range. */
double murk_snell_reach(double range_m, double height_m, const double n[2]);

#endif
