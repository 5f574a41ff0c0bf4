/* Case weights: what survival weights are worth against Russian roulette alone,
 * as time to the same error. value and reference_value are figures of merit,
 * 1 / (error^2 time), with weights down to a least one and with roulette; the
 * error is the worst of reflectance and transmittance, in units of .1 % or
 * 3e-5. For the photon maps (a foggy room) it is that of the share of all
 * stored power that lies in one quarter of the room, by emitted photon; there
 * the time is the tracer's, and a line on standard error counts records in its
 * place, which is what memory and sensing go by. One thread.
 *
 * The share's error is a ratio estimator's (base/stats.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stats.h"
#include "times.h"
#include "worlds.h"

#define PHOTONS (64 * MURK_BATCH_PHOTONS)

typedef struct slab {
    double index, albedo, g, tau;
} slab;

static const slab slabs[] = {{1, .2, 0, 1},    {1, .9, .75, 2},
                             {1, .8, 0, 5},    {1, .99, .875, 5},
                             {1.5, .9, .5, 5}, {1, .5, .5, 1}};

static const double min_weights[] = {1, .3, .1, .01, .001};

#define SLABS   (sizeof slabs / sizeof slabs[0])
#define WEIGHTS (sizeof min_weights / sizeof min_weights[0])

/* By photon; scenes score two things each. */
static double x[PHOTONS], y[PHOTONS];
static double records;

static void ends(void *context, uint64_t batch, const murk_event *event)
{
    (void)context;
    (void)batch;
    if (event->kind == MURK_EVENT_ESCAPED) {
        (event->direction_in.z < 0 ? x : y)[event->photon] += event->weight;
    }
}

static void stored(void *context, uint64_t batch, const murk_event *event)
{
    (void)context;
    (void)batch;
    if (event->outcome == MURK_SCATTERED || event->outcome == MURK_DIFFUSE) {
        const bool is_there = event->position.x < 5 && event->position.y < 5;
        x[event->photon] += is_there ? event->leaving : 0;
        y[event->photon] += event->leaving;
        records += 1;
    }
}

/* The times for all photons. */
static bench_times traced(test_world *w, double least_weight,
                          murk_event_sink sink)
{
    murk_trace trace = murk_trace_defaults();
    trace.world = &w->world;
    trace.seed = 1;
    trace.last = PHOTONS;
    trace.least_weight = least_weight;
    trace.sink = sink;
    bench_times times = {0};
    for (int i = 0; i < BENCH_REPEATS; ++i) {
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        records = 0;
        const bench_moment begun = bench_now();
        murk_trace_run(&trace, w->ledger);
        bench_add(&times, i, begun);
    }
    return times;
}

static double squared_error(murk_estimate e)
{
    const double over = e.standard_error / fmax(1e-3 * e.value, 3e-5);
    return over * over;
}

/* The time and the squared error of a run, or of roulette alone. */
typedef struct merit {
    bench_times times;
    double error2;
} merit;

static void tell(const char *name, double least_weight, const merit *m,
                 const merit *roulette)
{
    char title[160];
    snprintf(title, sizeof title, "weights %s least %g", name, least_weight);
    bench_print(&(bench_row){.name = title,
                             .unit = "1/(squared error)/s",
                             .reference = "roulette alone",
                             .threads = 1,
                             .work = 1 / m->error2,
                             .reference_work = 1 / roulette->error2,
                             .ours = &m->times,
                             .theirs = &roulette->times});
}

static void bench_slab(const slab *s)
{
    const double wide = 1e5, air = s->index > 1;
    const murk_source light =
        test_beam(murk_vec(0, 0, -air), murk_vec(0, 0, 1));
    const murk_medium fog = test_medium(1, s->albedo, s->g);
    murk_region region = test_everywhere(0);
    if (s->index > 1) {
        region = test_box_region(0, murk_vec(-2 * wide, -2 * wide, 0),
                                 murk_vec(2 * wide, 2 * wide, s->tau));
        region.ior = s->index;
    }
    /* One slab across a periodic domain, with air on both sides if it has
     * an index. */
    test_world w = test_world_made(&(test_setup){
        .domain = {{{-wide, -wide, -air}, {wide, wide, s->tau + air}}, true},
        .lights = &light,
        .n_lights = 1,
        .media = &fog,
        .n_media = 1,
        .regions = &region,
        .n_regions = 1});
    char name[96];
    snprintf(name, sizeof name, "slab n %g a %g g %g tau %g", s->index,
             s->albedo, s->g, s->tau);
    /* Merit is 1 / (squared error * time), relative to that of plain
     * roulette. */
    merit roulette = {0};
    for (size_t k = 0; k < WEIGHTS; ++k) {
        merit m = {.times = traced(&w, min_weights[k], ends)};
        m.error2 = fmax(squared_error(murk_mean_estimate(x, PHOTONS)),
                        squared_error(murk_mean_estimate(y, PHOTONS)));
        roulette = k == 0 ? m : roulette;
        tell(name, min_weights[k], &m, &roulette);
    }
    test_world_unmade(&w);
}

static void bench_maps(void)
{
    const murk_source lamp = test_point(murk_vec(3, 4, 3.5));
    const murk_medium fog = test_medium(.1, .95, .8);
    const murk_region region = test_everywhere(0);
    const murk_material paint = test_material(.5, 0, 0, 0);
    const murk_surface_desc walls =
        test_box(murk_vec(0, 0, 0), murk_vec(10, 10, 4), 0);
    /* A room with diffuse walls and thin fog, lit by one point source. */
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {11, 11, 5}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &walls,
                      .n_surfaces = 1,
                      .materials = &paint,
                      .n_materials = 1,
                      .media = &fog,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    /* Merit by time and by stored record, relative to that of plain
     * roulette. */
    merit roulette = {0};
    double by_record = 0;
    for (size_t k = 0; k < WEIGHTS; ++k) {
        merit m = {.times = traced(&w, min_weights[k], stored)};
        const double error =
            murk_ratio_estimate(x, y, PHOTONS, PHOTONS).standard_error;
        m.error2 = error * error;
        roulette = k == 0 ? m : roulette;
        tell("maps", min_weights[k], &m, &roulette);
        by_record = k == 0 ? m.error2 * records : by_record;
        fprintf(stderr, "weights maps least %g: merit by record %.3f\n",
                min_weights[k], by_record / (m.error2 * records));
    }
    test_world_unmade(&w);
}

int main(void)
{
    for (size_t i = 0; i < SLABS; ++i) {
        bench_slab(&slabs[i]);
    }
    bench_maps();
    return 0;
}
