/* The host of the process is a static variable; the host of each thread is a
 * thread-local pointer. */
#include "base/host.h"

#include "base/version.h"

static murk_host process;
static _Thread_local murk_host *entered; /* NULL: the host of the process */

murk_host *murk_host_now(void)
{
    return entered ? entered : &process;
}

const char *murk_host_version(void)
{
    const char *version = murk_host_now()->version;
    return version ? version : MURK_VERSION;
}

murk_host *murk_host_enter(murk_host *host)
{
    murk_host *before = murk_host_now();
    entered = host;
    return before;
}
