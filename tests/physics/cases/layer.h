/* One even layer across the whole domain, from z = 0 to z = tau: lengths are
 * optical depths, light comes from below and travels along +z. */
#ifndef MURK_TESTS_CASES_LAYER_H
#define MURK_TESTS_CASES_LAYER_H

#include "worlds.h"

typedef struct layer {
    double albedo;
    murk_phase phase;
    double tau;      /* INFINITY: so deep that nothing comes back */
    double mu0;      /* cosine of the beam with z; 0: 1 */
    bool is_diffuse; /* lit by cosine law instead */
} layer;

test_world layer_made(const layer *of);

#endif
