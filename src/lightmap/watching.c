/* Passes each event to the record buffers and to the cells of paths. */
#include "lightmap/watching.h"

#include "base/ranks.h"

bool murk_can_watch(const murk_stage *stage)
{
    const murk_scene_photons *settings = &stage->scene->photons;
    return settings->emit > 0 && settings->emit <= MURK_WATCHED_PHOTONS_MAX &&
           !stage->scene->by_delta && murk_ranks_count() == 1;
}

void murk_watch_event(void *context, uint64_t batch, const murk_event *event)
{
    const murk_watching *watching = context;
    murk_path_cells_add(watching->cells, watching->domain, event);
    murk_record_buffers_event(watching->buffers, batch, event);
}

void murk_watch(murk_watching *watching, murk_trace *trace)
{
    trace->sink = murk_watch_event;
    trace->context = watching;
    trace->takes_any_order = true;
}
