#include "cases/layer.h"

#include <math.h>

/* Even with albedo .99 and g .95, light that went this deep has lost all but
 * exp(-80) of its power. */
#define DEEP 4e3

/* So wide that hardly any leg meets a side; what does is wrapped. */
#define HALF_WIDTH 1e5

test_world layer_made(const layer *of)
{
    const double tau = isinf(of->tau) ? DEEP : of->tau;
    const double mu0 = of->mu0 > 0 ? of->mu0 : 1;
    murk_light light =
        test_beam(murk_vec(.1, .2, 0), murk_vec(sqrt(1 - mu0 * mu0), 0, mu0));
    if (of->is_diffuse) {
        light.type = MURK_LIGHT_RECT;
        light.position = murk_vec(-1, -1, 0);
        light.edge1 = murk_vec(2, 0, 0);
        light.edge2 = murk_vec(0, 2, 0);
    }
    murk_medium medium = test_medium(1, of->albedo, 0);
    medium.phase[0] = of->phase;
    const murk_region region = test_everywhere(0);
    return test_world_made(
        &(test_setup){.domain = {{{-HALF_WIDTH, -HALF_WIDTH, 0},
                                  {HALF_WIDTH, HALF_WIDTH, tau}},
                                 true},
                      .lights = &light,
                      .n_lights = 1,
                      .media = &medium,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
}
