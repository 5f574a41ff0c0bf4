/* How fast daylight falls in water, by murk itself: a scene with a preset below
 * a level surface of index 1.34, a sun and nothing else in the sky. */
#ifndef MURK_TESTS_DAYLIGHT_H
#define MURK_TESTS_DAYLIGHT_H

#include "base/stats.h"

#include <stddef.h>
#include <stdint.h>

#define DAYLIGHT_BANDS_MAX 16

/* Attenuation of downward irradiance [1/m] between the depths at which the
 * shares share[0] and share[1] of what is just below the surface are left, at
 * each wavelength; share[0] = 1 is just below the surface itself. `water`
 * is a medium's map: "preset: water/jerlov-I". about_per_m[n] is what to
 * expect: depths are laid by it, from half a hundredth of the light to ten
 * times of it. The error treats both irradiances as independent, which is no
 * less than it is. Prints what is wrong and gives NAN where it cannot. */
void daylight_attenuation(murk_estimate *out, const char *water,
                          double sun_zenith_deg, const double share[2],
                          size_t n, const int *line_nm,
                          const double *about_per_m, uint64_t photons_a_band,
                          uint32_t seed);

#endif
