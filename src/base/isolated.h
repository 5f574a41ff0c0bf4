/* Runs a computation in a subprocess. The subprocess may start threads and ray
 * devices, which end with it, and a crash of the subprocess leaves the calling
 * process intact. Results return as messages through a pipe.
 *
 * The call forks, so the calling process must have no threads and no ray
 * device. */
#ifndef MURK_BASE_ISOLATED_H
#define MURK_BASE_ISOLATED_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_isolated murk_isolated;

/* The computation, called in the subprocess. A failure is passed to the caller
 * of murk_isolated_run() unchanged. Signals that interrupt are handled by the
 * parent process, which kills the subprocess. */
typedef murk_status (*murk_isolated_work)(murk_isolated *process, void *context,
                                          murk_error *err);
/* Sends one message from the subprocess. Fails with MURK_RUN_FAILED if the
 * parent process no longer reads. */
murk_status murk_isolated_send(murk_isolated *process, const void *bytes,
                               size_t size, murk_error *err);

/* Called in the parent process for each message, in order of sending.
 * bytes[size] is '\0', and the bytes are valid during the call only. A failure
 * ends the computation. */
typedef murk_status (*murk_isolated_receive)(void *context, const char *bytes,
                                             size_t size, murk_error *err);

/* Bytes: far above the longest row of a study, so that a damaged length is
 * noticed before memory is taken for it. */
#define MURK_ISOLATED_MESSAGE_MAX 67108864u

/* Runs work() in a subprocess and receive() for each message in this process.
 * Fails with the failure of either, with MURK_INTERRUPTED, or with
 * MURK_RUN_FAILED if the subprocess died (for example, out of memory). */
murk_status murk_isolated_run(murk_isolated_work work, void *work_context,
                              murk_isolated_receive receive,
                              void *receive_context, murk_error *err);

#endif
