/* Ctrl-C and friends: long work stops at the next batch, nothing half-written
 * stays behind, and the program ends with 130. */
#ifndef MURK_BASE_INTERRUPT_H
#define MURK_BASE_INTERRUPT_H

#include <stdbool.h>

/* Installs the handlers for SIGINT and SIGTERM. A second signal ends the
 * program at once. */
void murk_interrupt_install(void);

/* True from the first signal on. */
bool murk_interrupted(void);

/* Raises the flag, as a signal would: for callers of the library. */
void murk_interrupt_request(void);

#endif
