/* Creates the forward model and traces the light of all conditions: chooses the
 * media whose densities must be recorded, divides photons into batches and
 * runs, forecasts memory, and computes slopes of world keys. */
#include "calibrate/model_parts.h"

#include "base/log.h"
#include "base/machine.h"
#include "base/progress.h"
#include "calibrate/beams.h"
#include "calibrate/fit_forecast.h"
#include "calibrate/world_slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Batches of photons. The covariance of rows is singular, or too small, unless
 * there are many more batches than rows; BATCHES_MIN is the least that is
 * accepted, BATCHES_ROOM limits batches * rows (256 MB). */
#define BATCHES_MAX  4096
#define BATCHES_MIN  100
#define BATCHES_ROOM (UINT64_C(1) << 25)

/* Warn if fewer photons than this cross a receiver: the standard error itself
 * is then uncertain by 10 %. */
#define PHOTONS_FEW 50

/* Runs of photons for the noise of slopes. That covariance is not inverted, so
 * fewer suffice. */
#define RUNS_MAX 256

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the fit's model");
}

static void release_world(murk_model_world *w)
{
    murk_lit_rows_release(&w->rows);
    murk_lit_release(&w->lit);
    murk_instruments_release(&w->instruments);
    murk_scene_desc_destroy(w->scene);
    free(w->medium);
    free(w->world_slope);
}

void murk_model_destroy(murk_model *m)
{
    if (!m) {
        return;
    }
    for (size_t c = 0; c < m->worlds; ++c) {
        release_world(&m->world[c]);
    }
    free(m->world);
    free(m->traced);
    free(m->slope_off);
    free(m->slope_size);
    free(m->factor);
    free(m->gain_key);
    free(m->lit);
    free(m->place);
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
    murk_sides around;
    /* Optics at two values of each key. */
    murk_status status = murk_model_look_around(&around, m, c, value, err);
    w->medium = calloc(n_media + 1, sizeof *w->medium);
    if (!status && !w->medium) {
        status = no_memory(err);
    }
    w->desc.medium = w->medium;
    /* A medium is recorded if a key changes extinction, albedo or phase
     * function. */
    for (size_t i = 0; i < n_media && !status; ++i) {
        bool is_recorded = false;
        for (size_t k = 0; k < m->n; ++k) {
            const murk_optics_sides *side = &around.side[k];
            is_recorded = is_recorded ||
                          (side->low && (differs(side->low, side->high, i) ||
                                         m->desc.keys->key[k].turns_phase));
        }
        if (is_recorded) {
            w->medium[w->desc.media++] = i;
        }
    }
    /* Cosines and world keys. */
    for (size_t k = 0; k < m->n && !status; ++k) {
        w->desc.keeps_cosines =
            w->desc.keeps_cosines ||
            (around.side[k].low && m->desc.keys->key[k].turns_phase);
        w->has_world_keys =
            w->has_world_keys || murk_model_turns_world(m, k, c);
    }
    murk_sides_release(&around, m->n);
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
    w->desc = (murk_lit_desc){
        .keys = keys,
        .instruments = &w->instruments,
        .base = murk_imported_stage_of(m->desc.imported, keys->condition[c]),
        .condition = c,
        .threads = m->desc.threads};
    if (!status && w->instruments.lit) {
        status = choose_media(m, c, start, err);
    }
    return status;
}

static int by_size(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

/* Lists the rows that need light, of all conditions. */
static murk_status list_lit(murk_model *m, murk_error *err)
{
    /* Collect them. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_instruments *instruments = &m->world[c].instruments;
        memcpy(m->lit + m->lits, instruments->lit_row,
               instruments->lit * sizeof *instruments->lit_row);
        m->lits += instruments->lit;
    }
    if (m->lits > MURK_MODEL_LIT_ROWS_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, m->desc.measured->path,
                         "%zu rows of light and coverage, at most %d", m->lits,
                         MURK_MODEL_LIT_ROWS_MAX);
    }
    /* Sort; place[] is the inverse. */
    qsort(m->lit, m->lits, sizeof *m->lit, by_size);
    for (size_t i = 0; i < m->lits; ++i) {
        m->place[m->lit[i]] = i;
    }
    return MURK_OK;
}

/* Determines the number of batches and runs: as many as memory, the limits and
 * the photons permit. */
static murk_status lay_batches(murk_model *m, murk_error *err)
{
    const uint64_t room = BATCHES_ROOM / (m->lits + 1);
    m->batches = room < BATCHES_MAX ? (size_t)room : BATCHES_MAX;
    murk_status status = MURK_OK;
    /* No more batches than photons in any condition. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        const murk_scene_photons *photons = &w->scene->photons;
        const uint64_t emit = photons->store ? photons->store : photons->emit;
        if (w->instruments.lit && emit < BATCHES_MIN) {
            return murk_fail(err, MURK_BAD_VALUE, w->scene->path,
                             "photons.emit: %llu, must be %d or more for a fit",
                             (unsigned long long)emit, BATCHES_MIN);
        }
        if (w->instruments.lit && w->scene->continues) {
            /* The amount of light that enters through the sides would depend on
             * the medium, and recorded paths do not contain that dependence. */
            return murk_fail(err, MURK_UNSUPPORTED, w->scene->domain_where,
                             "outside: continued does not go with fits, use "
                             "sides: periodic or outside: empty");
        }
        if (w->instruments.lit && emit < m->batches) {
            m->batches = (size_t)emit;
        }
    }
    /* Runs divide batches. */
    m->runs = m->batches < RUNS_MAX ? m->batches : RUNS_MAX;
    m->batches -= m->batches % m->runs;
    /* Allocate the rows. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        w->desc.batches = m->batches;
        w->desc.runs = m->runs;
        if (w->instruments.lit) {
            w->world_slope =
                calloc(w->instruments.lit * m->n, sizeof *w->world_slope);
            status = w->world_slope
                         ? murk_lit_rows_create(&w->rows, &w->desc, m->n, err)
                         : no_memory(err);
        }
    }
    return status;
}

/* Fills the model. */
static murk_status fill(murk_model *m, murk_error *err)
{
    const murk_free_keys *keys = m->desc.keys;
    m->world = calloc(keys->conditions + 1, sizeof *m->world);
    m->traced = calloc(m->n + 1, sizeof *m->traced);
    m->slope_off = calloc(m->n + 1, sizeof *m->slope_off);
    m->slope_size = calloc(m->n + 1, sizeof *m->slope_size);
    m->factor = calloc(m->rows + 1, sizeof *m->factor);
    m->gain_key = calloc(m->rows + 1, sizeof *m->gain_key);
    m->lit = calloc(m->rows + 1, sizeof *m->lit);
    m->place = calloc(m->rows + 1, sizeof *m->place);
    /* Allocate. */
    double *start = calloc(m->n + 1, sizeof *start);
    murk_status status = MURK_OK;
    if (!m->world || !m->traced || !m->slope_off || !m->slope_size ||
        !m->factor || !m->gain_key || !m->lit || !m->place || !start) {
        status = no_memory(err);
    }
    /* Prepare the conditions at the start values. */
    for (size_t k = 0; k < m->n && !status; ++k) {
        start[k] = keys->key[k].start;
    }
    for (size_t c = 0; c < keys->conditions && !status; ++c) {
        m->worlds = c + 1;
        status = begin_world(m, c, start, err);
    }
    free(start);
    if (!status) {
        status = list_lit(m, err);
    }
    return status ? status : lay_batches(m, err);
}

murk_status murk_model_create(murk_model **out, const murk_model_desc *desc,
                              murk_error *err)
{
    murk_model *m = calloc(1, sizeof *m);
    if (!m) {
        return no_memory(err);
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
    const size_t lit = w->instruments.lit;
    double *slope = calloc(2 * lit + 1, sizeof *slope), *error = slope + lit;
    murk_status status = slope ? MURK_OK : no_memory(err);
    for (size_t k = 0; k < m->n && !status; ++k) {
        if (!murk_model_turns_world(m, k, c)) {
            continue;
        }
        status = murk_world_slopes(slope, error, &w->desc, m->desc.measured, k,
                                   m->traced, err);
        m->traces += MURK_WORLD_SLOPE_TRACES;
        for (size_t i = 0; i < lit && !status; ++i) {
            w->world_slope[i * m->n + k] = slope[i];
            m->slope_size[k] += slope[i] * slope[i];
            m->slope_off[k] += error[i] * error[i];
        }
    }
    free(slope);
    return status;
}

/* Warns of receivers that few photons cross: their value and their error are
 * then unreliable. */
static void warn_of_few(const murk_model *m, const murk_model_world *w)
{
    const murk_followed *f = w->lit.followed;
    const murk_measurements *measured = m->desc.measured;
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
        const size_t row = w->instruments.lit_row[first];
        murk_warn(
            measured->path,
            "line %zu%s: %zu photons pass its sphere, from which neither "
            "its value nor its noise can be told: take a larger radius_m, "
            "or more photons",
            measured->reading[measured->row[row].first].line,
            few > 1 ? ", and others" : "", photons[first]);
    }
    free(photons);
}

/* Forecasts the memory, and fails if there is less. */
static murk_status foretell(murk_model *m, murk_error *err)
{
    murk_fit_forecast forecast;
    const murk_status status = murk_model_forecast(&forecast, m, err);
    if (status) {
        return status;
    }
    m->memory_bytes = forecast.bytes;
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
        murk_lit_release(&m->world[c].lit);
        murk_reweighed_release(&m->world[c].rows.reweighed);
    }
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        status = murk_lit_build(&w->lit, &w->desc, value, err);
        if (!status) {
            status = murk_beams_check(w->lit.stage, m->desc.measured,
                                      m->desc.keys->condition[c], err);
        }
        if (!status) {
            murk_instruments_warn_of_cut(&w->instruments, m->desc.measured,
                                         w->lit.stage->surfaces);
        }
    }
    return status;
}

/* Traces the light of one condition, and the slopes of world keys. */
static murk_status light_world(murk_model *m, size_t c, murk_error *err)
{
    murk_model_world *w = &m->world[c];
    if (!w->instruments.lit) {
        return MURK_OK;
    }
    murk_status status = murk_lit_light(&w->lit, 0, err);
    if (!status) {
        ++m->traces;
        m->photons = w->lit.followed->emitted;
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
    /* Warnings about the worlds are printed once. */
    /* Reset. */
    const murk_warn_sink sink = m->was_built ? murk_warn_to(NULL) : NULL;
    memcpy(m->traced, value, m->n * sizeof *value);
    for (size_t k = 0; k < m->n; ++k) {
        m->slope_off[k] = m->slope_size[k] = 0;
    }
    /* Build, forecast, trace. */
    const double begun_s = murk_clock_s();
    murk_status status = build_worlds(m, value, err);
    if (!status && !m->was_built) {
        status = foretell(m, err);
    }
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        status = light_world(m, c, err);
    }
    m->trace_s += murk_clock_s() - begun_s;
    if (m->was_built) {
        (void)murk_warn_to(sink);
    }
    m->was_built = true;
    return status;
}

double murk_model_memory_bytes(const murk_model *m)
{
    return m->memory_bytes;
}

double murk_model_slope_error(const murk_model *m, size_t key)
{
    return m->slope_size[key] > 0 ? sqrt(m->slope_off[key] / m->slope_size[key])
                                  : NAN;
}

const murk_stage *murk_model_stage(const murk_model *m, size_t c)
{
    return m->world[c].lit.stage;
}

size_t murk_model_traces(const murk_model *m)
{
    return m->traces;
}

uint64_t murk_model_photons(const murk_model *m)
{
    return m->photons;
}

double murk_model_trace_s(const murk_model *m)
{
    return m->trace_s;
}
