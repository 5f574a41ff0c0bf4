/* One atomic flag that the handler of SIGINT and SIGTERM sets and long
 * computations poll. The handler is installed for one signal only, so that a
 * second signal kills a program that does not react. */
#include "base/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>

static atomic_int requested; /* lock-free, so a signal handler may set it */

static void on_signal(int number)
{
    (void)number;
    atomic_store(&requested, 1);
}

void murk_interrupt_install(void)
{
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND; /* the second signal kills the
                                          * process */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

bool murk_interrupted(void)
{
    return atomic_load_explicit(&requested, memory_order_relaxed) != 0;
}

murk_status murk_interrupt_check(murk_error *err)
{
    return murk_interrupted()
               ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
               : MURK_OK;
}

void murk_interrupt_request(void)
{
    atomic_store(&requested, 1);
}
