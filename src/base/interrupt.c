/* One atomic flag of each host (base/host.h), which long computations poll. */
#include "base/interrupt.h"

#include "base/host.h"

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
