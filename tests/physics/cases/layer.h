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
    double tau;        /* INFINITY: so deep that nothing comes back */
    double mu0;        /* cosine of the beam with z; 0: 1 */
    bool is_diffuse;   /* lit by cosine law instead */
    double half_width; /* of the periodic domain; 0: so wide that hardly any
                          segment meets a side */
} layer;

test_world layer_made(const layer *of);

/* Tallies in it: a plane across the layer whose normal is +z, and the mean
 * fluence of a thin slice about a level (a grid of one cell). */
murk_tally_desc layer_plane(const char *name, double z, size_t angle_bins);
murk_tally_desc layer_slice(const char *name, const layer *of, double z,
                            double thickness);

#endif
