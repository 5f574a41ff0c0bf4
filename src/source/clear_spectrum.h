/* Spectral irradiance below a clear sky, line by line of murk_bird: the model
 * of Bird and Riordan. Private to this room. */
#ifndef MURK_SOURCE_CLEAR_SPECTRUM_H
#define MURK_SOURCE_CLEAR_SPECTRUM_H

#include "source/solar_tables.h"

typedef struct murk_clear_air {
    double zenith_deg;       /* apparent, below 90 */
    double relative_airmass; /* Kasten and Young's */
    double pressure_hpa;
    double water_cm, ozone_cm;
    double aerosol_500; /* optical depth at 500 nm */
    double ground_albedo;
} murk_clear_air;

/* W/m2/nm at 1 au. */
typedef struct murk_clear_spectrum {
    double direct[MURK_BIRD_LINES];  /* at right angles */
    double diffuse[MURK_BIRD_LINES]; /* on a horizontal plane */
} murk_clear_spectrum;

void murk_clear_spectrum_make(murk_clear_spectrum *out,
                              const murk_clear_air *air);

#endif
