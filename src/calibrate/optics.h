/* The optical properties of a scene that re-weighting needs: extinction, albedo
 * and phase function of the media in each band, and the power of light sources.
 *
 * Derivatives with respect to parameters are differences of these properties,
 * which have no noise; murk_free_key_around() determines the step. */
#ifndef MURK_CALIBRATE_OPTICS_H
#define MURK_CALIBRATE_OPTICS_H

#include "base/bands.h"
#include "base/status.h"
#include "scene/scene.h"
#include "world/phases.h"

typedef struct murk_optics {
    size_t media, channels; /* channel: light * bands + band */
    int bands;
    murk_spectrum *extinction_per_m; /* [media]; times density; 1 if a profile
                                      * states the extinction */
    murk_spectrum *albedo;           /* [media]; 0 if the albedo is a grid */
    murk_phases *phases;             /* phases->medium[media][band] */
    double *power_w;                 /* [channels]; all 0: no source emits */
    murk_scene_desc *scene;          /* owned: the scene it was read from */
} murk_optics;

/* Takes ownership of the scene, also after a failure. Prints no warnings,
 * because the stage prints them. The caller owns *out. */
murk_status murk_optics_create(murk_optics **out, murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);
void murk_optics_destroy(murk_optics *optics); /* NULL is fine */

/* The same with known channel powers: power_w[channels] is copied. */
murk_status murk_optics_create_lit(murk_optics **out, murk_scene_desc *scene,
                                   const double *power_w, murk_error *err);

/* True if the phase functions of a medium agree in a band, within 1e-7 of the
 * density at any angle. */
bool murk_optics_turn_alike(const murk_optics *a, const murk_optics *b,
                            size_t medium, int band);

#endif
