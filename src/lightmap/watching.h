/* Noting the paths of photons while their records are stored. For use inside
 * src/lightmap only. */
#ifndef MURK_LIGHTMAP_WATCHING_H
#define MURK_LIGHTMAP_WATCHING_H

#include "lightmap/path_cells.h"
#include "lightmap/record_buffers.h"
#include "world/stage.h"

/* The paths take 8 bytes a photon. */
#define MURK_WATCHED_PHOTONS_MAX 100000000

/* True if an update of the light can make use of paths: photons.emit, at most
 * MURK_WATCHED_PHOTONS_MAX photons, free flight by marching, one rank. */
bool murk_can_watch(const murk_stage *stage);

/* The receivers of all events. */
typedef struct murk_watching {
    murk_record_buffers *buffers;
    murk_path_cells *cells;
    const murk_domain *domain;
} murk_watching;

/* A murk_event_sink with a murk_watching as context. */
void murk_watch_event(void *context, uint64_t batch, const murk_event *event);

/* Sets the sink of a trace. */
void murk_watch(murk_watching *watching, murk_trace *trace);

#endif
