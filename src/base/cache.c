#include "base/cache.h"

#include "base/file.h"

#include <stdlib.h>
#include <string.h>

static void enter(murk_cache *kept)
{
    while (atomic_flag_test_and_set_explicit(&kept->is_taken,
                                             memory_order_acquire)) {
    }
}

static void leave(murk_cache *kept)
{
    atomic_flag_clear_explicit(&kept->is_taken, memory_order_release);
}

static struct murk_cache_item *look(murk_cache *kept, const void *key,
                                    size_t key_size, const uint64_t sum[2])
{
    for (size_t i = 0; i < kept->n; ++i) {
        struct murk_cache_item *item = &kept->item[i];
        if (item->sum[0] == sum[0] && item->sum[1] == sum[1] &&
            item->key_size == key_size &&
            memcmp(item->bytes, key, key_size) == 0) {
            return item;
        }
    }
    return NULL;
}

void *murk_cache_find(murk_cache *kept, const void *key, size_t key_size,
                      size_t *size)
{
    uint64_t sum[2];
    void *out = NULL;
    murk_checksum(key, key_size, sum);
    enter(kept);
    struct murk_cache_item *item = look(kept, key, key_size, sum);
    if (item) {
        item->used = ++kept->now;
        out = malloc(item->size + 1);
    }
    if (out) {
        memcpy(out, (const char *)item->bytes + key_size, item->size);
        *size = item->size;
    }
    leave(kept);
    return out;
}

/* Takes the one out that was not used the longest; the caller frees it. */
static void *drop_oldest(murk_cache *kept)
{
    size_t oldest = 0;
    for (size_t i = 1; i < kept->n; ++i) {
        oldest = kept->item[i].used < kept->item[oldest].used ? i : oldest;
    }
    void *bytes = kept->item[oldest].bytes;
    kept->bytes -= kept->item[oldest].key_size + kept->item[oldest].size;
    kept->item[oldest] = kept->item[--kept->n];
    return bytes;
}

void murk_cache_put(murk_cache *kept, const void *key, size_t key_size,
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
    enter(kept);
    if (look(kept, key, key_size, item.sum)) { /* another was faster */
        free(item.bytes);
    } else {
        while (kept->n == MURK_CACHE_MAX ||
               (kept->n > 0 &&
                kept->bytes + key_size + size > MURK_CACHE_BYTES_MAX)) {
            free(drop_oldest(kept));
        }
        item.used = ++kept->now;
        kept->bytes += key_size + size;
        kept->item[kept->n++] = item;
    }
    leave(kept);
}
