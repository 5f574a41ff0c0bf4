/* The files of a scene and of its conditions, imported once for all worlds that
 * a fit builds: before any of them, since that makes a ray device, and
 * importing forks. */
#ifndef MURK_CALIBRATE_DONORS_H
#define MURK_CALIBRATE_DONORS_H

#include "study/stage.h"

typedef struct murk_donors {
    size_t n;
    murk_stage **stage; /* [n] imported, not built: as the scene stands, then
                           its conditions, which may share */
} murk_donors;

/* Release also after a failure. The scene must outlive it. */
murk_status murk_donors_import(murk_donors *out, const murk_scene *scene,
                               murk_error *err);
void murk_donors_release(murk_donors *donors);

/* Of a condition of the scene, SIZE_MAX: as it stands. */
static inline const murk_stage *murk_donor_of(const murk_donors *donors,
                                              size_t condition)
{
    return donors->stage[condition == SIZE_MAX ? 0 : condition + 1];
}

#endif
