/* The command line's say in a scene: --set KEY=VALUE, applied to the tree
 * before anything is checked; and a condition's, key by key. */
#ifndef MURK_SCENE_OVERRIDE_H
#define MURK_SCENE_OVERRIDE_H

#include "scene/scene.h"
#include "scene/yaml.h"

/* Sets the key in the tree. `source` (the option, for messages) must outlive
 * the tree. A key that excludes another (photons: emit, store) replaces it,
 * unless the command line gave that one, too. */
murk_status murk_override_apply(murk_yaml *root, const murk_override *override,
                                const char *source, murk_error *err);

/* Puts a value at a path of the tree, as a condition does; takes `value`, also
 * where it fails. `where` is the place that messages name. A key that excludes
 * another replaces it, unless that one is, or holds, one of own[n_own]: values
 * put before, of which no path may lie within another. */
murk_status murk_override_put(murk_yaml *root, const char *path,
                              murk_yaml *value, const char *where,
                              murk_yaml *const *own, size_t n_own,
                              murk_error *err);

/* The option as messages name it: override->option, or "--set KEY=VALUE".
 * NULL when out of memory; free() it. */
char *murk_override_source(const murk_override *override);

#endif
