/* From watts to what eyes, plants and counters take of light: lumens, photons,
 * photosynthetic photons.
 *
 * A band is a line (from_nm == to_nm) or the wavelengths between two edges.
 * Within a band light is taken as even in wavelength, or as a given shape of
 * spectrum says.
 *
 * V: the photopic luminous efficiency CIE 1924, which is the 1931 standard
 * observer's y (ISO/CIE 11664-1:2019), at 5 nm, cubic between; 380-780 nm, 0
 * elsewhere. 683 lm/W at V = 1. Photons by hc = 1.98644586e-25 J m (SI 2019).
 * PAR: the photons of 400-700 nm (McCree, Agric. Meteorol. 10 (1972) 443,
 * doi:10.1016/0002-1571(72)90045-3). */
#ifndef MURK_BASE_PHOTOMETRY_H
#define MURK_BASE_PHOTOMETRY_H

#define MURK_LUMEN_PER_WATT 683.0 /* at V = 1 */
#define MURK_AVOGADRO       6.02214076e23

/* What a watt is read as, and the unit of an irradiance then. */
typedef enum murk_quantity {
    MURK_RADIOMETRIC, /* W/m2 */
    MURK_PHOTOMETRIC, /* lux */
    MURK_PHOTONS,     /* 1/s/m2 */
    MURK_PAR          /* umol/s/m2, 400-700 nm only */
} murk_quantity;

/* V at a wavelength, 0..1. */
double murk_luminous_efficiency(double wavelength_nm);

double murk_photons_per_joule(double wavelength_nm);

/* Relative spectral power at a wavelength, in any unit, >= 0. */
typedef double (*murk_spectral_shape)(const void *context,
                                      double wavelength_nm);

/* What one watt of light in a band counts as: 1, lumens, photons/s or umol/s.
 * So an irradiance [W/m2] times this is in the quantity's unit. Edges in nm,
 * 0 < from <= to. */
double murk_quantity_per_watt(murk_quantity quantity, double from_nm,
                              double to_nm);

/* The same for light of a given shape within the band; even where the shape is
 * 0 throughout. The shape is asked at steps of 1 nm or less. */
double murk_quantity_per_watt_of(murk_quantity quantity, double from_nm,
                                 double to_nm, murk_spectral_shape shape,
                                 const void *context);

#endif
