/* A shard: one of several parts of a run, which machines without a common
 * memory compute and `murk merge` puts together. */
#ifndef MURK_BASE_SHARD_H
#define MURK_BASE_SHARD_H

#include <stdint.h>

#define MURK_SHARDS_MAX 100000 /* of a run; a choice */

typedef struct murk_shard {
    uint32_t number; /* 1..count */
    uint32_t count;  /* 0: the run is not divided */
} murk_shard;

#endif
