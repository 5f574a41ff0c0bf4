/* The functions in the table of laws (laws.c), for use inside this room. The
 * file of each function states the inputs and the source. */
#ifndef MURK_PRESET_LAWS_H
#define MURK_PRESET_LAWS_H

#include "preset/law.h"

/* visibility.c */
murk_status murk_law_kruse(murk_law_result *, const murk_law_call *,
                           murk_error *);
murk_status murk_law_kim(murk_law_result *, const murk_law_call *,
                         murk_error *);

/* air.c */
murk_status murk_law_rayleigh(murk_law_result *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_angstrom(murk_law_result *, const murk_law_call *,
                              murk_error *);

/* rain.c */
murk_status murk_law_rain_power(murk_law_result *, const murk_law_call *,
                                murk_error *);
murk_status murk_law_marshall_palmer(murk_law_result *, const murk_law_call *,
                                     murk_error *);

/* water_laws.c */
murk_status murk_law_water(murk_law_result *, const murk_law_call *,
                           murk_error *);
murk_status murk_law_water_morel(murk_law_result *, const murk_law_call *,
                                 murk_error *);
murk_status murk_law_chlorophyll(murk_law_result *, const murk_law_call *,
                                 murk_error *);
murk_status murk_law_case_1(murk_law_result *, const murk_law_call *,
                            murk_error *);
murk_status murk_law_cdom(murk_law_result *, const murk_law_call *,
                          murk_error *);
murk_status murk_law_sediment(murk_law_result *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_in_green(murk_law_result *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_diffuse_attenuation(murk_law_result *,
                                         const murk_law_call *, murk_error *);

/* droplet_laws.c */
murk_status murk_law_droplets(murk_law_result *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_gamma_droplets(murk_law_result *, const murk_law_call *,
                                    murk_error *);

#endif
