/* Sight: which photons of the photon maps a sensor sees, and with which
 * clarity.
 *
 * Visibility V = [within range, in the field of view, in a band of the type,
 * travelling toward the sensor if the type asks for it][surface photon: normal
 * . (sensor - photon) > 0][segment open], with 1 for a bracket that is true and
 * 0 for one that is false; the segment is the straight line between sensor and
 * photon. The clarity is V times the transmittance of sheets and media along
 * the segment, in the photon's band, rounded to 1/65535; a photon whose clarity
 * rounds to 0 is not seen. With a
 * threshold the clarity is full if the transmittance is the threshold or more,
 * and else 0. Photons are numbered surface map first, then volume map, each in
 * the order of the map. A sight is immutable except for the counters and the
 * scratch buffers of the workers.
 *
 * A segment is open if it meets no surface (with `through_sheets`: none but
 * thin sheets), and the refractive index does not change along the segment,
 * unless `refracts` is set. With MURK_VISIBILITY_NORMAL every segment is open.
 * With detection by power the clarity is the detection probability
 * (sensing/power.h).
 *
 * Grazing photons are not seen. "> 0" means more than the possible error of
 * storage: 2^-20 of the domain's largest coordinate, and
 * MURK_DIRECTION_ERROR_RAD if the normal is not along an axis (axes are stored
 * exactly). So a sensor in the plane of a wall sees nothing of the wall; the
 * cost is that sensors within that height or angle of the plane do not see the
 * wall either. */
#ifndef MURK_SENSING_SIGHT_H
#define MURK_SENSING_SIGHT_H

#include "base/bands.h"
#include "base/box_list.h"
#include "base/stats.h"
#include "base/status.h"
#include "base/tally.h"
#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "photonmap/map.h"
#include "placement/problem.h"
#include "sensing/interest.h"
#include "sensing/sensor.h"

typedef enum murk_visibility {
    MURK_VISIBILITY_RAY,   /* shadow rays: the default */
    MURK_VISIBILITY_NORMAL /* no shadow rays: of surfaces only the normal of a
                              surface photon is tested. Surfaces and sheets hide
                              nothing; media attenuate */
} murk_visibility;

/* Weights of the two maps. Balanced: the mean of the fractions of both maps
 * (the half of an empty map goes to the other; a map without power counts as
 * empty). Otherwise (a X_S + b X_V) / (a Y_S + b Y_V), with X the covered and Y
 * the whole weight of a map. */
typedef struct murk_map_weights {
    bool balanced;
    double surface, volume; /* a, b >= 0, not both 0 */
} murk_map_weights;

/* With fewer photons in the estimate, the light at a place is estimated badly:
 * the relative standard error is 1 / sqrt(10 - 2), a third, or more. */
#define MURK_POWER_FEW 10

/* The stored light, and the number of emitted photons. */
typedef struct murk_power_light {
    const murk_photon_map *surface_map, *volume_map;
    uint64_t photons_emitted;
} murk_power_light;

/* Settings of detection by power (sensing/power.h). */
typedef struct murk_power_settings {
    double radius_m;   /* 0: detection is not by power; else a radius that
                          murk_power_check_radius() accepts */
    size_t neighbours; /* 0: the estimate uses all photons within radius_m.
                          Otherwise >= 2: the radius of the estimate is the
                          distance of the photon of this number, counted from
                          the nearest, but radius_m at most */
    double band_nm[MURK_BANDS_MAX];
    murk_power_light light; /* maps NULL: those of the sight */
} murk_power_settings;

/* Fails with MURK_BAD_VALUE at `where` unless the radius is above 0 and at most
 * 1e9 m, in a periodic domain at most half the shorter period. */
murk_status murk_power_check_radius(double radius_m, const murk_domain *domain,
                                    const char *where, murk_error *err);

typedef struct murk_sight_desc {
    const murk_surfaces *surfaces;
    const murk_media *media;
    const murk_boundary_meshes
        *boundary_meshes; /* of the regions that are meshes; NULL: none */
    murk_domain domain;   /* periodic: sightlines go to the nearest image */
    const murk_photon_map *surface_map, *volume_map; /* either may be empty */
    uint64_t
        photons_emitted; /* all emitted photons, also those without a record */
    const murk_sensor_type *type; /* [types], copied */
    size_t types;
    murk_vec3 north; /* horizontal, of length 1; zero: +y */
    murk_visibility visibility;
    bool through_sheets; /* thin sheets transmit light; false: they block. The
                            scene key `through`, thin or block */
    bool refracts;       /* sightlines are refracted at one flat boundary, with
                            MURK_VISIBILITY_RAY only. The scene key `through`,
                            refract */
    murk_map_weights weights;
    const murk_interest *interest; /* NULL: no regions of interest */
    murk_detection detection;      /* the mode by which a clarity follows from a
                                      transmittance */
    double threshold; /* of the transmittance, 0..1; for modes that have one */
    murk_combining combining; /* how entries of several sensors combine */
    unsigned
        redundancy; /* number of the largest entries of a photon that count, 0
                       or 1: one; up to MURK_REDUNDANCY_MAX. For detection
                       probabilities 0 or 1, and all entries count */
    unsigned at_least; /* the coverage also gives the share seen by so many
                          sensors or more; 0: not; up to MURK_REDUNDANCY_MAX */
    murk_power_settings
        power; /* detection by power, with combining INDEPENDENT: the clarity is
                  the probability of sensing/power.h. Not with a threshold */
    unsigned threads;
    const char *where; /* place in the scene for messages; NULL: none */
} murk_sight_desc;

typedef struct murk_sight murk_sight;

/* Copies the sensor types and borrows all else that desc points to. Fails with
 * MURK_BAD_VALUE (types, weights, threshold, redundancy), MURK_BAD_FILE (a
 * record that no run can have stored: power negative or not finite, position
 * not finite, band or emitted index out of range), MURK_RUN_FAILED (no photon
 * has weight, at desc->where; more than 2^32 - 1 photons), with detection by
 * power as murk_power_create() in sensing/power.h, or with MURK_NO_MEMORY: the
 * scratch buffers take 4 to 10 bytes a photon and thread. */
murk_status murk_sight_create(murk_sight **out, const murk_sight_desc *desc,
                              murk_error *err);
void murk_sight_destroy(murk_sight *sight); /* accepts NULL */

/* Gives the memory of the scratch buffers back to the machine until the next
 * row is computed. The row of every worker becomes invalid. */
void murk_sight_rest(murk_sight *sight);

/* Hands the maps to the sight, which destroys them in murk_sight_destroy().
 * They are the maps of the description. */
void murk_sight_own_maps(murk_sight *sight, murk_photon_map *surface,
                         murk_photon_map *volume);

/* The row of a sensor in the coverage matrix; valid until the worker's next
 * call. worker is in [0, threads), pose->type below types. */
void murk_sight_row(murk_sight *sight, unsigned worker, const murk_pose *pose,
                    murk_sparse_row *row);

/* The sightlines of a row: those that were tested, or reused, and those that
 * were lost to interfaces, as in murk_sight_work. */
typedef struct murk_row_counts {
    uint32_t tested, bent, reflected;
} murk_row_counts;

/* In place of the number of tested sightlines: the row is not computed here. */
#define MURK_NOT_TESTED UINT32_MAX

/* How this sight differs from an earlier one of the same sensor types, settings
 * and interfaces: in some photons, and in sightlines that meet a changed place.
 */
typedef struct murk_sight_changes {
    /* The photons that the earlier sight had not, those of the surface map
     * first: their numbers in their map, rising, their records, and a bit for
     * each photon of this sight. */
    const uint32_t *added;
    const murk_photon *added_photon;
    size_t added_surface, added_volume;
    const uint64_t *is_added;
    const murk_photon *gone; /* [gone_photons] those that this sight has not */
    size_t gone_photons;
    murk_box_list changed;         /* enlarged for the rounding of sightlines */
    const murk_surfaces *surfaces; /* of the earlier sight */
} murk_sight_changes;

/* True if photon i of sight a and photon k of sight b, which are equal but for
 * the power, receive the same signals: without detection by power always, else
 * if the light at both places is estimated from the same records. Phase
 * functions are not compared. */
bool murk_sight_has_same_light(const murk_sight *a, size_t i,
                               const murk_sight *b, size_t k);

/* The part of murk_sight_row() that may differ from the row of the earlier
 * sight: the entries of photons that were added or whose sightlines meet a
 * changed place. Sets a bit in tested[photons / 64] for each photon whose
 * sightline was tested; of these, *row has those that are seen. The sightlines
 * that the row has in common with the earlier row, which had `before`, are
 * counted as if they were tested, and as reused. */
void murk_sight_row_again(murk_sight *sight, unsigned worker,
                          const murk_pose *pose,
                          const murk_sight_changes *changes,
                          const murk_row_counts *before, uint64_t *tested,
                          murk_sparse_row *row);

/* The sightlines of the last row of a worker. */
murk_row_counts murk_sight_counts(const murk_sight *sight, unsigned worker);

/* The same for the photons that are needed; false, without a row, if the row
 * was given up (murk_problem.get_part). Sightlines to other photons are not
 * tested.
 */
bool murk_sight_part(murk_sight *sight, unsigned worker, const murk_pose *pose,
                     const murk_row_need *need, murk_sparse_row *row);

/* Optical depths along straight sightlines, unrounded. photon[n] are numbers as
 * in a row of the sensor at `pose`. depth[i * count + m] becomes the optical
 * depth in media[m] of the sightline to photon[i], in the band of that photon;
 * each of media[count] must occupy the regions of the sight's media. sheets[i]
 * becomes the transmittance, 0..1, of the sheets on that sightline (1 if the
 * sight does not look through sheets). Without a threshold or detection by
 * power, a clarity is exp(-depth in the sight's media) times sheets[i], rounded
 * to 1/65535. Not for sightlines that bend. */
void murk_sight_depths(double *depth, double *sheets, const murk_sight *sight,
                       const murk_pose *pose, const uint32_t *photon, size_t n,
                       const murk_media *const *media, size_t count);

/* Rows that are made from those of an earlier sight. */
typedef struct murk_known_rows {
    /* Fills *row with the row of a candidate, until the next call with the same
     * worker; false if its earlier row is not known. */
    bool (*get)(void *context, unsigned worker, size_t candidate,
                murk_sparse_row *row);
    void *context;
    /* As in murk_problem. */
    bool is_unmerged;
    const uint64_t *earlier_hash;
    void (*get_differences)(void *context, unsigned worker,
                            murk_sparse_row *gone, murk_sparse_row *come);
    murk_row_patches patches; /* get() has the context of murk_known_rows */
} murk_known_rows;

/* The placement problem of the candidates pose[n], of which some may be of
 * MURK_POSE_OF_NONE. Borrows poses and sight.
 * problem.context points to *out, so *out must not move. */
typedef struct murk_sight_problem {
    murk_problem problem;
    murk_sight *sight;
    const murk_pose *pose;
    const murk_known_rows *known; /* of murk_sight_problem_know(), or NULL */
    murk_row_counts *tested; /* [candidates] gets the sightlines of each row;
                              * NULL: nobody asks */
} murk_sight_problem;
void murk_sight_problem_init(murk_sight_problem *out, murk_sight *sight,
                             const murk_pose *pose, size_t n);

/* Makes rows from those of an earlier sight, NULL: none. Borrows `known`. */
void murk_sight_problem_know(murk_sight_problem *problem,
                             const murk_known_rows *known);

/* Whole-number weights of the photons [surface + volume], as plans count them:
 * within a map proportional to power (times the factor of the regions of
 * interest), rounded; equal powers have equal weights. Rounding changes a
 * weight by at most half a unit. For `balanced` maps and a redundancy of 1 this
 * is less than 2^-20 of the map's mean weight up to 2^26 records, unless the
 * power of a map lies in so few records that their weights reach the limit of
 * 32 bits. The sum, times the redundancy (or at_least, if larger), is below
 * 2^47. */
const uint32_t *murk_sight_weights(const murk_sight *sight);
size_t murk_sight_photons(const murk_sight *sight);

/* Photon i, with i as in murk_sparse_row.photon. */
const murk_photon *murk_sight_photon(const murk_sight *sight, size_t i);

/* The regions of interest that contain photon i, bit r for region r (0 without
 * regions of interest), and the photon's power [W] times the factor that
 * follows from these regions (murk_interest_factor(); 1 without regions of
 * interest). */
uint64_t murk_sight_regions(const murk_sight *sight, size_t i);
double murk_sight_power_w(const murk_sight *sight, size_t i);

/* True if the photons are in a scratch file, so that they should be read in
 * their order. */
bool murk_sight_is_in_file(const murk_sight *sight);

/* The description that the sight was made from. */
const murk_sight_desc *murk_sight_described(const murk_sight *sight);

/* The number of photons whose light is estimated from fewer than MURK_POWER_FEW
 * others; 0 without detection by power. */
size_t murk_sight_power_few(const murk_sight *sight);

/* Counters since creation: rows (each queries both maps), sightlines tested
 * against surfaces, and sightlines lost to boundaries between refractive
 * indices: those that no surface blocks and a boundary does, and with
 * refraction the photons without a path across one flat boundary. Totally
 * reflected ones are counted separately. `reused` of the shadow rays were not
 * tested, because a row was known (murk_sight_row_again()). */
#define MURK_SIGHT_COUNTERS 5
typedef struct murk_sight_work {
    uint64_t queries, shadow_rays, blocked_by_interfaces, totally_reflected,
        reused;
} murk_sight_work;
murk_sight_work murk_sight_work_of(const murk_sight *sight);

/* Coverage of a region of interest: the total that would result if all other
 * photons were absent and every region had weight 1. NaN if the region contains
 * no photon with power in a map that has weight. */
typedef struct murk_region_coverage {
    size_t photons; /* records in the region, in both maps */
    murk_estimate coverage;
} murk_region_coverage;

/* The part of one map in the total. */
typedef struct murk_map_share {
    size_t photons; /* records */
    double weight; /* weight in the total, 0..1; the weights of both maps sum to
                      1, and total = sum weight * fraction of the map */
    double
        standard_error; /* of the total, from the records of this map alone */
} murk_map_share;

/* Coverage of sensors pose[n], measured on the maps of this sight. */
typedef struct murk_coverage_result {
    murk_estimate total; /* with the error by emitted photon */
    murk_estimate
        surface; /* by power times factors of regions, whatever the weights of
                    the maps; NaN for a map that is empty or without power */
    murk_estimate volume;
    murk_map_share map[2]; /* surface, volume */
    double sum_of_views;   /* the sum over the sensors of the share of the
                              weight, times clarity, that each sees; a photon
                              seen twice counts twice, whatever the
                              redundancy */
    double *covers; /* [n] each sensor alone; with redundancy k at most 1 / k */
    double *only_it_covers;   /* [n] total less the total without the sensor */
    double *seen_by_at_least; /* [n]: shares of the whole weight seen by 1, 2,
                                 .., n sensors or more; a photon that is seen at
                                 all counts fully */
    murk_estimate at_least;   /* seen_by_at_least for the sight's at_least, with
                                 the error; both NaN if the sight's at_least is
                                 0 */
    murk_region_coverage *region; /* [interest->n]; NULL without */
} murk_coverage_result;

/* All values except surface, volume and region use the whole-number weights
 * that plans count, so the total is exactly a plan's value / whole. Errors:
 * ratio estimator over all emitted photons, each with all records in both maps;
 * for `balanced` the residuals of the two ratios are added photon by photon,
 * because the records of one path are correlated. Fails with MURK_BAD_VALUE if
 * a sensor is outside the domain, with MURK_NO_MEMORY (some 20 bytes a photon,
 * 6 more for each further entry that counts) or MURK_INTERRUPTED. With
 * detection probabilities the row of each sensor is computed twice. After
 * success call murk_coverage_result_release(); after a failure *out is
 * unchanged. */
murk_status murk_coverage_result_measure(murk_coverage_result *out,
                                         murk_sight *sight,
                                         const murk_pose *pose, size_t n,
                                         murk_error *err);
void murk_coverage_result_release(murk_coverage_result *coverage);

/* The total alone. After a failure *out is {0, 0}. */
murk_status murk_coverage_total_measure(murk_estimate *out, murk_sight *sight,
                                        const murk_pose *pose, size_t n,
                                        murk_error *err);

/* A result of zeros for n sensors and so many regions of interest. False when
 * out of memory; release it also then. */
bool murk_coverage_result_create(murk_coverage_result *out, size_t n,
                                 size_t regions);

#endif
