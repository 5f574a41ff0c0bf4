/* A host that is created here owns two parts: the progress line, which is made
 * with the host, and the set of inputs, which murk_inputs_begin() makes. Both
 * are released with the host. */
#include "base/host_make.h"

#include "base/inputs.h"
#include "base/progress.h"

#include <stdlib.h>

murk_host *murk_host_create(void)
{
    murk_host *host = calloc(1, sizeof *host);
    if (host && !(host->bar = murk_progress_create())) {
        free(host);
        host = NULL;
    }
    return host;
}

void murk_host_destroy(murk_host *host)
{
    if (host) {
        murk_host *before = murk_host_enter(host);
        murk_inputs_end();
        (void)murk_host_enter(before);
        murk_progress_destroy(host->bar);
        free(host);
    }
}
