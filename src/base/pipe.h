/* Bytes through a pipe between two processes, whole or not at all. */
#ifndef MURK_BASE_PIPE_H
#define MURK_BASE_PIPE_H

#include <stdbool.h>
#include <stddef.h>

/* False when nobody reads any more. */
bool murk_pipe_write(int fd, const void *bytes, size_t size);

typedef enum murk_pipe_verdict {
    MURK_PIPE_RECEIVED,
    MURK_PIPE_CUT_SHORT, /* the writer is gone */
    MURK_PIPE_TOO_LONG,  /* the deadline has passed */
    MURK_PIPE_STOPPED    /* murk_interrupted() */
} murk_pipe_verdict;

/* Exactly `size` bytes, or why not. The deadline is of murk_clock_s(). */
murk_pipe_verdict murk_pipe_read(int fd, void *bytes, size_t size,
                                 double deadline_s);

#endif
