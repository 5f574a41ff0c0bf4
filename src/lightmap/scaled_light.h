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

/* Light sources whose traced light serves several scenes at once, which are
 * added one after the other, so that they need not be in memory together. The
 * scenes have the same light sources, portals included, except for power. Each
 * channel gets the largest share that it has of the total power in any of the
 * scenes. */
typedef struct murk_scaled_shares murk_scaled_shares;

/* Begins with the light sources of the scene `first`, which must outlive *out;
 * its powers are not added. The caller owns *out. Fails as murk_sky_lights().
 */
murk_status murk_scaled_shares_create(murk_scaled_shares **out,
                                      const murk_scene_desc *first,
                                      murk_error *err);
void murk_scaled_shares_destroy(murk_scaled_shares *shares); /* NULL is fine */

/* Adds a scene, of which power_w[channels] are the channel powers. Fails as
 * murk_sky_lights(). */
murk_status murk_scaled_shares_add(murk_scaled_shares *shares,
                                   const murk_scene_desc *scene,
                                   const double *power_w, murk_error *err);

/* True if any channel of a scene that was added has power; and if not all of
 * them have the same powers. */
bool murk_scaled_shares_shine(const murk_scaled_shares *shares);
bool murk_scaled_shares_differ(const murk_scaled_shares *shares);

/* The light sources; at least one scene must have power. *grow is the sum of
 * the shares: if *grow times as many photons are emitted as for one scene, then
 * every channel gets, to a few photons, at least as many as it would get in a
 * run of any scene alone. The caller owns *out. Fails as murk_sources_create().
 */
murk_status murk_scaled_shares_sources(murk_sources **out, double *grow,
                                       const murk_scaled_shares *shares,
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
