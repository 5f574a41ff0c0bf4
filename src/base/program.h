/* The files beside the library: programs that work for hosts with threads, and
 * modules, which are parts of the library that few runs need.
 *
 * The programs are murk-reader, which reads untrusted files
 * (base/subprocess.h), and murk-rows, which runs rows of studies
 * (base/isolated.h). The modules bring large libraries with them, which would
 * take most of the time that every other run needs to start.
 *
 * All lie in the folder libmurk0 beside the library, or beside the program that
 * contains the library's code; that program may lie in libmurk0 itself. If the
 * host names murk-reader, all lie in the folder of that file. */
#ifndef MURK_BASE_PROGRAM_H
#define MURK_BASE_PROGRAM_H

#include "base/parcel.h"
#include "base/status.h"

#include <limits.h>
#include <sys/types.h>

#define MURK_PROGRAM_READER "murk-reader"
#define MURK_PROGRAM_ROWS   "murk-rows"

/* The files of a program: the request on standard input, and the pipe of the
 * answer. Everything else is closed. */
#define MURK_PROGRAM_ANSWER 3

/* Finds the path of a program, named as above. Fails with MURK_RUN_FAILED at
 * `where` if there is no such program. */
murk_status murk_program_find(char path[PATH_MAX], const char *name,
                              const char *where, murk_error *err);

/* A module: its file, the object in it that murk uses, and the address of that
 * object, NULL until the module is loaded. */
typedef struct murk_module {
    const char *file, *symbol;
    const void *_Atomic loaded;
} murk_module;

/* Loads a module, which stays loaded, unless that has been done. Any thread may
 * call it. Returns `loaded`, or NULL with MURK_RUN_FAILED in *err at `where` if
 * the file is not there or lacks a library. */
const void *murk_module_load(murk_module *module, const char *where,
                             murk_error *err);

/* Starts a program by posix_spawn(). *fd: the reading end of the answer, and
 * *pid: the process, both the caller's. Fails with MURK_RUN_FAILED at
 * `where`. */
murk_status murk_program_start(pid_t *pid, int *fd, const char *name,
                               const murk_parcel *request, const char *where,
                               murk_error *err);

/* The other side, in the program: the request, which stays mapped. If standard
 * input is no request, says on standard error that the program `name` is
 * started by the library, and returns false. */
bool murk_program_request(murk_parcel *request, const char *name);

#endif
