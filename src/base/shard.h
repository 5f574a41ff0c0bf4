/* A shard: one of several parts of a run, which machines without a common
 * memory compute and `murk merge` puts together. */
#ifndef MURK_BASE_SHARD_H
#define MURK_BASE_SHARD_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_SHARDS_MAX 100000 /* of a run; a choice */

typedef struct murk_shard {
    uint32_t number; /* 1..count */
    uint32_t count;  /* 0: the run is not divided */
} murk_shard;

/* Fails with MURK_BAD_VALUE, at the place "shard", if there is no such shard.
 */
murk_status murk_shard_check(murk_shard shard, murk_error *err);

/* Fails with MURK_BAD_VALUE unless `version` of murk made the part in the file
 * `path`. made_by: the version in the file, of `size` characters at most, which
 * need not end with '\0'. */
murk_status murk_shard_check_version(const char *made_by, size_t size,
                                     const char *version, const char *path,
                                     murk_error *err);

/* Warns of the parts for which has_part(of, number) is false, of which the
 * first few are named. `now` says what happens to their work. */
void murk_shards_warn_of_missing(bool (*has_part)(const void *of,
                                                  uint32_t number),
                                 const void *of, uint32_t count,
                                 const char *now);

#endif
