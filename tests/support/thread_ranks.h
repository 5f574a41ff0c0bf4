/* Ranks (base/ranks.h) as threads of one process, for tests without MPI. Each
 * rank is a thread that works for a host of its own. Up to
 * THREAD_RANKS_ONE_MACHINE ranks count as being on one machine. Of more, the
 * last is on a machine of its own, and the others are on two machines, those
 * with even and those with odd numbers. A defect
 * makes one exchange slightly wrong, which shows that a test would notice. */
#ifndef MURK_TESTS_THREAD_RANKS_H
#define MURK_TESTS_THREAD_RANKS_H

#include "base/ranks.h"

#define THREAD_RANKS_MAX 8

#define THREAD_RANKS_ONE_MACHINE 3 /* so many ranks, at most */

typedef enum thread_ranks_defect {
    THREAD_RANKS_SOUND,
    THREAD_RANKS_LOSE_WORDS, /* sums leave out the words of the last rank */
    THREAD_RANKS_LOSE_CARRY, /* sums of 128 bits drop the carry */
    THREAD_RANKS_FLIP_BIT,   /* a bit in the middle of the bytes that the last
                              * rank gives to a gather is another, but not of
                              * checksums (murk_ranks_compare()) */
    THREAD_RANKS_DEAL_TWICE, /* the counter gives the number 1 twice */
} thread_ranks_defect;

/* The machine of a rank of `count`. */
murk_ranks_here thread_ranks_here(unsigned count, unsigned rank);

/* Work of one rank. It must not use CHECK(), which is not for threads. */
typedef murk_status (*thread_ranks_work)(void *context, unsigned number,
                                         murk_error *err);

/* The end of each rank, after the statuses were compared a last time. */
typedef struct thread_ranks_end {
    murk_status status[THREAD_RANKS_MAX]; /* [count] */
    murk_error error[THREAD_RANKS_MAX];
} thread_ranks_end;

/* Runs work(context, number, err) in `count` ranks. */
thread_ranks_end thread_ranks_run(unsigned count, thread_ranks_defect defect,
                                  thread_ranks_work work, void *context);

/* The same, and rank 1 is asked to stop when the ranks compare their statuses
 * for the time number stop_at, from 1 on. */
thread_ranks_end thread_ranks_run_stopped(unsigned count, unsigned stop_at,
                                          thread_ranks_work work,
                                          void *context);

/* True if all ranks ended with MURK_OK. */
bool thread_ranks_succeeded(const thread_ranks_end *end, unsigned count);

#endif
