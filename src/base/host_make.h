/* Creates and destroys hosts (base/host.h) beside that of the process. */
#ifndef MURK_BASE_HOST_MAKE_H
#define MURK_BASE_HOST_MAKE_H

#include "base/host.h"

/* Creates a host that logs nothing, shows no progress and has no set of inputs.
 * NULL when out of memory. */
murk_host *murk_host_create(void);
/* No thread may belong to the host any more. NULL is fine. */
void murk_host_destroy(murk_host *host);

#endif
