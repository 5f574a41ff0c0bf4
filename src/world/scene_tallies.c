/* Converts the tallies of a scene into those of the photon tracer
 * (transport/tallies.h) and creates them for a run. */
#include "world/scene_tallies.h"

#include <stdlib.h>
#include <string.h>

static murk_tally_desc desc_of(const murk_scene_tally *t)
{
    murk_tally_desc desc = {.where = t->where,
                            .type = t->type,
                            .point = t->point,
                            .normal = t->normal,
                            .bins = {t->bins[0], t->bins[1]},
                            .angle_bins = t->angle_bins,
                            .box = t->box,
                            .size = {t->size[0], t->size[1], t->size[2]},
                            .center = t->center,
                            .radius_m = t->radius_m,
                            .hemispheres = t->hemispheres};
    _Static_assert(sizeof desc.name == sizeof t->name, "names fit");
    memcpy(desc.name, t->name, sizeof desc.name);
    return desc;
}

murk_status murk_tallies_asked(murk_tally_desc **out,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err)
{
    *out = NULL;
    if (scene->n_tallies == 0) {
        return MURK_OK;
    }
    murk_tally_desc *descs = calloc(scene->n_tallies, sizeof *descs);
    if (!descs) {
        return murk_no_memory(err, scene->path, "for the tallies");
    }
    for (size_t i = 0; i < scene->n_tallies; ++i) {
        descs[i] = desc_of(&scene->tallies[i]);
    }
    const murk_status status =
        murk_tallies_check(descs, scene->n_tallies, domain, err);
    if (status) {
        free(descs);
        return status;
    }
    *out = descs;
    return MURK_OK;
}

double murk_tallies_bytes(const murk_stage *stage, unsigned threads)
{
    return stage->tally
               ? murk_tallies_memory(stage->tally, stage->scene->n_tallies,
                                     murk_sources_channels(stage->lights),
                                     stage->scene->bands, threads)
               : 0;
}

murk_status murk_tallies_of_stage(murk_tallies **out, const murk_stage *stage,
                                  unsigned threads, double memory_max_bytes,
                                  murk_error *err)
{
    *out = NULL;
    return stage->tally
               ? murk_tallies_create(
                     out, stage->tally, stage->scene->n_tallies,
                     &stage->world.domain, murk_sources_channels(stage->lights),
                     stage->scene->bands, threads, memory_max_bytes, err)
               : MURK_OK;
}
