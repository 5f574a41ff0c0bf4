/* Whether a file with light belongs to a scene: the text by which the file
 * names the scene, and the origin of positions. */
#ifndef MURK_LIGHTMAP_KEY_CHECK_H
#define MURK_LIGHTMAP_KEY_CHECK_H

#include "photonmap/map_file.h"
#include "scene/scene.h"

/* Compares the text of a file with that of the scene, line by line. Fails with
 * MURK_BAD_VALUE, "made for another WHAT", and names the first line that
 * differs. */
murk_status murk_lightmap_check_text(const murk_section *section,
                                     const char *text, const char *what,
                                     const char *path, murk_error *err);

/* Positions of records are relative to the local origin of the scene that they
 * were traced for. In a scene without a domain the origin depends on the
 * sensors as well, which the light key does not contain, so the origin is
 * compared here. A file without the section (NULL) has the origin 0. Fails with
 * MURK_BAD_VALUE. */
murk_status murk_lightmap_check_origin(const murk_section *origin,
                                       const murk_scene_desc *scene,
                                       const char *path, murk_error *err);

#endif
