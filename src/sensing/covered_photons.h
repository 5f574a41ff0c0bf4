/* The photons that sensors cover, and the sums of coverage over them. For use
 * inside src/sensing only. */
#ifndef MURK_SENSING_COVERED_PHOTONS_H
#define MURK_SENSING_COVERED_PHOTONS_H

#include "sensing/combined_rows.h"
#include "sensing/sight.h"

/* Bits of a listed photon. The other bits are the band, times
 * MURK_LISTED_BAND. */
#define MURK_LISTED_VOLUME 1 /* a photon of the volume map, not the surface */
#define MURK_LISTED_FIRST  2 /* the first photon of one emitted photon */
#define MURK_LISTED_BAND   4

/* What the sums read of photons that are not stored, in the order of emitted
 * photons. */
typedef struct murk_photon_list {
    float *power_w; /* until the power of the packets is known: shares of a
                       packet */
    uint8_t *light, *bits;
} murk_photon_list;

typedef struct murk_covered_photons {
    const murk_sight_desc *desc;
    const murk_sight *sight; /* the stored photons; NULL: `list` */
    const murk_photon_list *list;
    const double *power_w; /* [photons] of the stored photons; NULL: to be asked
                              of the sight */
    size_t sensors, photons, surface_photons;
    const uint32_t *weight;        /* [photons] */
    murk_combined_rows combined;   /* the rows of the sensors */
    uint64_t *single_value, *only; /* [sensors] sums of weight * clarity: of the
                                      sensor alone (NULL: not known), and lost
                                      without the sensor */
    uint64_t *seen_by; /* [sensors + 1]: element k is the weight of the photons
                          that exactly k sensors see */
    size_t at_least; /* 0, or a number of sensors: a photon that so many sensors
                        or more see counts fully, any other photon not at all */
} murk_covered_photons;

/* Allocates combined rows of so many photons, only and seen_by, after desc and
 * sensors are set. False when out of memory; release it also then. */
bool murk_covered_photons_init(murk_covered_photons *out, size_t photons);
void murk_covered_photons_release(murk_covered_photons *covered);

/* Fills *out from the combined rows, `only` and single_value. *out has the
 * arrays of murk_coverage_result_create(). Without single_value, covers and
 * sum_of_views are NaN. Fails with MURK_NO_MEMORY. */
murk_status murk_covered_photons_sum_up(murk_coverage_result *out,
                                        const murk_covered_photons *covered,
                                        murk_error *err);

/* Receives the row of one sensor. */
typedef void (*murk_row_sink)(void *context, uint32_t sensor,
                              const murk_sparse_row *row);

/* Computes the rows of pose[n] by the threads of the sight, and passes them to
 * the sink in order, in the calling thread. Fails with MURK_INTERRUPTED. */
murk_status murk_coverage_rows(murk_sight *sight, const murk_pose *pose,
                               size_t n, murk_row_sink sink, void *context,
                               murk_error *err);

/* Fails with MURK_BAD_VALUE if a sensor is outside the domain. */
murk_status murk_coverage_check(const murk_sight_desc *desc,
                                const murk_pose *pose, size_t n,
                                murk_error *err);

#endif
