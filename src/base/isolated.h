/* Runs a computation of murk in a process of its own. That process may start
 * threads and ray devices, which end with it, and a crash of it leaves the
 * calling process intact. Results return as messages.
 *
 * The host of the calling thread chooses the process (base/host.h): a fork, for
 * which the calling process must have no other threads (the thread of the
 * progress line is stopped); the program murk-rows (base/program.h), which
 * hosts with threads may start; or the calling process. */
#ifndef MURK_BASE_ISOLATED_H
#define MURK_BASE_ISOLATED_H

#include "base/parcel.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_isolated murk_isolated;

/* The computation. The error of a failure is passed to the caller of
 * murk_isolated_do() unchanged; a failure that leaves *err empty is passed with
 * its status. The computation may redirect the warnings of its host
 * (base/log.h).
 * A subprocess ignores SIGINT: the parent process notices the interrupt and
 * kills the subprocess. */
typedef murk_status (*murk_isolated_work)(murk_isolated *process, void *context,
                                          murk_error *err);
/* Sends one message of at most MURK_ISOLATED_MESSAGE_MAX bytes to the function
 * that receives. Fails with MURK_RUN_FAILED if the parent process no longer
 * reads (SIGPIPE must be ignored). In the calling process, fails with the
 * failure of that function, and with MURK_INTERRUPTED after a request to stop,
 * because the work before may then be incomplete. */
murk_status murk_isolated_send(murk_isolated *process, const void *bytes,
                               size_t size, murk_error *err);

/* True if the work is done in another process than the caller's. */
bool murk_isolated_is_subprocess(const murk_isolated *process);

/* Called in the parent process for each message, in order of sending.
 * bytes[size] is '\0', and the bytes are valid during the call only. If the
 * function fails, the computation ends and the subprocess is killed. */
typedef murk_status (*murk_isolated_receive)(void *context, const char *bytes,
                                             size_t size, murk_error *err);

/* The largest message [bytes], far above the longest row of a study. A length
 * above the limit is taken to be damaged, and the computation fails before
 * memory is allocated for the message. */
#define MURK_ISOLATED_MESSAGE_MAX 67108864u

/* A kind of work, which murk-rows finds by the name. pack() puts all that
 * work() needs of the context into a parcel, and work_packed() calls work()
 * with a context that it takes from there. */
typedef struct murk_isolated_job {
    const char *name;
    murk_isolated_work work;
    void (*pack)(murk_parcel *to, const void *context);
    murk_status (*work_packed)(murk_isolated *process, murk_parcel *from,
                               murk_error *err);
} murk_isolated_job;

/* Fails with MURK_RUN_FAILED if the host asks for murk-rows and there is no
 * such program. */
murk_status murk_isolated_check(murk_error *err);

/* Does the work in the process that the host chooses, and calls receive() for
 * each message in this process. `version` is that of the library; murk-rows
 * refuses the work of another version. Fails with the failure of either
 * function, with MURK_INTERRUPTED, or with MURK_RUN_FAILED if no pipe or
 * process could be made or the subprocess died (for example, out of memory). */
murk_status murk_isolated_do(const murk_isolated_job *job, void *work_context,
                             const char *version, murk_isolated_receive receive,
                             void *receive_context, murk_error *err);

/* The other side of murk_isolated_do(), in murk-rows: finds the job of a
 * request among jobs[n], does the work, and answers to `fd`. `version` is that
 * of murk-rows. */
_Noreturn void murk_isolated_serve(murk_parcel *request, int fd,
                                   const char *version,
                                   const murk_isolated_job *const jobs[],
                                   size_t n);

#endif
