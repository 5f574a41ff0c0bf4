/* Cache of phase tables in memory (base/cache.h): the key is the input of
 * the table, and the value holds the struct, the nodes and the guide. */
#include "medium/phase_cache.h"

#include "base/cache.h"
#include "medium/phase_nodes.h"

#include <stdlib.h>
#include <string.h>

static murk_cache kept = MURK_CACHE_NONE;

/* The key: a, then b. The caller frees it with free(). */
static double *key_of(const murk_phase_origin *origin, size_t *size)
{
    const size_t half = origin->n * sizeof(double);
    double *key = malloc(2 * half);
    if (key) {
        memcpy(key, origin->a, half);
        memcpy(key + origin->n, origin->b, half);
    }
    *size = 2 * half;
    return key;
}

static size_t guide_bytes(const murk_phase_table *table)
{
    return table->guides * sizeof *table->guide;
}

static size_t node_bytes(const murk_phase_table *table)
{
    return table->nodes * sizeof *table->node;
}

/* Makes a table of the cached bytes: struct, nodes, guide. */
static murk_phase_table *unpack(const char *bytes)
{
    murk_phase_table *table = malloc(sizeof *table);
    if (!table) {
        return NULL;
    }
    memcpy(table, bytes, sizeof *table);
    table->node = malloc(node_bytes(table) + 1);
    table->guide = malloc(guide_bytes(table) + 1);
    if (!table->node || !table->guide) {
        murk_phase_table_destroy(table);
        return NULL;
    }
    bytes += sizeof *table;
    memcpy(table->node, bytes, node_bytes(table));
    memcpy(table->guide, bytes + node_bytes(table), guide_bytes(table));
    return table;
}

bool murk_phase_cache_find(murk_phase_table **out,
                           const murk_phase_origin *origin)
{
    size_t key_size, size;
    double *key = key_of(origin, &key_size);
    char *bytes = key ? murk_cache_find(&kept, key, key_size, &size) : NULL;
    murk_phase_table *table = bytes ? unpack(bytes) : NULL;
    if (table) {
        *out = table;
    }
    free(key);
    free(bytes);
    return table != NULL;
}

void murk_phase_cache_put(const murk_phase_table *table,
                          const murk_phase_origin *origin)
{
    const size_t size = sizeof *table + node_bytes(table) + guide_bytes(table);
    size_t key_size;
    double *key = key_of(origin, &key_size);
    char *bytes = malloc(size);
    if (key && bytes) {
        memcpy(bytes, table, sizeof *table);
        memcpy(bytes + sizeof *table, table->node, node_bytes(table));
        memcpy(bytes + sizeof *table + node_bytes(table), table->guide,
               guide_bytes(table));
        murk_cache_put(&kept, key, key_size, bytes, size);
    }
    free(key);
    free(bytes);
}
