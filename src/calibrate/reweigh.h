/* Contributions at other parameters: each one's weight, and its slope by each
 * of them.
 *
 * The weight is that of calibrate/followed.h; a chord's is the mean of it along
 * the chord, by (1 - exp(-x)) / x with x the sum over media of (sigma_t' -
 * sigma_t) times the chord's density path: exact where the density is even
 * across the receiver's sphere, else off by x times the share by which the
 * density's mean place lies off the chord's middle. */
#ifndef MURK_CALIBRATE_REWEIGH_H
#define MURK_CALIBRATE_REWEIGH_H

#include "calibrate/followed.h"
#include "calibrate/optics.h"

/* A parameter's own two sides: optics at its value a little lower and higher.
 */
typedef struct murk_optics_sides {
    const murk_optics *low, *high;
    double span; /* high less low, of the parameter */
} murk_optics_sides;

/* A ratio beyond is cut off: its light tells nothing, but sums stay finite. */
#define MURK_RATIO_MAX 1e130

typedef struct murk_reweighed {
    size_t n, keys;
    double *ratio; /* [n] of the contribution's weight to that traced, its
                      light's power included */
    double *slope; /* [keys][n] of ratio */
    double effective_share; /* (sum r)^2 / (n sum r^2) over contributions, each
                               by its traced worth: 1 when nothing changed.
                               The least over receivers and maps */
    size_t room;            /* private: numbers that slope has room for */
} murk_reweighed;

/* followed was traced with `traced`; wanted at `at`. sides[keys] are the
 * parameters'; low NULL: the parameter has no say here (slope 0). What is
 * wanted must not differ from what was traced but in optics, and not in those
 * of media that were not kept, nor in phase functions where no cosines were.
 * Fails where light was traced without a scattering, extinction or power that
 * is now wanted, when out of memory, and when interrupted. The same bits for
 * any number of threads. On success, release with murk_reweighed_release(). */
murk_status murk_reweigh(murk_reweighed *out, const murk_followed *followed,
                         const murk_optics *traced, const murk_optics *at,
                         const murk_optics_sides *sides, size_t keys,
                         unsigned threads, murk_error *err);
/* The same into what an earlier call made, or zeroes, whose room is used again
 * where it fits; to be released after a failure, too. */
murk_status murk_reweigh_again(murk_reweighed *out,
                               const murk_followed *followed,
                               const murk_optics *traced, const murk_optics *at,
                               const murk_optics_sides *sides, size_t keys,
                               unsigned threads, murk_error *err);
void murk_reweighed_release(murk_reweighed *reweighed);

/* What receivers read, W/m2 in each band that they take, times per_watt[r *
 * lights + light] by band: value[receivers], slope[receivers][keys], and sums
 * by batch of photons batch[batches][receivers] whose totals are the values.
 * Batches are runs of photons' indices. slope_batch[runs][receivers][keys],
 * NULL or likewise of the slopes. */
void murk_receivers_read(double *value, double *slope, double *batch,
                         size_t batches, double *slope_batch, size_t runs,
                         const murk_receiver *receiver,
                         const murk_spectrum *per_watt, size_t receivers,
                         const murk_followed *followed,
                         const murk_reweighed *reweighed, unsigned threads);

#endif
