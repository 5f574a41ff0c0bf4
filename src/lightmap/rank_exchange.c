/* Packs the records of batches for the other ranks, and adds the sums of ledger
 * and tallies of all ranks (lightmap/rank_exchange.h). */
#include "lightmap/rank_exchange.h"

#include "base/ranks.h"

#include <stdlib.h>
#include <string.h>

/* Packs the flag, the numbers of records of the own batches, then the records.
 * *bytes: for free(). */
static murk_status pack(char **bytes, size_t *size,
                        const murk_record_buffers *buffers,
                        const size_t *buffer, size_t n, uint64_t flag,
                        murk_error *err)
{
    uint64_t head[MURK_WAVE_BATCHES_MAX + 1] = {flag};
    size_t heads = 1, records = 0;
    bool fits = true;
    /* The numbers of records. */
    for (size_t k = 0; k < murk_ranks_share(n); ++k) {
        const murk_record_list *list =
            &buffers->buffer[buffer[murk_ranks_item(k)]];
        head[heads++] = list->n;
        records += list->n;
        fits = fits && !list->is_short_of_memory;
    }
    *size = heads * sizeof *head + records * sizeof(murk_photon);
    char *at = *bytes = fits ? malloc(*size) : NULL;
    if (!at) {
        return murk_no_memory(err, buffers->settings->where,
                              "for the records of a wave");
    }
    memcpy(at, head, heads * sizeof *head);
    at += heads * sizeof *head;
    /* The records. */
    for (size_t k = 0; k < murk_ranks_share(n); ++k) {
        const murk_record_list *list =
            &buffers->buffer[buffer[murk_ranks_item(k)]];
        if (list->n) {
            memcpy(at, list->photon, list->n * sizeof *list->photon);
        }
        at += list->n * sizeof *list->photon;
    }
    return MURK_OK;
}

/* Fills the batches of another rank. */
static void unpack(murk_record_buffers *buffers, const char *bytes,
                   const size_t *buffer, size_t n, unsigned rank)
{
    const size_t own = (size_t)murk_ranks_share_of(n, rank);
    const char *counts = bytes + sizeof(uint64_t);
    const char *at = counts + own * sizeof(uint64_t);
    for (size_t k = 0; k < n; ++k) {
        uint64_t records;
        if (murk_ranks_owner(k) != rank) {
            continue;
        }
        memcpy(&records, counts, sizeof records);
        counts += sizeof records;
        murk_record_buffers_fill(buffers, buffer[k], (const void *)at, records);
        at += records * sizeof(murk_photon);
    }
}

murk_status murk_ranks_exchange_records(murk_record_buffers *buffers,
                                        const size_t *buffer, size_t n,
                                        bool *flag, murk_status status,
                                        murk_error *err)
{
    if (murk_ranks_count() == 1) {
        return status;
    }
    char *bytes = NULL;
    size_t size = 0;
    murk_gathered all = {0};
    if (!status) {
        status = pack(&bytes, &size, buffers, buffer, n, *flag, err);
    }
    status = murk_ranks_gather(&all, bytes, size, status, err);
    /* The flag of rank 0, and the batches of all ranks but this one. */
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        const char *from = all.bytes + all.begin[r];
        if (r == 0) {
            uint64_t first;
            memcpy(&first, from, sizeof first);
            *flag = first != 0;
        }
        if (r != murk_ranks_number()) {
            unpack(buffers, from, buffer, n, r);
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    return status;
}

murk_status murk_light_sums_read(murk_light_sums *out,
                                 const murk_ledger *ledger,
                                 const murk_tallies *tallies, bool of_all,
                                 murk_status status, murk_error *err)
{
    *out =
        (murk_light_sums){.cells = murk_ledger_cells(ledger),
                          .words = tallies ? murk_tallies_words(tallies) : 0};
    out->cell = calloc(out->cells + 1, sizeof *out->cell);
    out->word = calloc(out->words + 1, sizeof *out->word);
    if (!status && !(out->cell && out->word)) {
        status = murk_no_memory(err, "", "for the sums of the light");
    }
    if (!status) {
        murk_ledger_read(ledger, out->cell);
    }
    if (!status && tallies) {
        murk_tallies_read_sums(tallies, out->word);
    }
    if (of_all) {
        /* The sum of two's complements is that of signed numbers. */
        status = murk_ranks_sum((uint64_t *)out->cell, out->cells, false,
                                status, err);
        status = murk_ranks_sum(out->word, out->words, true, status, err);
    }
    return status;
}

void murk_light_sums_release(murk_light_sums *sums)
{
    free(sums->cell);
    free(sums->word);
    *sums = (murk_light_sums){.cell = NULL};
}

murk_status murk_ranks_add_sums(murk_ledger *ledger, murk_tallies *tallies,
                                murk_status status, murk_error *err)
{
    if (murk_ranks_count() == 1) {
        return status;
    }
    murk_light_sums own, all;
    status = murk_light_sums_read(&own, ledger, tallies, false, status, err);
    status = murk_light_sums_read(&all, ledger, tallies, true, status, err);
    /* Add the differences, of numbers of 128 bits with a borrow. */
    if (!status) {
        for (size_t i = 0; i < all.cells; ++i) {
            all.cell[i] -= own.cell[i];
        }
        murk_ledger_add(ledger, all.cell);
    }
    if (!status && tallies) {
        for (size_t i = 0; i < all.words; i += 2) {
            const bool borrows = all.word[i] < own.word[i];
            all.word[i] -= own.word[i];
            all.word[i + 1] -= own.word[i + 1] + borrows;
        }
        murk_tallies_add_sums(tallies, all.word);
    }
    murk_light_sums_release(&own);
    murk_light_sums_release(&all);
    return status;
}
