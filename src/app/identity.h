/* What results follow from, as one hash: the same for any number of threads,
 * any output folder, and any order of different options. */
#ifndef MURK_APP_IDENTITY_H
#define MURK_APP_IDENTITY_H

#include "app/options.h"
#include "scene/scene.h"

#include "results/json.h"
#include <stddef.h>

/* *out: the options that results depend on beside the scene, with the contents
 * of files in place of their names, as lines of text; for free(), also after a
 * failure. */
murk_status murk_identity_asked(char **out, const murk_options *options,
                                murk_error *err);

/* SHA-256 over version, command, the text of murk_identity_asked(), seed, and
 * `of`, a text that identifies the input. Fails with MURK_NO_MEMORY, or if a
 * file cannot be read. */
murk_status murk_identity(char out[65], const murk_options *options,
                          const char *of, uint32_t seed, murk_error *err);

/* The same with a scene as the input: its keys, its seed, and the contents of
 * the files that it names, so that the hash is the same in any folder and on
 * any machine. */
murk_status murk_identity_scene(char out[65], const murk_options *options,
                                const murk_scene_desc *scene, murk_error *err);

/* Prints the JSON of a command that has no scene, with "identity" and "files".
 * The identity follows from the keys that --set gives and from `of`, a text
 * that identifies all other input. file: the file that the command wrote, or
 * NULL. Deletes root. */
murk_status murk_print_alone(cJSON *root, const murk_options *options,
                             const char *of, const char *file, murk_error *err);

#endif
