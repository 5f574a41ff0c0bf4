/* Finds and starts murk-reader. A process with threads may only call exec after
 * a fork; posix_spawn() of the C library does both without copying the process.
 * The request is a file in memory, so nothing waits for the reader and no
 * signal comes when the reader ends early. */
#include "base/reader.h"

#include "base/host.h"
#include "base/pipe.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

extern char **environ;

/* The smallest descriptor, in this process, of the files of the request and of
 * the answer: above the numbers that they get in murk-reader, so that dup2()
 * overwrites neither. */
#define MIN_FD (MURK_READER_ANSWER + 1)

/* The possible paths of murk-reader, relative to the folder of the file that
 * contains this code: of the library, or of a program that lies beside the
 * library; and of a program in the folder of programs of an installation. */
static const char *const places[] = {MURK_READER_FOLDER "/murk-reader",
                                     MURK_FROM_PROGRAMS "/" MURK_READER_FOLDER
                                                        "/murk-reader"};

/* The path of the program in path[PATH_MAX]. False if there is none; path is
 * then the first place where it could be. */
static bool find(char path[PATH_MAX])
{
    const char *given = murk_host_now()->reader;
    Dl_info library;
    char file[PATH_MAX], first[PATH_MAX] = "";
    if (given) {
        snprintf(path, PATH_MAX, "%s", given);
        return access(path, X_OK) == 0;
    }
    /* The file that this code is in: the library, or a program. */
    path[0] = '\0';
    if (!dladdr((const void *)places, &library) ||
        (!realpath(library.dli_fname, file) &&
         !realpath("/proc/self/exe", file))) { /* a program found by $PATH */
        return false;
    }
    *strrchr(file, '/') = '\0';
    for (size_t i = 0; i < sizeof places / sizeof *places; ++i) {
        if (snprintf(path, PATH_MAX, "%s/%s", file, places[i]) < PATH_MAX &&
            access(path, X_OK) == 0) {
            return true;
        }
        if (i == 0) {
            memcpy(first, path, sizeof first);
        }
    }
    memcpy(path, first, sizeof first);
    return false;
}

/* A file in memory with the request; -1 on failure. */
static int file_of(const murk_parcel *request)
{
    const int made = memfd_create("murk-request", MFD_CLOEXEC);
    const int fd = made < 0 ? -1 : fcntl(made, F_DUPFD_CLOEXEC, MIN_FD);
    if (made >= 0) {
        close(made);
    }
    if (fd >= 0 && !murk_pipe_write(fd, request->bytes, request->size)) {
        close(fd);
        return -1;
    }
    return fd;
}

/* Starts the program with the two files. Returns 0 or an error number. */
static int spawn(pid_t *pid, const char *path, int request, int answer)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t none;
    char *const arguments[] = {"murk-reader", NULL};
    int failure = posix_spawn_file_actions_init(&files);
    if (failure) {
        return failure;
    }
    failure = posix_spawnattr_init(&attributes);
    if (failure) {
        posix_spawn_file_actions_destroy(&files);
        return failure;
    }
    /* Signals that the host has blocked are not blocked in the reader. */
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    failure = posix_spawn_file_actions_adddup2(&files, request, STDIN_FILENO);
    failure = failure ? failure
                      : posix_spawn_file_actions_addopen(
                            &files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    failure = failure ? failure
                      : posix_spawn_file_actions_addopen(
                            &files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    failure = failure ? failure
                      : posix_spawn_file_actions_adddup2(&files, answer,
                                                         MURK_READER_ANSWER);
    failure = failure ? failure
                      : posix_spawn(pid, path, &files, &attributes, arguments,
                                    environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return failure;
}

murk_status murk_reader_start(pid_t *pid, int *fd, const murk_parcel *request,
                              const char *where, murk_error *err)
{
    char path[PATH_MAX];
    int ends[2];
    if (!find(path)) {
        return murk_fail(err, MURK_RUN_FAILED, where,
                         "the program that reads it is not at %s; must lie "
                         "beside the library, or be named in the options of "
                         "the context",
                         path);
    }
    const murk_status opened = murk_pipe_open(ends, where, err);
    if (opened) {
        return opened;
    }
    /* The ends that the reader gets are closed here in any case. */
    const int answer = fcntl(ends[1], F_DUPFD_CLOEXEC, MIN_FD),
              file = file_of(request);
    const int failure =
        answer < 0 || file < 0 ? errno : spawn(pid, path, file, answer);
    close(ends[1]);
    if (answer >= 0) {
        close(answer);
    }
    if (file >= 0) {
        close(file);
    }
    if (failure) {
        close(ends[0]);
        return murk_fail(err, MURK_RUN_FAILED, where,
                         "cannot start %s, which reads it: %s", path,
                         strerror(failure));
    }
    *fd = ends[0];
    return MURK_OK;
}
