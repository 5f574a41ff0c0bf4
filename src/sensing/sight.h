/* What a sensor sees of the photon maps.
 *
 * V = [within range][surface photon: normal . (sensor - photon) > 0][segment
 * open]; clarity = V * transmittance of sheets and media along the segment, in
 * the photon's band. Photons are numbered surface map first, then volume map,
 * each in the map's own order. Immutable but for its counters. */
#ifndef MURK_SENSING_SIGHT_H
#define MURK_SENSING_SIGHT_H

#include "base/stats.h"
#include "base/status.h"
#include "base/tally.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "photonmap/map.h"
#include "placement/problem.h"

typedef enum murk_visibility {
    MURK_VISIBILITY_RAY,   /* shadow rays: the default */
    MURK_VISIBILITY_NORMAL /* the paper's literal text: the normal test only */
} murk_visibility;

/* Balanced: the mean of the two maps' fractions (an empty map's half goes to
 * the other); else (a X_S + b X_V) / (a Y_S + b Y_V). */
typedef struct murk_map_weights {
    bool balanced;
    double surface, volume; /* a, b >= 0, not both 0 */
} murk_map_weights;

typedef struct murk_sight_desc {
    const murk_surfaces *surfaces;
    const murk_media *media;
    murk_domain domain; /* periodic: sightlines go to the nearest image */
    const murk_photon_map *surface_map, *volume_map; /* either may be empty */
    uint64_t photons_emitted; /* all emitted, those that stored nothing too */
    double range_m;
    murk_visibility visibility;
    bool through_sheets; /* through: thin; false: block */
    murk_map_weights weights;
    unsigned threads;
} murk_sight_desc;

typedef struct murk_sight murk_sight;

/* Borrows all that desc points to. */
murk_status murk_sight_create(murk_sight **out, const murk_sight_desc *desc,
                              murk_error *err);
void murk_sight_destroy(murk_sight *sight); /* NULL is fine */

/* What a sensor at `position` sees; valid until the worker's next look.
 * worker in [0, threads). */
void murk_sight_look(murk_sight *sight, unsigned worker, murk_vec3 position,
                     murk_look *look);

/* The placement problem over these candidates (borrowed, as is the sight). */
typedef struct murk_sight_problem {
    murk_problem problem;
    murk_sight *sight;
    const murk_vec3 *position;
} murk_sight_problem;
void murk_sight_problem_init(murk_sight_problem *out, murk_sight *sight,
                             const murk_vec3 *position, size_t n);

/* Whole-number weights of the photons [surface + volume], as the plan counts
 * them. */
const uint32_t *murk_sight_weights(const murk_sight *sight);
size_t murk_sight_photons(const murk_sight *sight);

/* Counters since creation. */
uint64_t murk_sight_queries(const murk_sight *sight);
uint64_t murk_sight_shadow_rays(const murk_sight *sight);

/* Coverage of sensors at `position` [n], measured on this sight's maps. */
typedef struct murk_coverage {
    murk_estimate total;   /* error by emitted photon */
    murk_estimate surface; /* NaN where the map is empty */
    murk_estimate volume;
    double sum_of_views;   /* the paper's eq. (1) as printed: photons seen
                              twice count twice */
    double *covers;        /* [n] alone */
    double *only_it_covers; /* [n] total less total without it */
    double *seen_by_at_least; /* [n]: by 1, 2, .., n sensors, of the balanced
                                 weight, seen at all counting whole */
} murk_coverage;

murk_status murk_coverage_measure(murk_coverage *out, murk_sight *sight,
                                  const murk_vec3 *position, size_t n,
                                  murk_error *err);
void murk_coverage_release(murk_coverage *coverage);

#endif
