/* The one way work is spread over threads.
 *
 * Calls job(context, batch) once for every batch in [0, batches), in any order
 * and on any thread. Jobs may write only what belongs to their own batch (or
 * to their own worker), or add to murk_tally cells; then the result is the
 * same for any thread count.
 *
 * An interrupt (base/interrupt.h) stops the handing out of batches: the call
 * returns early and the caller asks murk_interrupted(). */
#ifndef MURK_BASE_CREW_H
#define MURK_BASE_CREW_H

#include <stdint.h>

typedef void (*murk_job)(void *context, uint64_t batch);

/* As murk_job, and told which worker runs it, in [0, threads): for scratch
 * memory, which must not carry anything from one batch to the next. */
typedef void (*murk_worker_job)(void *context, unsigned worker, uint64_t batch);

/* threads >= 1. Where the machine refuses a thread, the others do its work. */
void murk_crew_run(unsigned threads, uint64_t batches, murk_job job,
                   void *context);
void murk_crew_run_workers(unsigned threads, uint64_t batches,
                           murk_worker_job job, void *context);

/* Processors this process may use, at least 1. */
unsigned murk_crew_processors(void);

#endif
