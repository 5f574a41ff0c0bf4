/* Blocking reads and writes of whole blocks of bytes on a pipe. Reading polls,
 * so that an interrupt of the user and a deadline are noticed while the other
 * process is silent. */
#include "base/pipe.h"

#include "base/interrupt.h"
#include "base/progress.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

murk_status murk_pipe_open(int ends[2], const char *where, murk_error *err)
{
    return pipe2(ends, O_CLOEXEC) == 0
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, where,
                           "cannot open a pipe: %s", strerror(errno));
}

bool murk_pipe_write(int fd, const void *bytes, size_t size)
{
    const char *at = bytes;
    while (size > 0) {
        const ssize_t n = write(fd, at, size);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return false;
        }
        at += n;
        size -= (size_t)n;
    }
    return true;
}

bool murk_pipe_send(int fd, uint32_t kind, murk_status status,
                    const void *bytes, size_t size)
{
    const murk_pipe_head head = {kind, (uint32_t)status, size};
    return murk_pipe_write(fd, &head, sizeof head) &&
           murk_pipe_write(fd, bytes, size);
}

murk_pipe_verdict murk_pipe_read(int fd, void *bytes, size_t size,
                                 double deadline_s)
{
    char *at = bytes;
    while (size > 0) {
        /* Wait for bytes for 0.1 s at most, then look for an interrupt or the
         * deadline. */
        struct pollfd ready = {.fd = fd, .events = POLLIN};
        const int n_ready = poll(&ready, 1, 100);
        if (murk_interrupted()) {
            return MURK_PIPE_STOPPED;
        }
        if (murk_clock_s() > deadline_s) {
            return MURK_PIPE_TOO_LONG;
        }
        if (n_ready <= 0) {
            continue;
        }
        /* A read may return fewer bytes than asked for, and 0 at the end of the
         * pipe. */
        const ssize_t n = read(fd, at, size);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return MURK_PIPE_CUT_SHORT;
        }
        at += n;
        size -= (size_t)n;
    }
    return MURK_PIPE_RECEIVED;
}

int murk_pipe_wait(pid_t process)
{
    int ended = 0;
    while (waitpid(process, &ended, 0) < 0 && errno == EINTR) {
    }
    return ended;
}
