/* The path of light between two points on either side of a plane between two
 * refractive indices. For use inside src/sensing only.
 *
 * By Fermat's principle there is exactly one path: the optical length n1 |s -
 * x| + n2 |x - p| is strictly convex in the point x of the plane. s is the
 * sensor in the index n1, p the photon in the index n2; d1 and d2 are the
 * lengths of both parts of the path, cos1 and cos2 the cosines of their angles
 * to the normal. So nothing between two points is totally reflected at an
 * infinite plane; no light arrives if the crossing lies beyond the edge of a
 * face.
 *
 * The apparent distance is the distance at which, without the plane and in the
 * sensor's index, the surroundings of the photon would fill the same solid
 * angle at the sensor: the square root of the product of the two spreads of a
 * bundle,
 *
 *     sagittal     d1 + d2 n1/n2,
 *     tangential   d1 cos2/cos1 + d2 (n1/n2) cos1/cos2.
 *
 * At normal incidence this is the apparent depth d1 + d2 n1/n2. Seen from the
 * other end the apparent distance is n2/n1 times that (conservation of
 * etendue).
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 3.3.3 (Fermat),
 * 4.6 (astigmatic pencils); the spreads are Coddington's equations for a
 * surface without curvature. */
#ifndef MURK_SENSING_SNELL_H
#define MURK_SENSING_SNELL_H

#include "base/vector.h"

#include <stdbool.h>

typedef struct murk_interface_plane {
    murk_vec3 point, normal; /* unit normal, to either side */
} murk_interface_plane;

typedef struct murk_snell {
    murk_vec3 crossing;
    double length_m[2];   /* sensor to crossing, crossing to photon */
    double cosine[2];     /* of the angles to the normal, > 0 */
    double transmittance; /* 1 - Fresnel reflectance, unpolarised; the same from
                             both ends */
    double apparent_m;    /* distance at which the sensor sees the photon,
                             judged by brightness */
} murk_snell;

/* Computes the path. False if the points do not lie on different sides of the
 * plane, or if a number is not finite. n: both indices, the sensor's first,
 * different, > 0. */
bool murk_snell_path(murk_vec3 sensor, murk_vec3 photon,
                     const murk_interface_plane *plane, const double n[2],
                     murk_snell *path);

/* The distance [m] beyond which everything appears farther than range_m through
 * the plane, for a sensor at this height over the plane. At grazing angles
 * light spreads little and objects appear near at any distance, so the result
 * can be many times the range. */
double murk_snell_reach(double range_m, double height_m, const double n[2]);

#endif
