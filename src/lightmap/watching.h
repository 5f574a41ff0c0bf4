/* Noting the paths of photons while their records are stored. For use inside
 * src/lightmap only. */
#ifndef MURK_LIGHTMAP_WATCHING_H
#define MURK_LIGHTMAP_WATCHING_H

#include "lightmap/lightmap.h"
#include "lightmap/record_buffers.h"

/* True if an update of the light can serve (lightmap/light_update.h). */
bool murk_can_watch(const murk_stage *stage);

/* The receivers of all events. */
typedef struct murk_watching {
    murk_record_buffers *buffers;
    murk_path_cells *cells;
} murk_watching;

/* A murk_event_sink with a murk_watching as context. */
void murk_watch_event(void *context, uint64_t batch, const murk_event *event);

/* Sets the sink of a trace. */
void murk_watch(murk_watching *watching, murk_trace *trace);

/* Sets packet_w from the photons that were emitted. Fails with
 * MURK_NO_MEMORY. */
struct murk_emission;
murk_status murk_traced_packet_powers(murk_traced *traced,
                                      const struct murk_emission *emission,
                                      murk_error *err);

/* Sets packet_w for all photons of the light, and fails with MURK_RUN_FAILED if
 * too many were lost (murk_emission_check_losses()). */
murk_status murk_traced_set_powers(murk_traced *traced, const murk_stage *stage,
                                   murk_error *err);
murk_status murk_traced_check_losses(const murk_traced *traced,
                                     const murk_stage *stage, murk_error *err);

#endif
