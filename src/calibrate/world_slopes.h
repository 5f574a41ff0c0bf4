/* How rows of light turn with a key that re-weighting does not know: by
 * differences of light traced at two of its values, under one seed.
 *
 * A wide step is biased, a narrow one is noisy. Two are tried, one half the
 * other: what they differ by beyond their noise tells the curvature, and per
 * row the one of less expected error is taken. */
#ifndef MURK_CALIBRATE_WORLD_SLOPES_H
#define MURK_CALIBRATE_WORLD_SLOPES_H

#include "calibrate/lit.h"

#define MURK_WORLD_SLOPE_TRACES 4 /* of light, each key and condition */

/* Of key k at value[keys->n]: slope[lit] and its standard error, photons and
 * step together. */
murk_status murk_world_slopes(double *slope, double *slope_error,
                              const murk_lit_desc *desc,
                              const murk_measurements *measured, size_t key,
                              const double *value, murk_error *err);

/* The two values around it that differences are over: share 1 of the wide step,
 * 1/2 of the narrow one. */
void murk_world_span(const murk_free_key *key, double value, double share,
                     double *low, double *high);

#endif
