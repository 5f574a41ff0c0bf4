/* Straight segments through free space, and distances of points to surfaces:
 * the tests of sites for sensors, of links between sensors, of deviations of
 * sensors, and of sightlines in exploration. For use inside src/sensing only.
 *
 * A ray aimed exactly at a seam of a mesh may slip through (one in 500, if a
 * vertex lies on another triangle's edge), and grids and walls at round
 * coordinates produce such rays. So a segment is open only if two more
 * segments, with the end `to` moved aside by half of tolerance_m, are open as
 * well. */
#ifndef MURK_SENSING_FREE_SEGMENTS_H
#define MURK_SENSING_FREE_SEGMENTS_H

#include "geometry/mount_sites.h"

typedef enum murk_closeness {
    MURK_CLEAR_OF_SURFACES,
    MURK_BARELY_CLEAR, /* no surface within tolerance_m or the requested
                          clearance, one within twice tolerance_m */
    MURK_TOO_CLOSE,    /* no surface within tolerance_m, but one nearer than the
                          requested clearance */
    MURK_ON_SURFACE /* a surface lies within tolerance_m: the searches let such
                       a point see nothing, and lead no segment to it */
} murk_closeness;

/* The setting of the tests. */
typedef struct murk_free_segments {
    const murk_surfaces *surfaces;
    const murk_domain *domain;
    bool by_sheets; /* transmitting sheets block as well; false by default */
    double tolerance_m; /* murk_path_surface_tolerance_m() */
    murk_vec3 aside[2]; /* offsets by half a tolerance */
} murk_free_segments;

murk_free_segments murk_free_segments_of(const murk_surfaces *surfaces,
                                         const murk_domain *domain);

/* True if no surface blocks the segment, nor either of the two segments beside
 * it. Transmitting sheets block only with by_sheets. */
bool murk_free_segment_is_open(const murk_free_segments *segments,
                               murk_vec3 from, murk_vec3 to);

/* True if an unblocked segment along an axis leads from the point to a side of
 * the domain: all six sides, in a periodic domain top and bottom. */
bool murk_free_segment_leads_out(const murk_free_segments *segments,
                                 murk_vec3 point);

/* The distance class of a point: how near surfaces are. foot: if a sensor is
 * mounted, the mounting point, with the normal of the surface towards the
 * sensor; the test of the clearance ignores that surface. NULL: not mounted. A
 * clearance of up to twice the tolerance is not tested; of a larger one, only
 * surfaces nearer than clearance_m - tolerance_m count. */
murk_closeness murk_free_segments_closeness(const murk_free_segments *segments,
                                            murk_vec3 point, double clearance_m,
                                            const murk_mount_site *foot);

#endif
