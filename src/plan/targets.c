/* Creates the records of targets: reads the list or draws points
 * (targets_drawn.c, targets_listed.c), then builds the maps. */
#include "plan/targets.h"

#include "plan/target_buffer.h"

#include <stdlib.h>

#define FIRST_CAPACITY 256 /* first capacity of a buffer: 8 kB */
/* points that murk_targets_check() draws: one shows that there is free space */
#define CHECK_KEEPS 1

bool murk_target_buffer_put(murk_target_buffer *buffer,
                            const murk_photon *photon)
{
    if (buffer->n == buffer->capacity) {
        const size_t capacity = buffer->capacity
                                    ? buffer->capacity + buffer->capacity / 2
                                    : FIRST_CAPACITY;
        murk_photon *grown = realloc(buffer->photon, capacity * sizeof *grown);
        if (!grown) {
            return false;
        }
        buffer->photon = grown;
        buffer->capacity = capacity;
    }
    buffer->photon[buffer->n++] = *photon;
    return true;
}

murk_photon murk_target_of(murk_vec3 place, murk_vec3 normal, uint32_t number,
                           int band)
{
    const bool is_volume = murk_dot(normal, normal) == 0;
    return murk_photon_make(&(murk_photon_values){.position_m = place,
                                                  .normal = normal,
                                                  .power_w = 1,
                                                  .emitted = number,
                                                  .band = (uint8_t)band,
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

/* Records of both maps before the maps are built. */
typedef struct target_records {
    murk_target_buffer surface, volume;
    murk_target_facts facts;
} target_records;

/* Reads or draws all targets. */
static murk_status fill(target_records *p, murk_target_source source,
                        murk_error *err)
{
    const murk_scene_targets *settings =
        &source.stage->scene->placement.targets;
    murk_target_facts *facts = &p->facts;
    facts->area_m2 = facts->volume_m3 = (murk_estimate){NAN, NAN};
    murk_target_draw drawn = {0};
    murk_status status = MURK_OK;
    /* Listed points. */
    if (settings->points) {
        status = murk_targets_read(&p->surface, &p->volume, &facts->points,
                                   source.stage, err);
    }
    /* Points on surfaces. */
    if (!status && settings->has_surfaces) {
        status = murk_targets_draw_surfaces(&p->surface, &drawn, &source, err);
        facts->area_m2 = drawn.size;
        facts->points += drawn.points;
        source.first_number = facts->points;
    }
    /* Points in the volume, numbered after those on surfaces. */
    if (!status && settings->has_volume) {
        status = murk_targets_draw_volume(&p->volume, &drawn, &source, err);
        facts->volume_m3 = drawn.size;
        facts->points += drawn.points;
    }
    facts->surface = p->surface.n;
    facts->volume = p->volume.n;
    return status;
}

murk_status murk_targets_create(murk_targets *out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err)
{
    *out = (murk_targets){0};
    target_records p = {0};
    const murk_target_source source = {.stage = stage,
                                       .stream = stream,
                                       .threads = threads,
                                       .max = UINT64_MAX};
    murk_status status = fill(&p, source, err);
    if (!status) { /* the map takes the records over, also when it fails */
        status = murk_photon_map_create(&out->surface, p.surface.photon,
                                        p.surface.n, threads, err);
        p.surface.photon = NULL;
    }
    if (!status) {
        status = murk_photon_map_create(&out->volume, p.volume.photon,
                                        p.volume.n, threads, err);
        p.volume.photon = NULL;
    }
    free(p.surface.photon);
    free(p.volume.photon);
    out->facts = p.facts;
    out->independent =
        stage->scene->placement.targets.points ? 1 : p.facts.points;
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
    target_records p = {0};
    const murk_target_source source = {
        .stage = stage, .threads = threads, .max = CHECK_KEEPS};
    const murk_status status = fill(&p, source, err);
    free(p.surface.photon);
    free(p.volume.photon);
    return status;
}
