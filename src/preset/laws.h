/* The functions behind laws.c; inside this room only. What each takes and
 * where it comes from is said in its own file. */
#ifndef MURK_PRESET_LAWS_H
#define MURK_PRESET_LAWS_H

#include "preset/law.h"

/* visibility.c */
murk_status murk_law_kruse(murk_optics *, const murk_law_call *, murk_error *);
murk_status murk_law_kim(murk_optics *, const murk_law_call *, murk_error *);

/* air.c */
murk_status murk_law_rayleigh(murk_optics *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_angstrom(murk_optics *, const murk_law_call *,
                              murk_error *);

/* rain.c */
murk_status murk_law_rain_power(murk_optics *, const murk_law_call *,
                                murk_error *);
murk_status murk_law_marshall_palmer(murk_optics *, const murk_law_call *,
                                     murk_error *);

/* water_laws.c */
murk_status murk_law_water(murk_optics *, const murk_law_call *, murk_error *);
murk_status murk_law_water_morel(murk_optics *, const murk_law_call *,
                                 murk_error *);
murk_status murk_law_chlorophyll(murk_optics *, const murk_law_call *,
                                 murk_error *);
murk_status murk_law_case_1(murk_optics *, const murk_law_call *, murk_error *);
murk_status murk_law_cdom(murk_optics *, const murk_law_call *, murk_error *);
murk_status murk_law_sediment(murk_optics *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_in_green(murk_optics *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_diffuse_attenuation(murk_optics *, const murk_law_call *,
                                         murk_error *);

/* droplet_laws.c */
murk_status murk_law_droplets(murk_optics *, const murk_law_call *,
                              murk_error *);
murk_status murk_law_gamma_droplets(murk_optics *, const murk_law_call *,
                                    murk_error *);

#endif
