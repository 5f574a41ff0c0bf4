/* Forks, runs a computation in the subprocess and reads messages from a pipe
 * until the subprocess reports the end of the computation with its status and
 * error. A message is a header (kind, status, size) and its bytes. */
#include "base/isolated.h"

#include "base/c_locale.h"
#include "base/pipe.h"
#include "base/progress.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

/* The subprocess sends messages, then the end with status and error. The values
 * are arbitrary marks that detect garbage in the pipe. */
typedef enum kind { MESSAGE = 0x6d736721, END = 0x656e6421 } kind;

struct murk_isolated {
    int fd;
};

murk_status murk_isolated_send(murk_isolated *process, const void *bytes,
                               size_t size, murk_error *err)
{
    return murk_pipe_send(process->fd, MESSAGE, MURK_OK, bytes, size)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "nobody listens to it any more");
}

static _Noreturn void run_and_exit(int fd, pid_t parent,
                                   murk_isolated_work work, void *context)
{
    (void)murk_c_locale_enter();
    signal(SIGINT, SIG_IGN); /* the parent handles the interrupt and kills this
                              * process */
    signal(SIGTERM, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* end with the parent */
#endif
    if (getppid() != parent) {
        _exit(1);
    }
    murk_isolated process = {fd};
    murk_error err = {0};
    const murk_status status = work(&process, context, &err);
    if (status && !err.code) { /* the parent judges by the error */
        murk_fail(&err, status, "", "its process failed without a message");
    }
    const bool sent = murk_pipe_send(fd, END, status, &err, sizeof err);
    _exit(sent ? 0 : 1); /* buffers that were filled before the fork are not
                          * flushed */
}

/* How reading ended: the verdict on the last read, and the error of the
 * computation, which counts if the verdict is MURK_PIPE_RECEIVED and `received`
 * is MURK_OK. */
typedef struct ending {
    murk_pipe_verdict verdict;
    murk_status received; /* status of the last receive() */
    murk_error error;
} ending;

static bool take_message(int fd, const murk_pipe_head *h,
                         murk_isolated_receive receive, void *context,
                         ending *end, murk_error *err)
{
    if (h->size > MURK_ISOLATED_MESSAGE_MAX) {
        end->verdict = MURK_PIPE_CUT_SHORT;
        return false;
    }
    char *bytes = malloc((size_t)h->size + 1);
    if (!bytes) {
        end->received = murk_no_memory(err, "", "for a message");
        return false;
    }
    end->verdict = murk_pipe_read(fd, bytes, (size_t)h->size, INFINITY);
    if (end->verdict == MURK_PIPE_RECEIVED) {
        bytes[h->size] = '\0';
        end->received = receive(context, bytes, (size_t)h->size, err);
    }
    free(bytes);
    return end->verdict == MURK_PIPE_RECEIVED && !end->received;
}

static void listen(int fd, murk_isolated_receive receive, void *context,
                   ending *end, murk_error *err)
{
    murk_pipe_head h;
    for (;;) {
        end->verdict = murk_pipe_read(fd, &h, sizeof h, INFINITY);
        if (end->verdict != MURK_PIPE_RECEIVED) {
            return;
        }
        if (h.kind == END && h.size == sizeof end->error) {
            end->verdict =
                murk_pipe_read(fd, &end->error, sizeof end->error, INFINITY);
            return;
        }
        if (h.kind != MESSAGE) {
            end->verdict = MURK_PIPE_CUT_SHORT;
            return;
        }
        if (!take_message(fd, &h, receive, context, end, err)) {
            return;
        }
    }
}

static murk_status explain(const ending *end, int ended, murk_error *err)
{
    if (end->verdict == MURK_PIPE_STOPPED) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (end->received) {
        return end->received;
    }
    if (end->verdict != MURK_PIPE_RECEIVED) {
        return WIFSIGNALED(ended)
                   ? murk_fail(err, MURK_RUN_FAILED, "",
                               "its process was ended by a signal: %s%s",
                               strsignal(WTERMSIG(ended)),
                               WTERMSIG(ended) == SIGKILL ? " (out of memory?)"
                                                          : "")
                   : murk_fail(err, MURK_RUN_FAILED, "",
                               "its process ended without a word");
    }
    return end->error.code ? murk_fail(err, end->error.code, end->error.where,
                                       "%s", end->error.text)
                           : MURK_OK;
}

murk_status murk_isolated_run(murk_isolated_work work, void *work_context,
                              murk_isolated_receive receive,
                              void *receive_context, murk_error *err)
{
    int ends[2];
    const murk_status opened = murk_pipe_open(ends, "", err);
    if (opened) {
        return opened;
    }
    /* No thread of this call may run during fork(): stop the progress
     * display. */
    murk_progress_pause();
    const pid_t self = getpid(), pid = fork();
    if (pid < 0) {
        murk_progress_resume();
        close(ends[0]);
        close(ends[1]);
        return murk_fail(err, MURK_RUN_FAILED, "", "cannot start a process: %s",
                         strerror(errno));
    }
    /* Subprocess: run the computation and exit. */
    if (pid == 0) {
        close(ends[0]);
        murk_progress_in_subprocess();
        run_and_exit(ends[1], self, work, work_context);
    }
    /* Parent: read messages, then kill the subprocess unless it sent its
     * end. */
    close(ends[1]);
    ending end = {0};
    listen(ends[0], receive, receive_context, &end, err);
    close(ends[0]);
    if (end.verdict != MURK_PIPE_RECEIVED || end.received) {
        kill(pid, SIGKILL);
    }
    const int ended = murk_pipe_wait(pid);
    murk_progress_resume();
    return explain(&end, ended, err);
}
