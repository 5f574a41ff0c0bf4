/* Runs a parser in a limited and confined subprocess, a fork or murk-reader,
 * and reads chunks of bytes from a pipe until the subprocess reports its end.
 * The parent process checks the kinds and sizes of the blocks in the pipe, and
 * gives up reading at a deadline. If the host trusts the files, the parser runs
 * in the calling process instead, without limits and confinement. */
#include "base/subprocess.h"

#include "base/c_locale.h"
#include "base/confine.h"
#include "base/host.h"
#include "base/inputs.h"
#include "base/log.h"
#include "base/pipe.h"
#include "base/program.h"
#include "base/progress.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
/* The address space and the speed of a sanitized program are not those of
 * murk. */
#define UNDER_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define UNDER_SANITIZER 1
#endif
#endif

/* Sanitizers slow a program down (ASan by 2, TSan by 5 to 15, according to
 * their manuals), so that the time limits grow by this factor under them. */
#ifdef UNDER_SANITIZER
#define SECONDS_FACTOR 15
#else
#define SECONDS_FACTOR 1
#endif

#define MEGABYTE UINT64_C(1000000) /* bytes */
#define MIN_MEMORY \
    (2000 * MEGABYTE) /* the parsing libraries alone take some of it */

/* The blocks in the pipe, in order: UNCONFINED or nothing, chunks, INPUTS if
 * murk-reader sends them, then the end with status and error of the parser. The
 * values are arbitrary marks that detect garbage in the pipe. */
typedef enum kind {
    CHUNK = 0x6d75726b,
    UNCONFINED = 0x66726565, /* the first block, if the kernel cannot confine
                              * the subprocess */
    INPUTS = 0x696e7075,     /* hashes of the files that murk-reader opened */
    END = 0x656e6421
} kind;

typedef struct inbox {
    unsigned char *bytes;
    size_t size, capacity;
} inbox;

struct murk_subprocess {
    int fd;
    inbox *in; /* NULL, unless the work is done in the calling process */
};

typedef enum verdict {
    RECEIVED = MURK_PIPE_RECEIVED,
    CUT_SHORT = MURK_PIPE_CUT_SHORT,
    TOO_LONG = MURK_PIPE_TOO_LONG,
    STOPPED = MURK_PIPE_STOPPED,
    TOO_MUCH,
    NO_MEMORY, /* of this process */
    GARBAGE    /* something else than messages of a reader */
} verdict;

static verdict reserve(inbox *in, uint64_t more, uint64_t max)
{
    if (more > max || in->size > max - more) {
        return TOO_MUCH;
    }
    const size_t need = in->size + (size_t)more;
    if (need <= in->capacity) {
        return RECEIVED;
    }
    const size_t capacity = need + need / 2 + 64;
    unsigned char *grown = realloc(in->bytes, capacity);
    if (!grown) {
        return NO_MEMORY;
    }
    in->bytes = grown;
    in->capacity = capacity;
    return RECEIVED;
}

/* Appends the bytes that work in the calling process sends. */
static murk_status put_into(inbox *in, const void *bytes, size_t size)
{
    if (reserve(in, size, UINT64_MAX) != RECEIVED) {
        return MURK_NO_MEMORY;
    }
    memcpy(in->bytes + in->size, bytes, size);
    in->size += size;
    return MURK_OK;
}

murk_status murk_subprocess_send(murk_subprocess *process, const void *bytes,
                                 size_t size)
{
    if (process->in) {
        return put_into(process->in, bytes, size);
    }
    return murk_pipe_send(process->fd, CHUNK, MURK_OK, bytes, size)
               ? MURK_OK
               : MURK_RUN_FAILED;
}

murk_subprocess_limits murk_subprocess_limits_for(uint64_t file_bytes)
{
    const uint64_t eightfold =
        file_bytes > UINT64_MAX / 8 ? UINT64_MAX : file_bytes * 8;
    const uint64_t memory = eightfold > MIN_MEMORY ? eightfold : MIN_MEMORY;
    return (murk_subprocess_limits){
        .memory_bytes = memory,
        .handed_bytes = memory,
        .seconds = SECONDS_FACTOR *
                   (8 + (unsigned)(file_bytes / (4 * MEGABYTE) % 100000))};
}

static void set_limit(int what, uint64_t value)
{
    const struct rlimit limit = {(rlim_t)value, (rlim_t)value};
    (void)setrlimit(what, &limit);
}

#ifndef UNDER_SANITIZER
/* Returns the current address space of the process: a subprocess starts with
 * all of the address space of its parent, which must not use up the memory that
 * is allowed for the file. 0 if it is unknown. */
static uint64_t address_space_now(void)
{
    unsigned long pages = 0;
    FILE *statm = fopen("/proc/self/statm", "r");
    if (statm) {
        if (fscanf(statm, "%lu", &pages) != 1) {
            pages = 0;
        }
        fclose(statm);
    }
    return (uint64_t)pages * (uint64_t)sysconf(_SC_PAGESIZE);
}
#endif

/* Sends the set of inputs of murk-reader. A fork sends nothing, because it
 * shares the set with the parent process. */
static bool send_inputs(int fd)
{
    uint64_t *hash = NULL;
    size_t n = 0;
    if (murk_host_now()->importing != MURK_IMPORT_STARTS) {
        return true;
    }
    murk_inputs_list(&hash, &n);
    const bool sent =
        murk_pipe_send(fd, INPUTS, MURK_OK, hash, n * sizeof *hash);
    free(hash);
    return sent;
}

/* Does the work, unless `prepared` tells of a failure before. */
static _Noreturn void run_and_exit(int fd, const murk_error *prepared,
                                   murk_subprocess_work work, void *context,
                                   const murk_subprocess_limits *limits)
{
    const int sink = open("/dev/null", O_WRONLY);
    if (sink >= 0) {
        dup2(sink, STDOUT_FILENO);
        dup2(sink, STDERR_FILENO);
    }
    (void)murk_c_locale_enter();
    signal(SIGINT, SIG_IGN); /* the parent handles the interrupt and kills this
                              * process */
    signal(SIGPIPE, SIG_DFL);
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, limits->seconds);
#ifndef UNDER_SANITIZER
    set_limit(RLIMIT_AS, address_space_now() + limits->memory_bytes);
#endif
    if (!murk_confine(fd) &&
        !murk_pipe_send(fd, UNCONFINED, MURK_OK, NULL, 0)) {
        _exit(1);
    }
    murk_subprocess process = {.fd = fd};
    murk_error err = *prepared;
    const murk_status status =
        err.code ? err.code : work(&process, context, &err);
    const bool sent =
        send_inputs(fd) && murk_pipe_send(fd, END, status, &err, sizeof err);
    _exit(sent ? 0 : 1); /* no atexit handlers: the file may have damaged their
                          * data */
}

/* Printed once in a run of the program, because the kernel is the same for all
 * files. */
static void say_unconfined(void)
{
    static atomic_flag is_said = ATOMIC_FLAG_INIT;
    if (!atomic_flag_test_and_set(&is_said)) {
        murk_note("", "this kernel has no seccomp filter: the readers of mesh "
                      "and OpenVDB files have limits on memory and time, but "
                      "are not kept from the network and other files");
    }
}

/* Ends place and text of an error that came from the subprocess, which no more
 * is used of, and replaces a code that does not exist. */
static void confine(murk_error *err)
{
    err->where[sizeof err->where - 1] = '\0';
    err->text[sizeof err->text - 1] = '\0';
    const long code = (long)err->code;
    if (code < MURK_OK || code > MURK_INTERRUPTED) {
        err->code = MURK_BAD_FILE;
    }
}

static verdict receive(int fd, inbox *in, const murk_subprocess_limits *limits,
                       murk_error *err)
{
    /* Read one block after the other until the end, an error or the
     * deadline. */
    const double deadline_s = murk_clock_s() + 2.0 * limits->seconds;
    for (;;) {
        murk_pipe_head h;
        verdict v = (verdict)murk_pipe_read(fd, &h, sizeof h, deadline_s);
        if (v != RECEIVED) {
            return v;
        }
        if (h.kind == END && h.size == sizeof *err) {
            v = (verdict)murk_pipe_read(fd, err, sizeof *err, deadline_s);
            confine(err);
            return v;
        }
        if (h.kind == UNCONFINED) {
            say_unconfined();
            continue;
        }
        if (h.kind != CHUNK && h.kind != INPUTS) {
            return GARBAGE;
        }
        v = reserve(in, h.size, limits->handed_bytes);
        if (v == RECEIVED) {
            v = (verdict)murk_pipe_read(fd, in->bytes + in->size,
                                        (size_t)h.size, deadline_s);
        }
        if (v != RECEIVED) {
            return v;
        }
        if (h.kind == CHUNK) {
            in->size += (size_t)h.size;
        } else {
            murk_inputs_add_listed(in->bytes + in->size,
                                   (size_t)h.size / sizeof(uint64_t));
        }
    }
}

/* The message for each way in which the subprocess can fail. Decisions of this
 * process come first, because a SIGKILL that it sent says nothing about the
 * parser. */
static murk_status explain(verdict v, int ended,
                           const murk_subprocess_limits *limits,
                           const char *where, murk_error *err)
{
    const double memory_gb = (double)limits->memory_bytes / 1e9;
    /* Decisions of this process. */
    if (v == STOPPED) {
        return murk_fail(err, MURK_INTERRUPTED, where, "interrupted");
    }
    if (v == NO_MEMORY) {
        return murk_no_memory(err, where, "for what its reader has read");
    }
    if (v == TOO_MUCH) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "holds more than %.3g GB, malformed or too large",
                         (double)limits->handed_bytes / 1e9);
    }
    if (v == GARBAGE) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "malformed: its reader sent no result");
    }
    if (v == TOO_LONG || (WIFSIGNALED(ended) && (WTERMSIG(ended) == SIGXCPU ||
                                                 WTERMSIG(ended) == SIGKILL))) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "reading it takes more than %u s or %.3g GB: "
                         "malformed, or too large",
                         limits->seconds, memory_gb);
    }
    /* Crashes and refusals in the subprocess. */
    if (WIFSIGNALED(ended)) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "malformed: its reader crashed (%s)",
                         strsignal(WTERMSIG(ended)));
    }
    return murk_fail(err, MURK_BAD_FILE, where,
                     "malformed: its reader gave up (more than %.3g GB?)",
                     memory_gb);
}

/* Kills the subprocess unless it has ended; then its number may be that of
 * another process already, if the host waits for all its subprocesses. */
static void end(pid_t pid)
{
    siginfo_t ended = {.si_pid = 0};
    if (waitid(P_PID, (id_t)pid, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == 0) {
        kill(pid, SIGKILL);
    }
}

/* Receives, then ends the subprocess, which has nothing left to do; one that is
 * about to end, by a crash or by itself, keeps its exit status. Reports a
 * failure of the subprocess, or the error of the parser. */
static murk_status take_result(int fd, pid_t pid, unsigned char **out,
                               size_t *size,
                               const murk_subprocess_limits *limits,
                               const char *where, murk_error *err)
{
    inbox in = {0};
    murk_error reported = {0};
    const verdict v = receive(fd, &in, limits, &reported);
    close(fd);
    end(pid);
    const int ended = murk_pipe_wait(pid);
    /* A failure of the subprocess, or the error of the parser. */
    if (v != RECEIVED) {
        free(in.bytes);
        return explain(v, ended, limits, where, err);
    }
    if (reported.code) {
        free(in.bytes);
        return murk_fail(err, reported.code, reported.where, "%s",
                         reported.text);
    }
    *out = in.bytes;
    *size = in.size;
    return MURK_OK;
}

murk_status murk_subprocess_run(unsigned char **out, size_t *size,
                                murk_subprocess_work work, void *context,
                                const murk_subprocess_limits *limits,
                                const char *where, murk_error *err)
{
    int ends[2];
    const murk_status opened = murk_pipe_open(ends, where, err);
    if (opened) {
        return opened;
    }
    /* No other thread may run during fork(): stop the progress display. */
    murk_progress_pause();
    const pid_t pid = fork();
    if (pid != 0) {
        murk_progress_resume();
    }
    if (pid < 0) {
        close(ends[0]);
        close(ends[1]);
        return murk_fail(err, MURK_RUN_FAILED, where,
                         "cannot start a reader: %s", strerror(errno));
    }
    /* Subprocess: parse and exit. */
    if (pid == 0) {
        const murk_error none = {0};
        close(ends[0]);
        run_and_exit(ends[1], &none, work, context, limits);
    }
    close(ends[1]);
    return take_result(ends[0], pid, out, size, limits, where, err);
}

/* ---- work in the process that the host chooses ---- */

static murk_status start(unsigned char **out, size_t *size,
                         const murk_subprocess_job *job, const void *context,
                         const murk_subprocess_limits *limits,
                         const char *where, murk_error *err)
{
    murk_parcel request = {0};
    pid_t pid = 0;
    int fd = -1;
    /* The request: name of the job, limits, and the packed context. */
    murk_parcel_put_text(&request, job->name);
    murk_parcel_put(&request, limits, sizeof *limits);
    job->pack(&request, context);
    const char *program = job->program ? job->program : MURK_PROGRAM_READER;
    const murk_status status =
        request.is_short
            ? murk_no_memory(err, where, "for its reader")
            : murk_program_start(&pid, &fd, program, &request, where, err);
    murk_parcel_release(&request);
    return status ? status
                  : take_result(fd, pid, out, size, limits, where, err);
}

/* Does the work in the calling process, without limits and confinement. */
static murk_status do_here(unsigned char **out, size_t *size,
                           const murk_subprocess_job *job, void *context,
                           murk_error *err)
{
    inbox in = {0};
    murk_subprocess process = {.fd = -1, .in = &in};
    void *const locale = murk_c_locale_enter();
    const murk_status status = job->work(&process, context, err);
    murk_c_locale_leave(locale);
    if (status) {
        free(in.bytes);
        return status;
    }
    *out = in.bytes;
    *size = in.size;
    return MURK_OK;
}

murk_status murk_subprocess_do(unsigned char **out, size_t *size,
                               const murk_subprocess_job *job, void *context,
                               const murk_subprocess_limits *limits,
                               const char *where, murk_error *err)
{
    char path[PATH_MAX];
    if (job->program) {
        return murk_program_find(path, job->program, where, NULL)
                   ? murk_fail(err, MURK_UNSUPPORTED, where, "%s", job->needs)
                   : start(out, size, job, context, limits, where, err);
    }
    if (murk_host_now()->importing == MURK_IMPORT_STARTS) {
        return start(out, size, job, context, limits, where, err);
    }
    const murk_status prepared =
        job->prepare ? job->prepare(where, err) : MURK_OK;
    if (prepared) {
        return prepared;
    }
    return murk_host_now()->importing == MURK_IMPORT_IN_PROCESS
               ? do_here(out, size, job, context, err)
               : murk_subprocess_run(out, size, job->work, context, limits,
                                     where, err);
}

/* ---- murk-reader ---- */

/* A job and the parcel that has the context. */
typedef struct packed_job {
    const murk_subprocess_job *job;
    murk_parcel *from;
} packed_job;

/* A murk_subprocess_work. */
static murk_status work_packed(murk_subprocess *process, void *context,
                               murk_error *err)
{
    const packed_job *packed = context;
    return packed->job->work_packed(process, packed->from, err);
}

_Noreturn void murk_subprocess_serve(murk_parcel *request, int fd,
                                     const murk_subprocess_job *const jobs[],
                                     size_t n)
{
    packed_job packed = {.from = request};
    const char *name = murk_parcel_take_text(request);
    const murk_subprocess_limits *limits =
        murk_parcel_take(request, sizeof *limits);
    for (size_t i = 0; name && i < n; ++i) {
        if (strcmp(jobs[i]->name, name) == 0) {
            packed.job = jobs[i];
        }
    }
    if (!packed.job || !limits) {
        _exit(1);
    }
    murk_error prepared = {0};
    if (packed.job->prepare) {
        packed.job->prepare("", &prepared);
    }
    murk_host_now()->importing = MURK_IMPORT_STARTS;
    murk_inputs_begin();
    run_and_exit(fd, &prepared, work_packed, &packed, limits);
}
