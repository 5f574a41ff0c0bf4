/* Converts radiant power [W] to lumens, photons and photosynthetic photons.
 *
 * A band is a single wavelength (from_nm == to_nm) or the interval between two
 * edges. Within a band, the spectrum of the light is constant or has a given
 * shape.
 *
 * The luminous efficiency V is the photopic function CIE 1924, which equals the
 * y function of the 1931 standard observer (ISO/CIE 11664-1:2019), tabulated
 * every 5 nm from 380 to 780 nm, interpolated by cubics, and 0 elsewhere. Light
 * of V = 1 has 683 lm/W. Photons are counted with hc = 1.98644586e-25 J m (SI
 * 2019). PAR is the number of photons of 400 to 700 nm (McCree, Agric.
 * Meteorol. 10 (1972) 443, doi:10.1016/0002-1571(72)90045-3). */
#ifndef MURK_BASE_PHOTOMETRY_H
#define MURK_BASE_PHOTOMETRY_H

#include <stddef.h>

/* at V = 1, by the definition of the candela (SI) */
#define MURK_LUMEN_PER_WATT 683.0
#define MURK_AVOGADRO       6.02214076e23 /* 1/mol, SI 2019 */

/* The quantity that light is measured in, and the unit of irradiance in that
 * quantity. */
typedef enum murk_quantity {
    MURK_RADIOMETRIC, /* W/m2 */
    MURK_PHOTOMETRIC, /* lux */
    MURK_PHOTONS,     /* 1/s/m2 */
    MURK_PAR          /* umol/s/m2, 400-700 nm only */
} murk_quantity;

/* The luminous efficiency V at a wavelength, 0 or more and 1 at 555 nm; the
 * interpolation exceeds 1 by less than 1e-5. */
double murk_luminous_efficiency(double wavelength_nm);

double murk_photons_per_joule(double wavelength_nm);

/* Relative spectral power at a wavelength, >= 0, in any unit. */
typedef double (*murk_spectral_shape)(const void *context,
                                      double wavelength_nm);

/* The amount of a quantity that one watt of light in a band has: 1, lumens,
 * photons/s or umol/s, in the order of murk_quantity. An irradiance [W/m2]
 * times this amount is in the unit of the quantity. The power per nm is
 * constant within the band. Edges in nm, 0 < from <= to. */
double murk_quantity_per_watt(murk_quantity quantity, double from_nm,
                              double to_nm);

/* Like murk_quantity_per_watt(), for light with a given spectral shape within
 * the band. A shape that is 0 in the whole band is replaced by a constant one.
 * The shape is sampled at steps of 1 nm or less, or, in parts of a band of more
 * than 20,000 nm, at 20,000 points. */
double murk_quantity_per_watt_of(murk_quantity quantity, double from_nm,
                                 double to_nm, murk_spectral_shape shape,
                                 const void *context);

/* Likewise for a table of n rising wavelengths and the power per nm, 0 or more,
 * linear between the wavelengths and 0 beyond the first and the last. The power
 * is exact; V is sampled at steps of 1 nm or less between the wavelengths of
 * the table, so that a line of any width counts. */
double murk_quantity_per_watt_of_table(murk_quantity quantity, double from_nm,
                                       double to_nm, size_t n, const double *nm,
                                       const double *power_per_nm);

#endif
