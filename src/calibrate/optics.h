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
    murk_spectrum *extinction_per_m; /* [media]; to be multiplied by the
                                      * density; 1 if a profile states the
                                      * extinction */
    murk_spectrum *albedo;           /* [media]; 0 if the albedo is a grid */
    murk_phases *phases;             /* phases->medium[media][band] */
    double *power_w;                 /* [channels]; all 0: no source emits */
    murk_scene_desc *scene;          /* owned: the scene it was read from */
} murk_optics;

/* Optics at two values of a parameter, slightly below and above the present
 * one; near a limit of the range, one of them is the present value
 * (murk_free_key_around()). */
typedef struct murk_optics_sides {
    murk_optics *low, *high; /* NULL: the parameter has no effect here */
    double span;             /* difference of the two values */
} murk_optics_sides;

/* Takes ownership of the scene, also after a failure. power_w[channels], unless
 * NULL, is copied; otherwise the powers are those of the light sources in the
 * domain. fillings are as in murk_phases_create(). Prints no warnings: building
 * the world of the scene prints them. The caller owns *out. */
murk_status murk_optics_create(murk_optics **out, murk_scene_desc *scene,
                               const murk_domain *domain,
                               const murk_fillings *fillings,
                               const double *power_w, murk_error *err);
void murk_optics_destroy(murk_optics *optics); /* NULL is fine */

/* True if the phase functions of a medium agree in a band, to 1e-7 of the
 * density at each angle that is compared. */
bool murk_optics_turn_alike(const murk_optics *a, const murk_optics *b,
                            size_t medium, int band);

#endif
