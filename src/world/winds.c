/* Wave slopes of regions under wind, and the warnings about wind speeds and
 * sightlines. */
#include "world/winds.h"

#include "base/log.h"
#include "medium/waves.h"

double murk_region_mean_square_slope(const murk_scene_region *region)
{
    return region->wind_m_per_s > 0
               ? murk_wind_mean_square_slope(region->wind_m_per_s)
               : 0;
}

void murk_warn_of_winds(const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (!(r->wind_m_per_s > 0)) {
            continue;
        }
        if (r->wind_m_per_s < MURK_WIND_MEASURED_MIN ||
            r->wind_m_per_s > MURK_WIND_MEASURED_MAX) {
            murk_warn(r->where,
                      "wind_m_per_s is %g m/s: slopes were measured at %g to "
                      "%g m/s, beyond that the same line goes on",
                      r->wind_m_per_s, MURK_WIND_MEASURED_MIN,
                      (double)MURK_WIND_MEASURED_MAX);
        }
        if (scene->placement.through == MURK_SCENE_REFRACT) {
            murk_warn(r->where, "sightlines (through: refract) cross these "
                                "waves as if they were level");
        }
    }
}
