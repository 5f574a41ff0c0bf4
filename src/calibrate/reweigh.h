/* Re-weights contributions to other parameters: the ratio of weights of each
 * contribution and the derivatives of the ratio.
 *
 * The ratio is that of calibrate/histories.h. For a chord it is the ratio at
 * the point of entry times the mean of the attenuation along the chord, (1 -
 * exp(-x)) / x with x the sum over media of (sigma_t' - sigma_t) times the
 * density path of the chord. The mean is exact if the density is even across
 * the sphere of the receiver; otherwise the relative error is, for small x, x
 * times the distance of the centre of density from the middle of the chord, as
 * a share of the length of the chord. */
#ifndef MURK_CALIBRATE_REWEIGH_H
#define MURK_CALIBRATE_REWEIGH_H

#include "base/ranks.h"
#include "calibrate/histories.h"
#include "calibrate/optics.h"

/* Ratios are limited to this value, so that sums remain finite; light with such
 * a ratio carries no information. */
#define MURK_RATIO_MAX 1e130

typedef struct murk_reweighed {
    size_t n, keys;
    double *ratio; /* [n]; weight of a contribution relative to the traced one,
                    * including the power of the light source */
    double *slope; /* [keys][n]; derivatives of ratio */
    double effective_share; /* effective share (Kish): (sum r)^2 / (n sum r^2),
                             * each contribution weighted by its traced value; 1
                             * if nothing changed, 0 if all r are 0. The
                             * smallest over receivers and maps */
    size_t capacity;        /* internal: of slope */
    size_t runs; /* set by the caller: the runs of the sums that will follow,
                  * by which ranks (base/ranks.h) divide the evaluation; 0:
                  * they do not */
    bool is_divided; /* they do: this rank has ratios and slopes for its runs
                      * and for its part of effective_share alone, and all
                      * others are undefined */
} murk_reweighed;

/* Re-weights histories traced at `traced` to the optics `at`, into the result
 * of an earlier call, or into zeros; the arrays are reused if n is the same and
 * there is room for the slopes. sides[keys] belong to the parameters; low NULL:
 * the parameter has no effect here (slope 0). The wanted scene may differ in
 * optics alone, in recorded media alone, and in phase functions only if cosines
 * were stored. Collective if `runs` is set. Fails if scattering, extinction or
 * power is wanted that the traced light did not have, when out of memory, and
 * when interrupted. The result has the same bits for any number of threads.
 * Release also after a failure. */
murk_status murk_reweigh(murk_reweighed *out, const murk_histories *histories,
                         const murk_optics *traced, const murk_optics *at,
                         const murk_optics_sides *sides, size_t keys,
                         unsigned threads, murk_error *err);
void murk_reweighed_release(murk_reweighed *reweighed);

/* The results of an evaluation at re-weighted light. A row is the reading of
 * one receiver or of one group of sensors. The batches are parts of the emitted
 * photons: photon p is in batch p * batches / emitted, rounded down. A run
 * consists of consecutive batches. The arrays belong to the caller. */
typedef struct murk_row_sums {
    double *value; /* [rows] */
    double *slope; /* [rows][keys]; with respect to the keys of the
                    * re-weighting */
    double *batch; /* [batches][rows]; contributions of the batches, which add
                      up to the values */
    double
        *run; /* [runs][rows][keys]; contributions of the runs to the slopes */
    size_t rows, batches, runs; /* runs divides batches */
} murk_row_sums;

/* The runs that this rank evaluates: all, unless ranks divide the evaluation.
 */
static inline size_t murk_reweighed_first_run(const murk_reweighed *reweighed,
                                              size_t runs)
{
    return reweighed->is_divided ? (size_t)murk_ranks_begin(runs) : 0;
}
static inline size_t murk_reweighed_end_run(const murk_reweighed *reweighed,
                                            size_t runs)
{
    return reweighed->is_divided ? (size_t)murk_ranks_end(runs) : runs;
}

/* Evaluates the receivers into the rows 0 .. receivers - 1. The irradiance or
 * fluence rate [W/m2] that light l causes in band b at receiver r is multiplied
 * by per_watt[r * lights + l].band[b], which converts it to the unit of the
 * row, and summed over the lights and the bands of the receiver. Sets value,
 * slope, batch and run of these rows. Collective if ranks divide the
 * evaluation. */
murk_status murk_receivers_read(const murk_row_sums *out,
                                const murk_receiver *receiver,
                                const murk_spectrum *per_watt, size_t receivers,
                                const murk_histories *histories,
                                const murk_reweighed *reweighed,
                                unsigned threads, murk_error *err);

#endif
