/* Builds the world of a single homogeneous layer and the tallies that the
 * reference cases of layers score to. All lengths are optical depths, because
 * the extinction coefficient is 1/m. */
#include "cases/layer.h"

#include <math.h>
#include <stdio.h>

/* With albedo .999 and g .9, the palest that is put so deep, light falls as
 * exp(-.0173 tau) (diffusion) there. */
#define DEEP 4e3

#define WIDE 1e5 /* half the width where none is given */

#define AIR 1.0 /* before and behind a layer with an index */

static double half_width(const layer *of)
{
    return of->half_width > 0 ? of->half_width : WIDE;
}

static murk_source light_of(const layer *of, double z)
{
    const double mu0 = of->mu0 > 0 ? of->mu0 : 1;
    murk_source light =
        test_beam(murk_vec(.1, .2, z), murk_vec(sqrt(1 - mu0 * mu0), 0, mu0));
    if (of->is_diffuse) {
        light.type = MURK_SOURCE_RECT;
        light.position = murk_vec(-1, -1, z);
        light.edge1 = murk_vec(2, 0, 0);
        light.edge2 = murk_vec(0, 2, 0);
    }
    return light;
}

test_world layer_made(const layer *of)
{
    const double tau = isinf(of->tau) ? DEEP : of->tau;
    const double air = of->index > 1 ? AIR : 0;
    const double wide = half_width(of);
    murk_source light = light_of(of, -air);
    murk_medium medium = test_medium(1, of->albedo, 0);
    medium.phase[0] = of->phase;
    murk_region region = test_everywhere(0);
    if (of->index > 1) {
        region = test_box_region(0, murk_vec(-2 * wide, -2 * wide, 0),
                                 murk_vec(2 * wide, 2 * wide, tau));
        region.ior = of->index;
    }
    return test_world_made(&(test_setup){
        .domain = {{{-wide, -wide, -air}, {wide, wide, tau + air}}, true},
        .lights = &light,
        .n_lights = 1,
        .media = &medium,
        .n_media = 1,
        .regions = &region,
        .n_regions = 1});
}

murk_tally_desc layer_plane(const char *name, double z, size_t angle_bins)
{
    murk_tally_desc plane = {.type = MURK_TALLY_PLANE,
                             .point = {0, 0, z},
                             .normal = {0, 0, 1},
                             .bins = {1, 1},
                             .angle_bins = angle_bins,
                             .where = name};
    snprintf(plane.name, sizeof plane.name, "%s", name);
    return plane;
}

murk_tally_desc layer_slice(const char *name, const layer *of, double z,
                            double thickness)
{
    const double w = half_width(of);
    murk_tally_desc slice = {
        .type = MURK_TALLY_GRID,
        .box = {{-w, -w, z - thickness / 2}, {w, w, z + thickness / 2}},
        .size = {1, 1, 1},
        .where = name};
    snprintf(slice.name, sizeof slice.name, "%s", name);
    return slice;
}
