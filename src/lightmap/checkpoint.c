/* Writes and reads checkpoints (lightmap/checkpoint.h). The gathered records
 * lie in two lists, of the surface map and of the volume map; a part has the
 * records of each batch in the order of photons, so the lists are merged. */
#include "lightmap/checkpoint.h"

#include "base/block.h"
#include "base/file.h"
#include "base/inputs.h"
#include "base/log.h"
#include "base/path.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "lightmap/rank_exchange.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool murk_checkpoint_is_due(const murk_checkpoint *c)
{
    return c && murk_clock_s() - c->last_s >= c->every_s;
}

/* Merges both lists by photon, and counts the records of each batch. */
static void merge(murk_photon *record, uint32_t *count,
                  const murk_record_buffers *buffers)
{
    const murk_record_list *a = &buffers->surface, *b = &buffers->volume;
    size_t i = 0, j = 0;
    for (size_t k = 0; k < a->n + b->n; ++k) {
        const bool is_first =
            j == b->n || (i < a->n && murk_photon_emitted(&a->photon[i]) <=
                                          murk_photon_emitted(&b->photon[j]));
        record[k] = is_first ? a->photon[i++] : b->photon[j++];
        ++count[murk_photon_emitted(&record[k]) / MURK_BATCH_PHOTONS];
    }
}

static murk_status make_folder_of(const char *path, murk_error *err)
{
    char *folder = strdup(path);
    if (!folder) {
        return murk_no_memory(err, path, "for a path");
    }
    folder[murk_path_name(path) - path] = '\0';
    const murk_status status =
        folder[0] ? murk_folder_make(folder, err) : MURK_OK;
    free(folder);
    return status;
}

void murk_checkpoint_write(murk_checkpoint *c, const murk_stage *stage,
                           const murk_record_buffers *buffers,
                           const murk_light_sums *sums, uint64_t batches)
{
    const size_t n = buffers->surface.n + buffers->volume.n;
    murk_error err = {0};
    murk_block merged = {0};
    uint32_t *count = calloc(batches + 1, sizeof *count);
    murk_status status =
        count ? murk_block_resize(&merged, n * sizeof(murk_photon),
                                  murk_block_memory_bytes(), &err)
              : murk_no_memory(&err, c->path, "for %.3g records", (double)n);
    /* The folder of the results is made by the first checkpoint. */
    if (!status) {
        status = make_folder_of(c->path, &err);
    }
    if (!status) {
        merge(merged.bytes, count, buffers);
        const murk_light_part_content content = {.shard = {1, 1},
                                                 .batches = batches,
                                                 .count = count,
                                                 .record = merged.bytes,
                                                 .records = n,
                                                 .sums = sums};
        status = murk_light_part_write(c->path, &content, stage, &err);
    }
    if (status) {
        murk_warn(err.where, "no checkpoint is written: %s", err.text);
    }
    murk_block_release(&merged);
    free(count);
    c->last_s = murk_clock_s();
}

murk_status murk_checkpoint_read(murk_light_parts **out, const char *path,
                                 const murk_stage *stage, murk_error *err)
{
    *out = NULL;
    murk_error why = {0};
    murk_status status = MURK_OK;
    const bool is_there = access(path, F_OK) == 0 || errno != ENOENT;
    if (is_there) {
        /* The run writes this file again, so it is no input. */
        const murk_inputs_before before = murk_inputs_try();
        status = murk_light_parts_read(out, &path, 1, stage, &why);
        murk_inputs_forget(&before);
    }
    /* A file that another run has left, or that is damaged, is no reason to
     * end; one that could not be read here would be lost. */
    if (status == MURK_BAD_FILE || status == MURK_BAD_VALUE) {
        murk_warn(why.where,
                  "this checkpoint is not used, and light is traced from the "
                  "begin: %s",
                  why.text);
        status = MURK_OK;
    } else if (status) {
        status = murk_fail(err, status, why.where, "%s", why.text);
    }
    /* All ranks go on from the same photons, or none does. */
    const uint64_t end = *out ? murk_light_parts_end(*out) : 0;
    bool is_same = true;
    status = murk_ranks_compare(&is_same, &end, sizeof end, status, err);
    if (!status && !is_same) {
        murk_warn(path, "ranks see different checkpoints, so light is traced "
                        "from the begin: they need a common folder");
    }
    if (status || !is_same) {
        murk_light_parts_destroy(*out);
        *out = NULL;
    } else if (*out) {
        murk_note(path, "%.6g photons of an earlier run go on from here",
                  (double)end * MURK_BATCH_PHOTONS);
    }
    return status;
}
