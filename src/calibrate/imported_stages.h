/* The imported files of a scene and its conditions, shared by all worlds that a
 * fit builds. Files are imported before the first world is built, because
 * importing starts subprocesses and building creates a ray device. */
#ifndef MURK_CALIBRATE_IMPORTED_STAGES_H
#define MURK_CALIBRATE_IMPORTED_STAGES_H

#include "world/stage.h"

typedef struct murk_imported_stages {
    size_t n;
    murk_stage **stage; /* [n]; imported, not built: the scene without a
                         * condition first, then the conditions; elements may be
                         * equal */
} murk_imported_stages;

/* Imports the files of the scene and of each of its conditions. Release *out
 * also after a failure. The scene must outlive *out. */
murk_status murk_imported_stages_import(murk_imported_stages *out,
                                        const murk_scene_desc *scene,
                                        murk_error *err);
void murk_imported_stages_release(murk_imported_stages *imported);

/* The stage of a condition of the scene; SIZE_MAX: the scene without a
 * condition. */
static inline const murk_stage *
murk_imported_stage_of(const murk_imported_stages *imported, size_t condition)
{
    return imported->stage[condition == SIZE_MAX ? 0 : condition + 1];
}

#endif
