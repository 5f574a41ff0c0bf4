/* Requests to stop, by murk_context_cancel() or by a signal that the program
 * receives (app/terminal.h): long computations stop at the next batch and
 * remove unfinished files. And requests to finish, by murk_context_finish(): a
 * search ends with the best that it has found, and the work goes on with that.
 * A deadline has the same effect as a request to finish.
 *
 * A host is a caller of the library (base/host.h), and has one flag. A thread
 * that is bound to no host belongs to the host of the process, so every thread
 * has a flag. No function of this header clears the flag of requests to
 * stop. */
#ifndef MURK_BASE_INTERRUPT_H
#define MURK_BASE_INTERRUPT_H

#include "base/status.h"

#include <stdbool.h>

/* True if the flag of the host of the calling thread is set. */
bool murk_interrupted(void);

/* Fails with MURK_INTERRUPTED if the flag of the host of the calling thread is
 * set. */
murk_status murk_interrupt_check(murk_error *err);

/* Sets the flag of the host of the calling thread. */
void murk_interrupt_request(void);

/* A request to finish is taken only while a search runs of a host that allows
 * such requests, because a result that depends on the time of a request must
 * not enter a study or a comparison unnoticed. A request holds until the host
 * no longer allows it, so later searches of the same work finish at once. */
typedef enum murk_finish_state {
    MURK_FINISH_REFUSED,   /* at first */
    MURK_FINISH_ALLOWED,   /* no search runs */
    MURK_FINISH_POSSIBLE,  /* a search runs */
    MURK_FINISH_REQUESTED, /* a search runs or has run */
} murk_finish_state;

/* Whether searches of the host of the calling thread may be asked to finish
 * from now on; with ranks (base/ranks.h) they never are. Either value forgets a
 * request. */
void murk_finish_allow(bool is_allowed);

/* A search of the host begins and ends. The second function returns true if a
 * search of the host was asked to finish. Searches are not nested. */
void murk_finish_search_begins(void);
bool murk_finish_search_ends(void);

/* Asks the search that runs to finish. Returns false, without effect, if no
 * search runs that may be asked, or if one was asked before. May be called from
 * any thread and from a signal handler. */
struct murk_host;
bool murk_finish_request(struct murk_host *host);

/* The searches of the host of the calling thread finish, too, once
 * murk_clock_s() (base/progress.h) passes at_s, whatever the state of requests.
 * INFINITY: never, as at first. Called while no search runs. */
void murk_finish_set_deadline(double at_s);

/* True if a search has finished because of the deadline that was set last. */
bool murk_finish_was_late(void);

/* True if the host of the calling thread was asked to finish or to stop, or if
 * its deadline has passed: what a search polls where it may end with a complete
 * result. Once true, it stays so until the searches are over. */
bool murk_must_finish(void);

#endif
