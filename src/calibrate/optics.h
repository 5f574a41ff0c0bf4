/* What re-weighting needs to know of a scene: its media's extinction, albedo
 * and phase function in each band, and its lights' power; and how these change
 * with a parameter.
 *
 * Derivatives are differences of the scene's own laws, which have no noise:
 * murk_free_key_around() says how far apart. */
#ifndef MURK_CALIBRATE_OPTICS_H
#define MURK_CALIBRATE_OPTICS_H

#include "base/bands.h"
#include "base/status.h"
#include "scene/scene.h"
#include "world/phases.h"

typedef struct murk_optics {
    size_t media, channels; /* channel: light * bands + band */
    int bands;
    murk_spectrum *extinction_per_m; /* [media] times density; 1 where a profile
                                        says it */
    murk_spectrum *albedo;           /* [media]; 0 where it is a grid */
    murk_phases *phases;             /* phases->medium[media][band] */
    double *power_w;                 /* [channels]; all 0: it is dark */
    murk_scene_desc *scene;          /* owned: what it was read from */
} murk_optics;

/* Takes the scene over, also on failure. Says no warnings: those are the
 * stage's to say. *out is the caller's. */
murk_status murk_optics_create(murk_optics **out, murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);
void murk_optics_destroy(murk_optics *optics); /* NULL is fine */

/* The same where the channels' power is known: power_w[channels], copied. */
murk_status murk_optics_create_lit(murk_optics **out, murk_scene_desc *scene,
                                   const double *power_w, murk_error *err);

/* Whether a medium turns light alike in a band of both, to 1e-7 of the density
 * at any angle. */
bool murk_optics_turn_alike(const murk_optics *a, const murk_optics *b,
                            size_t medium, int band);

#endif
