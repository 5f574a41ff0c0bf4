#include "base/crew.h"

#include "base/interrupt.h"

#include <pthread.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

#define THREADS_MAX 256

static unsigned threads_allowed = THREADS_MAX;

typedef struct crew {
    murk_job job;
    murk_worker_job worker_job;
    void *context;
    uint64_t batches;
    atomic_uint_fast64_t next;
} crew;

typedef struct worker {
    crew *crew;
    unsigned number;
} worker;

static void *work(void *argument)
{
    const worker *me = argument;
    crew *c = me->crew;
    while (!murk_interrupted()) {
        const uint64_t batch = atomic_fetch_add(&c->next, 1);
        if (batch >= c->batches) {
            break;
        }
        if (c->job) {
            c->job(c->context, batch);
        } else {
            c->worker_job(c->context, me->number, batch);
        }
    }
    return NULL;
}

static void run(unsigned threads, crew *c)
{
    worker workers[THREADS_MAX];
    pthread_t thread[THREADS_MAX];
    unsigned started = 0;
    if (threads > threads_allowed) {
        threads = threads_allowed;
    }
    if (threads > c->batches) {
        threads = c->batches > 0 ? (unsigned)c->batches : 1;
    }
    for (unsigned i = 0; i < threads; ++i) {
        workers[i] = (worker){c, i};
    }
    while (started + 1 < threads &&
           pthread_create(&thread[started], NULL, work,
                          &workers[started + 1]) == 0) {
        ++started;
    }
    work(&workers[0]);
    for (unsigned i = 0; i < started; ++i) {
        pthread_join(thread[i], NULL);
    }
}

/* Waits until all threads of a trial have been started. */
static void *wait_for_release(void *argument)
{
    pthread_mutex_t *held = argument;
    pthread_mutex_lock(held);
    pthread_mutex_unlock(held);
    return NULL;
}

murk_status murk_crew_allow(unsigned threads, murk_error *err)
{
    pthread_t thread[THREADS_MAX];
    pthread_mutex_t held = PTHREAD_MUTEX_INITIALIZER;
    unsigned started = 0;
    int refusal = 0;
    threads_allowed = threads < THREADS_MAX ? threads : THREADS_MAX;
    /* the calling thread works, too, so one less is started */
    pthread_mutex_lock(&held);
    while (!refusal && started + 1 < threads_allowed) {
        refusal =
            pthread_create(&thread[started], NULL, wait_for_release, &held);
        started += !refusal;
    }
    pthread_mutex_unlock(&held);
    for (unsigned i = 0; i < started; ++i) {
        pthread_join(thread[i], NULL);
    }
    return refusal ? murk_fail(err, MURK_RUN_FAILED, "",
                               "cannot start %u threads, only %u: %s; "
                               "--threads N asks for fewer",
                               threads_allowed, started + 1, strerror(refusal))
                   : MURK_OK;
}

void murk_crew_run(unsigned threads, uint64_t batches, murk_job job,
                   void *context)
{
    crew c = {.job = job, .context = context, .batches = batches};
    run(threads, &c);
}

void murk_crew_run_workers(unsigned threads, uint64_t batches,
                           murk_worker_job job, void *context)
{
    crew c = {.worker_job = job, .context = context, .batches = batches};
    run(threads, &c);
}

unsigned murk_crew_processors(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > THREADS_MAX ? THREADS_MAX : (unsigned)n;
}
