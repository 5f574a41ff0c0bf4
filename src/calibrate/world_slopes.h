/* Slopes of light rows with respect to keys that re-weighting cannot vary:
 * differences of light that is traced at two values of the key with the same
 * seed.
 *
 * A wide step has a bias, a narrow step has more noise. Both a step and half of
 * it are used: the difference of the two slopes beyond the noise estimates the
 * bias, and each row takes the slope with the smaller expected error. */
#ifndef MURK_CALIBRATE_WORLD_SLOPES_H
#define MURK_CALIBRATE_WORLD_SLOPES_H

#include "calibrate/lighting.h"

/* traces of light for each key and condition: two steps of two values */
#define MURK_WORLD_SLOPE_TRACES 4

/* Computes the slopes of the light rows (calibrate/lighting.h) with respect to
 * key number `key` at value[keys->n]. slope and slope_error have an element for
 * each light row; slope_error is the standard error from photon noise and the
 * bias of the step together. */
murk_status murk_world_slopes(double *slope, double *slope_error,
                              const murk_lighting_desc *desc,
                              const murk_readings *measured, size_t key,
                              const double *value, murk_error *err);

/* The two values around `value` of a difference: share 1 is the wide step, 1/2
 * the narrow one. Both values are cut at the limits of the key. */
void murk_world_span(const murk_free_key *key, double value, double share,
                     double *low, double *high);

#endif
