/* The effect of a key: whether two scenes differ in the optics of media, in the
 * power of light sources, or in the world. Internal to free_keys. */
#ifndef MURK_CALIBRATE_KEY_EFFECT_H
#define MURK_CALIBRATE_KEY_EFFECT_H

#include "calibrate/optics.h"

typedef struct murk_key_effect {
    bool world;  /* anything but the optics of media and the power of lights */
    bool optics; /* the optics of a medium */
    bool phase;  /* the phase function of a medium */
    bool tables; /* a phase function that is a table */
    bool power;  /* the power of light sources */
} murk_key_effect;

/* Adds the differences of two scenes of one file to *effect. Everything that is
 * neither the optics of a medium nor the power of a light source is compared
 * key by key, and light sources by position and shape. If these parts differ,
 * optics and powers are not compared. Fails as murk_source_shapes_print()
 * (world/source_shapes.h), or with MURK_NO_MEMORY. */
murk_status murk_key_effect_add(murk_key_effect *effect, const murk_optics *a,
                                const murk_optics *b, murk_error *err);

/* True if b has scattering, extinction or power that a does not have; key
 * receives the part ("media.fog", "lights.0"). Such a change cannot be
 * re-weighted. */
bool murk_key_effect_from_nothing(char *key, size_t size, const murk_optics *a,
                                  const murk_optics *b);

#endif
