/* Every batch is done once, whatever the number of threads; an interrupt ends
 * the handing out. */
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/tally.h"
#include "check.h"

#define BATCHES 1000

typedef struct work {
    int done[BATCHES];
    murk_tally sum;
    unsigned threads;
    murk_tally worker_is_bad;
} work;

static void job(void *context, uint64_t batch)
{
    work *w = context;
    ++w->done[batch];
    murk_tally_add(&w->sum, (int64_t)batch);
    murk_progress_add(1);
}

static void worker_job(void *context, unsigned worker, uint64_t batch)
{
    work *w = context;
    murk_tally_add(&w->worker_is_bad, worker >= w->threads);
    job(context, batch);
}

static void check_all_done(const work *w)
{
    int wrong = 0;
    for (int i = 0; i < BATCHES; ++i) {
        wrong += w->done[i] != 1;
    }
    CHECK(wrong == 0);
    CHECK(murk_tally_read(&w->sum) == BATCHES * (BATCHES - 1) / 2);
    CHECK(murk_tally_read(&w->worker_is_bad) == 0);
}

int main(void)
{
    const unsigned threads[] = {1, 2, 5, 64};
    murk_progress_begin("test", BATCHES, "batches");
    for (int i = 0; i < 4; ++i) {
        work w = {.threads = threads[i]};
        murk_pool_run(threads[i], BATCHES, job, &w);
        check_all_done(&w);
        work v = {.threads = threads[i]};
        murk_pool_run_workers(threads[i], BATCHES, worker_job, &v);
        check_all_done(&v);
    }
    /* what is allowed holds for every later run */
    CHECK(murk_pool_allow(3, NULL) == MURK_OK);
    work few = {.threads = 3};
    murk_pool_run_workers(64, BATCHES, worker_job, &few);
    check_all_done(&few);
    CHECK(murk_pool_allow(1, NULL) == MURK_OK);
    work one = {.threads = 1};
    murk_pool_run_workers(2, BATCHES, worker_job, &one);
    check_all_done(&one);
    CHECK(murk_pool_allow(1000, NULL) == MURK_OK);
    work none = {.threads = 2};
    murk_pool_run(2, 0, job, &none);
    CHECK(murk_tally_read(&none.sum) == 0);
    murk_progress_end();
    CHECK(murk_pool_processors() >= 1);

    murk_interrupt_request();
    work stopped = {.threads = 2};
    murk_pool_run(2, BATCHES, job, &stopped);
    CHECK(murk_tally_read(&stopped.sum) == 0);
    return check_done();
}
