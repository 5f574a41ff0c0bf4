/* Untrusted files are parsed in a child process with limits on memory and
 * processor time, confined to reading (base/confine.h; where the kernel cannot,
 * a note says so once), and handed over as plain bytes: whatever a broken file
 * does to the parser, the parent sees bytes or a clear error.
 *
 * Call it before any thread or ray device exists (fork). */
#ifndef MURK_BASE_SUBPROCESS_H
#define MURK_BASE_SUBPROCESS_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

/* Runs in the child: parse, then hand bytes over with murk_subprocess_send(). A
 * failure's err reaches the parent's err as it is. */
typedef struct murk_subprocess murk_subprocess;
typedef murk_status (*murk_subprocess_work)(murk_subprocess *child,
                                            void *context, murk_error *err);
murk_status murk_subprocess_send(murk_subprocess *child, const void *bytes,
                                 size_t size);

typedef struct murk_subprocess_limits {
    uint64_t memory_bytes; /* address space, beside what the parent has;
                              ignored under sanitizers */
    uint64_t handed_bytes; /* most that the child may send */
    unsigned seconds;      /* processor time; wall time is twice that */
} murk_subprocess_limits;

/* The default for a file of that size: the larger of 2 GB and 8 times the
 * file, 8 s of processor time and 1 s more for every 4 MB. */
murk_subprocess_limits murk_subprocess_limits_for(uint64_t file_bytes);

/* *out (malloc'ed, the caller's; 16-byte aligned) and *size hold all that the
 * child sent. Fails with the child's own error, or with MURK_BAD_FILE at
 * `where` when the child died or ran into a limit. What the child prints is
 * thrown away: warnings travel as data. */
murk_status murk_subprocess_run(unsigned char **out, size_t *size,
                                murk_subprocess_work work, void *context,
                                const murk_subprocess_limits *limits,
                                const char *where, murk_error *err);

#endif
