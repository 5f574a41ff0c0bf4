/* Candidate sites of sensors: points of a grid, listed points, and sites
 * mounted on surfaces, without those outside of free space, too close to a
 * surface, forbidden by zones, or listed twice. Zones forbid a site that lies
 * in a zone of the request's `avoid`, or in none of those of `within`.
 *
 * A point of the grid is usable if it is reached, at least clearance_m from any
 * surface, and not forbidden. A point is reached if an unblocked straight
 * segment joins it to a lamp (for distant light, a segment along an axis to an
 * open side of the domain: all six sides, in a periodic domain top and bottom),
 * or if unblocked steps between neighbours of the grid lead to it from a
 * reached point. Steps may pass points that are too close to a surface, and
 * skip points on a surface. In a periodic domain segments go to the nearest
 * image, and the first and last points along x and y are neighbours through the
 * side. Transmitting sheets do not block. So points inside a closed crate are
 * dropped, whatever the winding of the triangles.
 *
 * Listed points and mounts are reached if one unblocked straight segment joins
 * each of them to a reached point of the grid (up to 1000 reached points among
 * the some 32768 nearest points of the grid are tried), to a lamp, or to an
 * open side. For a mount the segment from the mounting point must be open as
 * well, and the surface that carries the mount does not count for clearance
 * (geometry/mount_sites.h).
 *
 * Solids block segments as they block sightlines, but not for a lamp inside: a
 * lamp in a solid of transmitting material, or in the hollow of one, also
 * counts from just outside, in six fixed directions.
 *
 * A point within rounding of a surface (2^-18 of the domain's largest
 * coordinate; more if surfaces are larger than the domain) sees nothing: it is
 * dropped as too close, unless a zone forbids it first, and no step leads to
 * it. */
#ifndef MURK_SENSING_CANDIDATES_H
#define MURK_SENSING_CANDIDATES_H

#include "sensing/candidate_request.h"

typedef enum murk_candidate_kind {
    MURK_CANDIDATE_GRID,
    MURK_CANDIDATE_POINT,
    MURK_CANDIDATE_MOUNT
} murk_candidate_kind;

/* Order of the arrays: the points of the grid (x fastest, then y, z), the
 * listed points, the mounts; of a mounting point first the side of the normal.
 * Sides of mounting points that the limits on the normal exclude are not
 * requested. Each requested site is counted once in `asked`, and once in
 * `usable` or under one cause. The first of these causes that applies counts: a
 * duplicate, outside of the domain (unreached), forbidden, on a surface
 * (too_close), unreached, nearer than the clearance (too_close). Points of the
 * grid are never duplicates. */
typedef struct murk_candidates {
    size_t asked;
    size_t usable;
    size_t doubtful;   /* grid points dropped although a diagonal step would
                          reach them, and usable sites within twice the rounding
                          distance of a surface */
    size_t duplicates; /* within the rounding distance (2^-18, see above) of a
                          candidate of the grid or of an earlier listed site */
    size_t forbidden;  /* excluded by the zones */
    size_t too_close;  /* on a surface, or reached but closer to a surface than
                          the clearance */
    size_t unreached;  /* not reached */
    murk_vec3 *position; /* [usable] */
    murk_vec3
        *normal; /* [usable] unit normal of mounts, out of the surface; zero for
                    free sites; NULL if no mounts were requested */
    uint8_t *kind; /* [usable] murk_candidate_kind */
} murk_candidates;

/* The caller destroys *out with murk_candidates_destroy(). Fails with
 * MURK_BAD_VALUE at `where`: no sites or more than MURK_CANDIDATES_MAX, a grid
 * that murk_candidate_desc_check() refuses, a grid point or listed point
 * outside the domain, a clearance that is negative or not finite, an offset
 * lost in rounding, or no usable site (the message counts the causes, or names
 * the precision of the surfaces if that is coarser than a millimetre and than
 * the clearance). Fails also with MURK_NO_MEMORY or MURK_INTERRUPTED. After a
 * failure *out is unchanged. */
murk_status murk_candidates_create(murk_candidates **out,
                                   const murk_candidate_desc *desc,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err);
void murk_candidates_destroy(murk_candidates *candidates); /* accepts NULL */

#endif
