/* One atomic flag of each host (base/host.h), which long computations poll. The
 * handler of SIGINT and SIGTERM sets the flag of the host that installed the
 * handler. The handler of each of the two serves once, so that a second signal
 * with the same number kills a program that does not react. */
#include "base/interrupt.h"

#include "base/host.h"

#include <signal.h>
#include <stddef.h>

/* The host that has installed the handlers. */
static murk_host *_Atomic signalled;

static void on_signal(int number)
{
    (void)number;
    atomic_store(&atomic_load(&signalled)->stop, 1);
}

void murk_interrupt_install(void)
{
    struct sigaction action = {.sa_handler = on_signal};
    atomic_store(&signalled, murk_host_now());
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND; /* the second signal of that number
                                          * kills the process */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

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
