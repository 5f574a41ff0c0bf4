/* A cache with least-recently-used replacement: a small array of items that is
 * searched linearly by the 128-bit checksum of the key, under a spin lock. At
 * most MURK_CACHE_MAX items make a tree or hash table unnecessary. The lock is
 * held for one search and for the copy of a value that is found or the removal
 * of old items. */
#include "base/cache.h"

#include "base/file.h"

#include <stdlib.h>
#include <string.h>

static void enter(murk_cache *cache)
{
    while (atomic_flag_test_and_set_explicit(&cache->is_taken,
                                             memory_order_acquire)) {
    }
}

static void leave(murk_cache *cache)
{
    atomic_flag_clear_explicit(&cache->is_taken, memory_order_release);
}

static struct murk_cache_item *find_item(murk_cache *cache, const void *key,
                                         size_t key_size, const uint64_t sum[2])
{
    for (size_t i = 0; i < cache->n; ++i) {
        struct murk_cache_item *item = &cache->item[i];
        if (item->sum[0] == sum[0] && item->sum[1] == sum[1] &&
            item->key_size == key_size &&
            memcmp(item->bytes, key, key_size) == 0) {
            return item;
        }
    }
    return NULL;
}

void *murk_cache_find(murk_cache *cache, const void *key, size_t key_size,
                      size_t *size)
{
    uint64_t sum[2];
    void *out = NULL;
    murk_checksum(key, key_size, sum);
    enter(cache);
    struct murk_cache_item *item = find_item(cache, key, key_size, sum);
    if (item) {
        item->used = ++cache->now;
        out = malloc(item->size + 1);
    }
    if (out) {
        memcpy(out, (const char *)item->bytes + key_size, item->size);
        *size = item->size;
    }
    leave(cache);
    return out;
}

/* Removes the least recently used item. Returns the memory of the item, which
 * the caller frees. */
static void *drop_oldest(murk_cache *cache)
{
    size_t oldest = 0;
    for (size_t i = 1; i < cache->n; ++i) {
        oldest = cache->item[i].used < cache->item[oldest].used ? i : oldest;
    }
    void *bytes = cache->item[oldest].bytes;
    cache->bytes -= cache->item[oldest].key_size + cache->item[oldest].size;
    cache->item[oldest] = cache->item[--cache->n];
    return bytes;
}

void murk_cache_put(murk_cache *cache, const void *key, size_t key_size,
                    const void *value, size_t size)
{
    struct murk_cache_item item = {.key_size = key_size, .size = size};
    if (key_size > MURK_CACHE_BYTES_MAX / 2 ||
        size > MURK_CACHE_BYTES_MAX / 2) {
        return;
    }
    item.bytes = malloc(key_size + size);
    if (!item.bytes) {
        return;
    }
    memcpy(item.bytes, key, key_size);
    memcpy((char *)item.bytes + key_size, value, size);
    murk_checksum(key, key_size, item.sum);
    enter(cache);
    if (find_item(cache, key, key_size,
                  item.sum)) { /* stored already, perhaps by another thread in
                                * the meantime */
        free(item.bytes);
    } else {
        while (cache->n == MURK_CACHE_MAX ||
               (cache->n > 0 &&
                cache->bytes + key_size + size > MURK_CACHE_BYTES_MAX)) {
            free(drop_oldest(cache));
        }
        item.used = ++cache->now;
        cache->bytes += key_size + size;
        cache->item[cache->n++] = item;
    }
    leave(cache);
}
