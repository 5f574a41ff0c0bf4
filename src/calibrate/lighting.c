/* Builds and traces the world of one condition, and evaluates the rows that
 * need light by re-weighting: receivers (calibrate/reweigh.h) and groups of
 * coverage (calibrate/covered.h). */
#include "calibrate/lit.h"

#include "base/interrupt.h"
#include "world/stage_build.h"
#include "world/units.h"

#include <stdlib.h>

/* Fills the factors from watts to the unit of each receiver, for each light
 * source and band. */
static murk_status count_watts(murk_lit *lit, murk_error *err)
{
    const murk_instruments *instruments = lit->desc->instruments;
    const size_t lights = lit->scene->n_lights;
    lit->per_watt =
        calloc(instruments->receivers * lights + 1, sizeof *lit->per_watt);
    if (!lit->per_watt) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for receivers");
    }
    for (size_t i = 0; i < instruments->receivers * lights; ++i) {
        for (int b = 0; b < lit->scene->bands; ++b) {
            lit->per_watt[i].band[b] = murk_units_per_watt(
                instruments->quantity[i / lights], lit->stage, i % lights, b);
        }
    }
    return MURK_OK;
}

/* Traces the light and finds the sightlines. */
static murk_status follow(murk_lit *lit, uint64_t photons, murk_error *err)
{
    const murk_lit_desc *d = lit->desc;
    const murk_instruments *instruments = d->instruments;
    /* Trace. */
    const murk_followed_desc followed = {.stage = lit->stage,
                                         .photons = photons,
                                         .threads = d->threads,
                                         .medium = d->medium,
                                         .media = d->media,
                                         .keeps_cosines = d->keeps_cosines,
                                         .receiver = instruments->receiver,
                                         .receivers = instruments->receivers,
                                         .keeps_records =
                                             instruments->groups > 0};
    murk_status status = murk_followed_trace(&lit->followed, &followed, err);
    if (!status) {
        status = count_watts(lit, err);
    }
    /* Find sightlines, if there are rows of coverage. */
    if (!status && instruments->groups) {
        const murk_covered_desc covered = {.stage = lit->stage,
                                           .followed = lit->followed,
                                           .pose = instruments->pose,
                                           .group = instruments->group,
                                           .poses = instruments->poses,
                                           .groups = instruments->groups,
                                           .threads = d->threads};
        status = murk_covered_create(&lit->covered, &covered, err);
    }
    return status;
}

murk_status murk_lit_build(murk_lit *out, const murk_lit_desc *desc,
                           const double *value, murk_error *err)
{
    *out = (murk_lit){.desc = desc};
    const murk_free_keys *keys = desc->keys;
    murk_status status =
        murk_free_scene(&out->scene, keys, desc->condition, value, err);
    if (!status) {
        status =
            murk_stage_import_beside(&out->stage, out->scene, desc->base, err);
    }
    if (!status) {
        status = murk_stage_build(out->stage, err);
    }
    if (!status) {
        status =
            murk_free_optics(&out->optics, keys, desc->condition, value, err);
    }
    return status;
}

murk_status murk_lit_light(murk_lit *lit, uint64_t photons, murk_error *err)
{
    return lit->desc->instruments->lit ? follow(lit, photons, err) : MURK_OK;
}

murk_status murk_lit_create(murk_lit *out, const murk_lit_desc *desc,
                            const double *value, murk_error *err)
{
    const murk_status status = murk_lit_build(out, desc, value, err);
    return status ? status : murk_lit_light(out, 0, err);
}

void murk_lit_darken(murk_lit *lit)
{
    free(lit->per_watt);
    murk_covered_destroy(lit->covered);
    murk_followed_destroy(lit->followed);
    lit->per_watt = NULL;
    lit->covered = NULL;
    lit->followed = NULL;
}

void murk_lit_release(murk_lit *lit)
{
    murk_lit_darken(lit);
    murk_optics_destroy(lit->optics);
    murk_stage_destroy(lit->stage);
    murk_scene_desc_destroy(lit->scene);
    *lit = (murk_lit){0};
}

murk_status murk_lit_rows_create(murk_lit_rows *out, const murk_lit_desc *desc,
                                 size_t keys, murk_error *err)
{
    const size_t lit = desc->instruments->lit + 1;
    *out = (murk_lit_rows){
        .value = calloc(lit, sizeof *out->value),
        .slope = calloc(lit * (keys + 1), sizeof *out->slope),
        .batch = calloc(lit * desc->batches, sizeof *out->batch),
        .run = calloc(lit * desc->runs * (keys + 1), sizeof *out->run)};
    return out->value && out->slope && out->batch && out->run
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory for %zu rows of light",
                           desc->instruments->lit);
}

void murk_lit_rows_release(murk_lit_rows *rows)
{
    free(rows->value);
    free(rows->slope);
    free(rows->batch);
    free(rows->run);
    murk_reweighed_release(&rows->reweighed);
    *rows = (murk_lit_rows){0};
}

/* Copies the contributions of the runs for n rows from index `first` on to
 * their place among all rows. */
static void place_runs(murk_lit_rows *out, const murk_lit_desc *desc,
                       const double *run, size_t first, size_t n, size_t keys,
                       const double *scale)
{
    for (size_t r = 0; r < desc->runs; ++r) {
        for (size_t i = 0; i < n; ++i) {
            double *to =
                out->run + (r * desc->instruments->lit + first + i) * keys;
            for (size_t k = 0; k < keys; ++k) {
                to[k] = run[(r * n + i) * keys + k] * (scale ? scale[i] : 1);
            }
        }
    }
}

/* Converts coverage, a fraction, to the unit of the row, which may be percent.
 */
static void turn_groups(murk_lit_rows *out, const murk_lit_desc *desc,
                        const murk_measurements *measured, const double *batch,
                        double *scale, size_t keys)
{
    const murk_instruments *instruments = desc->instruments;
    for (size_t g = 0; g < instruments->groups; ++g) {
        const size_t i = instruments->receivers + g;
        const murk_measured_row *row = &measured->row[instruments->lit_row[i]];
        double slope;
        out->value[i] = murk_reading_in_unit(measured->reading[row->first].unit,
                                             out->value[i], 1, &slope);
        scale[g] = slope;
        for (size_t k = 0; k < keys; ++k) {
            out->slope[i * keys + k] *= slope;
        }
        for (size_t b = 0; b < desc->batches; ++b) {
            out->batch[b * instruments->lit + i] =
                batch[b * instruments->groups + g] * slope;
        }
    }
}

static murk_status read_groups(murk_lit_rows *out, const murk_lit *lit,
                               const murk_reweighed *reweighed,
                               const murk_measurements *measured,
                               const murk_optics *at,
                               const murk_optics_sides *sides, size_t keys,
                               murk_error *err)
{
    const murk_lit_desc *d = lit->desc;
    const size_t first = d->instruments->receivers,
                 groups = d->instruments->groups;
    /* Evaluate. */
    double *batch = calloc((d->batches + 1) * groups, sizeof *batch);
    double *run = calloc(d->runs * groups * (keys + 1), sizeof *run);
    murk_status status = MURK_OK;
    if (!batch || !run) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for coverage");
    } else {
        status = murk_covered_read(
            out->value + first, out->slope + first * keys, batch, d->batches,
            keys ? run : NULL, d->runs, lit->covered, reweighed, lit->optics,
            at, sides, keys, err);
    }
    /* Convert, and copy into place. */
    if (!status) {
        double *scale = batch + d->batches * groups;
        turn_groups(out, d, measured, batch, scale, keys);
        place_runs(out, d, run, first, groups, keys, scale);
    }
    free(batch);
    free(run);
    return status;
}

static murk_status read_receivers(murk_lit_rows *out, const murk_lit *lit,
                                  const murk_reweighed *reweighed,
                                  murk_error *err)
{
    const murk_lit_desc *d = lit->desc;
    const murk_instruments *instruments = d->instruments;
    const size_t keys = reweighed->keys;
    double *batch = calloc(d->batches * instruments->receivers, sizeof *batch);
    double *run =
        calloc(d->runs * instruments->receivers * (keys + 1), sizeof *run);
    if (!batch || !run) {
        free(batch);
        free(run);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for receivers");
    }
    /* Evaluate, then copy runs and batches into place. */
    murk_receivers_read(out->value, out->slope, batch, d->batches, run, d->runs,
                        instruments->receiver, lit->per_watt,
                        instruments->receivers, lit->followed, reweighed,
                        d->threads);
    place_runs(out, d, run, 0, instruments->receivers, keys, NULL);
    free(run);
    for (size_t b = 0; b < d->batches; ++b) {
        for (size_t i = 0; i < instruments->receivers; ++i) {
            out->batch[b * instruments->lit + i] =
                batch[b * instruments->receivers + i];
        }
    }
    free(batch);
    return murk_interrupted()
               ? murk_fail(err, MURK_INTERRUPTED, "", "interrupted")
               : MURK_OK;
}

murk_status murk_lit_read(murk_lit_rows *out, const murk_lit *lit,
                          const murk_measurements *measured,
                          const murk_optics *at, const murk_optics_sides *sides,
                          size_t keys, murk_error *err)
{
    murk_reweighed *reweighed = &out->reweighed;
    murk_status status =
        murk_reweigh_again(reweighed, lit->followed, lit->optics, at, sides,
                           keys, lit->desc->threads, err);
    out->share = status ? 0 : reweighed->effective_share;
    if (!status && lit->desc->instruments->receivers) {
        status = read_receivers(out, lit, reweighed, err);
    }
    if (!status && lit->desc->instruments->groups) {
        status =
            read_groups(out, lit, reweighed, measured, at, sides, keys, err);
    }
    return status;
}
