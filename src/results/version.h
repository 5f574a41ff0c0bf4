/* What murk was built from: commit, compiler and packages. */
#ifndef MURK_RESULTS_VERSION_H
#define MURK_RESULTS_VERSION_H

#include "base/version.h"

#include <stddef.h>

typedef struct murk_package {
    const char *name, *version;
} murk_package;

extern const murk_package murk_packages[];
extern const size_t murk_packages_count;

const char *murk_version_commit(void);      /* "unknown" outside a checkout */
const char *murk_version_with_commit(void); /* "0.1.0 1234abcd" */
const char *murk_version_compiler(void);    /* "gcc 12.2.0" */
const char *murk_version_date(void);        /* of the commit, "2026-11-21" */

#endif
