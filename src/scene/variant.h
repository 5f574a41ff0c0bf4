/* Variants of a scene: what a row of a study sets in it, and which of its
 * conditions holds. A variant is one scene: it has no conditions, and nothing
 * is placed over them. */
#ifndef MURK_SCENE_VARIANT_H
#define MURK_SCENE_VARIANT_H

#include "scene/scene.h"
#include "scene/yaml.h"

typedef struct murk_key_change {
    const char *path;       /* of the key: "media.fog.visibility_m" */
    const murk_yaml *value; /* copied; its source must outlive the reading */
    const char *where;      /* the place that messages about the path name */
} murk_key_change;

typedef struct murk_variant {
    const char *condition;         /* of the scene's; NULL: as it stands */
    const murk_key_change *change; /* [n], put one after the other; no path may
                                  lie within another */
    size_t n;
} murk_variant;

/* As murk_scene_desc_read(), of a variant: overrides come first, then the
 * condition, then the changes. Files that changes name lie beside the file that
 * the value is from. With variant NULL it is the scene itself. */
murk_status
murk_scene_desc_read_variant(murk_scene_desc **out, const char *path,
                             const murk_override *overrides, size_t n_overrides,
                             const murk_variant *variant, murk_error *err);

#endif
