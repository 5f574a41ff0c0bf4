/* Reads the axes of a study: lists, ranges and named sets of values. For use
 * inside src/scene only. */
#ifndef MURK_SCENE_STUDY_AXES_H
#define MURK_SCENE_STUDY_AXES_H

#include "scene/walk.h"

/* Fills `axis`, `axes` and `rows` of the murk_study_file `study` from the map
 * of axes. The reader of a row of the key table (scene/keys.h). */
murk_status murk_study_axes_read(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *study);

#endif
