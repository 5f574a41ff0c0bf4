/* A request for candidate sites of sensors: a grid, listed points and mounting
 * points on surfaces, and the places from which light starts
 * (sensing/candidates.h). */
#ifndef MURK_SENSING_CANDIDATE_REQUEST_H
#define MURK_SENSING_CANDIDATE_REQUEST_H

#include "base/status.h"
#include "base/vector.h"
#include "geometry/mount_sites.h"
#include "geometry/surfaces.h"
#include "geometry/zones.h"

#include <stddef.h>
#include <stdint.h>

/* A limit on memory and time: ten million candidates. */
#define MURK_CANDIDATES_MAX 10000000

typedef struct murk_candidate_grid {
    murk_vec3 min, max; /* first and last point along each axis */
    size_t size[3]; /* points along each axis, >= 1; a single point lies in the
                       middle between min and max */
    double clearance_m;
} murk_candidate_grid;

/* A grid with its points in the middles of equal cells of the box. The edges of
 * a cell are near the edge of a cube of the volume of the box over `points`,
 * but along each axis there are at least 1 and at most `points` cells. So there
 * are about `points` cells, and more if an edge of the box is shorter than the
 * edge of the cube. The clearance is 0. The box has a volume above 0, and
 * points >= 1. */
murk_candidate_grid murk_candidate_grid_fill(const murk_box *box,
                                             size_t points);

/* The position of grid point `index`, which is below the product of the sizes.
 * Order: x fastest, then y, z. */
murk_vec3 murk_candidate_grid_point(const murk_candidate_grid *grid,
                                    size_t index);

/* The places from which free space is reached. */
typedef struct murk_reach {
    const murk_vec3 *lamps; /* [n_lamps] points from which light starts. A point
                               on a surface counts for both sides, unless the
                               caller moves it off to the lit side */
    size_t n_lamps;
    bool from_sides; /* distant light: also from the domain's open sides
                        (murk_free_segment_leads_out() in
                        sensing/free_segments.h) */
    murk_domain domain;
} murk_reach;

/* Mounting points on surfaces. A sensor can be on either side of each, as far
 * as the limits on the normal allow. */
typedef struct murk_candidate_mount {
    const murk_mount_site *site; /* [sites] */
    size_t sites;
    double offset_m;       /* distance from the surface along the normal, > 0 */
    double min_up, max_up; /* limits of normal.z, both included: -1 and 1 allow
                              all */
} murk_candidate_mount;

/* The request for candidates. */
typedef struct murk_candidate_desc {
    murk_candidate_grid
        grid; /* the clearance_m of the grid holds for all candidates */
    bool is_reach_grid;     /* the grid only serves to find free space
                               (sensing/candidates.h) and gives no candidates */
    const murk_vec3 *point; /* [points] inside the domain */
    size_t points;
    const murk_candidate_mount *mount; /* [mounts] */
    size_t mounts;
    const murk_zones
        *avoid; /* candidates lie in none of these zones; NULL: no such zones */
    const murk_zones
        *within; /* candidates lie in one of these zones; NULL: anywhere */
} murk_candidate_desc;

/* Checks the clearance, the grid, the listed points and the offsets of the
 * mounts; fails with MURK_BAD_VALUE at `where`. The total number of candidates
 * is checked by murk_candidates_create(). */
murk_status murk_candidate_desc_check(const murk_candidate_desc *desc,
                                      const murk_surfaces *surfaces,
                                      const murk_domain *domain,
                                      const char *where, murk_error *err);

/* True if the zones of the request exclude the point. */
bool murk_candidate_is_forbidden(const murk_candidate_desc *desc,
                                 murk_vec3 point);

#endif
