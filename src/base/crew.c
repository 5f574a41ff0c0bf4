#include "base/crew.h"

#include "base/interrupt.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#define THREADS_MAX 256

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
    if (threads > THREADS_MAX) {
        threads = THREADS_MAX;
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
