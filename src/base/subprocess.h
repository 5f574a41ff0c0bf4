/* Parses untrusted files in a subprocess with limits on memory and processor
 * time. The subprocess is confined to reading (base/confine.h; a note tells
 * once if the kernel cannot confine it) and returns plain bytes. Whatever a
 * malformed file does to the parser, the parent process receives bytes or an
 * error message.
 *
 * The host of the calling thread chooses the process (base/host.h): a fork, for
 * which the calling process must have no other threads (the thread of the
 * progress line is stopped) and no ray device; the program murk-reader
 * (base/program.h), which hosts with threads may start; or the calling process,
 * if the host trusts the files. */
#ifndef MURK_BASE_SUBPROCESS_H
#define MURK_BASE_SUBPROCESS_H

#include "base/parcel.h"
#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

/* The parser, called in the subprocess, sends bytes by murk_subprocess_send(),
 * which fails with MURK_RUN_FAILED, or with MURK_NO_MEMORY if the parser runs
 * in the calling process. The error of a failed parser is passed to the caller
 * of murk_subprocess_run() unchanged, so a failure must fill *err. */
typedef struct murk_subprocess murk_subprocess;
typedef murk_status (*murk_subprocess_work)(murk_subprocess *process,
                                            void *context, murk_error *err);
murk_status murk_subprocess_send(murk_subprocess *process, const void *bytes,
                                 size_t size);

/* A kind of work, which murk-reader finds by the name. pack() puts all that
 * work() needs of the context into a parcel, and work_packed() calls work()
 * with a context that it takes from there. prepare(), unless it is NULL, loads
 * what work() needs of other libraries, and is called before, in a process
 * without limits: the process that is forked, so that it loads once for all
 * files, or murk-reader. It fails at `where`. */
typedef struct murk_subprocess_job {
    const char *name;
    murk_status (*prepare)(const char *where, murk_error *err);
    murk_subprocess_work work;
    void (*pack)(murk_parcel *to, const void *context);
    murk_status (*work_packed)(murk_subprocess *process, murk_parcel *from,
                               murk_error *err);
    /* A program beside murk-reader that does this work alone, whatever the host
     * chooses, because it is linked with libraries that murk does not need; and
     * the text of the failure if it is not there. NULL: the host chooses. */
    const char *program, *needs;
} murk_subprocess_job;

typedef struct murk_subprocess_limits {
    uint64_t memory_bytes; /* address space in addition to that of the parent;
                            * ignored under sanitizers */
    uint64_t handed_bytes; /* the largest number of bytes that the subprocess
                            * may send */
    unsigned seconds;      /* processor time; the limit of the elapsed time is
                            * twice this */
} murk_subprocess_limits;

/* Default limits for a file of that size below 400 GB: memory and sent bytes of
 * 2 GB or 8 times the file, whichever is larger, and 8 s of processor time plus
 * 1 s for every 4 MB, under sanitizers 15 times as long. */
murk_subprocess_limits murk_subprocess_limits_for(uint64_t file_bytes);

/* Does the work in the process that the host chooses. The limits do not hold
 * in the calling process. *out, *size and failures are those of
 * murk_subprocess_run(); fails with MURK_RUN_FAILED if murk-reader cannot be
 * started, and with MURK_UNSUPPORTED if a program of the job is not there. */
murk_status murk_subprocess_do(unsigned char **out, size_t *size,
                               const murk_subprocess_job *job, void *context,
                               const murk_subprocess_limits *limits,
                               const char *where, murk_error *err);

/* The other side of murk_subprocess_do(), in murk-reader: finds the job of a
 * request among jobs[n], does the work with the limits of the request, answers
 * to `fd` and ends the process; without an answer if there is no such job or
 * the request has no limits. */
_Noreturn void murk_subprocess_serve(murk_parcel *request, int fd,
                                     const murk_subprocess_job *const jobs[],
                                     size_t n);

/* Does the work in a fork. *out (from malloc(), 16-byte aligned, freed by the
 * caller; NULL if nothing was sent) and *size hold all bytes that the
 * subprocess sent. Fails with the error of the parser; with MURK_BAD_FILE at
 * `where` if the subprocess died or exceeded a limit; with MURK_INTERRUPTED; or
 * with MURK_RUN_FAILED if no pipe or process could be made. Standard output and
 * standard error of the subprocess are discarded: warnings have to be sent as
 * data. */
murk_status murk_subprocess_run(unsigned char **out, size_t *size,
                                murk_subprocess_work work, void *context,
                                const murk_subprocess_limits *limits,
                                const char *where, murk_error *err);

#endif
