/* What differs between two values of a key: the optics of media, the power of
 * lights, or the world. Private to free_keys. */
#ifndef MURK_CALIBRATE_TURNED_H
#define MURK_CALIBRATE_TURNED_H

#include "calibrate/optics.h"

typedef struct murk_turned {
    bool world;  /* anything but what follows */
    bool optics; /* extinction, albedo or phase of a medium */
    bool phase;  /* of these */
    bool tables; /* phase functions that are tables */
    bool power;  /* of lights */
} murk_turned;

/* Adds to *turned. Two scenes of one file; what neither a medium's optics nor a
 * light's power says is held against each other key by key, and lights by where
 * and how they shine. Fails as murk_source_shapes_print(). */
murk_status murk_turned_add(murk_turned *turned, const murk_optics *a,
                            const murk_optics *b, murk_error *err);

/* What scatters, takes light or shines at b and does not at a, as its key
 * ("media.fog", "lights.0"); false: nothing. What was not there cannot be
 * re-weighted. */
bool murk_turned_from_nothing(char *key, size_t size, const murk_optics *a,
                              const murk_optics *b);

#endif
