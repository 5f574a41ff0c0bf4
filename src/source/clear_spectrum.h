/* Spectral irradiance at the ground under a clear sky, at the wavelengths of
 * the table murk_bird (source/solar_tables.h), by the model of Bird and
 * Riordan. For use inside src/source only. */
#ifndef MURK_SOURCE_CLEAR_SPECTRUM_H
#define MURK_SOURCE_CLEAR_SPECTRUM_H

#include "source/solar_tables.h"

/* The state of the atmosphere. */
typedef struct murk_clear_air {
    double zenith_deg;       /* apparent, below 90 */
    double relative_airmass; /* of Kasten and Young */
    double pressure_hpa;
    double water_cm, ozone_cm;
    double aerosol_500; /* optical depth at 500 nm */
    double ground_albedo;
} murk_clear_air;

/* The spectra in W/m2/nm at 1 au. */
typedef struct murk_clear_spectrum {
    double direct[MURK_BIRD_LINES];  /* at right angles */
    double diffuse[MURK_BIRD_LINES]; /* on a horizontal plane */
} murk_clear_spectrum;

/* Computes both spectra for an atmosphere. */
void murk_clear_spectrum_make(murk_clear_spectrum *out,
                              const murk_clear_air *air);

#endif
