/* Cases b1, b2, sph, ramp: the cube of side 60 with a pencil beam into the
 * middle of one face, no reflection at the faces, no maps (a unit of length is
 * a metre here; only products matter).
 *
 *   b1    absorption .005, scattering 1, g .01
 *   b2    scattering 10, g .9
 *   sph   b1 with a ball of radius 15 in the middle: .002, 5, .9
 *   ramp  b1 times a density that grows from 0 to 2 along the beam, in voxels
 *         of side 1; and ramp-linear, the same between the values at whole
 *         heights
 *
 * The reference is the plain scalar loop of tests/support/plain_tracer.c (delta
 * tracking, the same roulette), timed in turns with murk; two such loops side
 * by side stand against two threads. Medians of the repeats. Each case has a
 * line for photons/s and one for (real) collisions/s; murk and the loop must
 * agree on the light absorbed, or the case fails.
 *
 *   bench_cube [--delta] [CASE...]   --delta: flights by delta tracking */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/progress.h"
#include "plain_tracer.h"
#include "transport/trace.h"

#define REPEATS 9
#define SIDE    60
#define SLOPE   (2. / SIDE) /* of the ramp's density */

typedef struct cube {
    const char *name;
    uint64_t photons; /* of a repeat */
    plain_matter matter, ball;
    bool is_ramp, is_linear;
} cube;

static const cube CUBES[] = {
    {"b1", 40960, {.005, 1, .01}, {0, 0, 0}, false, false},
    {"b2", 8192, {.005, 10, .9}, {0, 0, 0}, false, false},
    {"sph", 16384, {.005, 1, .01}, {.002, 5, .9}, false, false},
    {"ramp", 16384, {.005, 1, .01}, {0, 0, 0}, true, false},
    {"ramp-linear", 16384, {.005, 1, .01}, {0, 0, 0}, true, true},
};

typedef struct parts {
    float *density;
    murk_grid *grid;
    murk_surfaces *surfaces;
    murk_media *media;
    murk_sources *lights;
    murk_ledger *ledger;
} parts;

static const murk_domain domain = {{{0, 0, 0}, {SIDE, SIDE, SIDE}}, false};

static murk_medium medium_of(const plain_matter *m)
{
    const double extinction = m->absorption_per_m + m->scattering_per_m;
    return (murk_medium){.extinction_per_m = {{extinction}},
                         .albedo = {{m->scattering_per_m / extinction}},
                         .phase = {murk_phase_hg(m->mean_cosine)},
                         .where = "cube"};
}

/* murk's samples: by voxels, or (one more along an axis) at whole coordinates,
 * so that the field is a ramp up to the faces. */
static murk_status make_ramp(parts *p, bool is_linear, murk_error *err)
{
    const size_t n = is_linear ? SIDE + 1 : SIDE;
    const size_t size[3] = {n, n, n};
    const double first = is_linear ? 0 : .5;
    murk_affine place = murk_affine_identity();
    place.shift = murk_vec(first, first, first);
    float *sample = calloc(n * n * n, sizeof *sample);
    if (!sample) {
        return murk_fail(err, MURK_NO_MEMORY, "ramp", "no memory");
    }
    for (size_t i = 0; i < n * n * n; ++i) {
        sample[i] = (float)(((double)(i / n / n) + first) * SLOPE);
    }
    const murk_status status =
        murk_grid_from_samples(&p->grid, size, sample, &place, "ramp", err);
    free(sample);
    return status;
}

/* The plain loop's, for which z grows fastest. */
static murk_status make_plain_ramp(parts *p, bool is_linear, murk_error *err)
{
    const size_t n = is_linear ? SIDE + 1 : SIDE;
    p->density = calloc(n * n * n, sizeof *p->density);
    if (!p->density) {
        return murk_fail(err, MURK_NO_MEMORY, "ramp", "no memory");
    }
    for (size_t i = 0; i < n * n * n; ++i) {
        p->density[i] =
            (float)(((double)(i % n) + (is_linear ? 0 : .5)) * SLOPE);
    }
    return MURK_OK;
}

static murk_transport_world world_of(const parts *p)
{
    return (murk_transport_world){.surfaces = p->surfaces,
                                  .media = p->media,
                                  .lights = p->lights,
                                  .domain = domain,
                                  .bands = 1};
}

static murk_status make(parts *p, const cube *c, murk_error *err)
{
    const murk_material black = {.name = "default"};
    murk_medium media[2] = {medium_of(&c->matter), medium_of(&c->ball)};
    murk_region regions[2] = {{.shape = MURK_REGION_EVERYWHERE,
                               .to_world = murk_affine_identity(),
                               .where = "cube"},
                              {.medium = 1,
                               .shape = MURK_REGION_SPHERE,
                               .center = {SIDE / 2, SIDE / 2, SIDE / 2},
                               .radius_m = 15,
                               .replaces = true,
                               .to_world = murk_affine_identity(),
                               .where = "ball"}};
    const size_t n = c->ball.scattering_per_m > 0 ? 2 : 1;
    const murk_source beam = {.type = MURK_SOURCE_BEAM,
                              .position = {30.1, 30.2, 0},
                              .direction = {0, 0, 1},
                              .power_w = {{1}},
                              .where = "beam"};
    /* The density grid of the case, for murk and for the plain loop. */
    murk_status status = c->is_ramp ? make_ramp(p, c->is_linear, err) : MURK_OK;
    if (!status && c->is_ramp) {
        status = make_plain_ramp(p, c->is_linear, err);
    }
    if (p->grid) {
        media[0].grid = p->grid;
        media[0].interpolation = c->is_linear ? MURK_LINEAR : MURK_NEAREST;
        regions[0].shape = MURK_REGION_GRID;
    }
    /* Surfaces, media with their majorants, the light source, the ledger. */
    if (!status) {
        status = murk_surfaces_create(&p->surfaces, NULL, 0, &black, 1, err);
    }
    if (!status) {
        status = murk_media_create(&p->media, media, n, regions, n, &domain.box,
                                   err);
    }
    if (!status) {
        status = murk_media_prepare_delta(p->media, err);
    }
    if (!status) {
        status = murk_sources_create(&p->lights, &beam, 1, 1, &domain, err);
    }
    const murk_transport_world world = world_of(p);
    return status ? status : murk_ledger_create(&p->ledger, &world, err);
}

static void unmake(parts *p)
{
    murk_ledger_destroy(p->ledger);
    murk_sources_destroy(p->lights);
    murk_media_destroy(p->media);
    murk_surfaces_destroy(p->surfaces);
    murk_grid_destroy(p->grid);
    free(p->density);
}

/* Seconds for photons [first, first + n). */
static double murk_seconds(parts *p, uint64_t first, uint64_t n,
                           unsigned threads, bool by_delta)
{
    const murk_transport_world world = world_of(p);
    murk_trace trace = murk_trace_defaults();
    trace.world = &world;
    trace.seed = 1;
    trace.first = first;
    trace.last = first + n;
    trace.threads = threads;
    trace.by_delta = by_delta;
    const double begin = murk_clock_s();
    murk_trace_run(&trace, p->ledger);
    return murk_clock_s() - begin;
}

typedef struct loops {
    const plain_box *box;
    uint64_t photons, seed; /* of each loop */
    plain_result result[2];
} loops;

static void loop(void *context, uint64_t i)
{
    loops *l = context;
    l->result[i] = plain_trace(l->box, l->photons, l->seed + i);
}

typedef struct count {
    double absorbed, collisions, photons;
} count;

static double plain_seconds(const plain_box *box, count *sum, uint64_t n,
                            uint64_t seed, unsigned threads)
{
    loops l = {box, n / threads, seed, {{0}}};
    const double begin = murk_clock_s();
    murk_pool_run(threads, threads, loop, &l);
    const double seconds = murk_clock_s() - begin;
    for (unsigned i = 0; i < threads; ++i) {
        sum->absorbed += (double)l.result[i].absorbed;
        sum->collisions += (double)l.result[i].collisions;
    }
    sum->photons += (double)n;
    return seconds;
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

static void print(const char *name, const char *what, const char *unit,
                  double value, double reference, unsigned threads)
{
    printf("{\"case\": \"%s%s\", \"value\": %.6g, \"unit\": \"%s/s\", "
           "\"reference\": \"plain scalar C loop\", \"reference_value\": "
           "%.6g, \"ratio\": %.4f, \"threads\": %u}\n",
           name, what, value, unit, reference, value / reference, threads);
}

static plain_box plain_box_of(const cube *c, const parts *p)
{
    const double extinction =
        c->matter.absorption_per_m + c->matter.scattering_per_m;
    const double in_ball = c->ball.absorption_per_m + c->ball.scattering_per_m;
    return (plain_box){.size_m = {SIDE, SIDE, SIDE},
                       .start_m = {30.1, 30.2, 0},
                       .direction = {0, 0, 1},
                       .matter = c->matter,
                       .majorant_per_m = c->is_ramp ? 2 * extinction
                                                    : fmax(extinction, in_ball),
                       .center_m = {SIDE / 2, SIDE / 2, SIDE / 2},
                       .radius_m = in_ball > 0 ? 15 : 0,
                       .ball = c->ball,
                       .density = p->density,
                       .is_linear = c->is_linear};
}

/* Times one case and prints its lines; false when the two disagree. */
static bool contest(const cube *c, parts *p, bool by_delta)
{
    const plain_box box = plain_box_of(c, p);
    const uint64_t n = c->photons;
    uint64_t first = 0;
    count plain = {0, 0, 0};
    double ours[2][REPEATS], theirs[2][REPEATS];
    /* Alternate the two programs, so that a drift of the clock rate meets
     * both. */
    for (int i = 0; i < REPEATS; ++i) {
        for (unsigned t = 0; t < 2; ++t, first += n) {
            theirs[t][i] = plain_seconds(&box, &plain, n, first + 1, t + 1);
            ours[t][i] = murk_seconds(p, first, n, t + 1, by_delta);
        }
    }
    /* Rates of photons and of collisions, for each number of threads. */
    const double photons = (double)first;
    const double absorbed =
        (double)(murk_tally_read(&p->ledger->absorbed_media[0]) / MURK_PACKET);
    const double per_photon =
        (double)murk_tally_read(&p->ledger->collisions) / photons;
    for (unsigned t = 0; t < 2; ++t) {
        const double rate = (double)n / median(ours[t]);
        const double reference = (double)n / median(theirs[t]);
        print(c->name, "", "photons", rate, reference, t + 1);
        print(c->name, "-collisions", "collisions", rate * per_photon,
              reference * plain.collisions / photons, t + 1);
    }
    /* Both follow the same physics: the absorbed shares must agree. */
    const double share = plain.absorbed / photons;
    const double off =
        (absorbed - plain.absorbed) / sqrt(2 * photons * share * (1 - share));
    fprintf(stderr,
            "%s: absorbed %.5f, plain loop %.5f (%.1f sigma); %.2f collisions "
            "a photon, plain loop %.2f\n",
            c->name, absorbed / photons, share, off, per_photon,
            plain.collisions / photons);
    return fabs(off) < 5;
}

static bool is_wanted(const cube *c, char **names)
{
    for (char **name = names; *name; ++name) {
        if (strcmp(*name, c->name) == 0) {
            return true;
        }
    }
    return !*names;
}

int main(int argc, char **argv)
{
    const bool by_delta = argc > 1 && strcmp(argv[1], "--delta") == 0;
    bool agree = true;
    for (size_t i = 0; i < sizeof CUBES / sizeof *CUBES; ++i) {
        if (!is_wanted(&CUBES[i], argv + 1 + by_delta)) {
            continue;
        }
        parts p = {0};
        murk_error err = {0};
        if (make(&p, &CUBES[i], &err)) {
            fprintf(stderr, "%s: %s\n", err.where, err.text);
            return 1;
        }
        agree &= contest(&CUBES[i], &p, by_delta);
        unmake(&p);
    }
    return agree ? 0 : 1;
}
