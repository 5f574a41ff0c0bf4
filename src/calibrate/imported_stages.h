/* The files of a scene and of its conditions, imported once for all worlds that
 * a fit builds: before any of them, since that makes a ray device, and
 * importing forks. */
#ifndef MURK_CALIBRATE_IMPORTED_STAGES_H
#define MURK_CALIBRATE_IMPORTED_STAGES_H

#include "world/stage.h"

typedef struct murk_imported_stages {
    size_t n;
    murk_stage **stage; /* [n] imported, not built: as the scene stands, then
                           its conditions, which may share */
} murk_imported_stages;

/* Release also after a failure. The scene must outlive it. */
murk_status murk_imported_stages_import(murk_imported_stages *out,
                                        const murk_scene_desc *scene,
                                        murk_error *err);
void murk_imported_stages_release(murk_imported_stages *imported);

/* Of a condition of the scene, SIZE_MAX: as it stands. */
static inline const murk_stage *
murk_imported_stage_of(const murk_imported_stages *imported, size_t condition)
{
    return imported->stage[condition == SIZE_MAX ? 0 : condition + 1];
}

#endif
