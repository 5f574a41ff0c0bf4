/* A thread pool on POSIX threads. The workers of a run take the next items from
 * an atomic counter, the calling thread included; the functions for batches are
 * those for items with one item at a time. Threads are started for each run and
 * joined at its end. */
#include "base/pool.h"

#include "base/host.h"
#include "base/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#define THREADS_MAX 256 /* more processors are not used */

/* The least stack size of a thread that is started here. Tracing and placing
 * take between 128 and 256 kB (largest frame: 139 kB, transport), and `ulimit
 * -s` may allow less. */
#define STACK_BYTES ((size_t)1 << 20)

typedef struct pool {
    murk_job job;
    murk_worker_job worker_job;
    void *context;
    murk_host *host;      /* of the calling thread */
    uint64_t items, each; /* a worker takes `each` items at a time */
    atomic_uint_fast64_t next;
} pool;

typedef struct worker {
    pool *pool;
    unsigned number;
} worker;

/* The number of threads that the host of the calling thread may use. */
static unsigned threads_allowed(void)
{
    const unsigned allowed = murk_host_now()->threads_allowed;
    return allowed > 0 && allowed < THREADS_MAX ? allowed : THREADS_MAX;
}

static void *work(void *argument)
{
    const worker *me = argument;
    pool *c = me->pool;
    (void)murk_host_enter(c->host); /* a new thread is bound to no host yet */
    while (!murk_interrupted()) {
        const uint64_t first = atomic_fetch_add(&c->next, c->each);
        if (first >= c->items) {
            break;
        }
        for (uint64_t i = first; i < c->items && i - first < c->each; ++i) {
            if (c->job) {
                c->job(c->context, i);
            } else {
                c->worker_job(c->context, me->number, i);
            }
        }
    }
    return NULL;
}

/* Starts a thread with a stack of at least STACK_BYTES. Returns 0 or an error
 * number, as pthread_create() does. */
static int start(pthread_t *thread, void *(*begin)(void *), void *argument)
{
    pthread_attr_t attributes;
    size_t usual = 0;
    int refusal = pthread_attr_init(&attributes);
    if (refusal) {
        return refusal;
    }
    pthread_attr_getstacksize(&attributes, &usual);
    if (usual < STACK_BYTES) {
        refusal = pthread_attr_setstacksize(&attributes, STACK_BYTES);
    }
    if (!refusal) {
        refusal = pthread_create(thread, &attributes, begin, argument);
    }
    pthread_attr_destroy(&attributes);
    return refusal;
}

/* ---- a stack that is large enough ---- */

struct task {
    void (*run)(void *);
    void *context;
    murk_host *host;  /* of the caller */
    sigset_t signals; /* the signal mask of the caller */
};

static void *run_task(void *argument)
{
    const struct task *e = argument;
    pthread_sigmask(SIG_SETMASK, &e->signals, NULL);
    (void)murk_host_enter(e->host);
    e->run(e->context);
    return NULL;
}

void murk_pool_run_with_stack(void (*run_it)(void *), void *context)
{
    struct task e = {
        .run = run_it, .context = context, .host = murk_host_now()};
    struct rlimit limit;
    const bool is_small = getrlimit(RLIMIT_STACK, &limit) == 0 &&
                          limit.rlim_cur != RLIM_INFINITY &&
                          limit.rlim_cur < STACK_BYTES;
    pthread_t thread;
    sigset_t all;
    /* Block signals in the waiting thread, so that they interrupt the system
     * calls of the working thread. */
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &e.signals);
    const bool has_own_thread = is_small && start(&thread, run_task, &e) == 0;
    if (has_own_thread) {
        pthread_join(thread, NULL);
    }
    pthread_sigmask(SIG_SETMASK, &e.signals, NULL);
    if (!has_own_thread) {
        run_it(context);
    }
}

/* ---- many workers ---- */

static void run(unsigned threads, pool *c)
{
    worker workers[THREADS_MAX];
    pthread_t thread[THREADS_MAX];
    unsigned started = 0;
    if (threads > threads_allowed()) {
        threads = threads_allowed();
    }
    if (threads > c->items) {
        threads = c->items > 0 ? (unsigned)c->items : 1;
    }
    for (unsigned i = 0; i < threads; ++i) {
        workers[i] = (worker){c, i};
    }
    while (started + 1 < threads &&
           start(&thread[started], work, &workers[started + 1]) == 0) {
        ++started;
    }
    work(&workers[0]);
    for (unsigned i = 0; i < started; ++i) {
        pthread_join(thread[i], NULL);
    }
}

/* Waits until all threads of the trial have been started. */
static void *wait_for_release(void *argument)
{
    pthread_mutex_t *held = argument;
    pthread_mutex_lock(held);
    pthread_mutex_unlock(held);
    return NULL;
}

murk_status murk_pool_allow(unsigned threads, murk_error *err)
{
    pthread_t thread[THREADS_MAX];
    pthread_mutex_t held = PTHREAD_MUTEX_INITIALIZER;
    unsigned started = 0;
    int refusal = 0;
    murk_host_now()->threads_allowed = threads;
    /* the calling thread works, too, so one thread less is started */
    pthread_mutex_lock(&held);
    while (!refusal && started + 1 < threads_allowed()) {
        refusal = start(&thread[started], wait_for_release, &held);
        started += !refusal;
    }
    pthread_mutex_unlock(&held);
    for (unsigned i = 0; i < started; ++i) {
        pthread_join(thread[i], NULL);
    }
    return refusal ? murk_fail(
                         err, MURK_RUN_FAILED, "",
                         "cannot start %u threads, only %u: %s; ask for fewer",
                         threads_allowed(), started + 1, strerror(refusal))
                   : MURK_OK;
}

void murk_pool_run(unsigned threads, uint64_t batches, murk_job job,
                   void *context)
{
    murk_pool_run_items(threads, batches, 1, job, context);
}

void murk_pool_run_workers(unsigned threads, uint64_t batches,
                           murk_worker_job job, void *context)
{
    murk_pool_run_items_of_workers(threads, batches, 1, job, context);
}

void murk_pool_run_items(unsigned threads, uint64_t items, uint64_t each,
                         murk_job job, void *context)
{
    pool c = {.job = job,
              .context = context,
              .host = murk_host_now(),
              .items = items,
              .each = each};
    run(threads, &c);
}

void murk_pool_run_items_of_workers(unsigned threads, uint64_t items,
                                    uint64_t each, murk_worker_job job,
                                    void *context)
{
    pool c = {.worker_job = job,
              .context = context,
              .host = murk_host_now(),
              .items = items,
              .each = each};
    run(threads, &c);
}

unsigned murk_pool_processors(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > THREADS_MAX ? THREADS_MAX : (unsigned)n;
}
