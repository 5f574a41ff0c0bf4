/* The sandbox of subprocesses that read untrusted files: libseccomp installs a
 * list of the system calls that a parser makes. Every other call fails with
 * ENOSYS, so that the C library falls back to an older call if there is one.
 *
 * The list names the allowed calls, not the forbidden ones, so that calls of
 * future kernels are refused. A parser that cannot do without a refused call
 * fails, and the parent process reports a malformed file. */
#include "base/confine.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <stddef.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

/* Calls that are allowed with any arguments. Names that are unknown to the
 * processor or to the version of libseccomp are skipped. */
static const char *const ALLOWED[] = {
    /* open files */
    "read", "readv", "pread64", "preadv", "preadv2", "write", "writev", "close",
    "lseek", "_llseek", "fstat", "fstat64", "fadvise64", "poll", "ppoll", "dup",
    /* properties and listings of files */
    "stat", "stat64", "lstat", "lstat64", "newfstatat", "fstatat64", "statx",
    "access", "faccessat", "faccessat2", "readlink", "readlinkat", "getcwd",
    "getdents", "getdents64",
    /* memory */
    "mmap", "mmap2", "munmap", "mremap", "mprotect", "madvise", "brk",
    "mincore",
    /* pipes within the process: the undefined-behaviour sanitizer uses them to
     * find out whether memory may be read */
    "pipe", "pipe2",
    /* threads, signals, exit */
    "futex", "futex_time64", "set_robust_list", "get_robust_list", "rseq",
    "sched_yield", "sched_getaffinity", "set_tid_address", "membarrier",
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigreturn",
    "sigaltstack", "exit", "exit_group", "restart_syscall",
    /* the clock and the machine */
    "clock_gettime", "clock_gettime64", "clock_getres", "clock_nanosleep",
    "clock_nanosleep_time64", "nanosleep", "gettimeofday", "time", "times",
    "getrandom", "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid",
    "getegid", "getrlimit", "ugetrlimit", "getrusage", "uname", "sysinfo",
    "arch_prctl", NULL};

static int allow(scmp_filter_ctx filter, const char *name)
{
    const int call = seccomp_syscall_resolve_name(name);
    return call == __NR_SCMP_ERROR
               ? 0
               : seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0);
}

/* Allows the call if argument number `at` under the mask has the given
 * value. */
static int allow_if(scmp_filter_ctx filter, const char *name, unsigned at,
                    scmp_datum_t mask, scmp_datum_t value)
{
    const struct scmp_arg_cmp is = {at, SCMP_CMP_MASKED_EQ, mask, value};
    const int call = seccomp_syscall_resolve_name(name);
    return call == __NR_SCMP_ERROR
               ? 0
               : seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 1, &is);
}

/* Allows calls whose effect depends on an argument, for harmless values of that
 * argument only. Returns 0 or a negative error number. */
static int allow_some(scmp_filter_ctx filter)
{
    /* O_TMPFILE contains the bit of O_DIRECTORY, which readers may use. */
    const scmp_datum_t writes = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND |
                                (scmp_datum_t)(O_TMPFILE & ~O_DIRECTORY);
    const scmp_datum_t all = ~(scmp_datum_t)0;
    const struct {
        const char *name;
        unsigned at;
        scmp_datum_t mask, value;
    } some[] = {
        {"open", 1, writes, O_RDONLY},
        {"openat", 2, writes, O_RDONLY},
        {"clone", 0, CLONE_THREAD, CLONE_THREAD},   /* threads only */
        {"tgkill", 0, all, (scmp_datum_t)getpid()}, /* abort() */
        {"prctl", 0, all, PR_SET_NAME},
        {"ioctl", 1, all, TCGETS}, /* is it a terminal? */
        {"fcntl", 1, all, F_GETFL},
        {"fcntl", 1, all, F_GETFD},
        {"fcntl", 1, all, F_SETFD},
        {"prlimit64", 2, all, 0}, /* queries only */
    };
    int failure = 0;
    for (size_t i = 0; i < sizeof some / sizeof *some && !failure; ++i) {
        failure = allow_if(filter, some[i].name, some[i].at, some[i].mask,
                           some[i].value);
    }
    return failure;
}

bool murk_confine(int fd)
{
    const struct rlimit none = {0, 0};
    (void)setrlimit(RLIMIT_FSIZE, &none);
    /* Close the other files that the parent process had open at the fork,
     * because the parser does not need them. */
    if (fd > STDERR_FILENO + 1) {
        (void)close_range(STDERR_FILENO + 1, (unsigned)fd - 1, 0);
    }
    (void)close_range((unsigned)fd + 1, ~0U, 0);

    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(ENOSYS));
    if (!filter) {
        return false;
    }
    int failure = allow_some(filter);
    for (const char *const *name = ALLOWED; *name && !failure; ++name) {
        failure = allow(filter, *name);
    }
    failure = failure ? failure : seccomp_load(filter);
    seccomp_release(filter);
    return !failure;
}
