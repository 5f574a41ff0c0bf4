/* Distance between a mounted sensor and all surfaces but the one that carries
 * it (murk_surfaces_near_mount()). For use inside src/geometry only. */
#ifndef MURK_GEOMETRY_MOUNT_CLEARANCE_H
#define MURK_GEOMETRY_MOUNT_CLEARANCE_H

#include "geometry/mount_sites.h"
#include "geometry/soup.h"

typedef struct murk_mount_clearance {
    murk_vec3 site; /* relative to the anchor of the soup */
    murk_vec3 normal;
    double above_m, slack_m;
} murk_mount_clearance;

/* Distance from `point` to the part of a face or sphere that does not belong to
 * the surface that carries the site; INFINITY if there is no such part.
 * mount_clearance.c states what belongs to that surface. */
double murk_mount_clearance_to_face(const murk_mount_clearance *clearance,
                                    const murk_triangle *face, murk_vec3 point);
double murk_mount_clearance_to_sphere(const murk_mount_clearance *clearance,
                                      const murk_stored_sphere *sphere,
                                      murk_vec3 point);

#endif
