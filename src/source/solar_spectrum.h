/* Distribution of sunlight and skylight over wavelengths.
 *
 * The clear-sky model (source/clear_sky.h) gives irradiance over all
 * wavelengths; the irradiance of a band is that times a share from this file.
 * The beam becomes red and dim as the sun sinks, the sky stays blue, and clouds
 * absorb the infrared; the shares therefore depend on the elevation of the sun
 * and on the air.
 *
 * Clear sky: the simple spectral model of Bird and Riordan (SPCTRAL2), J.
 * Climate Appl. Meteor. 25 (1986) 87, NREL/TR-215-2436 (1984),
 * doi:10.2172/5986936, as in the program spectrl2_2.c of NREL: 300-4000 nm at
 * some 10 nm. The model was made for elevations of at least 10 degrees;
 * elevations below 1 degree are treated as 1 degree. Aerosol by Linke
 * turbidity: Ineichen, Solar Energy 82 (2008) 1095,
 * doi:10.1016/j.solener.2008.04.010. Overcast: the global irradiance of a clear
 * day, transmitted by a level cloud of optical depth 20 with droplets of a
 * radius of 10 um that absorb like liquid water (Twomey and Bohren, J. Atmos.
 * Sci. 37 (1980) 2086), by two-stream theory (Bohren, Am. J. Phys. 55 (1987)
 * 524, doi:10.1119/1.15109). Both papers are cited from secondary sources. The
 * optical depth determines the loss in the infrared and little else.
 * Extraterrestrial: ASTM G173-03. */
#ifndef MURK_SOURCE_SOLAR_SPECTRUM_H
#define MURK_SOURCE_SOLAR_SPECTRUM_H

#include <stddef.h>

/* The spectra. */
typedef enum murk_spectrum_source {
    MURK_SPECTRUM_EXTRATERRESTRIAL, /* independent of the air */
    MURK_SPECTRUM_DIRECT,           /* the beam of the sun */
    MURK_SPECTRUM_CLEAR_SKY,        /* on a horizontal plane, without the sun */
    MURK_SPECTRUM_CLEAR_GLOBAL,     /* sun and sky on a horizontal plane */
    MURK_SPECTRUM_OVERCAST          /* likewise, under cloud */
} murk_spectrum_source;

/* The state of the atmosphere. Start from murk_spectrum_air_defaults(), the air
 * of ASTM G173 with the sun at air mass 1.5, and change members. The numbers
 * beside the members are the defaults. */
typedef struct murk_spectrum_air {
    double apparent_zenith_deg; /* of the sun: 48.19; 0 or more */
    double linke_turbidity;     /* 3; determines the aerosol */
    double pressure_hpa;        /* 1013.25 */
    double water_cm;            /* water vapour of a vertical path: 1.42, > 0 */
    double ozone_cm;            /* .344 atm cm */
    double ground_albedo;       /* .2 */
} murk_spectrum_air;

murk_spectrum_air murk_spectrum_air_defaults(void);

/* The optical depth of the aerosol at 550 nm and air mass 1 that gives the
 * Linke turbidity (at air mass 2); 0 if clean air with that much water vapour
 * is more turbid already. */
double murk_aerosol_depth(const murk_spectrum_air *air);

/* Two nodes for each of the 131 cells of ASTM G173, and two spare ones. */
#define MURK_SPECTRUM_NODES 264

/* A spectrum: spectral irradiance, linear between nodes, 0 beyond the first and
 * the last. A jump is two nodes at the same wavelength. */
typedef struct murk_solar_spectrum {
    size_t nodes;
    double nm[MURK_SPECTRUM_NODES];
    double w_per_m2_nm[MURK_SPECTRUM_NODES];
    double up_to[MURK_SPECTRUM_NODES]; /* integral up to the node [W/m2] */
    double total;                      /* the whole to which shares refer
                                        * [W/m2] */
} murk_solar_spectrum;

/* Computes a spectrum at 1 au; `air` is not read for the extraterrestrial one.
 * Only the extraterrestrial total, 1366.1 W/m2, includes the irradiance outside
 * of 280-4000 nm, 1.3 %. */
void murk_solar_spectrum_make(murk_solar_spectrum *out,
                              murk_spectrum_source source,
                              const murk_spectrum_air *air);

/* The share of the total between two wavelengths, 0 <= from <= to. */
double murk_solar_spectrum_share(const murk_solar_spectrum *spectrum,
                                 double from_nm, double to_nm);

/* The spectral irradiance [W/m2/nm]; a murk_spectral_shape (base/photometry.h)
 * whose context is a spectrum. */
double murk_solar_spectrum_at(const void *spectrum, double wavelength_nm);

#endif
