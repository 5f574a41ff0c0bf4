/* What went wrong, where in the user's input, and what would be allowed.
 *
 * Set-up returns a murk_status and fills a murk_error; the photon loop does
 * neither, it counts. */
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
    char where[320]; /* place in the user's input: "fog.yaml:12:5: media.fog" */
    char text[640];  /* what was found and what is allowed, with units */
} murk_error;

/* Fills err (which may be NULL) and returns status, so that a failing call
 * reads `return murk_fail(err, ...)`. Keeps the first message when err is
 * already filled: the deepest cause is the useful one. `where` may be "". */
murk_status murk_fail(murk_error *err, murk_status status, const char *where,
                      const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* The plain meaning of a status, as in MURK_STATUSES. */
const char *murk_status_text(murk_status status);

/* The program's exit code: 0 done, 1 the run failed (also out of memory),
 * 2 bad input, 130 interrupted. */
int murk_status_exit_code(murk_status status);

#endif
