/* Forks or starts the subprocess, which runs a computation, and reads messages
 * from a pipe until the subprocess reports the end of the computation with its
 * status and error. A message is a header (kind, status, size) and its bytes.
 * In the calling process a message is a call. */
#include "base/isolated.h"

#include "base/c_locale.h"
#include "base/host.h"
#include "base/inputs.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/pipe.h"
#include "base/program.h"
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

/* The subprocess sends messages, each behind INPUTS if murk-rows sends them,
 * then the end with status and error. The values are arbitrary marks that
 * detect garbage in the pipe. */
typedef enum kind {
    MESSAGE = 0x6d736721,
    INPUTS = 0x696e7075, /* hashes of the files that murk-rows opened */
    END = 0x656e6421
} kind;

struct murk_isolated {
    int fd;
    bool is_started; /* in murk-rows */
    /* In the calling process: the function that receives, NULL in a subprocess,
     * and the receiver of warnings of the caller. */
    murk_isolated_receive receive;
    void *context;
    murk_log_receiver log;
};

bool murk_isolated_is_subprocess(const murk_isolated *process)
{
    return !process->receive;
}

/* ---- in the process that works ---- */

/* Hands a message over in the calling process. Messages of receive() are for
 * the caller, so the receiver of warnings of the caller is set meanwhile. */
static murk_status hand_over(const murk_isolated *process, const void *bytes,
                             size_t size, murk_error *err)
{
    const murk_status stopped = murk_interrupt_check(err);
    if (stopped) {
        return stopped;
    }
    char *copy = malloc(size + 1);
    if (!copy) {
        return murk_no_memory(err, "", "for a message");
    }
    memcpy(copy, bytes, size);
    copy[size] = '\0';
    const murk_log_receiver own = murk_log_receiver_now();
    murk_log_restore(&process->log);
    const murk_status status =
        process->receive(process->context, copy, size, err);
    murk_log_restore(&own);
    free(copy);
    return status;
}

/* A fork shares the set of inputs with the parent process. */
static bool send_inputs(const murk_isolated *process)
{
    uint64_t *hash = NULL;
    size_t n = 0;
    if (!process->is_started) {
        return true;
    }
    murk_inputs_list(&hash, &n);
    const bool sent =
        murk_pipe_send(process->fd, INPUTS, MURK_OK, hash, n * sizeof *hash);
    free(hash);
    return sent;
}

murk_status murk_isolated_send(murk_isolated *process, const void *bytes,
                               size_t size, murk_error *err)
{
    if (process->receive) {
        return hand_over(process, bytes, size, err);
    }
    return send_inputs(process) &&
                   murk_pipe_send(process->fd, MESSAGE, MURK_OK, bytes, size)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "nobody listens to it any more");
}

/* Runs the computation. A failure has a message. */
static murk_status compute(murk_isolated *process, murk_isolated_work work,
                           void *context, murk_error *err)
{
    const murk_status status = work(process, context, err);
    if (status && !err->code) { /* the caller judges by the error */
        murk_fail(err, status, "", "its process failed without a message");
    }
    return status;
}

static _Noreturn void run_and_exit(murk_isolated *process, pid_t parent,
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
    murk_error err = {0};
    const murk_status status = compute(process, work, context, &err);
    const bool sent =
        send_inputs(process) &&
        murk_pipe_send(process->fd, END, status, &err, sizeof err);
    _exit(sent ? 0 : 1); /* buffers that were filled before the fork are not
                          * flushed */
}

/* ---- in the parent process ---- */

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
    if (end->verdict == MURK_PIPE_RECEIVED && h->kind == INPUTS) {
        murk_inputs_add_listed(bytes, (size_t)h->size / sizeof(uint64_t));
    } else if (end->verdict == MURK_PIPE_RECEIVED) {
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
        if (h.kind != MESSAGE && h.kind != INPUTS) {
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

/* Reads messages until the end, then kills the subprocess unless it sent its
 * end. Closes the file. */
static murk_status take_messages(int fd, pid_t pid,
                                 murk_isolated_receive receive, void *context,
                                 murk_error *err)
{
    ending end = {0};
    listen(fd, receive, context, &end, err);
    close(fd);
    if (end.verdict != MURK_PIPE_RECEIVED || end.received) {
        kill(pid, SIGKILL);
    }
    const int ended = murk_pipe_wait(pid);
    return explain(&end, ended, err);
}

/* ---- the three ways ---- */

static murk_status do_in_fork(murk_isolated_work work, void *work_context,
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
        murk_isolated process = {.fd = ends[1]};
        run_and_exit(&process, self, work, work_context);
    }
    close(ends[1]);
    const murk_status status =
        take_messages(ends[0], pid, receive, receive_context, err);
    murk_progress_resume();
    return status;
}

/* The numbers in a request. */
typedef struct request_head {
    pid_t parent;
    unsigned threads_allowed;
} request_head;

static murk_status do_in_program(const murk_isolated_job *job,
                                 const void *work_context, const char *version,
                                 murk_isolated_receive receive,
                                 void *receive_context, murk_error *err)
{
    murk_parcel request = {0};
    uint64_t *hash = NULL;
    size_t n = 0;
    pid_t pid = 0;
    int fd = -1;
    /* The request: version, name of the job, host, and the packed context. */
    const request_head head = {getpid(), murk_host_now()->threads_allowed};
    murk_parcel_put_text(&request, version);
    murk_parcel_put_text(&request, job->name);
    murk_parcel_put(&request, &head, sizeof head);
    murk_inputs_list(&hash, &n);
    murk_parcel_put(&request, &n, sizeof n);
    murk_parcel_put(&request, hash, n * sizeof *hash);
    free(hash);
    job->pack(&request, work_context);
    const murk_status status =
        request.is_short ? murk_no_memory(err, "", "for a process")
                         : murk_program_start(&pid, &fd, MURK_PROGRAM_ROWS,
                                              &request, "", err);
    murk_parcel_release(&request);
    return status ? status
                  : take_messages(fd, pid, receive, receive_context, err);
}

static murk_status do_here(murk_isolated_work work, void *work_context,
                           murk_isolated_receive receive, void *receive_context,
                           murk_error *err)
{
    murk_isolated process = {.fd = -1,
                             .receive = receive,
                             .context = receive_context,
                             .log = murk_log_receiver_now()};
    murk_error failure = {0};
    const murk_status status = compute(&process, work, work_context, &failure);
    murk_log_restore(&process.log);
    return status
               ? murk_fail(err, failure.code, failure.where, "%s", failure.text)
               : MURK_OK;
}

murk_status murk_isolated_check(murk_error *err)
{
    char path[PATH_MAX];
    return murk_host_now()->importing == MURK_IMPORT_STARTS
               ? murk_program_find(path, MURK_PROGRAM_ROWS, "", err)
               : MURK_OK;
}

murk_status murk_isolated_do(const murk_isolated_job *job, void *work_context,
                             const char *version, murk_isolated_receive receive,
                             void *receive_context, murk_error *err)
{
    switch (murk_host_now()->importing) {
    case MURK_IMPORT_STARTS:
        return do_in_program(job, work_context, version, receive,
                             receive_context, err);
    case MURK_IMPORT_IN_PROCESS:
        return do_here(job->work, work_context, receive, receive_context, err);
    case MURK_IMPORT_FORKS:
        break;
    }
    return do_in_fork(job->work, work_context, receive, receive_context, err);
}

/* ---- murk-rows ---- */

/* A job, the parcel that has the context, and the versions of the library and
 * of the program. */
typedef struct packed_job {
    const murk_isolated_job *job;
    murk_parcel *from;
    const char *asked, *own;
} packed_job;

/* A murk_isolated_work. */
static murk_status work_packed(murk_isolated *process, void *context,
                               murk_error *err)
{
    const packed_job *packed = context;
    return strcmp(packed->asked, packed->own) == 0
               ? packed->job->work_packed(process, packed->from, err)
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "the program " MURK_PROGRAM_ROWS
                           " is of version %s, must be that of the library, %s",
                           packed->own, packed->asked);
}

_Noreturn void murk_isolated_serve(murk_parcel *request, int fd,
                                   const char *version,
                                   const murk_isolated_job *const jobs[],
                                   size_t n)
{
    /* Take the request apart. */
    packed_job packed = {.from = request, .own = version};
    packed.asked = murk_parcel_take_text(request);
    const char *name = murk_parcel_take_text(request);
    const request_head *head = murk_parcel_take(request, sizeof *head);
    const size_t *inputs = murk_parcel_take(request, sizeof *inputs);
    const void *hash =
        inputs ? murk_parcel_take(request, *inputs * sizeof(uint64_t)) : NULL;
    for (size_t i = 0; name && i < n; ++i) {
        if (strcmp(jobs[i]->name, name) == 0) {
            packed.job = jobs[i];
        }
    }
    if (!packed.asked || !packed.job || !head || request->is_short) {
        _exit(1);
    }
    /* Set up the host of this process. */
    murk_host_now()->threads_allowed = head->threads_allowed;
    murk_inputs_begin();
    murk_inputs_add_listed(hash, *inputs);
    murk_isolated process = {.fd = fd, .is_started = true};
    run_and_exit(&process, head->parent, work_packed, &packed);
}
