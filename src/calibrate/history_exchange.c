/* Packs the histories of batches for the other ranks: the sizes of each batch,
 * then its arrays. Cosines that no contribution needs are left out. */
#include "calibrate/history_exchange.h"

#include "base/ranks.h"
#include "calibrate/packed_arrays.h"

#include <stdlib.h>
#include <string.h>

/* The sizes of a batch. */
typedef struct batch_head {
    uint64_t contributions, turns;
} batch_head;

enum { ARRAYS = 6 };

/* The arrays of n contributions and their cosines in a buffer. */
static void arrays_of(murk_packed_array out[ARRAYS], const murk_histories *h,
                      const batch_head *head)
{
    const size_t n = (size_t)head->contributions, turns = (size_t)head->turns;
    const size_t cells = n * h->media;
    const murk_packed_array arrays[ARRAYS] = {
        {h->contribution, n * sizeof *h->contribution},
        {h->path_m, cells * sizeof *h->path_m},
        {h->chord_m, cells * sizeof *h->chord_m},
        {h->count, cells * sizeof *h->count},
        {h->turn, turns * sizeof *h->turn},
        {h->turn_medium, turns * sizeof *h->turn_medium}};
    memcpy(out, arrays, sizeof arrays);
}

/* The size of a batch with its head. */
static size_t packed_bytes(const murk_histories *h, const batch_head *head)
{
    murk_packed_array array[ARRAYS];
    arrays_of(array, h, head);
    return sizeof *head + murk_arrays_bytes(array, ARRAYS);
}

static batch_head head_of(const murk_photon_history *f)
{
    return (batch_head){f->buffer.n, f->needed};
}

/* Packs the own batches. *bytes: for free(). */
static murk_status pack(char **bytes, size_t *size, const murk_recorder *r,
                        const size_t *place, size_t own, murk_error *err)
{
    bool fits = true;
    /* The size of all. */
    *size = 0;
    for (size_t k = 0; k < own; ++k) {
        const murk_photon_history *f = &r->photon[place[murk_ranks_item(k)]];
        const batch_head head = head_of(f);
        *size += packed_bytes(&f->buffer, &head);
        fits = fits && !f->is_short_of_memory;
    }
    char *at = *bytes = fits ? malloc(*size + 1) : NULL;
    if (!at) {
        return murk_no_memory(err, "fit", "for the histories of a wave");
    }
    /* The head and the arrays of each batch. */
    for (size_t k = 0; k < own; ++k) {
        const murk_photon_history *f = &r->photon[place[murk_ranks_item(k)]];
        const batch_head head = head_of(f);
        murk_packed_array array[ARRAYS];
        memcpy(at, &head, sizeof head);
        at += sizeof head;
        arrays_of(array, &f->buffer, &head);
        at = murk_arrays_pack(at, array, ARRAYS);
    }
    return MURK_OK;
}

/* Fills the batches of another rank. A lack of memory is noted in the batch,
 * and murk_recorder_gather() reports it. */
static void unpack(murk_recorder *r, const char *at, const size_t *place,
                   size_t n, unsigned rank)
{
    for (size_t k = 0; k < n; ++k) {
        if (murk_ranks_owner(k) != rank) {
            continue;
        }
        murk_photon_history *f = &r->photon[place[k]];
        murk_histories *buffer = &f->buffer;
        batch_head head;
        memcpy(&head, at, sizeof head);
        at += sizeof head;
        buffer->n = buffer->turns = f->needed = 0;
        if (!murk_histories_reserve(buffer, (size_t)head.contributions,
                                    (size_t)head.turns)) {
            f->is_short_of_memory = true;
            return;
        }
        murk_packed_array array[ARRAYS];
        arrays_of(array, buffer, &head);
        at = murk_arrays_unpack(array, ARRAYS, at);
        buffer->n = (size_t)head.contributions;
        buffer->turns = f->needed = (size_t)head.turns;
    }
}

murk_status murk_recorder_exchange(murk_recorder *r, const size_t *place,
                                   size_t n, murk_status status,
                                   murk_error *err)
{
    const size_t own = (size_t)murk_ranks_share(n);
    char *bytes = NULL;
    size_t size = 0;
    murk_gathered all = {0};
    /* Own batch k lies in buffer k, which is at or before its own place. */
    for (size_t k = own; k-- > 0;) {
        const size_t to = place[murk_ranks_item(k)];
        const murk_photon_history moved = r->photon[k];
        r->photon[k] = r->photon[to];
        r->photon[to] = moved;
    }
    if (!status) {
        status = pack(&bytes, &size, r, place, own, err);
    }
    status = murk_ranks_gather(&all, bytes, size, status, err);
    for (unsigned rank = 0; rank < murk_ranks_count() && !status; ++rank) {
        if (rank != murk_ranks_number()) {
            unpack(r, all.bytes + all.begin[rank], place, n, rank);
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    return status;
}
