/* Creates and destroys hosts (base/host.h) in addition to the host of the
 * process. */
#ifndef MURK_BASE_HOST_MAKE_H
#define MURK_BASE_HOST_MAKE_H

#include "base/host.h"

/* Creates a host that shows no progress and has no set of inputs. Warnings and
 * notes go to standard error until murk_warn_to() or murk_log_to() (base/log.h)
 * is called for the host. NULL when out of memory. */
murk_host *murk_host_create(void);
/* Releases the host with its progress line and its set of inputs. No thread may
 * belong to the host any more. NULL is fine. */
void murk_host_destroy(murk_host *host);

#endif
