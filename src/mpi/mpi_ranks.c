/* The collective functions of base/ranks.h by those of MPI, and a counter of
 * rank 0. A thread of rank 0 answers requests for the next number, because rank
 * 0 computes meanwhile and calls no function of MPI for minutes. Errors of MPI
 * end the processes of all ranks, which is what MPI does by default.
 *
 * A failure of a rank is passed on by agree(): the ranks compare their states
 * before each exchange, so a rank that has failed takes part in one more
 * comparison, at its end, and all others learn of the failure in the comparison
 * before their next exchange. */
#include "mpi/mpi_ranks.h"

#include "base/block.h"
#include "base/pool.h"

#include <math.h>
#include <mpi.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The bytes of a message, and the numbers that are added at a time; MPI counts
 * with an int. */
#define PORTION (1 << 26)

/* Tags of messages between a rank that asks for an item and rank 0. */
enum { ASK = 1, ANSWER = 2, STOP = 3 };

/* Between two looks of the dealing thread for requests [ns]. */
#define PAUSE_NS 500000

struct murk_mpi {
    murk_ranks ranks;
    MPI_Comm dealing; /* messages of the dealing thread are apart */
    MPI_Op add_128;
    MPI_Datatype wide; /* two words */
    _Atomic uint64_t next;
    bool has_dealer;
    pthread_t dealer;
    murk_status failed; /* of any rank */
    murk_error error;
};

/* ---- collective functions ---- */

static murk_status agree(void *context, murk_status status, murk_error *err)
{
    murk_mpi *mpi = context;
    if (!mpi->failed) {
        /* The first rank that has failed, or `count`. */
        const int count = (int)mpi->ranks.count;
        int first = status ? (int)mpi->ranks.number : count;
        MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN,
                      MPI_COMM_WORLD);
        if (first == count) {
            return MURK_OK;
        }
        if (first == (int)mpi->ranks.number) {
            mpi->failed = status;
            mpi->error = *err;
            mpi->error.code = status;
        }
        MPI_Bcast(&mpi->failed, sizeof mpi->failed, MPI_BYTE, first,
                  MPI_COMM_WORLD);
        MPI_Bcast(&mpi->error, sizeof mpi->error, MPI_BYTE, first,
                  MPI_COMM_WORLD);
    }
    *err = mpi->error;
    return mpi->failed;
}

static void add_128(void *in, void *inout, int *n, MPI_Datatype *type)
{
    const uint64_t *from = in;
    uint64_t *to = inout;
    (void)type;
    for (size_t i = 0; i < 2 * (size_t)*n; i += 2) {
        to[i] += from[i];
        to[i + 1] += from[i + 1] + (to[i] < from[i]);
    }
}

static void sum(void *context, uint64_t *word, size_t n, bool is_128)
{
    const murk_mpi *mpi = context;
    for (size_t i = 0; i < n;) {
        const size_t left = n - i;
        const size_t k = left < PORTION / 8 ? left : PORTION / 8;
        if (is_128) {
            MPI_Allreduce(MPI_IN_PLACE, word + i, (int)(k / 2), mpi->wide,
                          mpi->add_128, MPI_COMM_WORLD);
        } else {
            MPI_Allreduce(MPI_IN_PLACE, word + i, (int)k, MPI_UINT64_T, MPI_SUM,
                          MPI_COMM_WORLD);
        }
        i += k;
    }
}

static void sizes(void *context, uint64_t mine, uint64_t *size)
{
    (void)context;
    MPI_Allgather(&mine, 1, MPI_UINT64_T, size, 1, MPI_UINT64_T,
                  MPI_COMM_WORLD);
}

/* Each rank in turn sends its bytes to all others: MPI_Allgatherv() counts all
 * bytes together with an int. */
static void gather(void *context, const void *bytes, void *all,
                   const uint64_t *size)
{
    const murk_mpi *mpi = context;
    char *at = all;
    for (unsigned r = 0; r < mpi->ranks.count; ++r) {
        if (r == mpi->ranks.number && size[r] > 0) {
            memcpy(at, bytes, size[r]);
        }
        for (uint64_t i = 0; i < size[r]; i += PORTION) {
            const uint64_t left = size[r] - i;
            MPI_Bcast(at + i, (int)(left < PORTION ? left : PORTION), MPI_BYTE,
                      (int)r, MPI_COMM_WORLD);
        }
        at += size[r];
    }
}

/* ---- dealing items out ---- */

/* The thread of rank 0: answers each request with the next number. */
static void *deal(void *context)
{
    murk_mpi *mpi = context;
    const struct timespec pause = {.tv_nsec = PAUSE_NS};
    for (;;) {
        int is_there = 0;
        MPI_Status from;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, mpi->dealing, &is_there, &from);
        if (!is_there) {
            nanosleep(&pause, NULL);
            continue;
        }
        uint64_t add = 0;
        MPI_Recv(&add, 1, MPI_UINT64_T, from.MPI_SOURCE, from.MPI_TAG,
                 mpi->dealing, MPI_STATUS_IGNORE);
        if (from.MPI_TAG == STOP) {
            return NULL;
        }
        const uint64_t number = atomic_fetch_add(&mpi->next, add);
        MPI_Send(&number, 1, MPI_UINT64_T, from.MPI_SOURCE, ANSWER,
                 mpi->dealing);
    }
}

static uint64_t next(void *context, uint64_t add)
{
    murk_mpi *mpi = context;
    if (mpi->ranks.number == 0) {
        return atomic_fetch_add(&mpi->next, add);
    }
    uint64_t number = 0;
    MPI_Send(&add, 1, MPI_UINT64_T, 0, ASK, mpi->dealing);
    MPI_Recv(&number, 1, MPI_UINT64_T, 0, ANSWER, mpi->dealing,
             MPI_STATUS_IGNORE);
    return number;
}

static void restart(void *context)
{
    murk_mpi *mpi = context;
    atomic_store(&mpi->next, 0);
    MPI_Barrier(MPI_COMM_WORLD);
}

/* ---- begin and end ---- */

/* Whether this rank can have the memory of the first rank of the machine: a
 * container may hide the processes of the others. */
static bool can_share(MPI_Comm machine, int number)
{
    murk_error err = {0};
    murk_block block = {.is_for_ranks = true};
    bool can = number > 0 || !murk_block_resize(&block, 1, INFINITY, &err);
    murk_block_address first = murk_block_address_of(&block);
    MPI_Bcast(&first, sizeof first, MPI_BYTE, 0, machine);
    if (number > 0) {
        can = first.size > 0 && !murk_block_open(&block, &first, &err);
    }
    MPI_Barrier(machine);
    murk_block_release(&block);
    return can;
}

/* Finds the ranks of this machine, and the processors that are for this rank:
 * those that it is bound to, or its share of all. */
static void find_machine(murk_ranks *ranks)
{
    MPI_Comm machine, sharing;
    int count = 1, number = 0;
    cpu_set_t bound;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL,
                        &machine);
    MPI_Comm_size(machine, &count);
    MPI_Comm_rank(machine, &number);
    const unsigned share = murk_pool_processors() / (unsigned)count;
    const unsigned own = sched_getaffinity(0, sizeof bound, &bound) == 0
                             ? (unsigned)CPU_COUNT(&bound)
                             : share;
    const unsigned threads = own < share ? own : share;
    ranks->threads = threads > 0 ? threads : 1;
    /* A rank that cannot share memory is by itself. */
    const bool can = can_share(machine, number);
    int first = (int)ranks->number;
    MPI_Comm_split(machine, can ? 0 : number, 0, &sharing);
    MPI_Comm_size(sharing, &count);
    MPI_Comm_rank(sharing, &number);
    MPI_Bcast(&first, 1, MPI_INT, 0, sharing);
    ranks->here =
        (murk_ranks_here){(unsigned)first, (unsigned)count, (unsigned)number};
    MPI_Comm_free(&sharing);
    MPI_Comm_free(&machine);
}

murk_mpi *murk_mpi_begin(int *argc, char ***argv)
{
    int level = 0, number = 0, count = 1;
    MPI_Init_thread(argc, argv, MPI_THREAD_MULTIPLE, &level);
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    murk_mpi *mpi =
        level == MPI_THREAD_MULTIPLE ? calloc(1, sizeof *mpi) : NULL;
    if (!mpi) {
        fprintf(stderr, "murk: %s\n",
                level == MPI_THREAD_MULTIPLE
                    ? "out of memory"
                    : "this MPI serves one thread alone: murk-mpi needs "
                      "MPI_THREAD_MULTIPLE");
        MPI_Abort(MPI_COMM_WORLD, 1);
        return NULL;
    }
    /* The table of functions. */
    mpi->ranks = (murk_ranks){.number = (unsigned)number,
                              .count = (unsigned)count,
                              .context = mpi,
                              .agree = agree,
                              .sum = sum,
                              .sizes = sizes,
                              .gather = gather,
                              .next = next,
                              .restart = restart};
    find_machine(&mpi->ranks);
    /* Sums of 128 bits, and the thread that deals items out. */
    MPI_Comm_dup(MPI_COMM_WORLD, &mpi->dealing);
    MPI_Op_create(add_128, 1, &mpi->add_128);
    MPI_Type_contiguous(2, MPI_UINT64_T, &mpi->wide);
    MPI_Type_commit(&mpi->wide);
    if (number == 0 && count > 1) {
        mpi->has_dealer = pthread_create(&mpi->dealer, NULL, deal, mpi) == 0;
        if (!mpi->has_dealer) {
            fprintf(stderr, "murk: cannot start a thread\n");
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
    }
    return mpi;
}

const murk_ranks *murk_mpi_ranks(const murk_mpi *mpi)
{
    return &mpi->ranks;
}

void murk_mpi_end(murk_mpi *mpi)
{
    if (!mpi) {
        return;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    if (mpi->has_dealer) {
        const uint64_t none = 0;
        MPI_Send(&none, 1, MPI_UINT64_T, 0, STOP, mpi->dealing);
        pthread_join(mpi->dealer, NULL);
    }
    MPI_Type_free(&mpi->wide);
    MPI_Op_free(&mpi->add_128);
    MPI_Comm_free(&mpi->dealing);
    MPI_Finalize();
    free(mpi);
}
