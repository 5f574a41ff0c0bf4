/* The light of a stage from that of an earlier one of the same scene: photons
 * that no change touches stay as they were, the others are traced again. The
 * result is that of murk_lightmap_trace(), in every bit. */
#ifndef MURK_LIGHTMAP_LIGHT_UPDATE_H
#define MURK_LIGHTMAP_LIGHT_UPDATE_H

#include "lightmap/lightmap.h"

/* The light of `stage`, from `earlier`, which was traced for `earlier_stage`
 * by this function or by murk_lightmap_trace_watched(); *reused becomes the
 * number of emitted photons that were not traced. Photons that a change may
 * touch are traced twice: in the earlier world to subtract their contributions
 * to ledger and tallies, then in the new one. All photons are traced, once,
 * where the cells do not tell or that is faster; the cells then cover the
 * surroundings of what has changed now. `earlier` stays as it is. Fails as
 * murk_lightmap_trace(). */
murk_status murk_lightmap_update(murk_traced **out, uint64_t *reused,
                                 const murk_stage *stage,
                                 const murk_traced *earlier,
                                 const murk_stage *earlier_stage,
                                 unsigned threads, murk_error *err);

/* Light whose records were passed to a sink, and these records, in the order in
 * which they were passed. */
typedef struct murk_passed_light {
    const murk_stage *stage; /* that it was traced in; set by the caller who
                              * gives the light as the earlier one, borrowed */
    murk_traced *traced;     /* NULL: there is no light */
    murk_record_list surface, volume;
} murk_passed_light;

void murk_passed_light_release(murk_passed_light *light); /* {0} is fine */

/* The light of a stream of murk_lightmap_pass(), with photons.emit, whose sink
 * gets the same batches in every bit, from `earlier` of the same stream, NULL:
 * from none, as murk_lightmap_update() makes it. If paths cannot be noted, *out
 * has no records. The ledger of *out is that of the
 * photons that were traced. The caller releases *out, also after a failure, and
 * `earlier` stays as it is. Fails as murk_lightmap_pass(). */
murk_status murk_lightmap_update_passed(
    murk_passed_light *out, const murk_stage *stage, uint32_t stream,
    const murk_passed_light *earlier, unsigned threads, double bytes_each,
    murk_record_batch_sink each, void *context, murk_error *err);

#endif
