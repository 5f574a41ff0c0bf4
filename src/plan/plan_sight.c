/* Creates the sight of the sensors of a scene: the sensor types, the media and
 * surfaces of the stage, and the records to be covered, which are photons,
 * targets or given points. */
#include "plan/plan.h"

#include "base/log.h"
#include "sensing/coverage_stream.h"

#include <stdlib.h>
#include <string.h>

/* The records that sensors cover (traced light, targets or given points), and
 * the number of emitted photons or of independent points. */
typedef struct seen_maps {
    const murk_photon_map *surface, *volume;
    uint64_t emitted;
} seen_maps;

/* Largest radius of density estimates as a fraction of the diagonal of the
 * domain, if the scene leaves the radius to murk: the radius then depends on
 * the neighbours, and this limit keeps estimates local. */
#define POWER_RADIUS 0.1

/* Warn if more than this share of the photons or targets have an estimate from
 * fewer than MURK_POWER_FEW neighbours. The share is a choice. */
#define FEW_SHARE 0.05

double murk_plan_power_radius_m(const murk_stage *stage)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    const murk_domain *domain = &stage->world.domain;
    const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
    if (!murk_detection_is(settings->detection, MURK_DETECTION_BY_POWER)) {
        return 0;
    }
    if (settings->power_radius_m > 0) {
        return settings->power_radius_m;
    }
    const double own = POWER_RADIUS * murk_length(size);
    return domain->is_periodic ? fmin(own, fmin(size.x, size.y) / 2) : own;
}

size_t murk_plan_power_neighbours(const murk_stage *stage)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    return murk_detection_is(settings->detection, MURK_DETECTION_BY_POWER) &&
                   !(settings->power_radius_m > 0)
               ? (size_t)settings->power_neighbours
               : 0;
}

static murk_power_settings power_of(const murk_stage *stage,
                                    const murk_traced *traced)
{
    murk_power_settings out = {
        .radius_m = murk_plan_power_radius_m(stage),
        .neighbours = murk_plan_power_neighbours(stage),
        .light = {traced->surface, traced->volume, traced->emitted}};
    memcpy(out.band_nm, stage->scene->band_nm, sizeof out.band_nm);
    return out;
}

/* Warns if more than FEW_SHARE of all photons or targets have a density
 * estimate from few neighbours; `all` is the number of photons or targets. Only
 * for stream 0, because other streams are statistically equal. */
static void warn_of_few(const murk_sight *sight, const murk_stage *stage,
                        const murk_traced *traced, size_t all)
{
    const size_t few = murk_sight_power_few(sight);
    if (traced->stream == 0 && (double)few > FEW_SHARE * (double)all) {
        murk_warn(stage->scene->placement.where,
                  "detection: power: %zu of %zu photons (%.0f %%) have fewer "
                  "than %d neighbours within %g m and are judged badly: more "
                  "photons or a larger power_radius_m",
                  few, all, 100 * (double)few / (double)all, MURK_POWER_FEW,
                  murk_plan_power_radius_m(stage));
    }
}

/* The part of the description of sight that is the same for photons, targets
 * and points. Weights are balanced and the redundancy is 1; regions of
 * interest, at_least and the settings of detection by power are empty. */
static murk_sight_desc describe(const murk_stage *stage, const seen_maps *maps,
                                unsigned threads)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    return (murk_sight_desc){
        .surfaces = stage->surfaces,
        .media = stage->media,
        .boundary_meshes = stage->boundary_meshes,
        .domain = stage->world.domain,
        .surface_map = maps->surface,
        .volume_map = maps->volume,
        .photons_emitted = maps->emitted,
        .types = stage->scene->sensors.types,
        .north = stage->scene->north,
        .visibility =
            settings->by_normal ? MURK_VISIBILITY_NORMAL : MURK_VISIBILITY_RAY,
        .through_sheets = settings->through != MURK_SCENE_BLOCK,
        .refracts = settings->through == MURK_SCENE_REFRACT,
        .weights = {.balanced = true},
        .detection = settings->detection,
        .threshold = settings->threshold,
        .redundancy = 1,
        .threads = threads,
        .where = settings->where};
}

/* Creates a sight with the sensor types of the scene. If are_points is set, no
 * type selects records by arrival direction, because points have none. */
static murk_status create(murk_sight **out, const murk_stage *stage,
                          murk_sight_desc *desc, bool are_points,
                          murk_error *err)
{
    murk_sensor_type *types = murk_poses_types(stage->scene);
    if (!types) {
        return murk_no_memory(err, stage->scene->sensors.where,
                              "for the sensors' types");
    }
    for (size_t k = 0; k < desc->types && are_points; ++k) {
        types[k].toward = false;
    }
    desc->type = types;
    const murk_status status = murk_sight_create(out, desc, err);
    free(types);
    return status;
}

/* The description of the sight onto photons or targets: with the weights, the
 * regions of interest, the redundancy and at_least of the scene. */
static murk_sight_desc describe_onto(const murk_stage *stage,
                                     const seen_maps *maps, unsigned threads)
{
    const murk_scene_placement *settings = &stage->scene->placement;
    murk_sight_desc desc = describe(stage, maps, threads);
    desc.weights = (murk_map_weights){.balanced = settings->balanced,
                                      .surface = settings->weight_surface,
                                      .volume = settings->weight_volume};
    desc.interest = murk_goals_interest(stage->goals);
    desc.combining = murk_combining_of(settings->detection);
    desc.redundancy = (unsigned)settings->redundancy;
    desc.at_least = (unsigned)murk_plan_at_least(stage->scene);
    return desc;
}

/* Creates the sight onto photons or targets, with the settings of detection by
 * power of the scene. Warns, if asked to, of density estimates from few
 * neighbours. */
static murk_status sight_onto(murk_sight **out, const murk_stage *stage,
                              const murk_traced *traced, const seen_maps *maps,
                              unsigned threads, bool warns, murk_error *err)
{
    murk_sight_desc desc = describe_onto(stage, maps, threads);
    desc.power = power_of(stage, traced);
    const murk_status status = create(out, stage, &desc, false, err);
    if (!status && warns) {
        warn_of_few(*out, stage, traced,
                    murk_photon_map_count(maps->surface) +
                        murk_photon_map_count(maps->volume));
    }
    return status;
}

murk_status murk_plan_sight_points(murk_sight **out, const murk_stage *stage,
                                   const murk_photon_map *surface,
                                   const murk_photon_map *volume,
                                   uint64_t numbers, unsigned threads,
                                   murk_error *err)
{
    const seen_maps maps = {surface, volume, numbers};
    murk_sight_desc desc = describe(stage, &maps, threads);
    return create(out, stage, &desc, true, err);
}

static murk_status make_sight(murk_sight **out, murk_target_facts *facts,
                              const murk_stage *stage,
                              const murk_traced *traced, unsigned threads,
                              bool warns, murk_error *err)
{
    /* The records are those of the light, or targets. */
    murk_targets targets = {0};
    murk_sight *sight = NULL;
    murk_status status = MURK_OK;
    seen_maps maps = {traced->surface, traced->volume, traced->emitted};
    const bool has_targets = stage->scene->placement.targets.given;
    if (has_targets) {
        status =
            murk_targets_create(&targets, stage, traced->stream, threads, err);
        maps =
            (seen_maps){targets.surface, targets.volume, targets.independent};
    }
    *facts = targets.facts;
    /* Create the sight, which then owns the maps of targets. */
    if (!status) {
        status = sight_onto(&sight, stage, traced, &maps, threads, warns, err);
    }
    if (!status && has_targets) {
        murk_sight_own_maps(sight, targets.surface, targets.volume);
        targets = (murk_targets){0};
    }
    if (!status) {
        *out = sight;
        sight = NULL;
    }
    murk_sight_destroy(sight);
    murk_targets_release(&targets);
    return status;
}

murk_status murk_plan_sight_and_targets(murk_sight **out,
                                        murk_target_facts *facts,
                                        const murk_stage *stage,
                                        const murk_traced *traced,
                                        unsigned threads, murk_error *err)
{
    return make_sight(out, facts, stage, traced, threads, true, err);
}

murk_status murk_plan_sight(murk_sight **out, const murk_stage *stage,
                            const murk_traced *traced, unsigned threads,
                            murk_error *err)
{
    murk_target_facts facts;
    return make_sight(out, &facts, stage, traced, threads, true, err);
}

murk_status murk_plan_sight_again(murk_sight **out, const murk_stage *stage,
                                  const murk_traced *traced, unsigned threads,
                                  murk_error *err)
{
    murk_target_facts facts;
    return make_sight(out, &facts, stage, traced, threads, false, err);
}

/* ---- photons that are not stored ---- */

bool murk_plan_can_stream(const murk_stage *stage)
{
    const seen_maps none = {0};
    murk_sight_desc desc = describe_onto(stage, &none, 1);
    desc.power.radius_m = murk_plan_power_radius_m(stage);
    return !stage->scene->placement.targets.given &&
           murk_coverage_can_stream(&desc);
}

/* A murk_record_batch_sink. */
static murk_status add_batch(void *context, const murk_record_batch *batch,
                             murk_error *err)
{
    return murk_coverage_stream_add(context, batch->surface, batch->n_surface,
                                    batch->volume, batch->n_volume, err);
}

murk_status murk_plan_measure_streamed(murk_coverage_result *out,
                                       double *trace_s, const murk_stage *stage,
                                       uint32_t stream, const murk_pose *sensor,
                                       size_t n, size_t expected,
                                       const murk_passed_light *earlier,
                                       murk_passed_light *passed,
                                       unsigned threads, murk_error *err)
{
    const seen_maps none = {0};
    murk_sight_desc desc = describe_onto(stage, &none, threads);
    murk_sensor_type *types = murk_poses_types(stage->scene);
    murk_coverage_stream *coverage = NULL;
    murk_passed_light light = {0};
    if (!types) {
        return murk_no_memory(err, stage->scene->sensors.where,
                              "for the sensors' types");
    }
    desc.type = types;
    /* Test the photons while they are traced, or taken over. */
    const double bytes_each = murk_coverage_stream_bytes(desc.redundancy);
    murk_status status =
        murk_coverage_stream_create(&coverage, &desc, sensor, n, expected, err);
    if (!status && passed) {
        status = murk_lightmap_update_passed(
            &light, stage, stream, earlier, threads,
            bytes_each + sizeof(murk_photon), add_batch, coverage, err);
    } else if (!status) {
        status = murk_lightmap_pass(&light.traced, stage, stream, threads,
                                    bytes_each, add_batch, coverage, NULL, err);
    }
    const murk_traced *traced = light.traced;
    /* Sum up. With photons.emit records come in watts. */
    if (!status) {
        *trace_s += traced->trace_s;
        status = murk_coverage_stream_end(
            out, coverage, stage->scene->photons.emit ? NULL : traced->packet_w,
            stage->scene->bands, traced->emitted, err);
    }
    if (!status && passed) {
        *passed = light;
        light = (murk_passed_light){0};
    }
    murk_passed_light_release(&light);
    murk_coverage_stream_destroy(coverage);
    free(types);
    return status;
}
