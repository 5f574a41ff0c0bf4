/* Runs a computation in a subprocess. The subprocess may start threads and ray
 * devices, which end with it, and a crash of the subprocess leaves the calling
 * process intact. Results return as messages through a pipe.
 *
 * murk_isolated_run() forks. The caller must use no thread pool at that time;
 * the progress line is stopped. Other threads may run (src/api/README.md). */
#ifndef MURK_BASE_ISOLATED_H
#define MURK_BASE_ISOLATED_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_isolated murk_isolated;

/* The computation, called in the subprocess. The error of a failure is passed
 * to the caller of murk_isolated_run() unchanged; a failure that leaves *err
 * empty is passed with its status.
 * The subprocess ignores SIGINT: the parent process notices the interrupt and
 * kills the subprocess. */
typedef murk_status (*murk_isolated_work)(murk_isolated *process, void *context,
                                          murk_error *err);
/* Sends one message of at most MURK_ISOLATED_MESSAGE_MAX bytes from the
 * subprocess. Fails with MURK_RUN_FAILED if the parent process no longer reads
 * (SIGPIPE must be ignored). */
murk_status murk_isolated_send(murk_isolated *process, const void *bytes,
                               size_t size, murk_error *err);

/* Called in the parent process for each message, in order of sending.
 * bytes[size] is '\0', and the bytes are valid during the call only. If the
 * function fails, the computation ends and the subprocess is killed. */
typedef murk_status (*murk_isolated_receive)(void *context, const char *bytes,
                                             size_t size, murk_error *err);

/* The largest message [bytes], far above the longest row of a study. A length
 * above the limit is taken to be damaged, and the computation fails before
 * memory is allocated for the message. */
#define MURK_ISOLATED_MESSAGE_MAX 67108864u

/* Runs work() in a subprocess and receive() for each message in this process.
 * Fails with the failure of either, with MURK_INTERRUPTED, with MURK_NO_MEMORY
 * if there is no memory for a message, or with MURK_RUN_FAILED if no pipe or
 * process could be made or the subprocess died (for example, out of memory). */
murk_status murk_isolated_run(murk_isolated_work work, void *work_context,
                              murk_isolated_receive receive,
                              void *receive_context, murk_error *err);

#endif
