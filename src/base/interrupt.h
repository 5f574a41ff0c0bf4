/* Interruption by SIGINT and SIGTERM: long computations stop at the next batch,
 * remove unfinished files, and the program ends with exit code 130. */
#ifndef MURK_BASE_INTERRUPT_H
#define MURK_BASE_INTERRUPT_H

#include "base/status.h"

#include <stdbool.h>

/* Installs the handlers for SIGINT and SIGTERM. A second signal ends the
 * program at once. */
void murk_interrupt_install(void);

/* True after the first signal. */
bool murk_interrupted(void);

/* Fails with MURK_INTERRUPTED after the first signal. */
murk_status murk_interrupt_check(murk_error *err);

/* Sets the flag as a signal would; for callers of the library. */
void murk_interrupt_request(void);

#endif
