/* What a sensor sees of the photon maps.
 *
 * V = [within range, in the field of view, in a band of the type's, arriving as
 * it asks][surface photon: normal . (sensor - photon) > 0][segment open];
 * clarity = V * transmittance of sheets and media along the segment, in
 * the photon's band, rounded to 1/65535: what rounds to 0 is not seen. With a
 * threshold, clarity is full from there on, and below it is none. Photons
 * are numbered surface map first, then volume map, each in the map's own
 * order. Immutable but for its counters.
 *
 * A segment is open when no surface but a thin sheet is in the way and the
 * index of refraction does not change on it.
 *
 * Grazing is not seen. "> 0" means above what storing a photon may move it
 * by: 2^-20 of the domain's largest coordinate, and MURK_DIRECTION_ERROR_RAD
 * where its normal is not along an axis (axes are stored exactly). So a sensor
 * in the plane of a wall sees nothing of it; the cost is the sliver within that
 * height or angle of the plane. */
#ifndef MURK_SENSING_SIGHT_H
#define MURK_SENSING_SIGHT_H

#include "base/stats.h"
#include "base/status.h"
#include "base/tally.h"
#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "photonmap/map.h"
#include "placement/problem.h"
#include "sensing/interest.h"
#include "sensing/power_settings.h"
#include "sensing/sensor.h"

typedef enum murk_visibility {
    MURK_VISIBILITY_RAY,   /* shadow rays: the default */
    MURK_VISIBILITY_NORMAL /* the paper's literal text: the normal test in place
                              of shadow rays. Surfaces, sheets too, hide
                              nothing; media still attenuate */
} murk_visibility;

/* Balanced: the mean of the two maps' fractions (an empty map's half goes to
 * the other; a map without power counts as empty); else (a X_S + b X_V) / (a
 * Y_S + b Y_V). */
typedef struct murk_map_weights {
    bool balanced;
    double surface, volume; /* a, b >= 0, not both 0 */
} murk_map_weights;

typedef struct murk_sight_desc {
    const murk_surfaces *surfaces;
    const murk_media *media;
    const murk_boundary_meshes
        *boundary_meshes; /* of the regions that are meshes; NULL: none */
    murk_domain domain;   /* periodic: sightlines go to the nearest image */
    const murk_photon_map *surface_map, *volume_map; /* either may be empty */
    uint64_t photons_emitted; /* all emitted, those that stored nothing too */
    const murk_sensor_type *type; /* [types], copied */
    size_t types;
    murk_vec3 north; /* level, of length 1; zero: +y */
    murk_visibility visibility;
    bool through_sheets; /* through: thin; false: block */
    bool refracts; /* through: refract, with MURK_VISIBILITY_RAY: sightlines
                      bend at one flat boundary */
    murk_map_weights weights;
    const murk_interest *interest; /* NULL: no regions of interest */
    murk_detection detection;  /* how clearness follows from transmittance */
    double threshold;          /* of transmittance, 0..1; for modes that have
                                  one */
    murk_combining combining;  /* of several sensors' views */
    unsigned redundancy;       /* views of a photon that count, 0 or 1: one;
                                  up to MURK_REDUNDANCY_MAX, and one with
                                  independent chances */
    unsigned at_least;         /* coverage also says what so many sensors
                                  or more see; 0: does not; up to
                                  MURK_REDUNDANCY_MAX */
    murk_power_settings power; /* by what is taken up, with combining
                              INDEPENDENT: clarity is the chance of
                              sensing/power.h. Not with a threshold */
    unsigned threads;
    const char *where; /* of the wish, for messages; NULL: none */
} murk_sight_desc;

typedef struct murk_sight murk_sight;

/* Borrows all that desc points to. Fails with MURK_BAD_VALUE (types, weights,
 * threshold, redundancy),
 * MURK_BAD_FILE (a record that no run can have stored: power negative or not
 * finite, place not finite, band or emitted index out of range),
 * MURK_RUN_FAILED (no photon has weight: at desc->where) or MURK_NO_MEMORY: 4
 * to 10 bytes a photon and thread are set aside for looks. */
murk_status murk_sight_create(murk_sight **out, const murk_sight_desc *desc,
                              murk_error *err);
void murk_sight_destroy(murk_sight *sight); /* NULL is fine */

/* Gives the sight its maps, which it then destroys with itself. */
void murk_sight_own_maps(murk_sight *sight, murk_photon_map *surface,
                         murk_photon_map *volume);

/* What a sensor sees; valid until the worker's next look. worker in [0,
 * threads), pose->type below types. */
void murk_sight_row(murk_sight *sight, unsigned worker, const murk_pose *pose,
                    murk_sparse_row *row);

/* The placement problem over these candidates (borrowed, as is the sight). */
typedef struct murk_sight_problem {
    murk_problem problem;
    murk_sight *sight;
    const murk_pose *pose;
} murk_sight_problem;
void murk_sight_problem_init(murk_sight_problem *out, murk_sight *sight,
                             const murk_pose *pose, size_t n);

/* Whole-number weights of the photons [surface + volume], as the plan counts
 * them: in proportion to power (times the factor of its regions of interest)
 * within a map, rounded; equal powers weigh the
 * same. Rounding moves a weight by half a unit, less than 2^-20 of its map's
 * mean weight up to 2^26 records, unless so few records carry a map's power
 * that theirs meet the end of 32 bits. Their sum, times the redundancy (or
 * at_least, if more), is below 2^47. */
const uint32_t *murk_sight_weights(const murk_sight *sight);
size_t murk_sight_photons(const murk_sight *sight);

/* Photon i, by its number in looks. */
const murk_photon *murk_sight_photon(const murk_sight *sight, size_t i);

/* The regions of interest that photon i lies in, and its power times their
 * factor. */
uint64_t murk_sight_regions(const murk_sight *sight, size_t i);
double murk_sight_power_w(const murk_sight *sight, size_t i);

/* What it was made from. */
const murk_sight_desc *murk_sight_described(const murk_sight *sight);

/* Photons that are judged by the power of fewer than MURK_POWER_FEW others; 0
 * where power is not what judges. */
size_t murk_sight_power_few(const murk_sight *sight);

/* Counters since creation: looks (each asks both maps), and sightlines tested
 * against surfaces. */
uint64_t murk_sight_queries(const murk_sight *sight);
uint64_t murk_sight_shadow_rays(const murk_sight *sight);

/* Sightlines lost to boundaries where the index changes: those that no surface
 * blocks but a boundary does, and where sightlines bend those that have no way
 * across one flat boundary; those of them that are totally reflected apart. */
uint64_t murk_sight_blocked_by_interfaces(const murk_sight *sight);
uint64_t murk_sight_totally_reflected(const murk_sight *sight);

/* How much of a region of interest is in view: what the total would be if
 * nothing else were there and every region weighed 1. NaN where no photon with
 * power lies in it. */
typedef struct murk_region_coverage {
    size_t photons; /* stored in it, in both maps */
    murk_estimate coverage;
} murk_region_coverage;

/* What one map has in the total. */
typedef struct murk_map_share {
    size_t photons;        /* records */
    double weight;         /* of the total, 0..1; both maps' together 1, so
                              total = sum weight * the map's fraction */
    double standard_error; /* of the total, from this map's records alone */
} murk_map_share;

/* Coverage of sensors pose[n], measured on this sight's maps. */
typedef struct murk_coverage_result {
    murk_estimate total;   /* error by emitted photon */
    murk_estimate surface; /* by power times regions' factors, whatever the
                              maps' weights; NaN where the map is empty, or
                              without power */
    murk_estimate volume;
    murk_map_share map[2];    /* surface, volume */
    double sum_of_views;      /* the paper's eq. (1) as printed: photons seen
                                 twice count twice, whatever the redundancy */
    double *covers;           /* [n] alone; with redundancy k at most 1 / k */
    double *only_it_covers;   /* [n] total less total without it */
    double *seen_by_at_least; /* [n]: by 1, 2, .., n sensors, of the balanced
                                 weight, seen at all counting whole */
    murk_estimate at_least;   /* seen_by_at_least of the sight's at_least,
                                 with its error; NaN without */
    murk_region_coverage *region; /* [interest->n]; NULL without */
} murk_coverage_result;

/* All but surface and volume are of the same whole-number weights that plans
 * count, so total is exactly a plan's value / whole. Errors: the ratio
 * estimator over all emitted photons, each with all its records of both maps
 * together; for `balanced` the residuals of the two ratios are added photon by
 * photon (the maps' records of one path are correlated). Fails with
 * MURK_BAD_VALUE when a sensor is outside the domain, MURK_NO_MEMORY (some 26
 * bytes a photon, 6 more for each further view that counts) or
 * MURK_INTERRUPTED. With independent chances each sensor looks twice. Release
 * with murk_coverage_result_release(). */
murk_status murk_coverage_result_measure(murk_coverage_result *out,
                                         murk_sight *sight,
                                         const murk_pose *pose, size_t n,
                                         murk_error *err);
void murk_coverage_result_release(murk_coverage_result *coverage);

#endif
