/* A hash of everything that results depend on. The hash does not depend on the
 * number of threads or on the folder of the results. */
#ifndef MURK_RESULTS_IDENTITY_H
#define MURK_RESULTS_IDENTITY_H

#include "scene/scene.h"

/* Writes the SHA-256, in hex, of the version of murk, the command, the seed,
 * the texts `asked` (what the caller asks for beside the scene, as lines) and
 * `of` (further input), and, if scene is not NULL, the keys of the scene and
 * the contents of the files that it names. Fails with MURK_NO_MEMORY. */
murk_status murk_identity_of(char out[65], const char *command,
                             const char *asked, const murk_scene_desc *scene,
                             const char *of, uint32_t seed, murk_error *err);

#endif
