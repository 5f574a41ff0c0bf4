/* Checkpoints of a trace: from time to time all that was traced so far is
 * written to a file, from which the same run goes on after it was killed. The
 * file is that of part 1 of 1 (lightmap/light_part.h), so going on is merging,
 * and the light is that of an undisturbed run in every bit. */
#ifndef MURK_LIGHTMAP_CHECKPOINT_H
#define MURK_LIGHTMAP_CHECKPOINT_H

#include "lightmap/light_part.h"

struct murk_light_sums;

typedef struct murk_checkpoint {
    const char *path;
    double every_s;
    double last_s; /* murk_clock_s() at the begin, or of the last one */
} murk_checkpoint;

/* False if checkpoint is NULL. */
bool murk_checkpoint_is_due(const murk_checkpoint *checkpoint);

/* Writes the first `batches` batches: the records that the buffers have
 * gathered, and the sums of ledger and tallies. A failure is a warning, because
 * the run need not end for it. */
void murk_checkpoint_write(murk_checkpoint *checkpoint, const murk_stage *stage,
                           const murk_record_buffers *buffers,
                           const struct murk_light_sums *sums,
                           uint64_t batches);

/* Reads the checkpoint of an earlier run, if there is one: *out is NULL if
 * there is none, or, with a warning, if the file belongs to another run or if
 * ranks see different files. The caller destroys *out. Collective. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_checkpoint_read(murk_light_parts **out, const char *path,
                                 const murk_stage *stage, murk_error *err);

#endif
