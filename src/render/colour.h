/* What a picture in a scene's bands looks like to the eye: linear RGB.
 *
 * Each band's radiance counts by the CIE 1931 colour matching functions, as
 * fitted by Wyman, Sloan and Shirley (J. Comput. Graph. Tech. 2 (2013) 2,
 * simple analytic approximations: three percent at worst), mean over the band;
 * the sum is divided by that of the bands' y, so that Y is a mean radiance
 * [W/m2 /sr], and turned into the primaries of ITU-R BT.709 (IEC 61966-2-1).
 * Colours outside of them have negative parts. One band, and bands that no eye
 * sees, are grey: the bands' mean. */
#ifndef MURK_RENDER_COLOUR_H
#define MURK_RENDER_COLOUR_H

#include "base/bands.h"

/* rgb = weight * radiance, summed over bands. from_nm, to_nm: [bands] edges of
 * each band, equal for a line. */
void murk_colour_weights(int bands, const double *from_nm, const double *to_nm,
                         double weight[3][MURK_BANDS_MAX]);

#endif
