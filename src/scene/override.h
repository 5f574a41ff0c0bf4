/* Changes values of a scene's tree by their path, before anything is checked:
 * --set KEY=VALUE of the command line, the keys of a condition, and the keys
 * that a row of a study sets. */
#ifndef MURK_SCENE_OVERRIDE_H
#define MURK_SCENE_OVERRIDE_H

#include "scene/scene.h"
#include "scene/yaml.h"

/* Applies an option of the command line, or the key that a call of the library
 * sets. `source` (the option, for messages) must outlive the tree. A key that
 * excludes another key (photons: emit, store) replaces the other key; if the
 * command line set both, the function fails with MURK_BAD_VALUE. */
murk_status murk_override_apply(murk_yaml *root, const murk_override *override,
                                const char *source, murk_error *err);

/* Puts a value at a path of the tree. Takes ownership of `value`, also on
 * failure. `where` is the place for messages. A key that excludes another key
 * replaces the other key; if the other key is, or contains, one of own[n_own],
 * the values that were put before, the function fails with MURK_BAD_VALUE. The
 * path of no such value may lie within that of another. */
murk_status murk_override_put(murk_yaml *root, const char *path,
                              murk_yaml *value, const char *where,
                              murk_yaml *const *own, size_t n_own,
                              murk_error *err);

/* True if the paths are equal or one lies within the other. */
bool murk_override_overlap(const char *a, const char *b);

/* Makes the override of a key that a call of the library sets: the text
 * "KEY=VALUE", and the option "set KEY=VALUE" (MURK_SET_MARK). Release it with
 * murk_override_release(). Fails with MURK_NO_MEMORY. */
murk_status murk_override_make(murk_override *out, const char *key,
                               const char *value, murk_error *err);
void murk_override_release(murk_override *made);

/* The option as messages show it: override->option, or "--set KEY=VALUE".
 * NULL when out of memory; the caller frees it with free(). */
char *murk_override_source(const murk_override *override);

#endif
