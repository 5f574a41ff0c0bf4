/* Status codes and error messages: the problem, the place in the input of the
 * user, and the allowed values.
 *
 * Functions that set up a run return a murk_status and fill a murk_error. The
 * photon loop does neither; it counts lost photons. */
#ifndef MURK_BASE_STATUS_H
#define MURK_BASE_STATUS_H

#define MURK_STATUSES(X)                                      \
    X(MURK_OK, "ok")                                          \
    X(MURK_BAD_VALUE, "a value is outside its allowed range") \
    X(MURK_BAD_FILE, "a file is missing or malformed")        \
    X(MURK_UNSUPPORTED, "not supported yet")                  \
    X(MURK_NO_MEMORY, "out of memory")                        \
    X(MURK_RUN_FAILED, "the run failed")                      \
    X(MURK_INTERRUPTED, "interrupted")

typedef enum murk_status {
#define X(name, text) name,
    MURK_STATUSES(X)
#undef X
} murk_status;

typedef struct murk_error {
    murk_status status;
    char where[320]; /* place in the input of the user, e.g. "fog.yaml:12:5:
                      * media.fog" */
    char text[640];  /* the value found and the allowed values, with units */
} murk_error;

/* Fills err (which may be NULL) and returns status, so that a failing call
 * reads `return murk_fail(err, ...)`. A message that err contains already is
 * kept, because the deepest cause is the most useful one. `where` may be "". */
murk_status murk_fail(murk_error *err, murk_status status, const char *where,
                      const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Fails with MURK_NO_MEMORY and the text "no memory " and the given purpose, as
 * "for %zu points" or "to write it". */
murk_status murk_no_memory(murk_error *err, const char *where,
                           const char *purpose, ...)
    __attribute__((format(printf, 3, 4)));

/* The meaning of a status in words, as in MURK_STATUSES. */
const char *murk_status_text(murk_status status);

/* The exit code of the program: 0 done, 1 the run failed (also out of memory),
 * 2 bad input, 130 interrupted. */
int murk_status_exit_code(murk_status status);

#endif
