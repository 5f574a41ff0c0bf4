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

/* Messages, then the end with the work's status and error. */
typedef enum kind { MESSAGE = 0x6d736721, END = 0x656e6421 } kind;

typedef struct head {
    uint32_t kind, status;
    uint64_t size;
} head;

struct murk_isolated {
    int fd;
};

murk_status murk_isolated_send(murk_isolated *apart, const void *bytes,
                               size_t size, murk_error *err)
{
    const head h = {MESSAGE, MURK_OK, size};
    return murk_pipe_write(apart->fd, &h, sizeof h) &&
                   murk_pipe_write(apart->fd, bytes, size)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "nobody listens to it any more");
}

static _Noreturn void be_apart(int fd, pid_t parent, murk_isolated_work work,
                               void *context)
{
    (void)murk_c_locale_enter();
    signal(SIGINT, SIG_IGN); /* the parent decides, and kills */
    signal(SIGTERM, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* or runs on for nobody */
#endif
    if (getppid() != parent) {
        _exit(1);
    }
    murk_isolated apart = {fd};
    murk_error err = {0};
    const murk_status status = work(&apart, context, &err);
    const head h = {END, (uint32_t)status, sizeof err};
    const bool sent = murk_pipe_write(fd, &h, sizeof h) &&
                      murk_pipe_write(fd, &err, sizeof err);
    _exit(sent ? 0 : 1); /* what it shares with the parent is not flushed */
}

/* What the other process said last, or why it says no more. */
typedef struct ending {
    murk_pipe_verdict verdict;
    murk_status received; /* of receive() */
    murk_error told;
} ending;

static bool take_message(int fd, const head *h, murk_isolated_receive receive,
                         void *context, ending *end, murk_error *err)
{
    if (h->size > MURK_ISOLATED_MESSAGE_MAX) {
        end->verdict = MURK_PIPE_CUT_SHORT;
        return false;
    }
    char *bytes = malloc((size_t)h->size + 1);
    if (!bytes) {
        end->received =
            murk_fail(err, MURK_NO_MEMORY, "", "no memory for a message");
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
    head h;
    for (;;) {
        end->verdict = murk_pipe_read(fd, &h, sizeof h, INFINITY);
        if (end->verdict != MURK_PIPE_RECEIVED) {
            return;
        }
        if (h.kind == END && h.size == sizeof end->told) {
            end->verdict =
                murk_pipe_read(fd, &end->told, sizeof end->told, INFINITY);
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
    return end->told.status ? murk_fail(err, end->told.status, end->told.where,
                                        "%s", end->told.text)
                            : MURK_OK;
}

murk_status murk_isolated_run(murk_isolated_work work, void *work_context,
                              murk_isolated_receive receive,
                              void *receive_context, murk_error *err)
{
    int ends[2];
    if (pipe(ends) != 0) {
        return murk_fail(err, MURK_RUN_FAILED, "", "cannot open a pipe: %s",
                         strerror(errno));
    }
    murk_progress_pause();
    const pid_t self = getpid(), pid = fork();
    if (pid < 0) {
        murk_progress_resume();
        close(ends[0]);
        close(ends[1]);
        return murk_fail(err, MURK_RUN_FAILED, "", "cannot start a process: %s",
                         strerror(errno));
    }
    if (pid == 0) {
        close(ends[0]);
        murk_progress_apart();
        be_apart(ends[1], self, work, work_context);
    }
    close(ends[1]);
    ending end = {0};
    listen(ends[0], receive, receive_context, &end, err);
    close(ends[0]);
    if (end.verdict != MURK_PIPE_RECEIVED || end.received) {
        kill(pid, SIGKILL);
    }
    int ended = 0;
    while (waitpid(pid, &ended, 0) < 0 && errno == EINTR) {
    }
    murk_progress_resume();
    return explain(&end, ended, err);
}
