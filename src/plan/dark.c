/* Coverage of a stage that has nothing to see (murk_stage_has_nothing_to_see()
 * in world/stage.h: no light source has power, and either no targets replace
 * the photons or detection is by power). Every share is NaN, for the total, for
 * each map, for each sensor, for each number of sensors that see a photon
 * (seen_by_at_least), and for each region of interest. */
#include "plan/plan.h"

#include <math.h>

/* An undefined share. */
static const murk_estimate NOTHING = {NAN, NAN};

murk_status murk_dark_coverage(murk_coverage_result *out,
                               const murk_stage *stage, size_t n,
                               murk_error *err)
{
    const size_t regions = stage->scene->placement.n_interests;
    if (!murk_coverage_result_create(out, n, regions)) {
        murk_coverage_result_release(out);
        return murk_no_memory(err, stage->scene->path, "for %zu sensors", n);
    }
    /* The totals, the values of each sensor, and the regions of interest. */
    out->total = out->surface = out->volume = out->at_least = NOTHING;
    out->map[0] = out->map[1] = (murk_map_share){0, NAN, NAN};
    out->sum_of_views = NAN;
    for (size_t i = 0; i < n; ++i) {
        out->covers[i] = out->only_it_covers[i] = NAN;
        out->seen_by_at_least[i] = NAN;
    }
    for (size_t i = 0; i < regions; ++i) {
        out->region[i].coverage = NOTHING;
    }
    return MURK_OK;
}
