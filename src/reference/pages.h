/* The pages of the reference of keys (doc/reference), built into the
 * library. */
#ifndef MURK_REFERENCE_PAGES_H
#define MURK_REFERENCE_PAGES_H

#include "base/built_in.h"

extern const murk_built_in murk_reference_files;

#endif
