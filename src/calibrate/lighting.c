/* Builds and traces the world of one condition, and evaluates the rows that
 * need light by re-weighting: receivers (calibrate/reweigh.h) and groups of
 * coverage (calibrate/covered.h). */
#include "calibrate/lighting.h"

#include "world/stage_build.h"
#include "world/units.h"

#include <stdlib.h>

/* Fills the factors from watts to the unit of each receiver, for each light
 * source and band. */
static murk_status count_watts(murk_lighting *l, murk_error *err)
{
    const murk_instruments *instruments = l->desc->instruments;
    const size_t sources = l->scene->n_lights;
    l->per_watt =
        calloc(instruments->receivers * sources + 1, sizeof *l->per_watt);
    if (!l->per_watt) {
        return murk_no_memory(err, "", "for receivers");
    }
    for (size_t i = 0; i < instruments->receivers * sources; ++i) {
        for (int b = 0; b < l->scene->bands; ++b) {
            l->per_watt[i].band[b] = murk_units_per_watt(
                instruments->quantity[i / sources], l->stage, i % sources, b);
        }
    }
    return MURK_OK;
}

murk_status murk_lighting_build(murk_lighting *out,
                                const murk_lighting_desc *desc,
                                const double *value, murk_error *err)
{
    *out = (murk_lighting){.desc = desc};
    const murk_free_keys *keys = desc->keys;
    murk_status status =
        murk_free_scene(&out->scene, keys, desc->condition, value, err);
    if (status ||
        (status = murk_stage_import_beside(&out->stage, out->scene, desc->base,
                                           err)) ||
        (status = murk_stage_build(out->stage, err))) {
        return status;
    }
    return murk_free_optics(&out->optics, keys, desc->condition, value, err);
}

murk_status murk_lighting_trace(murk_lighting *l, uint64_t photons,
                                murk_error *err)
{
    const murk_lighting_desc *d = l->desc;
    const murk_instruments *instruments = d->instruments;
    if (!instruments->lights) {
        return MURK_OK;
    }
    /* Trace. */
    const murk_histories_desc histories = {.stage = l->stage,
                                           .photons = photons,
                                           .threads = d->threads,
                                           .medium = d->medium,
                                           .media = d->media,
                                           .keeps_cosines = d->keeps_cosines,
                                           .receiver = instruments->receiver,
                                           .receivers = instruments->receivers,
                                           .keeps_records =
                                               instruments->groups > 0};
    murk_status status = murk_histories_trace(&l->histories, &histories, err);
    status = status ? status : count_watts(l, err);
    /* Find sightlines, if there are rows of coverage. */
    if (!status && instruments->groups) {
        const murk_visible_desc visible = {.stage = l->stage,
                                           .optics = l->optics,
                                           .histories = l->histories,
                                           .pose = instruments->pose,
                                           .group = instruments->group,
                                           .poses = instruments->poses,
                                           .groups = instruments->groups,
                                           .threads = d->threads};
        status = murk_covered_create(&l->covered, &visible, err);
    }
    return status;
}

void murk_lighting_darken(murk_lighting *l)
{
    free(l->per_watt);
    murk_covered_destroy(l->covered);
    murk_histories_destroy(l->histories);
    l->per_watt = NULL;
    l->covered = NULL;
    l->histories = NULL;
}

void murk_lighting_release(murk_lighting *l)
{
    murk_lighting_darken(l);
    murk_optics_destroy(l->optics);
    murk_stage_destroy(l->stage);
    murk_scene_desc_destroy(l->scene);
    *l = (murk_lighting){0};
}

murk_status murk_lighting_rows_create(murk_lighting_rows *out,
                                      const murk_lighting_desc *desc,
                                      size_t keys, murk_error *err)
{
    const size_t lights = desc->instruments->lights, size = sizeof(double);
    murk_arena arena = {0};
    *out = (murk_lighting_rows){
        .value = murk_arena_array(&arena, lights, size),
        .slope = murk_arena_array(&arena, lights * keys, size),
        .batch = murk_arena_array(&arena, lights * desc->batches, size),
        .run = murk_arena_array(&arena, lights * desc->runs * keys, size)};
    out->arena = arena;
    return arena.is_short
               ? murk_no_memory(err, "", "for %zu rows of light", lights)
               : MURK_OK;
}

void murk_lighting_rows_release(murk_lighting_rows *rows)
{
    murk_reweighed_release(&rows->reweighed);
    murk_arena_release(&rows->arena);
    *rows = (murk_lighting_rows){0};
}

/* Converts coverage, a fraction, to the unit of the row, which may be percent.
 */
static void convert_groups(const murk_row_sums *sums,
                           const murk_instruments *instruments,
                           const murk_readings *measured, size_t keys)
{
    const size_t lights = instruments->lights;
    for (size_t i = instruments->receivers; i < lights; ++i) {
        const murk_reading *reading =
            murk_reading_of_row(measured, instruments->light_row[i]);
        double slope;
        sums->value[i] =
            murk_reading_in_unit(reading->unit, sums->value[i], 1, &slope);
        for (size_t k = 0; k < keys; ++k) {
            sums->slope[i * keys + k] *= slope;
        }
        for (size_t b = 0; b < sums->batches; ++b) {
            sums->batch[b * lights + i] *= slope;
        }
        for (size_t r = 0; r < sums->runs; ++r) {
            for (size_t k = 0; k < keys; ++k) {
                sums->run[(r * lights + i) * keys + k] *= slope;
            }
        }
    }
}

/* The runs by which ranks divide an evaluation; 0: they do not. */
static size_t divided_runs(const murk_lighting *l, size_t keys)
{
    const murk_lighting_desc *d = l->desc;
    const size_t n = l->histories->n;
    const size_t sums = d->instruments->lights * (d->batches + d->runs * keys);
    return n >= MURK_LIGHTING_DIVIDED && n >= sums / MURK_LIGHTING_SUMS_EACH
               ? d->runs
               : 0;
}

murk_status murk_lighting_read(murk_lighting_rows *out, const murk_lighting *l,
                               const murk_readings *measured,
                               const murk_optics *at,
                               const murk_optics_sides *sides, size_t keys,
                               murk_error *err)
{
    const murk_lighting_desc *d = l->desc;
    const murk_instruments *instruments = d->instruments;
    murk_reweighed *reweighed = &out->reweighed;
    const murk_row_sums sums = {.value = out->value,
                                .slope = out->slope,
                                .batch = out->batch,
                                .run = out->run,
                                .rows = instruments->lights,
                                .batches = d->batches,
                                .runs = d->runs};
    /* Re-weight, then evaluate receivers and coverage. */
    reweighed->runs = divided_runs(l, keys);
    murk_status status = murk_reweigh(reweighed, l->histories, l->optics, at,
                                      sides, keys, d->threads, err);
    out->share = status ? 0 : reweighed->effective_share;
    if (!status && instruments->receivers) {
        status = murk_receivers_read(&sums, instruments->receiver, l->per_watt,
                                     instruments->receivers, l->histories,
                                     reweighed, d->threads, err);
    }
    if (!status && instruments->groups) {
        status = murk_covered_read(&sums, instruments->receivers, l->covered,
                                   reweighed, l->optics, at, sides, err);
        if (!status) {
            convert_groups(&sums, instruments, measured, keys);
        }
    }
    return status;
}
