/* Coverage of given places instead of stored photons: voxels of a field,
 * centres of the faces of a mesh.
 *
 * Each place is given as a photon record, as targets are (plan/targets.h), and
 * is evaluated by a sight like the one that plans use: the same surfaces,
 * media, sheets, detection mode and types. Only properties that a place lacks
 * differ: regions of interest do not weigh it, and `arrival: toward` is
 * ignored, because a place has no direction in which light travels. */
#ifndef MURK_SENSING_PLACES_SEEN_H
#define MURK_SENSING_PLACES_SEEN_H

#include "sensing/sight.h"

typedef struct murk_place_seen {
    float worth; /* 0..1, the share that a plan would count of a photon stored
                    there; without redundancy and without detection
                    probabilities, the clarity of the clearest sensor */
    float
        clarity; /* 0..1, of the clearest sensor; 0: no sensor sees the place */
    float depth; /* optical depth of the media without sheets: the smallest of
                    all unblocked straight sightlines within range and field of
                    view, however small the clarity. INFINITY: no such
                    sightline. 0 if not requested */
    uint32_t sensors; /* number of sensors that see the place */
} murk_place_seen;

typedef struct murk_places {
    size_t n;
    /* Record of place i: position, normal, band, material, and whether it lies
     * in the volume. Called on any thread. */
    murk_photon (*record)(const void *context, size_t i);
    const void *context;
    bool wants_depth;
    const char *step; /* title of the progress bar; NULL: none */
} murk_places;

/* Fills out[places->n] for the sensors pose[n] of the types of `like`; the same
 * for any number of threads. The places are evaluated in pieces: each thread
 * holds a piece of 8192 places at a time, or with detection by power all
 * threads together hold one piece of a million. The memory is some 200 bytes
 * for each place of these pieces. Fails with MURK_NO_MEMORY or
 * MURK_INTERRUPTED, or as murk_sight_create() does. */
murk_status murk_places_see(murk_place_seen *out, const murk_places *places,
                            const murk_sight *like, const murk_pose *pose,
                            size_t n, murk_error *err);

#endif
