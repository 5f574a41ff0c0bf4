/* One even layer across the whole domain, from z = 0 to z = tau, in air of
 * index 1: lengths are optical depths. Light comes from below and travels along
 * +z; where the layer has an index, it starts one unit of length before it. */
#ifndef MURK_TESTS_CASES_LAYER_H
#define MURK_TESTS_CASES_LAYER_H

#include "worlds.h"

typedef struct layer {
    double index; /* of refraction; 0: 1 */
    double albedo;
    murk_phase phase;
    double tau;      /* INFINITY: so deep that nothing comes back */
    double mu0;      /* cosine of the beam with z; 0: 1 */
    bool is_diffuse; /* lit by cosine law instead */
} layer;

test_world layer_made(const layer *of);

#endif
