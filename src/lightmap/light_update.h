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

#endif
