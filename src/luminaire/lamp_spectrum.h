/* The spectrum of a lamp: a black body, or a table of wavelengths. Only the
 * shape has a meaning; the power of the lamp is known otherwise.
 *
 * Black body: Planck's law per unit of wavelength, with c2 = h c / k of the SI
 * (2019). A colour temperature that a maker states is often a correlated one;
 * the spectrum of such a lamp is not that of the black body. Table: linear
 * between the wavelengths, 0 beyond the first and the last. */
#ifndef MURK_LUMINAIRE_LAMP_SPECTRUM_H
#define MURK_LUMINAIRE_LAMP_SPECTRUM_H

#include "base/photometry.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* Range of the temperature [K]: below, V is met by less than 1e-9 of the
 * power; above, the spectrum is the same in the visible to 2 %. */
#define MURK_TEMPERATURE_K_MIN 500.0
#define MURK_TEMPERATURE_K_MAX 100000.0

typedef struct murk_lamp_spectrum {
    double temperature_k; /* of a black body; 0: a table */
    size_t n;
    double *nm, *power_per_nm; /* [n] rising; 0 or more; owned */
    unsigned further_owners;
} murk_lamp_spectrum;

/* Either takes no arrays (a black body), or takes ownership of both arrays of n
 * numbers, also on failure. The caller owns *out. Fails with MURK_NO_MEMORY. */
murk_status murk_lamp_spectrum_create(murk_lamp_spectrum **out,
                                      double temperature_k, size_t n,
                                      double *nm, double *power_per_nm,
                                      const char *where, murk_error *err);

/* Adds an owner, who also calls murk_lamp_spectrum_destroy(); NULL is fine. Not
 * for owners that several threads release at once. */
murk_lamp_spectrum *murk_lamp_spectrum_share(murk_lamp_spectrum *spectrum);
void murk_lamp_spectrum_destroy(murk_lamp_spectrum *spectrum); /* NULL: fine */

/* The spectral power at a wavelength, in any unit: a murk_spectral_shape
 * (base/photometry.h) with a murk_lamp_spectrum as context. */
double murk_lamp_spectrum_at(const void *spectrum, double nm);

/* The integral between two wavelengths, 0 < from <= to, in the unit of
 * murk_lamp_spectrum_at() times nm: exact for a table, by Simpson's rule in
 * steps of 1 nm or less for a black body (in parts of more than 20,000 nm in
 * 20,000 steps). */
double murk_lamp_spectrum_integral(const murk_lamp_spectrum *spectrum,
                                   double from_nm, double to_nm);

/* The amount of a quantity that one watt of the spectrum in a band has
 * (base/photometry.h), 0 < from <= to. Lines of a table count, however narrow;
 * a spectrum that is 0 in the band is replaced by a constant one. */
double murk_lamp_spectrum_per_watt(const murk_lamp_spectrum *spectrum,
                                   murk_quantity quantity, double from_nm,
                                   double to_nm);

/* The luminous flux [lm] of a spectrum whose power is that of
 * murk_lamp_spectrum_integral() in watts: 683 lm/W times the integral of V
 * (base/photometry.h). */
double murk_lamp_spectrum_lumens(const murk_lamp_spectrum *spectrum);

#endif
