/* Ranks: several processes that run the same computation on the same input,
 * divide its long loops among them, and exchange what each has computed. So
 * all ranks have the same values afterwards, and each goes on as a single
 * process would. The program murk-mpi provides the functions of murk_ranks by
 * MPI; without them there is one rank.
 *
 * Only whole numbers are added, and everything else is exchanged as bytes in
 * an order that does not depend on ranks. So no result depends on the number of
 * ranks.
 *
 * The functions below murk_ranks are collective unless their comment says
 * otherwise: every rank calls the same ones in the same order, from the thread
 * that works for the host. Each of them takes the status of the caller so far.
 * If a rank has failed, the call fails in all ranks, with the failure of the
 * first rank that has, and so does every later call: a failure that passed
 * through one of these functions is final, and sets the flag of requests to
 * stop (base/interrupt.h), so that a search whose steps return no status ends.
 * Work whose failure the caller tolerates is done after murk_ranks_leave(). */
#ifndef MURK_BASE_RANKS_H
#define MURK_BASE_RANKS_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The ranks on the machine of a rank, which can open each other's files in
 * memory (base/block.h): the rank number of the first of them, how many they
 * are, and the place of this rank among them, from 0 on. */
typedef struct murk_ranks_here {
    unsigned first, count, number;
} murk_ranks_here;

typedef struct murk_ranks {
    unsigned number; /* 0 .. count - 1; rank 0 prints and writes files */
    unsigned count;
    unsigned threads; /* that a rank has processors for */
    murk_ranks_here here;
    void *context; /* passed to the functions */
    /* Collective: passes *err of the first rank whose status is not MURK_OK to
     * all ranks, and returns the status of that rank. */
    murk_status (*agree)(void *context, murk_status status, murk_error *err);
    /* Collective: adds word[n] of all ranks, modulo 2^64, or modulo 2^128 if
     * is_128, where two successive words are a number, the low half first. */
    void (*sum)(void *context, uint64_t *word, size_t n, bool is_128);
    /* Collective: size[count] receives the sizes of the bytes of all ranks. */
    void (*sizes)(void *context, uint64_t mine, uint64_t *size);
    /* Collective: `all` receives the bytes of all ranks, of these sizes, in the
     * order of the ranks. */
    void (*gather)(void *context, const void *bytes, void *all,
                   const uint64_t *size);
    /* Adds to a counter that all ranks share, and returns the value before;
     * restart() sets the counter to 0 and is collective. */
    uint64_t (*next)(void *context, uint64_t add);
    void (*restart)(void *context);
} murk_ranks;

/* Of the host of the calling thread; not collective. */
unsigned murk_ranks_count(void); /* 1 without ranks */
unsigned murk_ranks_number(void);
unsigned murk_ranks_threads(void);           /* 0 without ranks */
murk_ranks_here murk_ranks_on_machine(void); /* {0, 1, 0} without ranks */

/* Items that are dealt to ranks in rounds, one to each rank: how many of n
 * items a rank has, the number of the k-th of them, and which rank has an item.
 * The rank that is first differs from round to round, without a period: dealt
 * in turn, the even candidates of a grid went to one rank of two, and if these
 * see more than the odd ones that rank had more work. Not collective. */
static inline unsigned murk_ranks_first_of(uint64_t round)
{
    /* Fibonacci hashing (Knuth, The Art of Computer Programming, vol. 3, 6.4).
     */
    const uint64_t hash = (round + 1) * UINT64_C(0x9e3779b97f4a7c15);
    return (unsigned)((hash >> 32) * murk_ranks_count() >> 32);
}
static inline unsigned murk_ranks_owner(uint64_t item)
{
    const unsigned count = murk_ranks_count();
    return (unsigned)((item + murk_ranks_first_of(item / count)) % count);
}
static inline uint64_t murk_ranks_share_of(uint64_t n, unsigned rank)
{
    const unsigned count = murk_ranks_count();
    const uint64_t rounds = n / count;
    const unsigned place = (rank + count - murk_ranks_first_of(rounds)) % count;
    return rounds + (place < n % count);
}
static inline uint64_t murk_ranks_share(uint64_t n)
{
    return murk_ranks_share_of(n, murk_ranks_number());
}
static inline uint64_t murk_ranks_item(uint64_t k)
{
    const unsigned count = murk_ranks_count();
    const unsigned place =
        (murk_ranks_number() + count - murk_ranks_first_of(k)) % count;
    return k * count + place;
}
static inline bool murk_ranks_owns(uint64_t item)
{
    return murk_ranks_owner(item) == murk_ranks_number();
}

/* Items that are dealt to ranks in blocks of successive ones: of n items, at
 * most 2^32, this rank has those from murk_ranks_begin(n) on, up to but not
 * including murk_ranks_end(n). Not collective. */
static inline uint64_t murk_ranks_begin(uint64_t n)
{
    return n * murk_ranks_number() / murk_ranks_count();
}
static inline uint64_t murk_ranks_end(uint64_t n)
{
    return n * (murk_ranks_number() + 1) / murk_ranks_count();
}

/* From here on the host computes as a single process: for work that is dealt
 * out to ranks as a whole. murk_ranks_return() ends this, with what
 * murk_ranks_leave() returned. Not collective. */
const murk_ranks *murk_ranks_leave(void);
void murk_ranks_return(const murk_ranks *ranks);

/* Says whether rank 0 alone needs the results of the work that follows: other
 * ranks then drop what nothing else needs, such as photon records. All ranks
 * must say the same. murk_ranks_keeps(): whether this rank must have results;
 * murk_ranks_keeps_shared(): whether it must have those that the ranks of a
 * machine share, which the first of them has. Not collective. */
void murk_ranks_keep_in_first(bool is_so);
bool murk_ranks_keeps(void);
bool murk_ranks_keeps_shared(void);

/* Returns `status`, or the failure of another rank. */
murk_status murk_ranks_agree(murk_status status, murk_error *err);

/* As murk_ranks_agree(), for a failure that a caller may tolerate, of which all
 * ranks must know: the failure of the first rank that has failed, which is
 * final only if it is MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_ranks_share_failure(murk_status status, murk_error *err);

/* *is_same: whether all ranks have equal bytes. */
murk_status murk_ranks_compare(bool *is_same, const void *bytes, size_t size,
                               murk_status status, murk_error *err);

/* Fails with MURK_RUN_FAILED, naming a rank, unless all ranks have equal bytes:
 * `what`, for example "scene". */
murk_status murk_ranks_check_same(const char *what, const void *bytes,
                                  size_t size, murk_status status,
                                  murk_error *err);

/* Adds the words of all ranks; see murk_ranks.sum. */
murk_status murk_ranks_sum(uint64_t *word, size_t n, bool is_128,
                           murk_status status, murk_error *err);

/* Completes an array of which each rank has filled a part of its own and left
 * the rest 0. */
murk_status murk_ranks_complete(void *array, size_t bytes, murk_status status,
                                murk_error *err);

/* Completes an array of n items of which each rank has filled its block, from
 * murk_ranks_begin(n) to murk_ranks_end(n). Fails with MURK_RUN_FAILED if ranks
 * join arrays of different sizes. */
murk_status murk_ranks_join(void *array, size_t n, size_t item_bytes,
                            murk_status status, murk_error *err);

/* What all ranks gave, in the order of the ranks: rank r gave the bytes from
 * begin[r] to begin[r + 1]. Release also after a failure. */
typedef struct murk_gathered {
    char *bytes;
    uint64_t *begin; /* [ranks + 1] */
} murk_gathered;

murk_status murk_ranks_gather(murk_gathered *out, const void *bytes,
                              size_t size, murk_status status, murk_error *err);
void murk_gathered_release(murk_gathered *gathered);

/* Deals items out: murk_ranks_take() gives the next item for this rank, or a
 * number of items or more if none is left. murk_ranks_take() is not collective,
 * and may be called after murk_ranks_leave().
 * Which rank takes which item depends on chance, so items must not depend on
 * each other. */
typedef struct murk_deal {
    const murk_ranks *ranks; /* of the host that began it; NULL: none */
    uint64_t next;           /* without ranks */
} murk_deal;

murk_status murk_ranks_deal(murk_deal *out, murk_status status,
                            murk_error *err);
uint64_t murk_ranks_take(murk_deal *deal);

/* No rank takes a further item. Not collective. */
void murk_ranks_take_no_more(murk_deal *deal);

#endif
