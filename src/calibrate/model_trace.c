/* Creates the forward model and traces the light of all conditions: chooses the
 * media whose density paths must be recorded, divides photons into batches and
 * runs, forecasts memory, and computes slopes of world keys. */
#include "calibrate/model_parts.h"

#include "base/log.h"
#include "base/machine.h"
#include "base/progress.h"
#include "calibrate/beams.h"
#include "calibrate/world_slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Batches of photons. The covariance of rows is singular, or too small, unless
 * there are many more batches than rows; BATCHES_MIN is the least that is
 * accepted, BATCH_SUMS_MAX limits batches * rows (256 MiB). */
#define BATCHES_MAX    4096
#define BATCHES_MIN    100
#define BATCH_SUMS_MAX (UINT64_C(1) << 25)

/* Warn if photon paths have fewer chords than this in a receiver: the standard
 * error itself is then uncertain by more than 10 %. */
#define PHOTONS_FEW 50

/* Largest number of runs of photons, from which the noise of slopes is
 * estimated. The covariance of slopes is not inverted, so fewer runs than
 * batches suffice. */
#define RUNS_MAX 256

void murk_model_destroy(murk_model *m)
{
    if (!m) {
        return;
    }
    for (size_t c = 0; c < m->worlds; ++c) {
        murk_model_world *w = &m->world[c];
        murk_lighting_rows_release(&w->rows);
        murk_lighting_release(&w->lighting);
        murk_instruments_release(&w->instruments);
        murk_scene_desc_destroy(w->scene);
    }
    murk_arena_release(&m->arena);
    free(m);
}

/* True if extinction or albedo of a medium differ. */
static bool differs(const murk_optics *a, const murk_optics *b, size_t medium)
{
    return memcmp(&a->extinction_per_m[medium], &b->extinction_per_m[medium],
                  sizeof a->extinction_per_m[medium]) != 0 ||
           memcmp(&a->albedo[medium], &b->albedo[medium],
                  sizeof a->albedo[medium]) != 0;
}

/* Finds the media that some key re-weights, whether cosines are needed, and
 * whether keys change the world. */
static murk_status choose_media(murk_model *m, size_t c, const double *value,
                                murk_error *err)
{
    murk_model_world *w = &m->world[c];
    const size_t n_media = w->scene->n_media;
    const murk_free_key *key = m->desc.keys->key;
    murk_optics_sides *side = NULL;
    /* Optics at two values of each key. */
    murk_status status = murk_model_sides(&side, m, c, value, err);
    w->medium = murk_arena_array(&m->arena, n_media, sizeof *w->medium);
    if (!status && !w->medium) {
        status = murk_model_no_memory(err);
    }
    w->desc.medium = w->medium;
    /* A medium is recorded if a key changes its extinction or albedo, or if a
     * key changes the phase function of any medium. */
    for (size_t i = 0; i < n_media && !status; ++i) {
        bool is_recorded = false;
        for (size_t k = 0; k < m->n; ++k) {
            is_recorded =
                is_recorded ||
                (side[k].low &&
                 (differs(side[k].low, side[k].high, i) || key[k].turns_phase));
        }
        if (is_recorded) {
            w->medium[w->desc.media++] = i;
        }
    }
    /* Cosines and world keys. */
    for (size_t k = 0; k < m->n && !status; ++k) {
        w->desc.keeps_cosines |= side[k].low && key[k].turns_phase;
        w->has_world_keys |= murk_model_changes_world(m, k, c);
    }
    murk_model_sides_release(side, m->n);
    return status;
}

/* Prepares one condition. */
static murk_status begin_world(murk_model *m, size_t c, const double *start,
                               murk_error *err)
{
    const murk_free_keys *keys = m->desc.keys;
    murk_model_world *w = &m->world[c];
    murk_status status = murk_free_scene(&w->scene, keys, c, start, err);
    if (status) {
        return status;
    }
    status = murk_instruments_create(&w->instruments, m->desc.measured,
                                     keys->condition[c], err);
    w->desc = (murk_lighting_desc){
        .keys = keys,
        .instruments = &w->instruments,
        .base = murk_imported_stage_of(m->desc.imported, keys->condition[c]),
        .condition = c,
        .threads = m->desc.threads};
    if (!status && w->instruments.lights) {
        status = choose_media(m, c, start, err);
    }
    return status;
}

/* Lists the rows that need light, of all conditions; place[] is the inverse. */
static murk_status list_light_rows(murk_model *m, murk_error *err)
{
    murk_model_facts *facts = &m->facts;
    /* Mark them, then number them in their order. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_instruments *instruments = &m->world[c].instruments;
        for (size_t i = 0; i < instruments->lights; ++i) {
            m->place[instruments->light_row[i]] = 1;
        }
    }
    for (size_t i = 0; i < m->rows; ++i) {
        if (m->place[i]) {
            m->place[i] = facts->lights;
            facts->light[facts->lights++] = i;
        }
    }
    return facts->lights <= MURK_MODEL_LIGHT_ROWS_MAX
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, m->desc.measured->path,
                           "%zu rows of light and coverage, at most %d",
                           facts->lights, MURK_MODEL_LIGHT_ROWS_MAX);
}

/* Determines the number of batches and runs: as many as memory, the limits and
 * the photons permit. */
static murk_status lay_batches(murk_model *m, murk_error *err)
{
    const uint64_t fits = BATCH_SUMS_MAX / (m->facts.lights + 1);
    m->facts.batches = fits < BATCHES_MAX ? (size_t)fits : BATCHES_MAX;
    murk_status status = MURK_OK;
    /* No more batches than photons (or records, if the scene states their
     * number) in any condition. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        const murk_scene_photons *photons = &w->scene->photons;
        const uint64_t emit = photons->store ? photons->store : photons->emit;
        if (w->instruments.lights && emit < BATCHES_MIN) {
            return murk_fail(err, MURK_BAD_VALUE, w->scene->path,
                             "photons.emit: %llu, must be %d or more for a fit",
                             (unsigned long long)emit, BATCHES_MIN);
        }
        if (w->instruments.lights && w->scene->continues) {
            /* The amount of light that enters through the sides would depend on
             * the medium, and recorded paths do not contain that dependence. */
            return murk_fail(err, MURK_UNSUPPORTED, w->scene->domain_where,
                             "outside: continued does not go with fits, use "
                             "sides: periodic or outside: empty");
        }
        if (w->instruments.lights && emit < m->facts.batches) {
            m->facts.batches = (size_t)emit;
        }
    }
    /* Runs divide batches. */
    m->facts.runs = m->facts.batches < RUNS_MAX ? m->facts.batches : RUNS_MAX;
    m->facts.batches -= m->facts.batches % m->facts.runs;
    /* Allocate the rows. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        w->desc.batches = m->facts.batches;
        w->desc.runs = m->facts.runs;
        if (w->instruments.lights) {
            w->world_slope =
                murk_arena_array(&m->arena, w->instruments.lights * m->n,
                                 sizeof *w->world_slope);
            status =
                w->world_slope
                    ? murk_lighting_rows_create(&w->rows, &w->desc, m->n, err)
                    : murk_model_no_memory(err);
        }
    }
    return status;
}

/* Fills the model. */
static murk_status fill(murk_model *m, murk_error *err)
{
    const murk_free_keys *keys = m->desc.keys;
    murk_arena *arena = &m->arena;
    double **const of_n[] = {&m->traced, &m->slope_off, &m->slope_size,
                             &m->moved, &m->beside};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; ++i) {
        *of_n[i] = murk_arena_array(arena, m->n, sizeof(double));
    }
    m->world = murk_arena_array(arena, keys->conditions, sizeof *m->world);
    m->factor = murk_arena_array(arena, m->rows, sizeof *m->factor);
    m->gain_key = murk_arena_array(arena, m->rows, sizeof *m->gain_key);
    m->facts.light = murk_arena_array(arena, m->rows, sizeof *m->facts.light);
    m->place = murk_arena_array(arena, m->rows, sizeof *m->place);
    murk_status status = arena->is_short ? murk_model_no_memory(err) : MURK_OK;
    /* Prepare the conditions at the start values. */
    for (size_t k = 0; k < m->n && !status; ++k) {
        m->moved[k] = keys->key[k].start;
    }
    for (size_t c = 0; c < keys->conditions && !status; ++c) {
        m->worlds = c + 1;
        status = begin_world(m, c, m->moved, err);
    }
    status = status ? status : list_light_rows(m, err);
    return status ? status : lay_batches(m, err);
}

murk_status murk_model_create(murk_model **out, const murk_model_desc *desc,
                              murk_error *err)
{
    murk_model *m = calloc(1, sizeof *m);
    if (!m) {
        return murk_model_no_memory(err);
    }
    m->desc = *desc;
    m->n = desc->keys->n;
    m->rows = desc->measured->rows;
    const murk_status status = fill(m, err);
    if (status) {
        murk_model_destroy(m);
        return status;
    }
    *out = m;
    return MURK_OK;
}

/* Computes the slopes of the rows of one condition with respect to world keys.
 */
static murk_status slopes_of_world(murk_model *m, size_t c, murk_error *err)
{
    murk_model_world *w = &m->world[c];
    const size_t lights = w->instruments.lights;
    double *slope = calloc(2 * lights + 1, sizeof *slope);
    murk_status status = slope ? MURK_OK : murk_model_no_memory(err);
    for (size_t k = 0; k < m->n && !status; ++k) {
        if (!murk_model_changes_world(m, k, c)) {
            continue;
        }
        status = murk_world_slopes(slope, slope + lights, &w->desc,
                                   m->desc.measured, k, m->traced, err);
        m->facts.traces += MURK_WORLD_SLOPE_TRACES;
        for (size_t i = 0; i < lights && !status; ++i) {
            const double error = slope[lights + i];
            w->world_slope[i * m->n + k] = slope[i];
            m->slope_size[k] += slope[i] * slope[i];
            m->slope_off[k] += error * error;
        }
    }
    free(slope);
    return status;
}

/* Warns of receivers that few photons cross: their value and their error are
 * then unreliable. */
static void warn_of_few(const murk_model *m, const murk_model_world *w)
{
    const murk_histories *f = w->lighting.histories;
    /* Count the chords of each receiver. */
    size_t *photons = calloc(w->instruments.receivers + 1, sizeof *photons);
    for (size_t i = 0; photons && i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        photons[murk_contribution_is_record(c) ? w->instruments.receivers
                                               : c->receiver]++;
    }
    /* Find the receivers with few. */
    size_t few = 0, first = 0;
    for (size_t i = 0; photons && i < w->instruments.receivers; ++i) {
        if (photons[i] < PHOTONS_FEW) {
            first = few++ ? first : i;
        }
    }
    if (few) {
        const murk_reading *reading = murk_reading_of_row(
            m->desc.measured, w->instruments.light_row[first]);
        murk_warn(
            m->desc.measured->path,
            "line %zu%s: %zu photons pass its sphere, from which neither "
            "its value nor its noise can be told: take a larger radius_m, "
            "or more photons",
            reading->line, few > 1 ? ", and others" : "", photons[first]);
    }
    free(photons);
}

/* Forecasts the memory of the fit, and fails if less is free. */
static murk_status forecast_memory(murk_model *m, murk_error *err)
{
    murk_fit_forecast forecast;
    const murk_status status = murk_model_forecast(&forecast, m, err);
    if (status) {
        return status;
    }
    m->facts.memory_bytes = forecast.bytes;
    const double have = murk_machine_memory_bytes();
    if (m->desc.forecast) {
        m->desc.forecast(m->desc.context, forecast.bytes, have);
    }
    return forecast.bytes <= have
               ? MURK_OK
               : murk_fail(
                     err, MURK_BAD_VALUE, m->world[0].scene->photons.where,
                     "the fit would keep about %.3g contributions of "
                     "light and take %.3g GB, must be at most the %.3g "
                     "GB that are free: fewer photons, receivers, "
                     "sensors or free keys",
                     forecast.contributions, forecast.bytes / 1e9, have / 1e9);
}

/* Builds the worlds of all conditions, without light. */
static murk_status build_worlds(murk_model *m, const double *value,
                                murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t c = 0; c < m->worlds; ++c) { /* release the old worlds first, to
                                              * save memory */
        murk_lighting_release(&m->world[c].lighting);
        murk_reweighed_release(&m->world[c].rows.reweighed);
    }
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        status = murk_lighting_build(&w->lighting, &w->desc, value, err);
        if (!status) {
            status = murk_beams_check(w->lighting.stage, m->desc.measured,
                                      m->desc.keys->condition[c], err);
        }
        if (!status) {
            murk_instruments_warn_of_cut(&w->instruments, m->desc.measured,
                                         w->lighting.stage->surfaces);
        }
    }
    return status;
}

/* Traces the light of one condition, and computes the slopes of world keys;
 * does nothing if no row of the condition needs light. */
static murk_status trace_world(murk_model *m, size_t c, murk_error *err)
{
    murk_model_world *w = &m->world[c];
    if (!w->instruments.lights) {
        return MURK_OK;
    }
    murk_status status = murk_lighting_trace(&w->lighting, 0, err);
    if (!status) {
        ++m->facts.traces;
        m->facts.photons = w->lighting.histories->emitted;
        warn_of_few(m, w);
    }
    if (!status && w->has_world_keys) {
        const murk_warn_sink before = murk_warn_to(NULL);
        status = slopes_of_world(m, c, err);
        (void)murk_warn_to(before);
    }
    return status;
}

murk_status murk_model_trace(murk_model *m, const double *value,
                             murk_error *err)
{
    /* Warnings about the worlds are told until a trace has succeeded. */
    const murk_warn_sink sink = m->was_built ? murk_warn_to(NULL) : NULL;
    memcpy(m->traced, value, m->n * sizeof *value);
    for (size_t k = 0; k < m->n; ++k) {
        m->slope_off[k] = m->slope_size[k] = 0;
    }
    /* Build, forecast, trace. */
    const double begun_s = murk_clock_s();
    murk_status status = build_worlds(m, value, err);
    if (!status && !m->was_built) {
        status = forecast_memory(m, err);
    }
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        status = trace_world(m, c, err);
    }
    m->facts.trace_s += murk_clock_s() - begun_s;
    if (m->was_built) {
        (void)murk_warn_to(sink);
    }
    m->was_built = m->was_built || !status;
    return status;
}

const murk_model_facts *murk_model_facts_of(const murk_model *m)
{
    return &m->facts;
}

const murk_stage *murk_model_stage(const murk_model *m, size_t c)
{
    return m->world[c].lighting.stage;
}

double murk_model_slope_error(const murk_model *m, size_t key)
{
    return m->slope_size[key] > 0 ? sqrt(m->slope_off[key] / m->slope_size[key])
                                  : NAN;
}
