/* The files that are built into the program: the scenes to start from
 * (scenes/start). */
#ifndef MURK_APP_BUILT_IN_FILES_H
#define MURK_APP_BUILT_IN_FILES_H

#include "base/built_in.h"

extern const murk_built_in murk_start_files;

#endif
