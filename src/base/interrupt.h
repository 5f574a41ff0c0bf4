/* Requests to stop, by murk_context_cancel() or by a signal that the program
 * receives (app/terminal.h): long computations stop at the next batch and
 * remove unfinished files.
 *
 * A host is a caller of the library (base/host.h), and has one flag. A thread
 * that is bound to no host belongs to the host of the process, so every thread
 * has a flag. No function of this header clears a flag. */
#ifndef MURK_BASE_INTERRUPT_H
#define MURK_BASE_INTERRUPT_H

#include "base/status.h"

#include <stdbool.h>

/* True if the flag of the host of the calling thread is set. */
bool murk_interrupted(void);

/* Fails with MURK_INTERRUPTED if the flag of the host of the calling thread is
 * set. */
murk_status murk_interrupt_check(murk_error *err);

/* Sets the flag of the host of the calling thread. */
void murk_interrupt_request(void);

#endif
