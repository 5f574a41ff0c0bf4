/* The list of candidate sites while it is built. For use inside src/geometry
 * only. */
#ifndef MURK_GEOMETRY_MOUNT_BUILDER_H
#define MURK_GEOMETRY_MOUNT_BUILDER_H

#include "base/cells.h"
#include "geometry/mount_sites.h"
#include "geometry/ray_scene.h"

/* As fractions of the spacing: the smallest distance between two sites of
 * one surface, and the longest side of the pieces that gaps are filled from.
 * The middle of a triangle is at most 2/3 of the longest side from any point
 * of it, so every place is within 3/4 + 2/3 * 1/2 = 1.1 spacings of a site. */
#define MURK_MOUNT_NEAREST 0.75
#define MURK_MOUNT_PIECE   0.5

typedef struct murk_mount_builder {
    const murk_surfaces *surfaces;
    const murk_mount_search *search;
    const char *where;
    murk_error *err;
    murk_status status; /* no more sites are accepted after a failure */
    double first[3];    /* first line of the lattice on each axis */
    double slack_m;     /* tolerance for rounding */
    double squares;     /* searched area in squares of the spacing */
    murk_cells *cells;
    murk_mount_site *site;
    size_t n, capacity;
} murk_mount_builder;

/* Adds a site unless the site is too close to another site of the surface, the
 * normal is out of the wanted range, the place is outside of the box by more
 * than rounding, or builder->status is a failure. The place is moved into the
 * box. A failure is stored in builder->status. */
void murk_mount_builder_offer(murk_mount_builder *builder, murk_vec3 place,
                              murk_vec3 normal);

/* Fails with MURK_BAD_VALUE and the message for more sites than allowed. */
murk_status murk_mount_builder_refuse(const murk_mount_builder *builder);

#endif
