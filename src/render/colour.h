/* Conversion of radiance in the bands of a scene to linear RGB.
 *
 * The radiance of each band is weighted by the CIE 1931 colour matching
 * functions, as fitted by Wyman, Sloan and Shirley (J. Comput. Graph. Tech. 2
 * (2013) 2; the error of the analytic approximation is 3 % at worst), averaged
 * over the band. The sum is divided by the sum of y over the bands, so that Y
 * is a mean radiance [W/m2 /sr], and converted to the primaries of ITU-R BT.709
 * (IEC 61966-2-1). Colours outside of the gamut have negative components. A
 * single band, and bands that are invisible, are shown in grey: the mean of the
 * bands. */
#ifndef MURK_RENDER_COLOUR_H
#define MURK_RENDER_COLOUR_H

#include "base/bands.h"

/* Computes weights with rgb = weight * radiance, summed over bands. from_nm,
 * to_nm: [bands] edges of each band, equal for a single wavelength. */
void murk_colour_weights(int bands, const double *from_nm, const double *to_nm,
                         double weight[3][MURK_BANDS_MAX]);

#endif
