/* Imports the files of each condition; conditions with the same world share one
 * import. */
#include "calibrate/imported_stages.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <string.h>

/* An imported stage with the same world, or NULL. */
static murk_stage *like(const murk_imported_stages *d,
                        const murk_scene_desc *scene)
{
    for (size_t i = 0; i < d->n; ++i) {
        if (strcmp(d->stage[i]->scene->world_key, scene->world_key) == 0) {
            return d->stage[i];
        }
    }
    return NULL;
}

murk_status murk_imported_stages_import(murk_imported_stages *out,
                                        const murk_scene_desc *scene,
                                        murk_error *err)
{
    *out = (murk_imported_stages){
        .stage = calloc(scene->n_conditions + 1, sizeof *out->stage)};
    if (!out->stage) {
        return murk_no_memory(err, scene->path, "for its conditions");
    }
    murk_status status = MURK_OK;
    for (size_t i = 0; i <= scene->n_conditions && !status; ++i) {
        const murk_scene_desc *of = i ? scene->conditions[i - 1].scene : scene;
        murk_stage *stage = like(out, of);
        if (!stage) {
            status = murk_stage_import(&stage, of, err);
        }
        if (!status) {
            out->stage[out->n++] = stage;
        }
    }
    return status;
}

void murk_imported_stages_release(murk_imported_stages *d)
{
    for (size_t i = d->n; i-- > 0;) {
        bool is_shared = false;
        for (size_t k = 0; k < i; ++k) {
            is_shared = is_shared || d->stage[k] == d->stage[i];
        }
        if (!is_shared) {
            murk_stage_destroy(d->stage[i]);
        }
    }
    free(d->stage);
    *d = (murk_imported_stages){0};
}
