/* The sandbox of child processes that read files of others: a list of the
 * system calls that a parser makes, by libseccomp; whatever else is called
 * fails with ENOSYS, so that the C library takes an older call where there is
 * one.
 *
 * A list of what is allowed, not of what is forbidden: what a kernel learns
 * tomorrow is refused. The process ends by its own error then, which the parent
 * reports as a malformed file. */
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

/* Calls allowed whatever their arguments. Names that a processor or a release
 * of libseccomp does not know are passed over. */
static const char *const ALLOWED[] = {
    /* files that are open */
    "read", "readv", "pread64", "preadv", "preadv2", "write", "writev", "close",
    "lseek", "_llseek", "fstat", "fstat64", "fadvise64", "poll", "ppoll", "dup",
    /* what files there are */
    "stat", "stat64", "lstat", "lstat64", "newfstatat", "fstatat64", "statx",
    "access", "faccessat", "faccessat2", "readlink", "readlinkat", "getcwd",
    "getdents", "getdents64",
    /* memory */
    "mmap", "mmap2", "munmap", "mremap", "mprotect", "madvise", "brk",
    "mincore",
    /* pipes within the process, by which the undefined-behaviour sanitizer
     * finds out whether memory may be read */
    "pipe", "pipe2",
    /* threads, signals, the end */
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

/* The call when argument `at` under the mask has that value. */
static int allow_if(scmp_filter_ctx filter, const char *name, unsigned at,
                    scmp_datum_t mask, scmp_datum_t value)
{
    const struct scmp_arg_cmp is = {at, SCMP_CMP_MASKED_EQ, mask, value};
    const int call = seccomp_syscall_resolve_name(name);
    return call == __NR_SCMP_ERROR
               ? 0
               : seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 1, &is);
}

/* Calls that depend on an argument; 0 or a negative error number. */
static int allow_some(scmp_filter_ctx filter)
{
    /* O_TMPFILE has the bit of O_DIRECTORY, which reading may have */
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
        {"clone", 0, CLONE_THREAD, CLONE_THREAD},   /* threads, no processes */
        {"tgkill", 0, all, (scmp_datum_t)getpid()}, /* abort() */
        {"prctl", 0, all, PR_SET_NAME},
        {"ioctl", 1, all, TCGETS}, /* is it a terminal? */
        {"fcntl", 1, all, F_GETFL},
        {"fcntl", 1, all, F_GETFD},
        {"fcntl", 1, all, F_SETFD},
        {"prlimit64", 2, all, 0}, /* asks; sets nothing */
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
    /* What the parent has open is none of the parser's business. */
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
