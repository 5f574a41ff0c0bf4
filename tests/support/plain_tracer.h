/* The simple twin of the photon tracer: one box of one medium (even, with a
 * ball of another in it, or of densities on a grid), a pencil of photons, delta
 * tracking (Woodcock et al., ANL-7050, 1965), a generator of its own. It shares
 * no code with murk, so agreement means something; it is also the plain scalar
 * loop that murk's speed is measured against. */
#ifndef MURK_TESTS_PLAIN_TRACER_H
#define MURK_TESTS_PLAIN_TRACER_H

#include <stdbool.h>
#include <stdint.h>

typedef struct plain_matter {
    double absorption_per_m, scattering_per_m, mean_cosine;
} plain_matter;

typedef struct plain_box {
    double size_m[3]; /* from the origin */
    double start_m[3], direction[3];
    plain_matter matter;
    double majorant_per_m; /* at least the extinction anywhere */

    /* A ball of other matter in place of the box's; none where radius_m is 0.
     */
    double center_m[3], radius_m;
    plain_matter ball;

    /* What the extinction is times, x slowest; NULL: 1. In voxels of 1 m, or
     * trilinear between whole coordinates, one more along an axis. */
    const float *density;
    bool is_linear;

    /* True: a photon leaves its absorbed part behind at each real collision and
     * goes on with the rest until it escapes. False: roulette, a photon is
     * absorbed whole or not at all. */
    bool has_weights;

    /* The expected absorption at each real collision is added to the cell of
     * 1 m that contains the collision, x slowest; NULL: no tally. */
    float *absorption;
} plain_box;

/* Photons, by weight, and the number of real collisions. */
typedef struct plain_result {
    double absorbed;
    double escaped[3][2]; /* through the lower and upper side of each axis */
    uint64_t collisions;
} plain_result;

plain_result plain_trace(const plain_box *box, uint64_t photons, uint64_t seed);

#endif
