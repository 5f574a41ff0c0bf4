/* Straight ways through free space, and how near points are to surfaces: what
 * decides where a sensor may stand. Internal to the room.
 *
 * A ray aimed exactly at a seam of a mesh may slip through (one in 500, where a
 * vertex lies on another triangle's edge), and grids and walls at round
 * coordinates do aim so. A way is therefore open only when two more, their far
 * end moved aside by half a hair, are open too. */
#ifndef MURK_SENSING_WAYS_H
#define MURK_SENSING_WAYS_H

#include "geometry/mount_sites.h"
#include "sensing/candidates.h"

typedef enum murk_closeness {
    MURK_CLEAR_OF_SURFACES,
    MURK_BARELY_CLEAR, /* nothing within a hair, something within two */
    MURK_TOO_CLOSE,    /* for the clearance asked for */
    MURK_ON_SURFACE    /* within a hair: sees nothing, and no way leads there */
} murk_closeness;

typedef struct murk_ways {
    const murk_surfaces *surfaces;
    const murk_domain *domain;
    bool by_sheets;     /* sheets that transmit block, too; false as made */
    double tolerance_m; /* murk_path_surface_tolerance_m() */
    murk_vec3 aside[2]; /* half a hair */
} murk_ways;

murk_ways murk_ways_of(const murk_surfaces *surfaces,
                       const murk_domain *domain);

bool murk_way_is_open(const murk_ways *ways, murk_vec3 from, murk_vec3 to);

/* Along an axis to an open side of the domain: all six, of a periodic domain
 * top and bottom. */
bool murk_way_leads_out(const murk_ways *ways, murk_vec3 point);

/* foot: what the point is mounted on and does not count for clearance, its
 * normal towards the point; NULL: nothing. */
murk_closeness murk_ways_closeness(const murk_ways *ways, murk_vec3 point,
                                   double clearance_m,
                                   const murk_mount_site *foot);

#endif
