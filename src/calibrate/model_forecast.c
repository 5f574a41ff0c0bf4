/* Traces a few photons of each condition, measures the memory of their
 * contributions and sightlines, and scales it to the number of photons of the
 * fit. */
#include "calibrate/model_parts.h"

#include "base/log.h"
#include "calibrate/recorder.h"
#include "lightmap/lightmap.h"

#include <math.h>

/* Memory of the traced light of one condition, in bytes except for the number
 * of contributions. */
typedef struct light_size {
    double contributions;
    double histories;  /* contributions and maps */
    double growing;    /* additional memory while they are traced */
    double sightlines; /* the same again while they are sorted */
    double weights;    /* ratios and slopes of one evaluation */
} light_size;

/* The memory of `grow` times the photons of the pilot. */
static light_size size_of(const murk_lighting *pilot, double grow, size_t keys)
{
    const murk_histories *h = pilot->histories;
    const double n = grow * (double)h->n, turns = grow * (double)h->turns;
    double records = 0;
    for (size_t i = 0; i < h->n; ++i) {
        records += murk_contribution_is_record(&h->contribution[i]) ? grow : 0;
    }
    const double plain = murk_histories_bytes(h->media, n, turns);
    const bool has_maps = pilot->covered != NULL;
    const double maps = has_maps ? murk_photon_map_memory_for(records) : 0;
    const double buffers = has_maps ? records * (double)sizeof(murk_photon) : 0;
    return (light_size){
        .contributions = n,
        .histories = plain + maps,
        .growing = (MURK_WHILE_GROWING - 1) * (plain + buffers),
        .sightlines = has_maps ? grow * murk_covered_bytes(pilot->covered) : 0,
        .weights = n * (double)(keys + 1) * sizeof(double)};
}

/* The ratio of the photons of the fit to those of the pilot. */
static murk_status find_growth(double *grow, const murk_lighting *pilot,
                               murk_error *err)
{
    const murk_scene_photons *settings = &pilot->scene->photons;
    murk_forecast forecast = {.emitted = (double)settings->emit};
    murk_status status = MURK_OK;
    if (!settings->emit) { /* the run ends when enough records are stored */
        status = murk_lightmap_forecast(&forecast, pilot->stage, 0,
                                        pilot->desc->threads, err);
    }
    *grow = forecast.emitted / (double)pilot->histories->emitted;
    return status;
}

/* Traces the pilot and forecasts; a failure other than an interrupt gives
 * zeros. */
static murk_status try_light(light_size *out, const murk_lighting *lighting,
                             size_t keys, murk_error *err)
{
    murk_lighting pilot = {.desc = lighting->desc,
                           .scene = lighting->scene,
                           .stage = lighting->stage,
                           .optics = lighting->optics};
    /* Few photons. */
    const uint64_t emit = lighting->scene->photons.emit;
    const uint64_t photons =
        emit && emit < MURK_FIT_FORECAST_FROM ? emit : MURK_FIT_FORECAST_FROM;
    /* Trace without warnings and errors. */
    murk_error own = {0};
    double grow = 1;
    const murk_warn_sink sink = murk_warn_to(NULL);
    murk_status status = murk_lighting_trace(&pilot, photons, &own);
    status = status ? status : find_growth(&grow, &pilot, &own);
    (void)murk_warn_to(sink);
    *out = (light_size){0};
    if (!status) {
        *out = size_of(&pilot, grow, keys);
    }
    murk_lighting_darken(&pilot);
    /* An interrupt is reported, and lack of memory, which may be that of one
     * rank alone; the trace of all photons reports other failures. */
    return status == MURK_INTERRUPTED || status == MURK_NO_MEMORY
               ? murk_fail(err, status, own.where, "%s", own.text)
               : MURK_OK;
}

/* Memory of the sums by batch and run for this number of rows. An evaluation
 * needs as much again for the sums of both maps. */
static double sums_bytes(const murk_model *m, double rows)
{
    return rows * sizeof(double) *
           ((double)m->facts.batches +
            (double)m->facts.runs * ((double)m->n + 1));
}

/* Memory of the covariance of all rows that need light, of the covariance of
 * the fitted ones, of the Cholesky factor of the latter, and of the batches. */
static double noise_bytes(const murk_model *m)
{
    const double lights = (double)m->facts.lights;
    return 3 * lights * lights * sizeof(double) + sums_bytes(m, lights);
}

/* Memory of all conditions together, and the largest additional memory of any
 * one while light is traced and while rows are evaluated. */
typedef struct need {
    double light, weights, sums;
    double tracing, reading;
} need;

static void add_condition(need *all, const light_size *size, double sums,
                          bool has_world_keys)
{
    const double tracing = fmax(size->growing, size->sightlines);
    /* Slopes of world keys need a second light, sums at two values and the sums
     * of one evaluation. */
    const double another = size->histories + size->sightlines +
                           size->contributions * (double)sizeof(double) +
                           3 * sums;
    all->light += size->histories + size->sightlines;
    all->weights += size->weights;
    all->sums += sums;
    all->tracing = fmax(all->tracing, tracing + (has_world_keys ? another : 0));
    all->reading = fmax(all->reading, sums);
}

murk_status murk_model_forecast(murk_fit_forecast *out, const murk_model *m,
                                murk_error *err)
{
    need all = {.reading = noise_bytes(m)};
    double contributions = 0;
    murk_status status = MURK_OK;
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        const murk_model_world *w = &m->world[c];
        light_size size;
        if (w->instruments.lights) {
            status = try_light(&size, &w->lighting, m->n, err);
            add_condition(&all, &size,
                          sums_bytes(m, (double)w->instruments.lights),
                          w->has_world_keys);
            contributions += size.contributions;
        }
    }
    /* Weights are released before light is traced again, so the larger of the
     * memory of tracing and that of an evaluation counts. */
    const double max = fmax(all.tracing, all.weights + all.reading);
    *out = (murk_fit_forecast){contributions, all.light + all.weights,
                               all.light + all.sums + max};
    return status;
}
