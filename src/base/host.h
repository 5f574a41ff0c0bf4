/* The caller of the library: where messages and progress go, how many threads
 * may run, whether the caller has asked to stop, and other settings that would
 * otherwise be variables of the process.
 *
 * A thread belongs to one host at a time. murk_host_enter() binds the calling
 * thread; threads that murk starts (base/pool.h, base/progress.h) belong to the
 * host of the thread that starts them. A thread that is bound to no host
 * belongs to the host of the process, which always exists. Two threads with
 * different hosts do not disturb each other. */
#ifndef MURK_BASE_HOST_H
#define MURK_BASE_HOST_H

#include "base/vector.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

/* The process that parses files of meshes and grids (base/subprocess.h), and
 * that runs rows of studies (base/isolated.h). */
typedef enum murk_importing {
    MURK_IMPORT_FORKS,      /* a fork of this process, which has no threads */
    MURK_IMPORT_STARTS,     /* the programs murk-reader and murk-rows */
    MURK_IMPORT_IN_PROCESS, /* this process: for files that are trusted */
} murk_importing;

typedef struct murk_host {
    /* The receiver of warnings and notes (NULL: none), and the receiver with an
     * argument of the caller that murk_log_to() sets instead: base/log.h */
    bool has_warn; /* false: warnings and notes go to standard error */
    void (*warn)(const char *where, const char *text);
    void (*log)(void *user, bool is_warning, const char *where,
                const char *text);
    void *user;
    /* Set to 1 by a request to stop; lock-free, so a signal handler may set it.
     * base/interrupt.h */
    atomic_int stop;
    atomic_int finish;        /* a value of murk_finish_state: lock-free, too */
    bool has_deadline;        /* searches finish at deadline_s, */
    double deadline_s;        /* a time of murk_clock_s() */
    atomic_bool is_late;      /* a search has found the deadline passed */
    unsigned threads_allowed; /* 0: no limit but that of base/pool.h */
    murk_vec3 origin;         /* of positions in messages: base/position.h */
    _Atomic uint64_t *inputs; /* the set of files that are read; NULL: no set
                               * was begun, or there was no memory for one:
                               * base/inputs.h */
    atomic_bool inputs_are_full;
    struct murk_progress_bar *bar;  /* base/progress.h */
    const struct murk_ranks *ranks; /* base/ranks.h; NULL: one process */
    bool keeps_in_first;            /* rank 0 alone needs the results */
    const char *version; /* of the library, with the commit; NULL: that of the
                          * header alone */
    murk_importing importing;
    const char *reader; /* path of the program murk-reader, beside which the
                         * other programs and the modules lie; NULL: those
                         * beside the library */
    const struct murk_memory_files *files; /* of paths "memory:NAME", or NULL:
                                            * base/memory_files.h */
} murk_host;

/* The host that the calling thread belongs to. */
murk_host *murk_host_now(void);

/* The version by which parts of runs of different builds are told apart. */
const char *murk_host_version(void);

/* Binds the calling thread to a host, or to the host of the process if `host`
 * is NULL. Returns the host that the thread belonged to, never NULL. The caller
 * binds the thread to that host again when the work for `host` ends. */
murk_host *murk_host_enter(murk_host *host);

#endif
