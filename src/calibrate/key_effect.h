/* The effect of a key: whether two scenes differ in the optics of media, in the
 * power of light sources, or in the world. Internal to free_keys. */
#ifndef MURK_CALIBRATE_TURNED_H
#define MURK_CALIBRATE_TURNED_H

#include "calibrate/optics.h"

typedef struct murk_turned { /* anything but the following */
    bool world;              /* anything but what follows */
    bool optics;             /* the phase function of a medium */
    bool phase;              /* a phase function that is a table */
    bool tables;             /* power of light sources */
    bool power;              /* of lights */
} murk_turned;

/* Adds the differences of two scenes of one file to *turned. Everything that is
 * neither the optics of a medium nor the power of a light source is compared
 * key by key, and light sources by position and shape. Fails as
 * murk_source_shapes_print(). */
murk_status murk_turned_add(murk_turned *turned, const murk_optics *a,
                            const murk_optics *b, murk_error *err);

/* True if b has scattering, extinction or power that a does not have; key
 * receives the part ("media.fog", "lights.0"). Such a change cannot be
 * re-weighted. */
bool murk_turned_from_nothing(char *key, size_t size, const murk_optics *a,
                              const murk_optics *b);

#endif
