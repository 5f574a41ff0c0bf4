/* The files under media/ that are built into the library: presets (yaml) and
 * tables (csv). */
#ifndef MURK_PRESET_FILES_H
#define MURK_PRESET_FILES_H

#include "base/built_in.h"

extern const murk_built_in murk_media_files;

#endif
