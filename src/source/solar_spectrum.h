/* How sunlight and skylight spread over wavelengths.
 *
 * The clear-sky model (source/clear_sky.h) gives irradiance over all
 * wavelengths; a band's part of it is that times a share from here. The beam
 * reddens and dims as the sun sinks, the sky stays blue, clouds take the
 * infrared: so shares depend on where the sun stands and on the air.
 *
 * Clear sky: the simple spectral model of Bird and Riordan (SPCTRAL2), J.
 * Climate Appl. Meteor. 25 (1986) 87, NREL/TR-215-2436 (1984),
 * doi:10.2172/5986936, as NREL's own program spectrl2_2.c has it: 300-4000 nm
 * at some 10 nm. Made for the sun at least 10 degrees up; below 1 degree it is
 * taken as at 1 degree.
 * Aerosol by Linke's turbidity: Ineichen, Solar Energy 82 (2008) 1095,
 * doi:10.1016/j.solener.2008.04.010.
 * Overcast: what reaches the ground of a clear day, through a level cloud of
 * optical depth 20, whose droplets of 10 um absorb as liquid water does
 * (Twomey and Bohren, J. Atmos. Sci. 37 (1980) 2086), by two-stream theory
 * (Bohren, Am. J. Phys. 55 (1987) 524, doi:10.1119/1.15109). Both at second
 * hand. The depth sets how much of the infrared is missing, little else.
 * Extraterrestrial and AM 1.5: ASTM G173-03. */
#ifndef MURK_SOURCE_SOLAR_SPECTRUM_H
#define MURK_SOURCE_SOLAR_SPECTRUM_H

#include <stddef.h>

typedef enum murk_spectrum_source {
    MURK_SPECTRUM_EXTRATERRESTRIAL, /* air does not matter */
    MURK_SPECTRUM_DIRECT,           /* the sun's beam */
    MURK_SPECTRUM_CLEAR_SKY,        /* on a horizontal plane, without the sun */
    MURK_SPECTRUM_CLEAR_GLOBAL,     /* sun and sky on a horizontal plane */
    MURK_SPECTRUM_OVERCAST,         /* likewise, under cloud */
    MURK_SPECTRUM_AM15_GLOBAL, /* the standard, plane tilted by 37 degrees */
    MURK_SPECTRUM_AM15_DIRECT  /* the standard beam with aureole */
} murk_spectrum_source;

/* Start from murk_spectrum_air_defaults(), which is the air of ASTM G173 with
 * the sun at air mass 1.5, and change what differs. */
typedef struct murk_spectrum_air {
    double apparent_zenith_deg; /* of the sun; 0 or more */
    double linke_turbidity;     /* 3; sets aerosol */
    double pressure_hpa;        /* 1013.25 */
    double water_cm;            /* water vapour above: 1.42, > 0 */
    double ozone_cm;            /* .344 atm cm */
    double ground_albedo;       /* .2 */
} murk_spectrum_air;

murk_spectrum_air murk_spectrum_air_defaults(void);

/* Aerosol optical depth at 550 nm and air mass 1 that makes Linke's turbidity
 * (at air mass 2) what it is; 0 where clean air with that much water is more
 * turbid already. */
double murk_aerosol_depth(const murk_spectrum_air *air);

#define MURK_SPECTRUM_NODES 264

/* Spectral irradiance, linear between nodes, 0 beyond the first and last; a
 * jump is two nodes at one wavelength. */
typedef struct murk_solar_spectrum {
    size_t nodes;
    double nm[MURK_SPECTRUM_NODES];
    double w_per_m2_nm[MURK_SPECTRUM_NODES];
    double up_to[MURK_SPECTRUM_NODES]; /* integral up to the node [W/m2] */
    double total;                      /* what shares are of [W/m2] */
} murk_solar_spectrum;

/* At 1 au. Only the extraterrestrial total, 1366.1 W/m2 there, holds what is
 * beyond 280-4000 nm, 1.3 %. */
void murk_solar_spectrum_make(murk_solar_spectrum *out,
                              murk_spectrum_source source,
                              const murk_spectrum_air *air);

/* The share of the total between two wavelengths, 0 <= from <= to. */
double murk_solar_spectrum_share(const murk_solar_spectrum *spectrum,
                                 double from_nm, double to_nm);

/* [W/m2/nm]; a murk_spectral_shape (base/photometry.h) of a spectrum. */
double murk_solar_spectrum_at(const void *spectrum, double wavelength_nm);

/* The share in the default air. */
double murk_spectrum_share(murk_spectrum_source source, double from_nm,
                           double to_nm);

#endif
