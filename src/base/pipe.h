/* Transfers blocks of bytes through a pipe between two processes. */
#ifndef MURK_BASE_PIPE_H
#define MURK_BASE_PIPE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

/* Opens a pipe: ends[0] to read, ends[1] to write. A program that another
 * thread starts does not inherit the ends. Fails with MURK_RUN_FAILED. */
murk_status murk_pipe_open(int ends[2], const char *where, murk_error *err);

/* Writes all bytes. Returns false if a write fails, for example because the
 * reading end is closed and SIGPIPE is ignored. */
bool murk_pipe_write(int fd, const void *bytes, size_t size);

/* A message is a header and `size` bytes. */
typedef struct murk_pipe_head {
    uint32_t kind, status; /* kind: a mark of the protocol; murk_status */
    uint64_t size;
} murk_pipe_head;

/* Writes a message. Returns false as murk_pipe_write() does. */
bool murk_pipe_send(int fd, uint32_t kind, murk_status status,
                    const void *bytes, size_t size);

/* The result of reading. */
typedef enum murk_pipe_verdict {
    MURK_PIPE_RECEIVED,
    MURK_PIPE_CUT_SHORT, /* the pipe ended, because the writing process did, or
                          * could not be read */
    MURK_PIPE_TOO_LONG,  /* the deadline has passed */
    MURK_PIPE_STOPPED    /* murk_interrupted() of base/interrupt.h became true
                          */
} murk_pipe_verdict;

/* Reads exactly `size` bytes, or returns the reason why that was impossible.
 * The deadline is a time of murk_clock_s(); INFINITY means none. */
murk_pipe_verdict murk_pipe_read(int fd, void *bytes, size_t size,
                                 double deadline_s);

/* Waits for the end of a subprocess. Returns the status that waitpid() stores,
 * or 0 if there is no such subprocess. */
int murk_pipe_wait(pid_t process);

#endif
