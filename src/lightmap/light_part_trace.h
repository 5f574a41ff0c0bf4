/* Traces a part of the light of a scene and writes the file of the part. */
#ifndef MURK_LIGHTMAP_LIGHT_PART_TRACE_H
#define MURK_LIGHTMAP_LIGHT_PART_TRACE_H

#include "base/shard.h"
#include "world/stage.h"

/* Traces the batches of a shard and writes the file. With photons.store a shard
 * ends with the batch that reaches its share of the records. Fails before
 * tracing as murk_emission_check() and murk_ending_check(), later with
 * MURK_RUN_FAILED if more than photons.max_stored records are stored or the
 * file cannot be written, with MURK_NO_MEMORY or with MURK_INTERRUPTED. */
murk_status murk_light_part_trace(const murk_stage *stage, murk_shard shard,
                                  unsigned threads, const char *path,
                                  murk_error *err);

#endif
