/* Light of a scene made from traced light of another scene, if the light
 * sources of both differ in power alone.
 *
 * A record names the light source and band it belongs to, so no photon has to
 * be traced again: each record is multiplied by the ratio of the channel
 * powers, and records of channels without power are dropped. */
#ifndef MURK_LIGHTMAP_SCALED_LIGHT_H
#define MURK_LIGHTMAP_SCALED_LIGHT_H

#include "lightmap/lightmap.h"

/* The power of each channel of the light sources of a scene in a domain:
 * (*out)[lights * bands], which the caller frees; 0 for sources that do not
 * emit. Fails as murk_sky_lights() and murk_sources_create(), or with
 * MURK_NO_MEMORY. */
murk_status murk_scaled_light_powers(double **out, const murk_scene_desc *scene,
                                     const murk_domain *domain,
                                     murk_error *err);

/* Light sources whose traced light serves n > 0 scenes at once. The scenes have
 * the same light sources, portals included, except for power;
 * power_w[n][channels] gives the channel powers of each scene; at least one of
 * all these powers is above 0. Each channel gets the largest share that it has
 * of the total power in any of the scenes. *grow is the sum of these shares: if
 * *grow times as many photons are emitted as for one scene, then every channel
 * gets, to a few photons, at least as many as it would get in a run of any
 * scene alone. The caller owns *out. Fails as murk_sky_lights() and
 * murk_sources_create(), or with MURK_NO_MEMORY. */
murk_status murk_scaled_light_sources(murk_sources **out, double *grow,
                                      const murk_scene_desc *const *scene,
                                      double *const *power_w, size_t n,
                                      const murk_domain *domain,
                                      murk_error *err);

/* Scales traced light. lights are the sources it was traced with;
 * power_w[channels] are the channel powers of the wanted scene. *out
 * (murk_traced_destroy()) has maps and packet powers, but no ledger and no
 * tallies (NULL); these exist for `traced` only. Fails with MURK_NO_MEMORY or
 * as murk_photon_map_create(). */
murk_status murk_scaled_light_make(murk_traced **out, const murk_traced *traced,
                                   const murk_sources *lights,
                                   const double *power_w, int bands,
                                   unsigned threads, murk_error *err);

#endif
