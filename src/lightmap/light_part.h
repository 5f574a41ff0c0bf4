/* Parts of the light of a scene: the batches of photons that the shards of a
 * run traced (lightmap/light_part_trace.h), and that a run puts together
 * (murk_lightmap_merge() in lightmap/lightmap.h).
 *
 * Shard K of N traces the batches K - 1, K - 1 + N, K - 1 + 2 N and so on. The
 * file of a part has the records of each batch, with shares of a packet in
 * place of watts, because the power of a packet depends on the number of all
 * photons, and the sums of ledger and tallies as integers. Sums of integers do
 * not depend on their order, and records are put in the order of photons, so
 * the parts together give the light of an undivided run in every bit. */
#ifndef MURK_LIGHTMAP_LIGHT_PART_H
#define MURK_LIGHTMAP_LIGHT_PART_H

#include "base/shard.h"
#include "lightmap/record_buffers.h"
#include "world/stage.h"

/* The section "part" of a file, as it is stored. */
typedef struct murk_light_part_facts {
    uint64_t batches; /* of this part */
    uint64_t end;     /* photons of this part have smaller numbers */
    uint32_t number, count;
    char version[64]; /* murk_host_version(), ended by '\0' */
} murk_light_part_facts;

/* The number of photons of a whole run, at most: with photons.store as many as
 * are tried for so many records. */
uint64_t murk_light_photons_max(const murk_scene_photons *settings);

/* The number of batches of a shard in a run of at most photons_max photons, and
 * the number behind the last photon of the first `batches` of them. */
uint64_t murk_light_part_batches(uint64_t photons_max, murk_shard shard);
uint64_t murk_light_part_end(uint64_t photons_max, murk_shard shard,
                             uint64_t batches);

/* What a file of a part has. */
typedef struct murk_light_part_content {
    murk_shard shard;
    uint64_t batches;
    const uint32_t *count;     /* [batches] records of each batch */
    const murk_photon *record; /* [records] by batch, and by photon in it */
    size_t records;
    const struct murk_light_sums *sums; /* lightmap/rank_exchange.h */
} murk_light_part_content;

/* Writes the file of a part. Fails as murk_map_file_write(). */
murk_status murk_light_part_write(const char *path,
                                  const murk_light_part_content *content,
                                  const murk_stage *stage, murk_error *err);

typedef struct murk_light_parts murk_light_parts;

/* Reads the files of parts. The same part may be given several times. Fails
 * with MURK_BAD_FILE if a file is damaged; with MURK_BAD_VALUE if a part
 * belongs to another scene, seed, version of murk or number of shards, with the
 * first difference, or if two files of one shard differ; or with
 * MURK_NO_MEMORY. Missing parts are named in a warning. The stage must outlive
 * *out. */
murk_status murk_light_parts_read(murk_light_parts **out,
                                  const char *const *path, size_t n,
                                  const murk_stage *stage, murk_error *err);
void murk_light_parts_destroy(murk_light_parts *parts); /* accepts NULL */

/* Adds the sums of all parts to the ledger and the tallies (NULL: none). */
void murk_light_parts_add(const murk_light_parts *parts, murk_ledger *ledger,
                          murk_tallies *tallies);

/* True if a part has the batch; fills *records, which may be NULL, with the
 * records of the batch in the order of photons, which belong to `parts`. */
bool murk_light_parts_batch(const murk_light_parts *parts, uint64_t batch,
                            const murk_photon **records, size_t *n);

/* The number behind the last batch that any part has. */
uint64_t murk_light_parts_end(const murk_light_parts *parts);

#endif
