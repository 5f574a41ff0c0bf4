/* Properties of a stage that has been built, and the settings for tracing
 * photons in it. */
#include "world/stage.h"

murk_trace murk_stage_trace(const murk_stage *stage)
{
    murk_trace trace = murk_trace_defaults();
    trace.world = &stage->world;
    trace.seed = stage->scene->seed;
    trace.least_weight = stage->scene->photons.least_weight;
    trace.by_delta = stage->scene->by_delta;
    return trace;
}

bool murk_stage_is_dark(const murk_stage *stage)
{
    return murk_sources_lit(stage->lights) == 0;
}

bool murk_stage_has_nothing_to_see(const murk_stage *stage)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    return murk_stage_is_dark(stage) &&
           (!settings->targets.given ||
            murk_detection_is(settings->detection, MURK_DETECTION_BY_POWER));
}
