/* Results that took long, kept for whoever asks for the same again in this
 * process: a fit reads one scene a thousand times.
 *
 * A result is kept under all the bytes that it follows from, which are held
 * against each other whole, so what is found is what would be computed, bit by
 * bit: whether it was kept shows in time alone. The one that was not asked for
 * the longest makes room. */
#ifndef MURK_BASE_CACHE_H
#define MURK_BASE_CACHE_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_CACHE_MAX       128
#define MURK_CACHE_BYTES_MAX 33554432 /* of all in one place, keys included */

/* Static, begun as MURK_CACHE_NONE; any number of threads. */
typedef struct murk_cache {
    atomic_flag is_taken;
    size_t n, bytes;
    uint64_t now;
    struct murk_cache_item {
        uint64_t sum[2], used;
        size_t key_size, size;
        void *bytes; /* key, then value */
    } item[MURK_CACHE_MAX];
} murk_cache;

#define MURK_CACHE_NONE              \
    {                                \
        .is_taken = ATOMIC_FLAG_INIT \
    }

/* A copy of what is kept under a key, for free(); NULL: nothing, or no
 * memory. */
void *murk_cache_find(murk_cache *kept, const void *key, size_t key_size,
                      size_t *size);

/* Keeps a copy. What is too large, or finds no memory, is not kept. */
void murk_cache_put(murk_cache *kept, const void *key, size_t key_size,
                    const void *value, size_t size);

#endif
