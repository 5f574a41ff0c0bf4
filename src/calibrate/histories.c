/* The arrays of photon histories: they grow by half, so that the number of
 * copies stays small. A binary search finds the contributions of a range of
 * photons. */
#include "calibrate/histories.h"

#include <stdlib.h>

/* First capacity, in contributions: some 10 kB with one re-weighted medium. */
#define FIRST_CAPACITY 256

static bool resize(void **array, size_t n, size_t size)
{
    const size_t bytes = n * size;
    void *resized = realloc(*array, bytes > 0 ? bytes : 1);
    if (resized) {
        *array = resized;
    }
    return resized != NULL;
}

static bool set_capacity(murk_histories *h, size_t n)
{
    const size_t cells = n * h->media;
    const bool fits =
        resize((void **)&h->contribution, n, sizeof *h->contribution) &&
        resize((void **)&h->path_m, cells, sizeof *h->path_m) &&
        resize((void **)&h->chord_m, cells, sizeof *h->chord_m) &&
        resize((void **)&h->count, cells, sizeof *h->count);
    h->capacity = fits ? n : h->capacity;
    return fits;
}

static bool set_turn_capacity(murk_histories *h, size_t n)
{
    const bool fits = resize((void **)&h->turn, n, sizeof *h->turn) &&
                      resize((void **)&h->turn_medium, n, 1);
    h->turn_capacity = fits ? n : h->turn_capacity;
    return fits;
}

/* The capacity to grow to, of at least `min`. */
static size_t grown(size_t capacity, size_t min)
{
    const size_t by_half = capacity + capacity / 2;
    return min > by_half              ? min
           : by_half < FIRST_CAPACITY ? FIRST_CAPACITY
                                      : by_half;
}

bool murk_histories_reserve(murk_histories *h, size_t more, size_t more_turns)
{
    const size_t min = h->n + more, min_turns = h->turns + more_turns;
    return (min <= h->capacity || set_capacity(h, grown(h->capacity, min))) &&
           (min_turns <= h->turn_capacity ||
            set_turn_capacity(h, grown(h->turn_capacity, min_turns)));
}

void murk_histories_fit(murk_histories *h)
{
    set_capacity(h, h->n);
    set_turn_capacity(h, h->turns);
}

size_t murk_histories_first(const murk_histories *h, size_t parts, size_t part)
{
    size_t low = 0, high = h->n;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const uint64_t photon = h->contribution[middle].photon;
        if (photon * parts / h->emitted < part) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

double murk_histories_bytes(size_t media, double n, double turns)
{
    const size_t each = sizeof(murk_contribution) +
                        media * (2 * sizeof(float) + sizeof(uint32_t));
    return n * (double)each + turns * (double)(sizeof(float) + 1);
}

void murk_histories_release(murk_histories *h)
{
    murk_photon_map_destroy(h->surface);
    murk_photon_map_destroy(h->volume);
    free(h->medium);
    free(h->emitted_in);
    free(h->packet_w);
    free(h->contribution);
    free(h->path_m);
    free(h->chord_m);
    free(h->count);
    free(h->turn);
    free(h->turn_medium);
}

void murk_histories_destroy(murk_histories *h)
{
    if (h) {
        murk_histories_release(h);
        free(h);
    }
}
