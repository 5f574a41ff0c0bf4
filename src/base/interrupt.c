/* Variables of each host (base/host.h), which long computations poll: the flag
 * of requests to stop, the state of requests to finish, and the deadline of
 * searches. The deadline is set while no search runs, and is noted as passed by
 * the poll that finds it so: a search that ended before was not cut. */
#include "base/interrupt.h"

#include "base/host.h"
#include "base/progress.h"
#include "base/ranks.h"

#include <math.h>

bool murk_interrupted(void)
{
    return atomic_load_explicit(&murk_host_now()->stop, memory_order_relaxed) !=
           0;
}

murk_status murk_interrupt_check(murk_error *err)
{
    return murk_interrupted()
               ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
               : MURK_OK;
}

void murk_interrupt_request(void)
{
    atomic_store(&murk_host_now()->stop, 1);
}

void murk_finish_allow(bool is_allowed)
{
    /* Ranks would finish at different points. */
    atomic_store(&murk_host_now()->finish, is_allowed && murk_ranks_count() == 1
                                               ? MURK_FINISH_ALLOWED
                                               : MURK_FINISH_REFUSED);
}

/* Changes the state `from` to the state `to`; false if the state is another. */
static bool change(murk_host *host, int from, int to)
{
    return atomic_compare_exchange_strong(&host->finish, &from, to);
}

void murk_finish_search_begins(void)
{
    (void)change(murk_host_now(), MURK_FINISH_ALLOWED, MURK_FINISH_POSSIBLE);
}

bool murk_finish_search_ends(void)
{
    murk_host *host = murk_host_now();
    (void)change(host, MURK_FINISH_POSSIBLE, MURK_FINISH_ALLOWED);
    return atomic_load(&host->finish) == MURK_FINISH_REQUESTED;
}

bool murk_finish_request(murk_host *host)
{
    return change(host, MURK_FINISH_POSSIBLE, MURK_FINISH_REQUESTED);
}

void murk_finish_set_deadline(double at_s)
{
    murk_host *host = murk_host_now();
    host->has_deadline = isfinite(at_s);
    host->deadline_s = at_s;
    atomic_store(&host->is_late, false);
}

bool murk_finish_was_late(void)
{
    return atomic_load_explicit(&murk_host_now()->is_late,
                                memory_order_relaxed);
}

/* Notes that the deadline has passed, if it has. */
static bool is_late(murk_host *host)
{
    if (host->has_deadline && murk_clock_s() >= host->deadline_s) {
        atomic_store_explicit(&host->is_late, true, memory_order_relaxed);
    }
    return atomic_load_explicit(&host->is_late, memory_order_relaxed);
}

bool murk_must_finish(void)
{
    murk_host *host = murk_host_now();
    return murk_interrupted() ||
           atomic_load_explicit(&host->finish, memory_order_relaxed) ==
               MURK_FINISH_REQUESTED ||
           is_late(host);
}
