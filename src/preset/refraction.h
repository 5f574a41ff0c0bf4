/* Refractive index of liquid water, for droplets.
 *
 * Real part: Hale & Querry, Appl. Opt. 12 (1973) 555, doi:10.1364/AO.12.000555,
 * linear between its wavelengths. Imaginary part: Segelstein, "The complex
 * refractive index of water", master's thesis, University of Missouri-Kansas
 * City (1981), hdl.handle.net/10355/11599, a power of e between its
 * wavelengths; it follows the bands from 950 nm on, which the former's steps of
 * 200 nm miss. Both 25 degrees C, and both at second hand, from the
 * refractiveindex.info database (Polyanskiy 2024,
 * doi:10.1038/s41597-023-02898-2). Segelstein's real part is .003 higher in the
 * visible and .006 lower at 1550 nm. */
#ifndef MURK_PRESET_REFRACTION_H
#define MURK_PRESET_REFRACTION_H

#include "preset/mie.h"

#define MURK_REFRACTION_NM_MIN 300
#define MURK_REFRACTION_NM_MAX 2500

/* Needs MURK_REFRACTION_NM_MIN..MAX. */
murk_mie_index murk_water_refraction(double wavelength_nm);

#endif
