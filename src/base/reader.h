/* Starts murk-reader, the program that reads untrusted files for hosts with
 * threads. It lies in the folder libmurk0 beside the library, or beside the
 * program that contains the library's code, or where the host says. */
#ifndef MURK_BASE_READER_H
#define MURK_BASE_READER_H

#include "base/parcel.h"
#include "base/status.h"

#include <sys/types.h>

/* The descriptor of the pipe of the answer in murk-reader. The request is on
 * standard input; standard output and standard error are discarded. */
#define MURK_READER_ANSWER 3

/* Starts murk-reader by posix_spawn(). *fd: the reading end of the answer, and
 * *pid: the process, both the caller's. Fails with MURK_RUN_FAILED at
 * `where`. */
murk_status murk_reader_start(pid_t *pid, int *fd, const murk_parcel *request,
                              const char *where, murk_error *err);

#endif
