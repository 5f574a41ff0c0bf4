/* The sums that coverage consists of, over re-weighted records: by map and
 * batch, with derivatives. For use inside src/calibrate only.
 *
 * The combined clarity D of a record is a function of the transmittances T of
 * its sightlines, with dD = sum of (dD/dT) dT and
 *
 * dT = -T * sum over media of d(extinction) * density path.
 *
 * The derivative of an extinction with respect to a parameter is the same for
 * all sightlines of equal acceptance and band, so this derivative is factored
 * out: one sum of w * (dD/dT) * T * path by acceptance, band and medium serves
 * all parameters, with w the re-weighted weight of the record.
 *
 * Records are summed in their order, in runs of batches, so the result does not
 * depend on threads. */
#ifndef MURK_CALIBRATE_COVERAGE_SUMS_H
#define MURK_CALIBRATE_COVERAGE_SUMS_H

#include "calibrate/reweigh.h"
#include "calibrate/visible.h"

enum { MURK_SURFACE_PART, MURK_VOLUME_PART, MURK_MAP_PARTS };

/* The caller fills the description, from `visible` to `runs`. */
typedef struct murk_coverage_sums {
    const murk_visible *visible;
    const murk_reweighed *reweighed;
    murk_combining combining;
    size_t redundancy; /* number of sightlines of a record that count, the
                        * clearest ones; at least 1; not used for independent
                        * detections */
    size_t bands, batches, keys;
    size_t runs;        /* runs of batches, processed in parallel; at most
                         * batches */
    bool *has_say;      /* [keys]; true if the weights may depend on the key;
                         * otherwise the slopes of the weights are 0 */
    size_t *bound;      /* [batches + 1]; index of the first contribution of
                         * each batch */
    double *extinction; /* [cells]; extinction at the wanted parameters; a cell
                         * is acceptance, band, re-weighted medium, in this
                         * order */
    double *steepness;  /* [keys][cells]; derivatives of the extinction */
    double *all;        /* [batches][MURK_MAP_PARTS]; sum of w */
    double *all_slope;  /* [runs][MURK_MAP_PARTS][keys] */
    double *in_view;    /* [groups][batches][MURK_MAP_PARTS]; sum of w D */
    double *in_view_slope; /* [groups][runs][MURK_MAP_PARTS][keys] */
    murk_tally failures;   /* number of tasks without memory */
    murk_arena arena;      /* of all arrays */
} murk_coverage_sums;

/* Allocates all arrays, with 0 in each. Release also after a failure. */
bool murk_coverage_sums_allocate(murk_coverage_sums *sums);
void murk_coverage_sums_release(murk_coverage_sums *sums);

size_t murk_coverage_cells(const murk_coverage_sums *sums);

/* Computes all sums. Collective if ranks divide the evaluation
 * (calibrate/reweigh.h). Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_coverage_sums_add(murk_coverage_sums *sums, unsigned threads,
                                   murk_error *err);

#endif
