/* Exchanges rows between ranks, in portions of bounded size or one at a time. A
 * row is sent as a head, with the distances of its arrays from the begin of its
 * block, and the block. */
#include "placement/row_exchange.h"

#include "base/interrupt.h"
#include "base/ranks.h"

#include <stdlib.h>
#include <string.h>

/* Bytes that all ranks together exchange at a time, unless a single row of each
 * rank is longer. */
#define PORTION (UINT64_C(1) << 26)

enum { BITS, AT, SEGMENT_START, CLARITY, SLOT, ARRAYS };

#define ABSENT UINT64_MAX

/* Fetched rows are kept as far as this memory holds them, but so many at least:
 * climbs and bounds ask for the rows of a plan again and again (a choice). */
#define FETCHED_BYTES ((size_t)1 << 26)
#define FETCHED_MIN   16
#define FETCHED_MAX   1024

typedef struct row_head {
    uint64_t candidate, kind, seen, words, bytes;
    uint64_t array[ARRAYS]; /* distance from the begin of the block; ABSENT */
} row_head;

bool murk_row_is_own(size_t candidate)
{
    return murk_ranks_owns(candidate);
}

static uint64_t distance(const murk_row *row, const void *array)
{
    return array ? (uint64_t)((const char *)array - (const char *)row->memory)
                 : ABSENT;
}

static const void *array_of(const row_head *head, int array, const void *block)
{
    return head->array[array] == ABSENT
               ? NULL
               : (const char *)block + head->array[array];
}

/* Packs the rows of this rank among [begin, end). *bytes: for free(). */
static murk_status pack(char **bytes, size_t *size, const murk_row *row,
                        size_t begin, size_t end, murk_error *err)
{
    *size = 0;
    for (size_t j = begin; j < end; ++j) {
        *size +=
            murk_row_is_own(j) ? sizeof(row_head) + row[j].memory_bytes : 0;
    }
    char *at = *bytes = malloc(*size + 1);
    if (!at) {
        return murk_no_memory(err, "", "to exchange the coverage matrix");
    }
    /* The head and the block of each row. */
    for (size_t j = begin; j < end; ++j) {
        const murk_row *r = &row[j];
        if (!murk_row_is_own(j)) {
            continue;
        }
        const row_head head = {
            .candidate = j,
            .kind = r->kind,
            .seen = r->seen,
            .words = r->words,
            .bytes = r->memory_bytes,
            .array = {distance(r, r->bits), distance(r, r->at),
                      distance(r, r->segment_start), distance(r, r->clarity),
                      distance(r, r->slot)}};
        memcpy(at, &head, sizeof head);
        at += sizeof head;
        if (r->memory_bytes) {
            memcpy(at, r->memory, r->memory_bytes);
        }
        at += r->memory_bytes;
    }
    return MURK_OK;
}

/* A row that was received, with its block in `memory`. */
static murk_row received(const row_head *head, const char *block, void *memory)
{
    if (head->bytes) {
        memcpy(memory, block, head->bytes);
    }
    return (murk_row){.kind = (murk_row_kind)head->kind,
                      .seen = head->seen,
                      .words = head->words,
                      .bits = array_of(head, BITS, memory),
                      .at = array_of(head, AT, memory),
                      .segment_start = array_of(head, SEGMENT_START, memory),
                      .clarity = array_of(head, CLARITY, memory),
                      .slot = array_of(head, SLOT, memory),
                      .memory = memory,
                      .memory_bytes = head->bytes};
}

/* Stores a row that was received. */
static murk_status store(murk_row *row, const row_head *head, const char *block,
                         murk_row_space *space, murk_error *err)
{
    void *memory = murk_aligned_zeros(head->bytes);
    if (!memory) {
        return murk_no_memory(err, "", "for the coverage matrix");
    }
    *row = received(head, block, memory);
    return murk_row_space_keep(space, row) ? MURK_OK
                                           : murk_row_space_check(space, err);
}

/* Stores the rows that are missing here. */
static murk_status unpack(murk_row *row, const murk_gathered *all,
                          murk_row_space *space, murk_error *err)
{
    const char *at = all->bytes;
    const char *end = all->bytes + all->begin[murk_ranks_count()];
    murk_status status = MURK_OK;
    while (at < end && !status) {
        row_head head;
        memcpy(&head, at, sizeof head);
        at += sizeof head;
        if (!row[head.candidate].memory) {
            status = store(&row[head.candidate], &head, at, space, err);
        }
        at += head.bytes;
    }
    return status;
}

murk_status murk_row_exchange(murk_row *row, size_t candidates,
                              murk_row_space *space, size_t row_bytes,
                              murk_status status, murk_error *err)
{
    const uint64_t rows = PORTION / (row_bytes + sizeof(row_head));
    const size_t step =
        rows > murk_ranks_count() ? (size_t)rows : murk_ranks_count();
    for (size_t begin = 0; begin < candidates; begin += step) {
        const size_t end =
            candidates - begin < step ? candidates : begin + step;
        char *bytes = NULL;
        size_t size = 0;
        murk_gathered all = {0};
        /* Pack, exchange, and store what is missing. */
        if (!status) {
            status = murk_interrupt_check(err);
        }
        if (!status) {
            status = pack(&bytes, &size, row, begin, end, err);
        }
        status = murk_ranks_gather(&all, bytes, size, status, err);
        if (!status) {
            status = unpack(row, &all, space, err);
        }
        murk_gathered_release(&all);
        free(bytes);
        if (status) {
            break;
        }
    }
    return status;
}

/* Places for rows, of which the one that was asked for least recently is filled
 * again. Each has memory for the largest row, so that fetching a row cannot
 * fail in one rank alone after the exchange. */
typedef struct fetched_place {
    size_t candidate;   /* SIZE_MAX: empty */
    uint64_t last_used; /* number of the call */
    murk_row row;
    void *memory; /* NULL until the place is filled */
} fetched_place;

struct murk_fetched_rows {
    size_t places, row_bytes;
    uint64_t calls;
    fetched_place *place; /* [places] */
};

/* The size of the largest row of any rank. */
static murk_status largest_row(size_t *bytes, const murk_row *row,
                               size_t candidates, murk_status status,
                               murk_error *err)
{
    const unsigned ranks = murk_ranks_count();
    uint64_t *of_rank = calloc(ranks, sizeof *of_rank);
    if (!status && !of_rank) {
        status = murk_no_memory(err, "", "for the coverage matrix");
    }
    for (size_t j = 0; j < candidates && !status; ++j) {
        uint64_t *own = &of_rank[murk_ranks_number()];
        *own = murk_row_is_own(j) && row[j].memory_bytes > *own
                   ? row[j].memory_bytes
                   : *own;
    }
    status = murk_ranks_complete(of_rank, ranks * sizeof *of_rank, status, err);
    *bytes = 0;
    for (unsigned r = 0; r < ranks && !status; ++r) {
        *bytes = of_rank[r] > *bytes ? (size_t)of_rank[r] : *bytes;
    }
    free(of_rank);
    return status;
}

murk_status murk_fetched_rows_create(murk_fetched_rows **out,
                                     const murk_row *row, size_t candidates,
                                     murk_status status, murk_error *err)
{
    size_t row_bytes;
    status = largest_row(&row_bytes, row, candidates, status, err);
    if (status) {
        return status;
    }
    /* As many places as the memory holds rows, within limits. */
    const size_t fits = FETCHED_BYTES / (row_bytes + 1);
    const size_t places = fits < FETCHED_MIN   ? FETCHED_MIN
                          : fits > FETCHED_MAX ? FETCHED_MAX
                                               : fits;
    murk_fetched_rows *f = calloc(1, sizeof *f);
    fetched_place *place = calloc(places, sizeof *place);
    if (!f || !place) {
        free(f);
        free(place);
        return murk_no_memory(err, "", "for the coverage matrix");
    }
    for (size_t k = 0; k < places; ++k) {
        place[k].candidate = SIZE_MAX;
    }
    *f = (murk_fetched_rows){
        .places = places, .row_bytes = row_bytes, .place = place};
    *out = f;
    return MURK_OK;
}

void murk_fetched_rows_destroy(murk_fetched_rows *fetched)
{
    if (fetched) {
        for (size_t k = 0; k < fetched->places; ++k) {
            free(fetched->place[k].memory);
        }
        free(fetched->place);
        free(fetched);
    }
}

/* Fetches a row into a place, which stays as it is after a failure. */
static murk_status fetch(const murk_fetched_rows *f, fetched_place *to,
                         const murk_row *row, murk_row_space *space,
                         size_t candidate, murk_error *err)
{
    char *bytes = NULL;
    size_t size = 0;
    murk_gathered all = {0};
    row_head head = {.candidate = 0};
    murk_status status = murk_interrupt_check(err);
    /* Memory for the row, in all ranks. */
    if (!status && !to->memory) {
        to->memory = murk_aligned_zeros(f->row_bytes);
        status = to->memory
                     ? MURK_OK
                     : murk_no_memory(err, "", "for the coverage matrix");
    }
    /* The rank that owns the row gives it. */
    if (!status) {
        murk_row_space_read(space, &row[candidate]);
        status = pack(&bytes, &size, row, candidate, candidate + 1, err);
    }
    status = murk_ranks_gather(&all, bytes, size, status, err);
    if (!status) {
        size = all.begin[murk_ranks_count()];
        memcpy(&head, all.bytes, size < sizeof head ? size : sizeof head);
        if (size != sizeof head + head.bytes || head.candidate != candidate ||
            head.bytes > f->row_bytes) {
            status = murk_ranks_agree(
                murk_fail(err, MURK_RUN_FAILED, "",
                          "ranks ask for different rows of the coverage "
                          "matrix: do their machines differ?"),
                err);
        } else {
            to->row = received(&head, all.bytes + sizeof head, to->memory);
            to->candidate = candidate;
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    return status;
}

murk_row murk_fetched_rows_get(murk_fetched_rows *fetched, const murk_row *row,
                               murk_row_space *space, size_t candidate)
{
    murk_error err = {0};
    fetched_place *oldest = &fetched->place[0];
    ++fetched->calls;
    for (size_t k = 0; k < fetched->places; ++k) {
        fetched_place *p = &fetched->place[k];
        if (p->candidate == candidate) {
            p->last_used = fetched->calls;
            return p->row;
        }
        oldest = p->last_used < oldest->last_used ? p : oldest;
    }
    /* The failure is final, and murk_interrupted() tells of it. */
    if (fetch(fetched, oldest, row, space, candidate, &err)) {
        return (murk_row){.kind = MURK_ROW_CLEAR_LIST};
    }
    oldest->last_used = fetched->calls;
    return oldest->row;
}
