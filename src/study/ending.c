#include "study/ending.h"

/* All of them lost by chance, where only one in a hundred may be: 1e-16. */
#define PHOTONS 8

static bool reflects_all(const murk_scene_material *m, int bands)
{
    for (int b = 0; b < bands; ++b) {
        if (m->diffuse.band[b] + m->specular.band[b] + m->transmit.band[b] <
            1) {
            return false;
        }
    }
    return true;
}

static bool scatters_all(const murk_scene_medium *m, int bands)
{
    for (int b = 0; b < bands; ++b) {
        if (m->albedo.band[b] < 1) {
            return false;
        }
    }
    return true;
}

/* Whether any surface or medium that is there takes light. */
static bool absorbs(const murk_stage *stage)
{
    const murk_scene *scene = stage->scene;
    for (size_t i = 0; i < scene->n_materials; ++i) {
        if (murk_surfaces_material_area(stage->surfaces, i) > 0 &&
            !reflects_all(&scene->materials[i], scene->bands)) {
            return true;
        }
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        if (!scatters_all(&scene->media[scene->regions[i].medium],
                          scene->bands)) {
            return true;
        }
    }
    return false;
}

murk_status murk_ending_check(const murk_stage *stage, uint32_t stream,
                              murk_error *err)
{
    const murk_scene *scene = stage->scene;
    murk_ledger *ledger = NULL;
    murk_status status = murk_ledger_create(&ledger, &stage->world, err);
    if (status) {
        return status;
    }
    murk_trace trace = murk_stage_trace(stage);
    trace.stream = stream;
    trace.last = PHOTONS;
    murk_trace_run(&trace, ledger);
    const int64_t traced = murk_tally_read(&ledger->photons);
    const int64_t lost =
        murk_tally_read(&ledger->lost_photons[MURK_LOSS_EVENTS]) +
        murk_tally_read(&ledger->lost_photons[MURK_LOSS_WRAPS]);
    if (traced == PHOTONS && lost == PHOTONS) {
        status = murk_fail(
            err, MURK_BAD_VALUE, scene->path,
            "light does not end: the first %d photons all went on for %u "
            "events or %u wraps; %s",
            PHOTONS, trace.events_max, trace.wraps_max,
            absorbs(stage) ? "give surfaces or media more absorption, or light "
                             "a way out"
                           : "no material or medium absorbs and there is no "
                             "way out: give one of them absorption, or open "
                             "the box");
    }
    murk_ledger_destroy(ledger);
    return status;
}
