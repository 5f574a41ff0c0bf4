/* Status codes and error messages: the problem, the place in the input of the
 * user, and the allowed values. The types are those of the public header
 * (murk.h); inside of murk, `code`, `where` and `text` of an error are used,
 * and the calls of the public header fill the other members.
 *
 * Functions that set up a run return a murk_status and fill a murk_error. The
 * photon loop does neither; it counts lost photons. */
#ifndef MURK_BASE_STATUS_H
#define MURK_BASE_STATUS_H

#include "murk.h"

/* Fills err (which may be NULL) and returns status, which is not MURK_OK, so
 * that a failing call reads `return murk_fail(err, ...)`. A message that err
 * contains already is kept, because the deepest cause is the most useful one.
 * `where` may be "" or NULL. */
murk_status murk_fail(murk_error *err, murk_status status, const char *where,
                      const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Fails with MURK_NO_MEMORY and the text "no memory " and the given purpose, as
 * "for %zu points" or "to write it". */
murk_status murk_no_memory(murk_error *err, const char *where,
                           const char *purpose, ...)
    __attribute__((format(printf, 3, 4)));

/* The exit code of the program: 0 done, 1 the run failed (also out of memory),
 * 2 bad or unsupported input, 130 interrupted. */
int murk_status_exit_code(murk_status status);

#endif
