/* The simple twin of the photon tracer: one box of one even medium, a pencil
 * of photons, delta tracking (Woodcock et al., ANL-7050, 1965), a generator of
 * its own. It shares no code with murk, so agreement means something; it is
 * also the plain scalar loop that murk's speed is measured against. */
#ifndef MURK_TESTS_PLAIN_TRACER_H
#define MURK_TESTS_PLAIN_TRACER_H

#include <stdint.h>

typedef struct plain_box {
    double size_m[3]; /* from the origin */
    double start_m[3], direction[3];
    double absorption_per_m, scattering_per_m, mean_cosine;
    double majorant_per_m; /* at least absorption + scattering */
} plain_box;

/* Counts of photons, and of real collisions. */
typedef struct plain_result {
    uint64_t absorbed;
    uint64_t escaped[3][2]; /* through the lower and upper side of each axis */
    uint64_t collisions;
} plain_result;

plain_result plain_trace(const plain_box *box, uint64_t photons, uint64_t seed);

#endif
