/* What libyaml does not ask of a text and of a map's keys.
 *
 * Inside this room only. */
#ifndef MURK_SCENE_YAML_CHECK_H
#define MURK_SCENE_YAML_CHECK_H

#include "scene/yaml.h"

/* text[size] is well-formed UTF-8 without control characters other than tab
 * and line ends; else MURK_BAD_FILE at the line and column of `source`. */
murk_status murk_yaml_check_text(const char *text, size_t size,
                                 const char *source, murk_error *err);

/* No key of the map is given twice; else MURK_BAD_FILE at the first key that
 * repeats another. */
murk_status murk_yaml_check_keys(const murk_yaml *map, murk_error *err);

#endif
