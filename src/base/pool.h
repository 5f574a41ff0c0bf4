/* The one way work is spread over threads.
 *
 * Calls job(context, batch) once for every batch in [0, batches), in any order
 * and on any thread. Jobs may write only what belongs to their own batch (or
 * to their own worker), or add to murk_tally cells; then the result is the
 * same for any thread count.
 *
 * An interrupt (base/interrupt.h) stops the handing out of batches: the call
 * returns early and the caller asks murk_interrupted(). */
#ifndef MURK_BASE_POOL_H
#define MURK_BASE_POOL_H

#include "base/status.h"

#include <stdint.h>

typedef void (*murk_job)(void *context, uint64_t batch);

/* As murk_job, and told which worker runs it, in [0, threads): for scratch
 * memory, which must not carry anything from one batch to the next. */
typedef void (*murk_worker_job)(void *context, unsigned worker, uint64_t batch);

/* Sets the largest number of threads that any later run may use, whatever the
 * run asks for; without this call it is 256. Starts as many once, so that a
 * machine that refuses them is known before the work: then MURK_RUN_FAILED. */
murk_status murk_pool_allow(unsigned threads, murk_error *err);

/* threads >= 1. Where the machine refuses a thread, the others do its work. */
void murk_pool_run(unsigned threads, uint64_t batches, murk_job job,
                   void *context);
void murk_pool_run_workers(unsigned threads, uint64_t batches,
                           murk_worker_job job, void *context);

/* Runs errand(context) to its end on a stack of 1 MB at least, as every thread
 * of the functions above has: on a thread of its own where `ulimit -s` allows
 * the calling one less. Library: threads that call murk need 512 kB. */
void murk_pool_run_with_stack(void (*errand)(void *), void *context);

/* Processors this process may use, at least 1. */
unsigned murk_pool_processors(void);

#endif
