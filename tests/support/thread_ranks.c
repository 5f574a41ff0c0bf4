/* The functions of the table murk_ranks by memory that all threads share. Each
 * collective function has the same three steps: every rank publishes a pointer,
 * every rank reads what the others published, and no rank goes on before all
 * have read. Barriers stand between the steps. */
#include "thread_ranks.h"

#include "base/host_make.h"
#include "base/interrupt.h"

#include <assert.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* What murk_ranks_compare() gathers of a rank. */
#define CHECKSUM_BYTES 16

typedef struct team {
    unsigned count;
    thread_ranks_defect defect;
    pthread_barrier_t barrier;
    const void *published[THREAD_RANKS_MAX];
    uint64_t size[THREAD_RANKS_MAX];
    murk_status status[THREAD_RANKS_MAX];
    _Atomic uint64_t next;
    unsigned stop_at; /* the comparison in which rank 1 is asked to stop; 0:
                       * never */
    thread_ranks_work work;
    void *context;
} team;

typedef struct member {
    team *team;
    murk_ranks ranks;
    unsigned comparisons; /* so far */
    murk_status failed;   /* of any rank */
    murk_error error;
    murk_status *status; /* of the end */
    murk_error *err;
} member;

static void wait_for_all(team *t)
{
    pthread_barrier_wait(&t->barrier);
}

static murk_status agree(void *context, murk_status status, murk_error *err)
{
    member *m = context;
    team *t = m->team;
    const unsigned number = m->ranks.number;
    if (++m->comparisons == t->stop_at && number == 1) {
        murk_interrupt_request();
    }
    if (!m->failed) {
        t->status[number] = status;
        t->published[number] = err;
        wait_for_all(t);
        for (unsigned r = 0; r < t->count && !m->failed; ++r) {
            if (t->status[r]) {
                m->failed = t->status[r];
                m->error = *(const murk_error *)t->published[r];
            }
        }
        wait_for_all(t);
    }
    if (m->failed) {
        *err = m->error;
    }
    return m->failed;
}

/* Adds the words of a rank. */
static void add(uint64_t *to, const uint64_t *from, size_t n, bool is_128,
                bool has_carry)
{
    for (size_t i = 0; i < n; ++i) {
        to[i] += from[i];
        if (is_128 && i % 2 == 0 && has_carry) {
            to[i + 1] += to[i] < from[i];
        }
    }
}

static void sum(void *context, uint64_t *word, size_t n, bool is_128)
{
    const member *m = context;
    team *t = m->team;
    uint64_t *total = calloc(n + 1, sizeof *total);
    assert(total && (!is_128 || n % 2 == 0));
    t->published[m->ranks.number] = word;
    wait_for_all(t);
    const bool loses = t->defect == THREAD_RANKS_LOSE_WORDS;
    for (unsigned r = 0; r < t->count - loses; ++r) {
        add(total, t->published[r], n, is_128,
            t->defect != THREAD_RANKS_LOSE_CARRY);
    }
    wait_for_all(t);
    if (n > 0) {
        memcpy(word, total, n * sizeof *word);
    }
    free(total);
}

static void sizes(void *context, uint64_t mine, uint64_t *size)
{
    const member *m = context;
    team *t = m->team;
    t->size[m->ranks.number] = mine;
    wait_for_all(t);
    memcpy(size, t->size, t->count * sizeof *size);
    wait_for_all(t);
}

static void gather(void *context, const void *bytes, void *all,
                   const uint64_t *size)
{
    const member *m = context;
    team *t = m->team;
    char *at = all;
    t->published[m->ranks.number] = bytes;
    wait_for_all(t);
    for (unsigned r = 0; r < t->count; ++r) {
        if (size[r] > 0) {
            memcpy(at, t->published[r], size[r]);
            if (t->defect == THREAD_RANKS_FLIP_BIT && r == t->count - 1 &&
                size[r] != CHECKSUM_BYTES) {
                at[size[r] / 2] ^= 1;
            }
        }
        at += size[r];
    }
    wait_for_all(t);
}

static uint64_t next(void *context, uint64_t add)
{
    const member *m = context;
    team *t = m->team;
    const uint64_t number = atomic_fetch_add(&t->next, add);
    return t->defect == THREAD_RANKS_DEAL_TWICE && number > 1 ? number - 1
                                                              : number;
}

static void restart(void *context)
{
    const member *m = context;
    if (m->ranks.number == 0) {
        atomic_store(&m->team->next, 0);
    }
    wait_for_all(m->team);
}

static void *live(void *context)
{
    member *m = context;
    const team *t = m->team;
    murk_host *host = murk_host_create();
    assert(host);
    host->ranks = &m->ranks;
    murk_host *before = murk_host_enter(host);
    /* As murk-mpi does: the ranks compare their statuses at the end. */
    const murk_status status = t->work(t->context, m->ranks.number, m->err);
    *m->status = murk_ranks_agree(status, m->err);
    murk_host_enter(before);
    murk_host_destroy(host);
    return NULL;
}

murk_ranks_here thread_ranks_here(unsigned count, unsigned rank)
{
    const bool is_one_machine = count <= THREAD_RANKS_ONE_MACHINE;
    const unsigned others = is_one_machine ? count : count - 1;
    const unsigned machines = is_one_machine ? 1 : 2;
    const unsigned first = rank % machines;
    return rank == others
               ? (murk_ranks_here){.first = rank, .count = 1}
               : (murk_ranks_here){.first = first,
                                   .count = (others - first + machines - 1) /
                                            machines,
                                   .number = rank / machines};
}

static thread_ranks_end run(unsigned count, thread_ranks_defect defect,
                            unsigned stop_at, thread_ranks_work work,
                            void *context)
{
    thread_ranks_end end = {{MURK_OK}, {{0}}};
    member ranks[THREAD_RANKS_MAX] = {{.team = NULL}};
    pthread_t thread[THREAD_RANKS_MAX];
    team t = {.count = count,
              .defect = defect,
              .stop_at = stop_at,
              .work = work,
              .context = context};
    assert(count > 0 && count <= THREAD_RANKS_MAX);
    pthread_barrier_init(&t.barrier, NULL, count);
    for (unsigned r = 0; r < count; ++r) {
        ranks[r] = (member){.team = &t,
                            .ranks = {.number = r,
                                      .count = count,
                                      .threads = 1,
                                      .here = thread_ranks_here(count, r),
                                      .context = &ranks[r],
                                      .agree = agree,
                                      .sum = sum,
                                      .sizes = sizes,
                                      .gather = gather,
                                      .next = next,
                                      .restart = restart},
                            .status = &end.status[r],
                            .err = &end.error[r]};
        /* A rank that is missing would let the others wait for ever. */
        if (pthread_create(&thread[r], NULL, live, &ranks[r]) != 0) {
            abort();
        }
    }
    for (unsigned r = 0; r < count; ++r) {
        pthread_join(thread[r], NULL);
    }
    pthread_barrier_destroy(&t.barrier);
    return end;
}

thread_ranks_end thread_ranks_run(unsigned count, thread_ranks_defect defect,
                                  thread_ranks_work work, void *context)
{
    return run(count, defect, 0, work, context);
}

thread_ranks_end thread_ranks_run_stopped(unsigned count, unsigned stop_at,
                                          thread_ranks_work work, void *context)
{
    return run(count, THREAD_RANKS_SOUND, stop_at, work, context);
}

bool thread_ranks_succeeded(const thread_ranks_end *end, unsigned count)
{
    bool has_succeeded = true;
    for (unsigned r = 0; r < count; ++r) {
        has_succeeded = has_succeeded && end->status[r] == MURK_OK;
    }
    return has_succeeded;
}
