/* The thread pool: the only functions that spread computations over threads.
 *
 * A run calls job(context, batch) once for every batch in [0, batches), in any
 * order and on any thread. A job may write only data that belong to its batch
 * (or to its worker), or add to murk_tally cells; then the result is the same
 * for any number of threads.
 *
 * After an interrupt (base/interrupt.h) no further batches are handed out: the
 * call returns early, and the caller checks murk_interrupted(). */
#ifndef MURK_BASE_POOL_H
#define MURK_BASE_POOL_H

#include "base/status.h"

#include <stdint.h>

typedef void (*murk_job)(void *context, uint64_t batch);

/* Like murk_job, with the number of the worker in [0, threads), for scratch
 * memory of the worker. Scratch memory must not carry information from one
 * batch to the next. */
typedef void (*murk_worker_job)(void *context, unsigned worker, uint64_t batch);

/* Sets the largest number of threads, the calling thread included, that any
 * later run of the host of the calling thread may use (base/host.h). 0 and
 * numbers above 256 mean 256, as without this call. Starts the other threads
 * once, so that a machine that refuses them is recognised before long
 * computations: then fails with MURK_RUN_FAILED. */
murk_status murk_pool_allow(unsigned threads, murk_error *err);

/* Runs all batches; threads >= 1. If the machine refuses a thread, the other
 * threads take its batches. */
void murk_pool_run(unsigned threads, uint64_t batches, murk_job job,
                   void *context);
void murk_pool_run_workers(unsigned threads, uint64_t batches,
                           murk_worker_job job, void *context);

/* Like the two functions above, with the number of an item in place of the
 * batch. A worker takes `each` >= 1 successive items at a time, for items that
 * are short. */
void murk_pool_run_items(unsigned threads, uint64_t items, uint64_t each,
                         murk_job job, void *context);
void murk_pool_run_items_of_workers(unsigned threads, uint64_t items,
                                    uint64_t each, murk_worker_job job,
                                    void *context);

/* Runs task(context) to its end. If `ulimit -s` is below 1 MB (1,048,576
 * bytes), the task runs in a new thread with a stack of 1 MB, the least stack
 * of the threads of the functions above; otherwise, or if no thread can be
 * started, in the calling thread. Threads of a host program that call the
 * library need a stack of 512 kB. */
void murk_pool_run_with_stack(void (*task)(void *), void *context);

/* The number of processors of the machine that are online, 1..256. Limits of
 * the process (CPU affinity, control groups) are not considered. */
unsigned murk_pool_processors(void);

#endif
