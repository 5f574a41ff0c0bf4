/* Light that only scales: what was traced for one scene, as light of another
 * whose lights differ in power alone.
 *
 * A record says which light and band it is of, and tallies and ledger are kept
 * by these channels; so each channel's packets get the power that they have in
 * the other scene, and one without power drops out. */
#ifndef MURK_LIGHTMAP_RELIGHT_H
#define MURK_LIGHTMAP_RELIGHT_H

#include "lightmap/lightmap.h"

/* The power of each channel of a scene's lights in a domain: [lights * bands]
 * for free(); all 0 where none shines. */
murk_status murk_relight_powers(double **out, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err);

/* Lights that serve n scenes at once, powers[n][channels], whose lights are
 * alike but for their power: each channel shines by the largest share that it
 * has of any scene's light. scene[n]; one of them at least has power. `grow` is
 * how many times the photons of one scene give every channel at least as many
 * as a scene of its own would. *out is the caller's. */
murk_status murk_relight_lights(murk_sources **out, double *grow,
                                const murk_scene_desc *const *scene,
                                double *const *power_w, size_t n,
                                const murk_domain *domain, murk_error *err);

/* The traced light of `lights` as that of channels' powers power_w. *out, for
 * murk_traced_destroy(), has maps and packet_w, but neither ledger nor tallies,
 * which stay with `traced`. */
murk_status murk_relight(murk_traced **out, const murk_traced *traced,
                         const murk_sources *lights, const double *power_w,
                         int bands, unsigned threads, murk_error *err);

#endif
