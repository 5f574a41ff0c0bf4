/* A cache of results that take long to compute, for later requests in the same
 * process: a fit reads one scene a thousand times.
 *
 * The key of a result is the sequence of all bytes from which the result
 * follows. Keys are compared in full, so a cached result equals the recomputed
 * one bit by bit, and the cache changes nothing but the run time. The least
 * recently used result is removed first. */
#ifndef MURK_BASE_CACHE_H
#define MURK_BASE_CACHE_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Optical properties of droplets and phase tables of one scene are some tens of
 * results. */
#define MURK_CACHE_MAX       128
#define MURK_CACHE_BYTES_MAX 33554432 /* keys and values of one cache */

/* A static object, initialised with MURK_CACHE_NONE; any number of threads may
 * use it. */
typedef struct murk_cache {
    atomic_flag is_taken;
    size_t n, bytes;
    uint64_t now;
    struct murk_cache_item {
        uint64_t sum[2], used;
        size_t key_size, size;
        void *bytes; /* the key, followed by the value */
    } item[MURK_CACHE_MAX];
} murk_cache;

#define MURK_CACHE_NONE              \
    {                                \
        .is_taken = ATOMIC_FLAG_INIT \
    }

/* Returns a copy of the value of a key, which the caller frees, and the size of
 * the value in *size. Returns NULL and leaves *size unchanged if the cache has
 * no such key or there is no memory. */
void *murk_cache_find(murk_cache *cache, const void *key, size_t key_size,
                      size_t *size);

/* Stores copies of the key and the value. Nothing is stored if the cache has
 * the key already, if the key or the value has more than half of
 * MURK_CACHE_BYTES_MAX bytes, or if there is no memory. */
void murk_cache_put(murk_cache *cache, const void *key, size_t key_size,
                    const void *value, size_t size);

#endif
