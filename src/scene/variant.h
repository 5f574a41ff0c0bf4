/* Variants of a scene, for the rows of a study: the scene with some keys
 * changed, and with one of its conditions applied. A variant is a single
 * scene: it has no conditions, and placement over conditions does not apply. */
#ifndef MURK_SCENE_VARIANT_H
#define MURK_SCENE_VARIANT_H

#include "scene/scene.h"
#include "scene/yaml.h"

typedef struct murk_key_change {
    const char *path;       /* path of the key: "media.fog.visibility_m" */
    const murk_yaml *value; /* copied; the source text must outlive the call */
    const char *where;      /* place for messages about the path */
} murk_key_change;

typedef struct murk_variant {
    const char *condition; /* name of a condition; NULL: the scene without any
                            * condition */
    const murk_key_change
        *change; /* [n], applied in order; no path may lie within another */
    size_t n;
} murk_variant;

/* murk_scene_desc_read() for a variant: overrides are applied first, then the
 * condition, then the changes. The path of a file in a change is relative to
 * the folder of the file that the value comes from. variant NULL: the scene as
 * it stands, with its conditions. */
murk_status
murk_scene_desc_read_variant(murk_scene_desc **out, const char *path,
                             const murk_override *overrides, size_t n_overrides,
                             const murk_variant *variant, murk_error *err);

/* murk_scene_desc_parse() for a variant. */
murk_status murk_scene_desc_parse_variant(murk_scene_desc **out,
                                          const char *text, const char *path,
                                          const murk_override *overrides,
                                          size_t n_overrides,
                                          const murk_variant *variant,
                                          murk_error *err);

/* Reads a scene that has a timeline at another time, without conditions and
 * without messages, from the text of the resolved scene. Lines and columns of
 * places are those of that text. */
murk_status murk_scene_desc_read_at(murk_scene_desc **out,
                                    const murk_scene_desc *scene, double t_s,
                                    murk_error *err);

#endif
