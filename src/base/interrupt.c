/* Two atomic variables of each host (base/host.h), which long computations
 * poll: the flag of requests to stop, and the state of requests to finish. */
#include "base/interrupt.h"

#include "base/host.h"
#include "base/ranks.h"

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

bool murk_must_finish(void)
{
    return murk_interrupted() ||
           atomic_load_explicit(&murk_host_now()->finish,
                                memory_order_relaxed) == MURK_FINISH_REQUESTED;
}
