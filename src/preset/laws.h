/* The functions in the table of laws (laws.c), for use inside src/preset only.
 * The file of each function states the inputs and the source. */
#ifndef MURK_PRESET_LAWS_H
#define MURK_PRESET_LAWS_H

#include "preset/law.h"

murk_law_run murk_law_kruse, murk_law_kim;                  /* visibility.c */
murk_law_run murk_law_rayleigh, murk_law_angstrom;          /* air.c */
murk_law_run murk_law_rain_power, murk_law_marshall_palmer; /* rain.c */
/* water_laws.c */
murk_law_run murk_law_water, murk_law_water_morel, murk_law_chlorophyll,
    murk_law_case_1, murk_law_cdom, murk_law_sediment, murk_law_in_green,
    murk_law_diffuse_attenuation;
murk_law_run murk_law_droplets, murk_law_gamma_droplets; /* droplet_laws.c */

/* Fills in extinction_per_m (wavelength / at_nm)^-exponent, of which the share
 * `albedo` is scattered (visibility.c). */
void murk_law_power(murk_law_result *out, const murk_law_call *call,
                    double extinction_per_m, double at_nm, double exponent,
                    double albedo);

#endif
