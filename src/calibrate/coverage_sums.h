/* Sums that coverage is made of, over re-weighted records: map by map, batch by
 * batch, and their slopes. Inside this room only.
 *
 * D of a record is a function of the transmittances T of its sightlines, with
 * dD = sum by dT, and
 *     dT = -T sum over media d(extinction) density path,
 * so what a parameter does to extinctions is taken out of the sum: by
 * acceptance, band and medium, sum w by T path is all that is needed.
 *
 * Contributions are summed in their order, in runs of batches, so that threads
 * cannot be told from the result. */
#ifndef MURK_CALIBRATE_COVERAGE_SUMS_H
#define MURK_CALIBRATE_COVERAGE_SUMS_H

#include "calibrate/reweigh.h"
#include "calibrate/seen.h"

enum { MURK_SURFACE_PART, MURK_VOLUME_PART, MURK_MAP_PARTS };

/* The caller fills and owns all; sums begin at 0. */
typedef struct murk_coverage_sums {
    const murk_seen *seen;
    const murk_reweighed *reweighed;
    murk_combining combining;
    size_t redundancy; /* views that count, 1 or more */
    size_t bands, batches, keys;
    size_t runs;        /* of batches, worked on apart; at most batches */
    bool *has_say;      /* [keys] of weights; else their slopes are 0 */
    size_t *bound;      /* [batches + 1] first contribution of each */
    double *extinction; /* [cells] at the wanted parameters; a cell: acceptance,
                           band, kept medium, in this order */
    double *steepness;  /* [keys][cells] its slopes */
    double *all;        /* [batches][MURK_MAP_PARTS] sum w */
    double *all_slope;  /* [runs][MURK_MAP_PARTS][keys] */
    double *in_view;    /* [groups][batches][MURK_MAP_PARTS] sum w D */
    double *in_view_slope; /* [groups][runs][MURK_MAP_PARTS][keys] */
    murk_tally failures;   /* for want of memory */
} murk_coverage_sums;

size_t murk_coverage_cells(const murk_coverage_sums *sums);

/* Adds everything up. False when out of memory; or interrupted, which the
 * caller asks. */
bool murk_coverage_sums_add(murk_coverage_sums *sums, unsigned threads);

#endif
