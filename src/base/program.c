/* Finds the files beside the library, starts programs and loads modules. A
 * process with threads may only
 * call exec after a fork; posix_spawn() of the C library does both without
 * copying the process. The request is a file in memory, so nothing waits for
 * the program and no signal comes when the program ends early. */
#include "base/program.h"

#include "base/host.h"
#include "base/pipe.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

extern char **environ;

/* The smallest descriptor, in this process, of the files of the request and of
 * the answer: above the numbers that they get in the program, so that dup2()
 * overwrites neither. */
#define MIN_FD (MURK_PROGRAM_ANSWER + 1)

/* The folders of programs and modules, seen from the folder of the library:
 * beside it; from the folder of programs of an installation; and the folder
 * itself, for a program that lies there. */
static const char *const places[] = {
    MURK_PROGRAMS_FOLDER, MURK_FROM_PROGRAMS "/" MURK_PROGRAMS_FOLDER, "."};

/* The path of a program or a module in path[PATH_MAX], to which access() grants
 * `mode`. False if there is none; path is then the first place where it could
 * be. */
static bool find(char path[PATH_MAX], const char *name, int mode)
{
    const char *reader = murk_host_now()->reader;
    Dl_info library;
    char file[PATH_MAX], first[PATH_MAX] = "";
    if (reader) {
        const char *end = strrchr(reader, '/');
        const int folder = end ? (int)(end + 1 - reader) : 0;
        if (strcmp(name, MURK_PROGRAM_READER) == 0) {
            snprintf(path, PATH_MAX, "%s", reader);
        } else {
            snprintf(path, PATH_MAX, "%.*s%s", folder, reader, name);
        }
        return access(path, mode) == 0;
    }
    /* The file that this code is in: the library, or a program. */
    snprintf(path, PATH_MAX, "%s", name);
    if (!dladdr((const void *)places, &library) ||
        (!realpath(library.dli_fname, file) &&
         !realpath("/proc/self/exe", file))) { /* a program found by $PATH */
        return false;
    }
    *strrchr(file, '/') = '\0';
    for (size_t i = 0; i < sizeof places / sizeof *places; ++i) {
        if (snprintf(path, PATH_MAX, "%s/%s/%s", file, places[i], name) <
                PATH_MAX &&
            access(path, mode) == 0) {
            return true;
        }
        if (i == 0) {
            memcpy(first, path, sizeof first);
        }
    }
    memcpy(path, first, sizeof first);
    return false;
}

murk_status murk_program_find(char path[PATH_MAX], const char *name,
                              const char *where, murk_error *err)
{
    return find(path, name, X_OK)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, where,
                           "the program %s is not there; must lie beside the "
                           "library, or in the folder of options->reader",
                           path);
}

const void *murk_module_load(murk_module *module, const char *where,
                             murk_error *err)
{
    char path[PATH_MAX];
    const void *object = atomic_load(&module->loaded);
    if (object) {
        return object;
    }
    if (!find(path, module->file, R_OK)) {
        murk_fail(err, MURK_RUN_FAILED, where,
                  "the module %s is not there; must lie beside the library, or "
                  "in the folder of options->reader",
                  path);
        return NULL;
    }
    /* Threads that load at the same time find the same object. */
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    object = library ? dlsym(library, module->symbol) : NULL;
    if (!object) {
        const char *reason = dlerror();
        murk_fail(err, MURK_RUN_FAILED, where, "cannot load a module: %s",
                  reason ? reason : path);
    }
    atomic_store(&module->loaded, object);
    return object;
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
static int spawn(pid_t *pid, const char *path, const char *name, int request,
                 int answer)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t none;
    char called[NAME_MAX + 1];
    char *const arguments[] = {called, NULL};
    int failure = posix_spawn_file_actions_init(&files);
    if (failure) {
        return failure;
    }
    failure = posix_spawnattr_init(&attributes);
    if (failure) {
        posix_spawn_file_actions_destroy(&files);
        return failure;
    }
    snprintf(called, sizeof called, "%s", name);
    /* Signals that the host has blocked are not blocked in the program. */
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
                                                         MURK_PROGRAM_ANSWER);
    failure = failure ? failure
                      : posix_spawn_file_actions_addclosefrom_np(
                            &files, MURK_PROGRAM_ANSWER + 1);
    failure = failure ? failure
                      : posix_spawn(pid, path, &files, &attributes, arguments,
                                    environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return failure;
}

murk_status murk_program_start(pid_t *pid, int *fd, const char *name,
                               const murk_parcel *request, const char *where,
                               murk_error *err)
{
    char path[PATH_MAX];
    int ends[2];
    const murk_status found = murk_program_find(path, name, where, err);
    if (found) {
        return found;
    }
    const murk_status opened = murk_pipe_open(ends, where, err);
    if (opened) {
        return opened;
    }
    /* The ends that the program gets are closed here in any case. */
    const int answer = fcntl(ends[1], F_DUPFD_CLOEXEC, MIN_FD),
              file = file_of(request);
    const int failure =
        answer < 0 || file < 0 ? errno : spawn(pid, path, name, file, answer);
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
                         "cannot start the program %s: %s", path,
                         strerror(failure));
    }
    *fd = ends[0];
    return MURK_OK;
}

bool murk_program_request(murk_parcel *request, const char *name)
{
    struct stat file;
    void *bytes = MAP_FAILED;
    if (fstat(STDIN_FILENO, &file) == 0 && S_ISREG(file.st_mode) &&
        file.st_size > 0) {
        bytes = mmap(NULL, (size_t)file.st_size, PROT_READ, MAP_PRIVATE,
                     STDIN_FILENO, 0);
    }
    if (bytes == MAP_FAILED) {
        fprintf(stderr, "%s: is started by the library murk\n", name);
        return false;
    }
    *request = (murk_parcel){.bytes = bytes, .size = (size_t)file.st_size};
    return true;
}
