/* The functions of base/ranks.h over the table of the host of the calling
 * thread. */
#include "base/ranks.h"

#include "base/file.h"
#include "base/host.h"

#include <stdlib.h>
#include <string.h>

/* More items than are ever dealt out. */
#define ITEMS_MAX (UINT64_C(1) << 60)

unsigned murk_ranks_count(void)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    return ranks ? ranks->count : 1;
}

unsigned murk_ranks_number(void)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    return ranks ? ranks->number : 0;
}

unsigned murk_ranks_threads(void)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    return ranks ? ranks->threads : 0;
}

murk_ranks_here murk_ranks_on_machine(void)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    return ranks ? ranks->here : (murk_ranks_here){.count = 1};
}

const murk_ranks *murk_ranks_leave(void)
{
    murk_host *host = murk_host_now();
    const murk_ranks *ranks = host->ranks;
    host->ranks = NULL;
    return ranks;
}

void murk_ranks_return(const murk_ranks *ranks)
{
    murk_host_now()->ranks = ranks;
}

void murk_ranks_keep_in_first(bool is_so)
{
    murk_host_now()->keeps_in_first = is_so;
}

bool murk_ranks_keeps(void)
{
    return murk_ranks_number() == 0 || !murk_host_now()->keeps_in_first;
}

bool murk_ranks_keeps_shared(void)
{
    return murk_ranks_keeps() && murk_ranks_on_machine().number == 0;
}

murk_status murk_ranks_agree(murk_status status, murk_error *err)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    if (!ranks) {
        return status;
    }
    status = ranks->agree(ranks->context, status, err);
    if (status) {
        atomic_store(&murk_host_now()->stop, 1);
    }
    return status;
}

murk_status murk_ranks_sum(uint64_t *word, size_t n, bool is_128,
                           murk_status status, murk_error *err)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    status = murk_ranks_agree(status, err);
    if (!status && ranks) {
        ranks->sum(ranks->context, word, n, is_128);
    }
    return status;
}

/* Each bit is 0 in all ranks but one, so the sum of words has no carry. */
murk_status murk_ranks_complete(void *array, size_t bytes, murk_status status,
                                murk_error *err)
{
    if (murk_ranks_count() == 1) {
        return status;
    }
    const size_t words = (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t);
    uint64_t *word = status ? NULL : calloc(words + 1, sizeof *word);
    if (!status && !word) {
        status = murk_no_memory(err, "", "to exchange results");
    }
    if (!status && bytes > 0) {
        memcpy(word, array, bytes);
    }
    status = murk_ranks_sum(word, words, false, status, err);
    if (!status && bytes > 0) {
        memcpy(array, word, bytes);
    }
    free(word);
    return status;
}

murk_status murk_ranks_gather(murk_gathered *out, const void *bytes,
                              size_t size, murk_status status, murk_error *err)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    const size_t count = murk_ranks_count();
    *out = (murk_gathered){.begin = calloc(count + 1, sizeof *out->begin)};
    uint64_t *sizes = calloc(count + 1, sizeof *sizes);
    if (!status && (!sizes || !out->begin)) {
        status = murk_no_memory(err, "", "to exchange results");
    }
    /* The sizes, then the bytes. */
    status = murk_ranks_agree(status, err);
    if (!status) {
        sizes[0] = size;
        if (ranks) {
            ranks->sizes(ranks->context, size, sizes);
        }
        for (size_t r = 0; r < count; ++r) {
            out->begin[r + 1] = out->begin[r] + sizes[r];
        }
        out->bytes = malloc(out->begin[count] + 1);
        if (!out->bytes) {
            status = murk_no_memory(err, "", "to exchange results");
        }
        status = murk_ranks_agree(status, err);
    }
    if (!status && ranks) {
        ranks->gather(ranks->context, bytes, out->bytes, sizes);
    } else if (!status && size > 0) {
        memcpy(out->bytes, bytes, size);
    }
    free(sizes);
    return status;
}

murk_status murk_ranks_join(void *array, size_t n, size_t item_bytes,
                            murk_status status, murk_error *err)
{
    if (murk_ranks_count() == 1) {
        return status;
    }
    const size_t begin = (size_t)murk_ranks_begin(n);
    const size_t own = ((size_t)murk_ranks_end(n) - begin) * item_bytes;
    /* In the order of the ranks the blocks are the array. */
    murk_gathered all;
    status = murk_ranks_gather(&all, (char *)array + begin * item_bytes, own,
                               status, err);
    if (!status && all.begin[murk_ranks_count()] != n * item_bytes) {
        status = murk_ranks_agree(
            murk_fail(err, MURK_RUN_FAILED, "",
                      "ranks exchange results of different sizes: do their "
                      "machines differ?"),
            err);
    }
    if (!status) {
        memcpy(array, all.bytes, n * item_bytes);
    }
    murk_gathered_release(&all);
    return status;
}

/* What a rank tells of its failure. */
typedef struct failure {
    murk_status status;
    murk_error error;
} failure;

murk_status murk_ranks_share_failure(murk_status status, murk_error *err)
{
    if (murk_ranks_count() == 1) {
        return status;
    }
    if (status == MURK_NO_MEMORY || status == MURK_INTERRUPTED) {
        return murk_ranks_agree(status, err);
    }
    failure own = {.status = status};
    if (status) {
        own.error = *err;
    }
    murk_gathered all;
    status = murk_ranks_gather(&all, &own, sizeof own, MURK_OK, err);
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        failure of_rank;
        memcpy(&of_rank, all.bytes + r * sizeof of_rank, sizeof of_rank);
        status = of_rank.status;
        if (status) {
            *err = of_rank.error;
        }
    }
    murk_gathered_release(&all);
    return status;
}

void murk_gathered_release(murk_gathered *gathered)
{
    free(gathered->bytes);
    free(gathered->begin);
    *gathered = (murk_gathered){0};
}

/* The first rank whose bytes are not those of rank 0; the number of ranks if
 * all are equal. */
static murk_status find_other(unsigned *other, const void *bytes, size_t size,
                              murk_status status, murk_error *err)
{
    murk_gathered all = {0};
    uint64_t sum[2] = {0};
    *other = murk_ranks_count();
    if (*other == 1) {
        return status;
    }
    if (!status) {
        murk_checksum(bytes, size, sum);
    }
    status = murk_ranks_gather(&all, sum, sizeof sum, status, err);
    for (unsigned r = murk_ranks_count(); r-- > 1 && !status;) {
        if (memcmp(all.bytes + r * sizeof sum, all.bytes, sizeof sum) != 0) {
            *other = r;
        }
    }
    murk_gathered_release(&all);
    return status;
}

murk_status murk_ranks_compare(bool *is_same, const void *bytes, size_t size,
                               murk_status status, murk_error *err)
{
    unsigned other;
    status = find_other(&other, bytes, size, status, err);
    *is_same = other == murk_ranks_count();
    return status;
}

murk_status murk_ranks_check_same(const char *what, const void *bytes,
                                  size_t size, murk_status status,
                                  murk_error *err)
{
    unsigned other;
    status = find_other(&other, bytes, size, status, err);
    return status || other == murk_ranks_count()
               ? status
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "rank %u has another %s than rank 0", other, what);
}

murk_status murk_ranks_deal(murk_deal *out, murk_status status, murk_error *err)
{
    const murk_ranks *ranks = murk_host_now()->ranks;
    *out = (murk_deal){.ranks = ranks};
    status = murk_ranks_agree(status, err);
    if (!status && ranks) {
        ranks->restart(ranks->context);
    }
    return status;
}

uint64_t murk_ranks_take(murk_deal *deal)
{
    const murk_ranks *ranks = deal->ranks;
    return ranks ? ranks->next(ranks->context, 1) : deal->next++;
}

void murk_ranks_take_no_more(murk_deal *deal)
{
    const murk_ranks *ranks = deal->ranks;
    if (ranks) {
        (void)ranks->next(ranks->context, ITEMS_MAX);
    } else {
        deal->next = ITEMS_MAX;
    }
}
