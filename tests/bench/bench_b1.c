/* Case b1: the even cube of side 60, absorption .005, scattering 1, g .01 per
 * unit length (a unit is a metre here; only products matter), a pencil beam
 * into the middle of one face, no reflection at the faces, no maps. The
 * reference is the plain scalar loop of tests/support/plain_tracer.c, which
 * does the same roulette, timed in turns with murk. Medians of the repeats.
 *
 * The reference runs on one thread and is counted once for each thread: plain
 * loops over photons share nothing, so that is what they would do at best. */
#include <stdio.h>
#include <stdlib.h>

#include "base/progress.h"
#include "plain_tracer.h"
#include "transport/trace.h"

#define REPEATS 7
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
                                .mean_cosine = {{.01}},
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
    return status ? status : murk_ledger_create(&p->ledger, 1, err);
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

static double plain_rate(plain_result *result, uint64_t seed)
{
    const plain_box box = {.size_m = {60, 60, 60},
                           .start_m = {30.1, 30.2, 0},
                           .direction = {0, 0, 1},
                           .absorption_per_m = .005,
                           .scattering_per_m = 1,
                           .mean_cosine = .01,
                           .majorant_per_m = 1.005};
    const double begin = murk_clock_s();
    *result = plain_trace(&box, PHOTONS, seed);
    return (double)PHOTONS / (murk_clock_s() - begin);
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
    double one[REPEATS], two[REPEATS], plain[REPEATS];
    plain_result result = {0};
    for (int i = 0; i < REPEATS; ++i) {
        const uint64_t first = (uint64_t)i * 2 * PHOTONS;
        plain[i] = plain_rate(&result, (uint64_t)i + 1);
        one[i] = murk_rate(&p, first, 1);
        two[i] = murk_rate(&p, first + PHOTONS, 2);
    }
    const double rate[2] = {median(one), median(two)};
    const double reference = median(plain);
    for (unsigned threads = 1; threads <= 2; ++threads) {
        printf("{\"case\": \"b1\", \"value\": %.6g, \"unit\": \"photons/s\", "
               "\"reference\": \"plain scalar C loop\", \"reference_value\": "
               "%.6g, \"ratio\": %.4f, \"threads\": %u}\n",
               rate[threads - 1], threads * reference,
               rate[threads - 1] / (threads * reference), threads);
    }
    fprintf(
        stderr, "absorbed: murk %.5f, plain %.5f\n",
        (double)(murk_tally_read(&p.ledger->absorbed_media[0]) / MURK_PACKET) /
            (double)murk_tally_read(&p.ledger->photons),
        (double)result.absorbed / (double)PHOTONS);
    murk_ledger_destroy(p.ledger);
    murk_lights_destroy(p.lights);
    murk_media_destroy(p.media);
    murk_surfaces_destroy(p.surfaces);
    return 0;
}
