/* Forks, limits and confines the subprocess, and reads chunks of bytes from a
 * pipe until the subprocess reports its end. The parent process trusts nothing
 * that comes through the pipe: it checks kinds and sizes, and gives up at a
 * deadline. */
#include "base/subprocess.h"

#include "base/c_locale.h"
#include "base/confine.h"
#include "base/log.h"
#include "base/pipe.h"
#include "base/progress.h"

#include <errno.h>
#include <fcntl.h>
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

/* The blocks in the pipe, in order: UNCONFINED or nothing, chunks, then the end
 * with status and error of the parser. The values are arbitrary marks that
 * detect garbage in the pipe. */
typedef enum kind {
    CHUNK = 0x6d75726b,
    UNCONFINED = 0x66726565, /* the first block, if the kernel cannot confine
                              * the subprocess */
    END = 0x656e6421
} kind;

struct murk_subprocess {
    int fd;
};

murk_status murk_subprocess_send(murk_subprocess *process, const void *bytes,
                                 size_t size)
{
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

static _Noreturn void run_and_exit(int fd, murk_subprocess_work work,
                                   void *context,
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
    murk_subprocess process = {fd};
    murk_error err = {0};
    const murk_status status = work(&process, context, &err);
    const bool sent = murk_pipe_send(fd, END, status, &err, sizeof err);
    _exit(sent ? 0 : 1); /* no atexit handlers: the file may have damaged their
                          * data */
}

typedef struct inbox {
    unsigned char *bytes;
    size_t size, capacity;
} inbox;

typedef enum verdict {
    RECEIVED = MURK_PIPE_RECEIVED,
    CUT_SHORT = MURK_PIPE_CUT_SHORT,
    TOO_LONG = MURK_PIPE_TOO_LONG,
    STOPPED = MURK_PIPE_STOPPED,
    TOO_MUCH
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
        return TOO_MUCH;
    }
    in->bytes = grown;
    in->capacity = capacity;
    return RECEIVED;
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
            return (verdict)murk_pipe_read(fd, err, sizeof *err, deadline_s);
        }
        if (h.kind == UNCONFINED) {
            say_unconfined();
            continue;
        }
        if (h.kind != CHUNK) {
            return CUT_SHORT;
        }
        v = reserve(in, h.size, limits->handed_bytes);
        if (v == RECEIVED) {
            v = (verdict)murk_pipe_read(fd, in->bytes + in->size,
                                        (size_t)h.size, deadline_s);
        }
        if (v != RECEIVED) {
            return v;
        }
        in->size += (size_t)h.size;
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
    if (v == TOO_MUCH) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "holds more than %.3g GB, malformed or too large",
                         (double)limits->handed_bytes / 1e9);
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

murk_status murk_subprocess_run(unsigned char **out, size_t *size,
                                murk_subprocess_work work, void *context,
                                const murk_subprocess_limits *limits,
                                const char *where, murk_error *err)
{
    int ends[2];
    if (pipe(ends) != 0) {
        return murk_fail(err, MURK_RUN_FAILED, where, "cannot open a pipe: %s",
                         strerror(errno));
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
        close(ends[0]);
        run_and_exit(ends[1], work, context, limits);
    }
    close(ends[1]);

    /* Parent: receive, then kill the subprocess unless it has sent its end or
     * closed the pipe. */
    inbox in = {0};
    murk_error reported = {0};
    const verdict v = receive(ends[0], &in, limits, &reported);
    close(ends[0]);
    if (v != RECEIVED && v != CUT_SHORT) {
        kill(pid, SIGKILL);
    }
    const int ended = murk_pipe_wait(pid);
    /* Report a failure of the subprocess, or the error of the parser. */
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
