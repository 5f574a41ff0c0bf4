/* Interruption by SIGINT and SIGTERM: long computations stop at the next batch,
 * remove unfinished files, and the program ends with exit code 130.
 *
 * A host is a caller of the library (base/host.h), and has one flag. A thread
 * that is bound to no host belongs to the host of the process, so every thread
 * has a flag. No function of this header clears a flag. */
#ifndef MURK_BASE_INTERRUPT_H
#define MURK_BASE_INTERRUPT_H

#include "base/status.h"

#include <stdbool.h>

/* Installs the handler for SIGINT and SIGTERM, which set the flag of the host
 * of the calling thread (base/host.h). A second signal with the same number
 * ends the program at once. */
void murk_interrupt_install(void);

/* True if the flag of the host of the calling thread is set. */
bool murk_interrupted(void);

/* Fails with MURK_INTERRUPTED if the flag of the host of the calling thread is
 * set. */
murk_status murk_interrupt_check(murk_error *err);

/* Sets the flag of the host of the calling thread, as a signal would; for
 * callers of the library. */
void murk_interrupt_request(void);

#endif
