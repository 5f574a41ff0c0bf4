/* What results follow from, as one hash: the same for any number of threads,
 * any output folder and any way of typing it. */
#ifndef MURK_APP_IDENTITY_H
#define MURK_APP_IDENTITY_H

#include "app/options.h"

#include <cjson/cJSON.h>
#include <stddef.h>

/* SHA-256 over version, command, what the command line asks beside the scene
 * (files by their contents), seed, and `of`: the resolved scene, or what else
 * says all of the input. MURK_NO_MEMORY, or a file that cannot be read. */
murk_status murk_identity(char out[65], const murk_options *options,
                          const char *of, uint32_t seed, murk_error *err);

/* Adds "identity" and "files" to the JSON of a command that has no scene: of
 * the argument, what --set gives, and `of`; file: the one that it wrote, or
 * NULL. */
murk_status murk_identify_alone(cJSON *root, const murk_options *options,
                                const char *of, const char *file,
                                murk_error *err);

#endif
