/* Comparisons of two traced lights in every bit: records in their order, the
 * ledger, tallies, and powers of packets. */
#ifndef MURK_TESTS_SAME_LIGHT_H
#define MURK_TESTS_SAME_LIGHT_H

#include "lightmap/lightmap.h"

#include <stdlib.h>
#include <string.h>

static inline bool same_map(const murk_photon_map *a, const murk_photon_map *b)
{
    const size_t n = murk_photon_map_count(a);
    return n == murk_photon_map_count(b) &&
           (n == 0 ||
            memcmp(murk_photon_map_photons(a), murk_photon_map_photons(b),
                   n * sizeof(murk_photon)) == 0);
}

static inline bool same_ledger(const murk_ledger *a, const murk_ledger *b)
{
    const size_t n = murk_ledger_cells(a);
    int64_t *x = malloc(n * sizeof *x), *y = malloc(n * sizeof *y);
    murk_ledger_read(a, x);
    murk_ledger_read(b, y);
    const bool is_same = memcmp(x, y, n * sizeof *x) == 0;
    free(x);
    free(y);
    return is_same;
}

/* Both may be NULL. */
static inline bool same_tallies(const murk_tallies *a, const murk_tallies *b)
{
    if (!a || !b) {
        return a == b;
    }
    const size_t n = murk_tallies_words(a);
    uint64_t *x = malloc(n * sizeof *x), *y = malloc(n * sizeof *y);
    murk_tallies_read_sums(a, x);
    murk_tallies_read_sums(b, y);
    const bool is_same = memcmp(x, y, n * sizeof *x) == 0;
    free(x);
    free(y);
    return is_same;
}

static inline bool same_packets(const murk_traced *a, const murk_traced *b)
{
    return a->emitted == b->emitted && a->channels == b->channels &&
           memcmp(a->packet_w, b->packet_w,
                  a->channels * sizeof *a->packet_w) == 0;
}

#endif
