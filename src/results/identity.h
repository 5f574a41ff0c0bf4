/* The facts that results follow from, as one hash: the same for any number of
 * threads and in any folder. */
#ifndef MURK_RESULTS_IDENTITY_H
#define MURK_RESULTS_IDENTITY_H

#include "scene/scene.h"

/* SHA-256 over the version of murk, the command, the seed, `asked` (what the
 * caller asks beside the scene, as lines of text), and the input: `of`, or if
 * scene is not NULL the keys of the scene and the contents of the files that it
 * names. Fails with MURK_NO_MEMORY. */
murk_status murk_identity_of(char out[65], const char *command,
                             const char *asked, const murk_scene_desc *scene,
                             const char *of, uint32_t seed, murk_error *err);

#endif
