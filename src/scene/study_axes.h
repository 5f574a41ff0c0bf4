/* The axes of a study: lists and ranges of values. Private to the room. */
#ifndef MURK_SCENE_STUDY_AXES_H
#define MURK_SCENE_STUDY_AXES_H

#include "scene/study_file.h"

/* Fills study->axis from the map of axes, and study->rows. */
murk_status murk_study_axes_read(murk_study_file *study, const murk_yaml *map,
                                 murk_error *err);

/* Fails at a node, or at its key: "study.yaml:5:3: axes.KEY". */
murk_status murk_study_fail(const murk_yaml *node, const char *key, bool at_key,
                            murk_error *err, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
murk_status murk_study_no_memory(const char *path, murk_error *err);

#endif
