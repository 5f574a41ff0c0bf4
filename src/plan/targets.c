/* Creates the records of targets: reads the list (targets_listed.c) or draws
 * points (targets_drawn.c), then builds the maps. */
#include "plan/targets.h"

#include <stdlib.h>

/* The number of points that murk_targets_check() keeps on surfaces, and in the
 * volume: a single point shows that there is free space. */
#define CHECK_KEEPS 1

murk_photon murk_target_of(murk_vec3 place, murk_vec3 normal, int band,
                           uint8_t material)
{
    const bool is_volume = murk_dot(normal, normal) == 0;
    return murk_photon_make(&(murk_photon_values){.position_m = place,
                                                  .normal = normal,
                                                  .power_w = 1,
                                                  .band = (uint8_t)band,
                                                  .material = material,
                                                  .is_volume = is_volume});
}

uint8_t murk_target_medium(const murk_stage *stage, int band, murk_vec3 place)
{
    const murk_inside inside =
        stage->boundary_meshes
            ? murk_boundary_meshes_at(stage->boundary_meshes, place)
            : 0;
    uint8_t best = MURK_TARGET_IN_NONE;
    double max = 0;
    for (size_t i = 0; i < stage->scene->n_media; ++i) {
        const double per_m =
            murk_media_extinction_of(stage->media, i, band, inside, place);
        if (per_m > max) {
            max = per_m;
            best = (uint8_t)i;
        }
    }
    return best;
}

int murk_targets_band(const murk_scene_desc *scene)
{
    for (int i = 0; i < scene->bands; ++i) {
        if (scene->band_nm[i] == scene->placement.targets.band_nm) {
            return i;
        }
    }
    return 0;
}

/* Reads or draws all targets. The caller frees both lists, also after a
 * failure. */
static murk_status fill(murk_target_records *to, murk_error *err)
{
    const murk_scene_targets *settings = &to->stage->scene->placement.targets;
    murk_status status = MURK_OK;
    to->band = murk_targets_band(to->stage->scene);
    to->facts.area_m2 = to->facts.volume_m3 = (murk_estimate){NAN, NAN};
    if (settings->points) {
        status = murk_targets_read(to, err);
    }
    if (!status && settings->has_surfaces) {
        status = murk_targets_draw_surfaces(to, err);
    }
    if (!status && settings->has_volume) {
        status = murk_targets_draw_volume(to, err);
    }
    to->facts.surface = to->surface.n;
    to->facts.volume = to->volume.n;
    return status;
}

murk_status murk_targets_create(murk_targets *out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err)
{
    murk_target_records made = {.stage = stage,
                                .stream = stream,
                                .threads = threads,
                                .max = UINT64_MAX};
    *out = (murk_targets){0};
    murk_status status = fill(&made, err);
    if (!status) {
        status =
            murk_record_list_map(&out->surface, &made.surface, threads, err);
    }
    if (!status) {
        status = murk_record_list_map(&out->volume, &made.volume, threads, err);
    }
    murk_record_list_release(&made.surface);
    murk_record_list_release(&made.volume);
    out->facts = made.facts;
    out->independent =
        stage->scene->placement.targets.points ? 1 : made.facts.points;
    return status;
}

void murk_targets_release(murk_targets *targets)
{
    murk_photon_map_destroy(targets->surface);
    murk_photon_map_destroy(targets->volume);
    *targets = (murk_targets){0};
}

murk_status murk_targets_check(const murk_stage *stage, unsigned threads,
                               murk_error *err)
{
    murk_target_records made = {
        .stage = stage, .threads = threads, .max = CHECK_KEEPS};
    const murk_status status = fill(&made, err);
    murk_record_list_release(&made.surface);
    murk_record_list_release(&made.volume);
    return status;
}
