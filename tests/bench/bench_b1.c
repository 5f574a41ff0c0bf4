/* Case b1: the even cube of side 60, absorption .005, scattering 1, g .01 per
 * unit length (a unit is a metre here; only products matter), a pencil beam
 * into the middle of one face, no reflection at the faces, no maps. The
 * reference is the plain scalar loop of tests/support/plain_tracer.c, which
 * does the same roulette, timed in turns with murk. Medians of the repeats.
 *
 * On two threads the reference is two such loops side by side. */
#include <stdio.h>
#include <stdlib.h>

#include "base/crew.h"
#include "base/progress.h"
#include "plain_tracer.h"
#include "transport/trace.h"

#define REPEATS 9
#define PHOTONS UINT64_C(40960)

typedef struct parts {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_lights *lights;
    murk_ledger *ledger;
} parts;

static const murk_domain cube = {{{0, 0, 0}, {60, 60, 60}}, false};

static murk_status make(parts *p, murk_error *err)
{
    const murk_material black = {.name = "default"};
    const murk_medium medium = {.extinction_per_m = {{1.005}},
                                .albedo = {{1 / 1.005}},
                                .phase = {{.g = .01}},
                                .where = "b1"};
    const murk_region region = {.shape = MURK_REGION_EVERYWHERE,
                                .to_world = murk_affine_identity(),
                                .where = "b1"};
    const murk_light beam = {.type = MURK_LIGHT_BEAM,
                             .position = {30.1, 30.2, 0},
                             .direction = {0, 0, 1},
                             .power_w = {{1}},
                             .where = "b1"};
    murk_status status =
        murk_surfaces_create(&p->surfaces, NULL, 0, &black, 1, err);
    if (!status) {
        status = murk_media_create(&p->media, &medium, 1, &region, 1, &cube.box,
                                   err);
    }
    if (!status) {
        status = murk_lights_create(&p->lights, &beam, 1, 1, &cube, err);
    }
    const murk_world world = {p->surfaces, p->media, p->lights, cube, 1};
    return status ? status : murk_ledger_create(&p->ledger, &world, err);
}

static double murk_rate(parts *p, uint64_t first, unsigned threads)
{
    const murk_world world = {p->surfaces, p->media, p->lights, cube, 1};
    murk_trace trace = murk_trace_defaults();
    trace.world = &world;
    trace.seed = 1;
    trace.first = first;
    trace.last = first + PHOTONS;
    trace.threads = threads;
    const double begin = murk_clock_s();
    murk_trace_run(&trace, p->ledger);
    return (double)PHOTONS / (murk_clock_s() - begin);
}

typedef struct loops {
    uint64_t photons, seed; /* of each loop */
    plain_result result[2];
} loops;

static void loop(void *context, uint64_t i)
{
    loops *l = context;
    const plain_box box = {.size_m = {60, 60, 60},
                           .start_m = {30.1, 30.2, 0},
                           .direction = {0, 0, 1},
                           .absorption_per_m = .005,
                           .scattering_per_m = 1,
                           .mean_cosine = .01,
                           .majorant_per_m = 1.005};
    l->result[i] = plain_trace(&box, l->photons, l->seed + i);
}

static double plain_rate(uint64_t *absorbed, uint64_t seed, unsigned threads)
{
    loops l = {PHOTONS / threads, seed, {{0}}};
    const double begin = murk_clock_s();
    murk_crew_run(threads, threads, loop, &l);
    const double seconds = murk_clock_s() - begin;
    for (unsigned i = 0; i < threads; ++i) {
        *absorbed += l.result[i].absorbed;
    }
    return (double)PHOTONS / seconds;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x)
{
    qsort(x, REPEATS, sizeof *x, ascending);
    return x[REPEATS / 2];
}

int main(void)
{
    parts p = {0};
    murk_error err = {0};
    if (make(&p, &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        return 1;
    }
    uint64_t absorbed = 0, first = 0;
    double murk[2][REPEATS], plain[2][REPEATS];
    for (int i = 0; i < REPEATS; ++i) {
        for (unsigned t = 0; t < 2; ++t, first += PHOTONS) {
            plain[t][i] = plain_rate(&absorbed, first + 1, t + 1);
            murk[t][i] = murk_rate(&p, first, t + 1);
        }
    }
    for (unsigned t = 0; t < 2; ++t) {
        const double value = median(murk[t]), reference = median(plain[t]);
        printf("{\"case\": \"b1\", \"value\": %.6g, \"unit\": \"photons/s\", "
               "\"reference\": \"plain scalar C loop\", \"reference_value\": "
               "%.6g, \"ratio\": %.4f, \"threads\": %u}\n",
               value, reference, value / reference, t + 1);
    }
    fprintf(
        stderr, "absorbed: murk %.5f, plain %.5f\n",
        (double)(murk_tally_read(&p.ledger->absorbed_media[0]) / MURK_PACKET) /
            (double)first,
        (double)absorbed / (double)first);
    murk_ledger_destroy(p.ledger);
    murk_lights_destroy(p.lights);
    murk_media_destroy(p.media);
    murk_surfaces_destroy(p.surfaces);
    return 0;
}
