/* Where sensors may stand: points of a grid, points listed, and places mounted
 * on surfaces, less those out of free space or in forbidden zones.
 *
 * A point of the grid is usable when it is reached and at least clearance_m
 * from any surface. Reached is what has an unblocked straight way to a lamp's
 * place (for distant light, along an axis to an open side of the domain: all
 * six, of a periodic domain top and bottom), and what unblocked steps between
 * the grid's neighbours along the axes then lead to, through points too close
 * as well. In a periodic domain ways go to the nearest image, and the grid's
 * ends along x and y are neighbours through the side. Transmitting sheets block
 * nothing. So the inside of a crate is dropped, also in open and badly wound
 * meshes.
 *
 * Listed points and mounts are reached when one unblocked straight way joins
 * them to a reached point of the grid (the nearest 1000 are tried, among the
 * 32768 points of the grid that are nearest), or to what reaches the grid. A
 * mount's way from its foot must be open, too, and the surface that it is on
 * does not count for clearance (geometry/mount_sites.h).
 *
 * Solids block ways as they block sightlines, but not out of a lamp: one that
 * stands in a solid of transmitting material, or in its hollow, counts from
 * just outside too, where six fixed ways leave it.
 *
 * A point within rounding of a surface (2^-18 of the domain's largest
 * coordinate; more where surfaces are larger than the domain) sees nothing: it
 * is dropped as too close and leads nowhere. */
#ifndef MURK_SENSING_CANDIDATES_H
#define MURK_SENSING_CANDIDATES_H

#include "base/status.h"
#include "base/vector.h"
#include "geometry/mount_sites.h"
#include "geometry/surfaces.h"
#include "geometry/zones.h"

#include <stddef.h>
#include <stdint.h>

typedef struct murk_candidate_grid {
    murk_vec3 min, max; /* first and last point along each axis */
    size_t size[3];     /* points along each axis, >= 1; 1: in the middle */
    double clearance_m;
} murk_candidate_grid;

/* In the middles of about `points` equal cells of the box, as nearly cubes as
 * it allows; no clearance. */
murk_candidate_grid murk_candidate_grid_over(const murk_box *box,
                                             size_t points);

/* Where the grid has its point `index`, below the product of sizes; x fastest,
 * then y, z. */
murk_vec3 murk_candidate_grid_point(const murk_candidate_grid *grid,
                                    size_t index);

/* Where free space is entered from. */
typedef struct murk_reach {
    const murk_vec3 *lamps; /* [n_lamps] points from which light starts. One on
                               a surface counts for both its sides: move it
                               off to the side that is lit, where known */
    size_t n_lamps;
    bool from_sides; /* distant light: from the domain's open sides, too */
    murk_domain domain;
} murk_reach;

/* Feet with a sensor on either side of each, as far as its normal allows. */
typedef struct murk_candidate_mount {
    const murk_mount_site *foot; /* [feet] */
    size_t feet;
    double offset_m;       /* along the normal, > 0 */
    double min_up, max_up; /* of normal.z: -1 and 1 take all */
} murk_candidate_mount;

/* What is asked for. */
typedef struct murk_candidate_desc {
    murk_candidate_grid grid; /* its clearance_m is everyone's */
    bool is_laid;             /* the grid carries reach only: no candidates */
    const murk_vec3 *point;   /* [points] in the domain */
    size_t points;
    const murk_candidate_mount *mount; /* [mounts] */
    size_t mounts;
    const murk_zones *avoid;  /* in none of these; NULL: no such zones */
    const murk_zones *within; /* in one of these; NULL: anywhere */
} murk_candidate_desc;

#define MURK_CANDIDATES_MAX 10000000

typedef enum murk_candidate_kind {
    MURK_CANDIDATE_GRID,
    MURK_CANDIDATE_POINT,
    MURK_CANDIDATE_MOUNT
} murk_candidate_kind;

/* Order: the grid (x fastest, then y, z), points, mounts; of a foot first the
 * side that its normal names. Each is counted once in `asked`, and once in
 * `usable` or by the first cause that dropped it: duplicates, forbidden,
 * too_close or unreached. */
typedef struct murk_candidates {
    size_t asked;
    size_t usable;
    size_t doubtful; /* dropped, though a diagonal step would have reached them,
                        or kept, though within rounding of a surface */
    size_t duplicates;   /* within rounding of one asked before */
    size_t forbidden;    /* by zones */
    size_t too_close;    /* dropped for clearance */
    size_t unreached;    /* dropped for reach */
    murk_vec3 *position; /* [usable] */
    murk_vec3 *normal;   /* [usable] of mounts, unit, out of the wall; zero for
                            what stands free; NULL: no mounts were asked */
    uint8_t *kind;       /* [usable] murk_candidate_kind */
} murk_candidates;

/* *out is the caller's: murk_candidates_destroy(). Fails with MURK_BAD_VALUE
 * at `where`: no or over MURK_CANDIDATES_MAX points, a point outside the
 * domain, a negative clearance, an offset lost in rounding, or no point usable
 * (the message counts why). */
murk_status murk_candidates_create(murk_candidates **out,
                                   const murk_candidate_desc *desc,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err);
void murk_candidates_destroy(murk_candidates *candidates); /* NULL is fine */

#endif
