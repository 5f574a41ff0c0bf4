/* How given sensors see places that no light chose: the voxels of a field, the
 * middles of a mesh's faces.
 *
 * Places are records like photons (plan/targets.h), and what is asked is a
 * sight like the one that plans were made by: the same surfaces, media, ways
 * through, detection and types. Only what a place does not have differs: no
 * region of interest weighs it, and `arrival: toward` is not asked, as nothing
 * travels there. */
#ifndef MURK_SENSING_PLACES_SEEN_H
#define MURK_SENSING_PLACES_SEEN_H

#include "sensing/sight.h"

typedef struct murk_place_seen {
    float worth;   /* 0..1: what a plan counts of a photon stored there. With
                      one view that counts: the clearest sensor's clarity */
    float clarity; /* 0..1, of the clearest sensor; 0: no one sees it */
    float depth;   /* optical depth of the media, without sheets: the least of
                      all straight sightlines that nothing closes, within range
                      and view; however small the clarity. INFINITY: none.
                      0 where it is not asked */
    uint32_t sensors; /* that see it */
} murk_place_seen;

typedef struct murk_places {
    size_t n;
    /* Place i: position, normal, band, material, and whether it lies in the
     * volume. Called on any thread. */
    murk_photon (*record)(const void *context, size_t i);
    const void *context;
    bool wants_depth;
    const char *step; /* of the progress bar; NULL: none */
} murk_places;

/* out[places->n], the same for any number of threads, of sensors pose[n] of
 * like's types. Takes some 200 bytes a place, of some ten thousand places
 * a thread at a time, of a million with detection by power. Fails with
 * MURK_NO_MEMORY or MURK_INTERRUPTED, or as murk_sight_create() does. */
murk_status murk_places_see(murk_place_seen *out, const murk_places *places,
                            const murk_sight *like, const murk_pose *pose,
                            size_t n, murk_error *err);

#endif
