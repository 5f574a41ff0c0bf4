/* Work in a process of its own: it may have threads and ray devices, which end
 * with it, and whatever it dies of leaves this one whole. What it finds comes
 * back as messages, one by one.
 *
 * Call it while this process has no threads and no ray device (fork). */
#ifndef MURK_BASE_ISOLATED_H
#define MURK_BASE_ISOLATED_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_isolated murk_isolated;

/* Runs in the other process. Its failure reaches the caller's err as it is.
 * Signals that interrupt are the caller's to act on: it ends the work. */
typedef murk_status (*murk_isolated_work)(murk_isolated *apart, void *context,
                                          murk_error *err);
/* One message, from within the work. Fails with MURK_RUN_FAILED where nobody
 * listens any more. */
murk_status murk_isolated_send(murk_isolated *apart, const void *bytes,
                               size_t size, murk_error *err);

/* Runs here for each message, in order; bytes[size] is '\0', and they are lent
 * for the call. A failure ends the work. */
typedef murk_status (*murk_isolated_receive)(void *context, const char *bytes,
                                             size_t size, murk_error *err);

#define MURK_ISOLATED_MESSAGE_MAX 67108864u /* bytes */

/* Fails as the work did, or receive(), or with MURK_INTERRUPTED; with
 * MURK_RUN_FAILED where the process died (out of memory, for one). */
murk_status murk_isolated_run(murk_isolated_work work, void *work_context,
                              murk_isolated_receive receive,
                              void *receive_context, murk_error *err);

#endif
