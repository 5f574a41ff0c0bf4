/* Re-weights contributions to other parameters: the ratio of weights of each
 * contribution and the derivatives of the ratio.
 *
 * The ratio is that of calibrate/followed.h. For a chord it is the mean along
 * the chord, (1 - exp(-x)) / x with x the sum over media of (sigma_t' -
 * sigma_t) times the density path of the chord. The mean is exact if the
 * density is even across the sphere of the receiver; otherwise the relative
 * error is x times the relative distance of the centre of density from the
 * middle of the chord. */
#ifndef MURK_CALIBRATE_REWEIGH_H
#define MURK_CALIBRATE_REWEIGH_H

#include "calibrate/followed.h"
#include "calibrate/optics.h"

/* Optics at two values of a parameter, slightly below and above the present
 * one. */
typedef struct murk_optics_sides {
    const murk_optics *low, *high;
    double span; /* difference of the two values */
} murk_optics_sides;

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
                             * if nothing changed. The smallest over receivers
                             * and maps */
    size_t room;            /* internal: capacity of slope */
} murk_reweighed;

/* Re-weights histories traced at `traced` to the optics `at`. sides[keys]
 * belong to the parameters; low NULL: the parameter has no effect here (slope
 * 0). The wanted scene may differ in optics alone, in recorded media alone, and
 * in phase functions only if cosines were stored. Fails if scattering,
 * extinction or power is wanted that the traced light did not have, when out of
 * memory, and when interrupted. The result has the same bits for any number of
 * threads. After success, release with murk_reweighed_release(). */
murk_status murk_reweigh(murk_reweighed *out, const murk_followed *followed,
                         const murk_optics *traced, const murk_optics *at,
                         const murk_optics_sides *sides, size_t keys,
                         unsigned threads, murk_error *err);
/* The same into the result of an earlier call, or into zeros; arrays are reused
 * if they are large enough. Release also after a failure. */
murk_status murk_reweigh_again(murk_reweighed *out,
                               const murk_followed *followed,
                               const murk_optics *traced, const murk_optics *at,
                               const murk_optics_sides *sides, size_t keys,
                               unsigned threads, murk_error *err);
void murk_reweighed_release(murk_reweighed *reweighed);

/* Evaluates receivers in W/m2 of their bands times per_watt[r * lights + light]
 * by band: value[receivers], slope[receivers][keys], and
 * batch[batches][receivers], which add up to the values. Batches are ranges of
 * photon numbers. slope_batch[runs][receivers][keys], or NULL, likewise for the
 * slopes. */
void murk_receivers_read(double *value, double *slope, double *batch,
                         size_t batches, double *slope_batch, size_t runs,
                         const murk_receiver *receiver,
                         const murk_spectrum *per_watt, size_t receivers,
                         const murk_followed *followed,
                         const murk_reweighed *reweighed, unsigned threads);

#endif
