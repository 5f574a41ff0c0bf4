/* Reads the axes of a study: lists, ranges and named sets of values. Private
 * to the room. */
#ifndef MURK_SCENE_STUDY_AXES_H
#define MURK_SCENE_STUDY_AXES_H

#include "scene/study_file.h"

/* Fills study->axis and study->rows from the map of axes. */
murk_status murk_study_axes_read(murk_study_file *study, const murk_yaml *map,
                                 murk_error *err);

#endif
