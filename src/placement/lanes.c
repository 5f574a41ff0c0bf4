/* Gains over several covers at once (placement/lanes.h). The lowest layers of
 * the covers are interleaved, so that the clarities of one photon in all covers
 * fill one vector register. The photons are taken in blocks whose interleaved
 * clarities fit the second-level cache, and each thread evaluates several rows
 * in a block before the next block. All sums are exact integers, so their order
 * does not matter. */
#include "placement/lanes.h"

#include "base/pool.h"
#include "base/ranks.h"

#include <stdlib.h>
#include <string.h>

/* Words of a block: 4096 photons, whose clarities in all lanes take 128 kB. */
#define BLOCK_WORDS 64

/* Rows that a thread evaluates together: a block is then fetched once for so
 * many rows, and the rows of one block stay in the cache meanwhile. */
#define ROWS_AT_ONCE 16

/* The covers may take this share of the memory of the rows. */
#define SHARE_OF_ROWS 2

bool murk_lanes_pay(const murk_evaluator *evaluator)
{
    if (!evaluator->matrix || evaluator->is_binary ||
        evaluator->layout->doses) {
        return false;
    }
    const size_t layers = evaluator->layout->layers + 1;
    return evaluator->layout->slots * sizeof(uint16_t) * MURK_COVER_LANES *
               layers <=
           evaluator->matrix->bytes / SHARE_OF_ROWS;
}

murk_status murk_lanes_init(murk_lanes *out, const murk_evaluator *evaluator,
                            murk_error *err)
{
    *out = (murk_lanes){
        .evaluator = evaluator,
        .best = murk_aligned_zeros(evaluator->layout->slots * MURK_COVER_LANES *
                                   sizeof *out->best),
        .gain = calloc((evaluator->candidates + 1) * MURK_COVER_LANES,
                       sizeof *out->gain)};
    if (!out->best || !out->gain) {
        murk_lanes_release(out);
        return murk_no_memory(err, "", "for %d plans of %zu photons",
                              MURK_COVER_LANES, evaluator->layout->photons);
    }
    return MURK_OK;
}

void murk_lanes_release(murk_lanes *lanes)
{
    free(lanes->best);
    free(lanes->gain);
    *lanes = (murk_lanes){0};
}

/* Interleaves one block of the covers. */
static void interleave(void *context, unsigned worker, uint64_t block)
{
    murk_lanes *l = context;
    (void)worker;
    const size_t slots = l->evaluator->layout->slots;
    const size_t first = 64 * BLOCK_WORDS * (size_t)block;
    const size_t past = first + 64 * BLOCK_WORDS;
    for (size_t lane = 0; lane < l->covers; ++lane) {
        const uint16_t *best = l->cover[lane]->best;
        for (size_t i = first; i < past && i < slots; ++i) {
            l->best[MURK_COVER_LANES * i + lane] = best[i];
        }
    }
}

/* The part of a row that is not yet evaluated. */
typedef struct row_rest {
    size_t word; /* index of the next stored word */
    const uint16_t *clarity;
} row_rest;

/* The index of the first stored word of the row, from `from` on, that is not
 * before word `word` of the layout. */
static size_t first_word_from(const murk_row *row, size_t from, size_t word)
{
    if (!row->at) {
        return word;
    }
    size_t low = from, high = row->words;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (row->at[middle] < word) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static bool has_lanes(const murk_row *row)
{
    return row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_PACKED;
}

/* Adds the gains of one row in words first..past-1 of the layout, which all
 * belong to one segment, to gain[MURK_COVER_LANES]. */
static void add_block(const murk_lanes *l, const murk_weight_run *segment,
                      const murk_row *row, row_rest *rest, size_t first,
                      size_t past, uint64_t *gain)
{
    const murk_layout *layout = l->evaluator->layout;
    const size_t end = first_word_from(row, rest->word, past);
    /* A row without `at` has its words in the order of the layout. */
    const size_t from = row->at ? 0 : 64 * first;
    uint64_t sum[MURK_COVER_LANES];
    size_t used = 0;
    layout->kernels->lanes(row->bits + rest->word,
                           row->at ? row->at + rest->word : NULL, rest->clarity,
                           l->best + MURK_COVER_LANES * from,
                           segment->is_mixed ? layout->weight + from : NULL,
                           end - rest->word, &used, sum);
    for (size_t lane = 0; lane < MURK_COVER_LANES; ++lane) {
        gain[lane] += sum[lane] * (segment->is_mixed ? 1 : segment->weight);
    }
    rest->word = end;
    rest->clarity = rest->clarity ? rest->clarity + used : NULL;
}

/* The rows that this rank stores: how many, and the candidate of row k. */
static size_t own_rows(const murk_lanes *l)
{
    const size_t n = l->evaluator->candidates;
    return murk_evaluator_is_distributed(l->evaluator) ? murk_ranks_share(n)
                                                       : n;
}

static size_t own_candidate(const murk_lanes *l, size_t k)
{
    return murk_evaluator_is_distributed(l->evaluator) ? murk_ranks_item(k) : k;
}

/* Evaluates ROWS_AT_ONCE candidates: rows of bits block by block, other rows
 * over each cover alone. */
static void evaluate_rows(void *context, unsigned worker, uint64_t batch)
{
    murk_lanes *l = context;
    (void)worker;
    const murk_layout *layout = l->evaluator->layout;
    const size_t first_row = batch * ROWS_AT_ONCE;
    const size_t left = own_rows(l) - first_row;
    const size_t n = left < ROWS_AT_ONCE ? left : ROWS_AT_ONCE;
    const murk_row *row[ROWS_AT_ONCE];
    uint64_t *gain[ROWS_AT_ONCE]; /* [n][MURK_COVER_LANES] */
    row_rest rest[ROWS_AT_ONCE];
    /* Begin each row; rows that have no bits are evaluated at once. */
    for (size_t k = 0; k < n; ++k) {
        const size_t candidate = own_candidate(l, first_row + k);
        row[k] = murk_matrix_row(l->evaluator->matrix, candidate);
        gain[k] = l->gain + candidate * MURK_COVER_LANES;
        rest[k] = (row_rest){0, row[k]->clarity};
        for (size_t lane = 0; lane < MURK_COVER_LANES; ++lane) {
            gain[k][lane] = has_lanes(row[k]) || lane >= l->covers
                                ? 0
                                : murk_row_gain(layout, row[k], l->cover[lane]);
        }
    }
    /* Each segment has blocks of its own. */
    for (size_t s = 0; s < layout->segments; ++s) {
        const murk_weight_run *segment = &layout->segment[s];
        const size_t segment_end = segment->first_word + segment->words;
        for (size_t first = segment->first_word; first < segment_end;
             first += BLOCK_WORDS) {
            const size_t past = first + BLOCK_WORDS < segment_end
                                    ? first + BLOCK_WORDS
                                    : segment_end;
            for (size_t k = 0; k < n; ++k) {
                if (has_lanes(row[k])) {
                    add_block(l, segment, row[k], &rest[k], first, past,
                              gain[k]);
                }
            }
        }
    }
}

void murk_lanes_gains(murk_lanes *l, const murk_cover *const *cover, size_t n)
{
    const unsigned threads =
        murk_evaluator_threads(l->evaluator, l->evaluator->candidates);
    const size_t words = l->evaluator->layout->words;
    l->cover = cover;
    l->covers = n;
    murk_pool_run_workers(threads, (words + BLOCK_WORDS - 1) / BLOCK_WORDS,
                          interleave, l);
    const size_t gains = l->evaluator->candidates * MURK_COVER_LANES;
    if (murk_evaluator_is_distributed(l->evaluator)) {
        memset(l->gain, 0, gains * sizeof *l->gain);
    }
    murk_pool_run_workers(threads,
                          (own_rows(l) + ROWS_AT_ONCE - 1) / ROWS_AT_ONCE,
                          evaluate_rows, l);
    murk_evaluator_complete(l->evaluator, l->gain, gains);
}
