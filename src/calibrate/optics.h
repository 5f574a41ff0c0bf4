/* What re-weighting needs to know of a scene: its media's extinction, albedo
 * and phase function in each band, and its lights' power; and how these change
 * with a parameter.
 *
 * Derivatives are central differences of the scene's own laws, which have no
 * noise: off by some 1e-9 of themselves. */
#ifndef MURK_CALIBRATE_OPTICS_H
#define MURK_CALIBRATE_OPTICS_H

#include "base/bands.h"
#include "base/status.h"
#include "scene/scene.h"
#include "study/phases.h"

typedef struct murk_optics {
    size_t media, channels; /* channel: light * bands + band */
    int bands;
    murk_spectrum *extinction_per_m; /* [media] times density */
    murk_spectrum *albedo;           /* [media] */
    murk_phases *phases;             /* phases->medium[media][band] */
    double *power_w;                 /* [channels] */
    murk_scene *scene;               /* owned: what it was read from */
} murk_optics;

/* Takes the scene over, also on failure. *out is the caller's. */
murk_status murk_optics_create(murk_optics **out, murk_scene *scene,
                               const murk_domain *domain, murk_error *err);
void murk_optics_destroy(murk_optics *optics); /* NULL is fine */

#endif
