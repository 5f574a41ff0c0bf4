/* Coverage of given sensors by photons that are not stored.
 *
 * The photons come in batches. Each is tested against the sensors and then
 * dropped; the stream keeps murk_coverage_stream_bytes() of it, by which the
 * result is summed up when all photons have come. So the result is that of
 * murk_coverage_result_measure(), but for `covers` and sum_of_views, which are
 * NaN, and for the rounding of sums of power, which are added in the order of
 * the emitted photons and not in that of a photon map. */
#ifndef MURK_SENSING_COVERAGE_STREAM_H
#define MURK_SENSING_COVERAGE_STREAM_H

#include "sensing/sight.h"

typedef struct murk_coverage_stream murk_coverage_stream;

/* The memory that is kept of a photon [bytes]: power, weight, combined rows. */
static inline double murk_coverage_stream_bytes(unsigned redundancy)
{
    return 16 + 6.0 * (redundancy > 1 ? redundancy : 1);
}

/* True if such photons suffice: without detection probabilities, which need all
 * rows twice, detection by power, which needs all photons at once, and regions
 * of interest. */
bool murk_coverage_can_stream(const murk_sight_desc *desc);

/* For the sensors pose[n], borrowed. About `expected` photons will come; memory
 * for them is reserved, more photons may come. desc->surface_map, volume_map
 * and photons_emitted are not read; the sensor types are copied. Fails with
 * MURK_BAD_VALUE if a sensor is outside the domain, or with MURK_NO_MEMORY. */
murk_status murk_coverage_stream_create(murk_coverage_stream **out,
                                        const murk_sight_desc *desc,
                                        const murk_pose *pose, size_t n,
                                        size_t expected, murk_error *err);
void murk_coverage_stream_destroy(murk_coverage_stream *stream); /* or NULL */

/* Adds the records of some emitted photons, which follow those added before.
 * All records of an emitted photon come in one call. The records are copied.
 * Fails as murk_sight_create(), with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_coverage_stream_add(murk_coverage_stream *stream,
                                     const murk_photon *surface,
                                     size_t n_surface,
                                     const murk_photon *volume, size_t n_volume,
                                     murk_error *err);

/* Fills *out, for murk_coverage_result_release(), from all photons that came.
 * `emitted` is the number of emitted photons. The power of each record is
 * multiplied by packet_w[light * bands + band], if packet_w is not NULL. The
 * stream cannot be used afterwards. Fails with MURK_RUN_FAILED if no photon has
 * weight, or with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_coverage_stream_end(murk_coverage_result *out,
                                     murk_coverage_stream *stream,
                                     const double *packet_w, int bands,
                                     uint64_t emitted, murk_error *err);

#endif
