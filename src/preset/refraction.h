/* The refractive index of liquid water, for droplets.
 *
 * Real part: Hale & Querry, Appl. Opt. 12 (1973) 555, doi:10.1364/AO.12.000555,
 * linear between the tabulated wavelengths. Imaginary part: Segelstein, "The
 * complex refractive index of water", master's thesis, University of
 * Missouri-Kansas City (1981), hdl.handle.net/10355/11599, exponential between
 * the tabulated wavelengths. The table of Segelstein resolves the absorption
 * bands from 950 nm on; that of Hale & Querry, with steps of 200 nm, does not.
 * Both are for 25 degrees C and were taken from the refractiveindex.info
 * database (Polyanskiy 2024, doi:10.1038/s41597-023-02898-2). The real part of
 * Segelstein is .003 higher in the visible and .006 lower at 1550 nm. */
#ifndef MURK_PRESET_REFRACTION_H
#define MURK_PRESET_REFRACTION_H

#include "preset/mie.h"

/* The range that both tables cover. */
#define MURK_REFRACTION_NM_MIN 300
#define MURK_REFRACTION_NM_MAX 2500

/* The index at a wavelength of MURK_REFRACTION_NM_MIN..MAX. */
murk_mie_index murk_water_refraction(double wavelength_nm);

#endif
