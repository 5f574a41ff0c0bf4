/* Checks of text and keys that libyaml does not make.
 *
 * For use inside src/scene only. */
#ifndef MURK_SCENE_YAML_CHECK_H
#define MURK_SCENE_YAML_CHECK_H

#include "scene/yaml.h"

/* Checks that the `size` bytes of text are well-formed UTF-8 without ASCII
 * control characters other than tab and line ends; otherwise fails with
 * MURK_BAD_FILE at the line and column in `source`. */
murk_status murk_yaml_check_text(const char *text, size_t size,
                                 const char *source, murk_error *err);

/* Checks that no key of the map is given twice; otherwise fails with
 * MURK_BAD_FILE at the first key that repeats another, or with
 * MURK_NO_MEMORY. */
murk_status murk_yaml_check_keys(const murk_yaml *map, murk_error *err);

#endif
