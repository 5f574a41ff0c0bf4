/* A point lamp in an infinite even medium: the fluence rate from .1 to 10 mean
 * free paths, by tallies of balls about the lamp (a shell is the difference of
 * two) and from the volume photon map (power / scattering coefficient, over the
 * shell's volume).
 *
 * Quantities are f(r) = 4 pi r^2 * fluence rate / power, averaged over the
 * shell from r / STRETCH to r * STRETCH; the reference is averaged alike
 * (cases/point_table.h), and that averaging is good to its stated error.
 *
 * A mean free path is 1 m, the domain ends at 60 m. In the clearest of these
 * media light falls by exp(-.206) a metre: what an endless one would send back
 * from beyond 60 m to 12 m is less than exp(-.206 * 96), 3e-9 of f(10).
 *
 * Errors come from blocks of photons, 64 or more: a difference of two tallies
 * has no error of its own, and it knows of all the events of a photon. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cases/groups.h"
#include "cases/point_table.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "stage_text.h"
#include "worlds.h"

#define SOURCE_ISOTROPIC  "Case, de Hoffmann and Placzek 1953"
#define SOURCE_HG         "P_N, N = 1199"
#define HALF_M            60.0
#define BLOCKS_MIN        64
#define BOUNDARIES_MAX    POINT_RADII_MAX
#define FARTHEST          10.0
#define TALLY_STRETCH     1.1
#define MAP_STRETCH       1.25
#define PHOTONS_MAX_TALLY (UINT64_C(1) << 28)
#define PHOTONS_MAX_MAP   (UINT64_C(1) << 28)
#define WHY_SHORT         "photons end at 2.7e8, which take most of an hour"

/* The medium of a table, and the one that is traced. */
typedef struct source_case {
    double albedo, g, traced_albedo;
    uint32_t seed;
} source_case;

/* Shells about the radii of a table, and what they have collected. */
typedef struct shells {
    size_t n;
    double from[BOUNDARIES_MAX], to[BOUNDARIES_MAX];
    validation_reference reference[BOUNDARIES_MAX];
    char quantity[BOUNDARIES_MAX][48];
    uint64_t photons, blocks;
    double sum[BOUNDARIES_MAX], square[BOUNDARIES_MAX]; /* of blocks' means */
} shells;

static void lay_shells(shells *s, const point_table *t, double stretch)
{
    *s = (shells){0};
    for (size_t i = 1; i < t->n && t->r[i] <= FARTHEST; ++i) {
        const double r = t->r[i], r0 = r / stretch, r1 = r * stretch;
        const double f = t->g == 0 ? point_exact_fluence(t->albedo, r0, r1)
                                   : point_table_fluence(t, r0, r1);
        snprintf(s->quantity[s->n], sizeof s->quantity[s->n],
                 "4 pi r^2 fluence, r %.3g..%.3g", r0, r1);
        s->from[s->n] = r0;
        s->to[s->n] = r1;
        s->reference[s->n] = (validation_reference){
            s->quantity[s->n], f,
            t->g == 0 ? 1e-7 * f : point_table_error(stretch) * f};
        ++s->n;
    }
}

/* Block means of f by shell. */
static void add_block(shells *s, const double *f, uint64_t photons)
{
    for (size_t i = 0; i < s->n; ++i) {
        s->sum[i] += f[i];
        s->square[i] += f[i] * f[i];
    }
    s->photons += photons;
    ++s->blocks;
}

static murk_estimate estimate_of(const shells *s, size_t i)
{
    const double n = (double)s->blocks, mean = s->sum[i] / n;
    return (murk_estimate){
        mean, sqrt(fmax(0, s->square[i] / n - mean * mean) / (n - 1))};
}

/* A wrong constant shows as soon as errors are known at all. */
static bool are_done(const validation *v, const source_case *c, const shells *s,
                     uint64_t max)
{
    if (s->blocks < BLOCKS_MIN) {
        return false;
    }
    bool done = true;
    for (size_t i = 0; i < s->n; ++i) {
        done &= estimate_of(s, i).standard_error <=
                validation_error_wanted(v, s->reference[i].value, 1);
    }
    return done || c->traced_albedo != c->albedo || s->photons >= max;
}

static void report(validation *v, const source_case *c, const char *name,
                   const shells *s)
{
    char wrong[32];
    snprintf(wrong, sizeof wrong, "albedo %g", c->traced_albedo);
    const bool is_wrong = c->traced_albedo != c->albedo;
    for (size_t i = 0; i < s->n; ++i) {
        const murk_estimate e = estimate_of(s, i);
        validation_check(v, name, c->g == 0 ? SOURCE_ISOTROPIC : SOURCE_HG,
                         is_wrong ? wrong : NULL, &s->reference[i], e,
                         s->photons);
        if (!is_wrong &&
            !(e.standard_error <=
              validation_error_wanted(v, s->reference[i].value, 1))) {
            validation_mark_short(v, WHY_SHORT);
        }
    }
    fprintf(stderr, "points/%s: %.3g photons\n", name, (double)s->photons);
}

/* ---- by tallies ---- */

static murk_tallies *balls_made(const shells *s, const test_world *w,
                                unsigned threads)
{
    murk_tally_desc desc[2 * BOUNDARIES_MAX] = {0};
    for (size_t i = 0; i < 2 * s->n; ++i) {
        desc[i].type = MURK_TALLY_SPHERE;
        desc[i].where = "ball";
        desc[i].radius_m = i % 2 ? s->to[i / 2] : s->from[i / 2];
        snprintf(desc[i].name, sizeof desc[i].name, "ball%zu", i);
    }
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    if (murk_tallies_create(&tallies, desc, 2 * s->n, &w->world.domain, 1, 1,
                            threads, 1e9, &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        exit(1);
    }
    return tallies;
}

/* Length flown in the ball by all photons so far, in photons' lengths. */
static double length_in(const murk_tallies *tallies, size_t ball, double radius,
                        const test_world *w)
{
    const double one = 1;
    return murk_tallies_read(tallies, ball, 0, 0, w->ledger->emitted, &one)
               .value *
           4 * MURK_PI / 3 * radius * radius * radius;
}

static void trace_tallies(validation *v, const source_case *c)
{
    char name[64];
    snprintf(name, sizeof name, "tallies albedo %g g %g", c->albedo, c->g);
    if (!validation_wants(v, name)) {
        return;
    }
    /* Shells of the reference, and a point source in an infinite medium. */
    const point_table table = point_table_read(c->albedo, c->g);
    shells s;
    lay_shells(&s, &table, TALLY_STRETCH);
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    const murk_medium medium = test_medium(1, c->traced_albedo, c->g);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(&(test_setup){
        .domain = {{{-HALF_M, -HALF_M, -HALF_M}, {HALF_M, HALF_M, HALF_M}},
                   false},
        .lights = &lamp,
        .n_lights = 1,
        .media = &medium,
        .n_media = 1,
        .regions = &region,
        .n_regions = 1});
    /* Two ball tallies for each shell, with the radii of its two surfaces. */
    const unsigned threads = validation_threads(v);
    murk_tallies *tallies = balls_made(&s, &w, threads);
    const uint64_t block =
        (validation_is_quick(v) ? 8 : 64) * MURK_BATCH_PHOTONS;
    double before[BOUNDARIES_MAX] = {0};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = validation_seed(v) + c->seed;
    trace.threads = threads;
    trace.tallies = tallies;
    /* Trace block by block; a shell has the track length of the larger ball
     * less that of the smaller. */
    while (!are_done(v, c, &s, PHOTONS_MAX_TALLY)) {
        trace.first = s.photons;
        trace.last = s.photons + block;
        murk_trace_run(&trace, w.ledger);
        double f[BOUNDARIES_MAX];
        for (size_t i = 0; i < s.n; ++i) {
            const double length = length_in(tallies, 2 * i + 1, s.to[i], &w) -
                                  length_in(tallies, 2 * i, s.from[i], &w);
            f[i] = (length - before[i]) / (double)block / (s.to[i] - s.from[i]);
            before[i] = length;
        }
        add_block(&s, f, block);
    }
    report(v, c, name, &s);
    murk_tallies_destroy(tallies);
    test_world_unmade(&w);
}

/* ---- by the volume photon map ---- */

static const char map_scene[] =
    "murk: 1\n"
    "domain: {min_m: [-60, -60, -60], max_m: [60, 60, 60]}\n"
    "media: {fog: {extinction_per_m: 1, albedo: %g, phase: {hg: %g}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
    "photons: {emit: %" PRIu64 ", maps: volume}\n"
    "seed: %" PRIu64 "\n";

/* The mean of f in each shell from the records of one map, per photon. */
static void read_map(const murk_traced *light, const murk_stage *stage,
                     const shells *s, double *f)
{
    /* Records within the outer radius of each shell. */
    const murk_vec3 lamp = {0, 0, 0};
    const murk_photon *photon = murk_photon_map_photons(light->volume);
    uint32_t *found =
        malloc((murk_photon_map_count(light->volume) + 1) * sizeof *found);
    for (size_t i = 0; found && i < s->n; ++i) {
        const size_t n =
            murk_photon_map_within(light->volume, lamp, s->to[i], found);
        const double inner2 = s->from[i] * s->from[i];
        /* Power over the scattering coefficient estimates the track length;
         * records within the inner radius are left out. */
        double sum = 0;
        for (size_t k = 0; k < n; ++k) {
            const murk_photon *p = &photon[found[k]];
            const murk_vec3 at = {(double)p->position_m[0],
                                  (double)p->position_m[1],
                                  (double)p->position_m[2]};
            if (murk_dot(at, at) > inner2) {
                sum += (double)p->power_w /
                       murk_media_scattering(stage->media, 0, 0, at);
            }
        }
        f[i] = sum / (s->to[i] - s->from[i]);
    }
    free(found);
}

/* Seeds go to 2^32 - 1. */
static uint64_t seed_of_block(const validation *v, const source_case *c,
                              uint64_t block)
{
    return (uint32_t)(validation_seed(v) + c->seed * 100000 + block);
}

static void trace_map(validation *v, const source_case *c)
{
    char name[64];
    snprintf(name, sizeof name, "volume map albedo %g g %g", c->albedo, c->g);
    if (!validation_wants(v, name)) {
        return;
    }
    /* Shells of the reference. */
    const point_table table = point_table_read(c->albedo, c->g);
    shells s;
    lay_shells(&s, &table, MAP_STRETCH);
    const uint64_t block = validation_is_quick(v) ? 20000 : 200000;
    /* Trace maps block by block, each with a seed of its own. */
    while (!are_done(v, c, &s, PHOTONS_MAX_MAP)) {
        char text[1024];
        murk_error err = {0};
        murk_traced *light = NULL;
        snprintf(text, sizeof text, map_scene, c->traced_albedo, c->g, block,
                 seed_of_block(v, c, s.blocks));
        murk_stage *stage = stage_text_create(text, NULL);
        if (!stage || murk_lightmap_trace(&light, stage, 0,
                                          validation_threads(v), &err)) {
            fprintf(stderr, "%s: %s\n", err.where, err.text);
            exit(1);
        }
        double f[BOUNDARIES_MAX] = {0};
        read_map(light, stage, &s, f);
        add_block(&s, f, block);
        murk_traced_destroy(light);
        stage_text_destroy(stage);
    }
    report(v, c, name, &s);
}

/* ---- the reference itself ---- */

static void require(bool is_so, const char *what, double albedo, double r)
{
    if (!is_so) {
        fprintf(stderr, "points: albedo %g, r %g: %s\n", albedo, r, what);
        exit(1);
    }
}

/* Where both are known: the table is what the exact formula gives, in shells
 * too thin to matter; the spline's shells are as good as they are said to be.
 */
static void check_table(double albedo)
{
    const point_table t = point_table_read(albedo, 0);
    for (size_t i = 1; i < t.n && t.r[i] <= FARTHEST; ++i) {
        const double r = t.r[i], thin = 1e-5;
        const double at =
            point_exact_fluence(albedo, r * (1 - thin), r * (1 + thin));
        require(fabs(point_table_at(&t, i) / at - 1) < 3e-7,
                "table and formula differ", albedo, r);
        for (int k = 0; k < 2; ++k) {
            const double stretch = k ? TALLY_STRETCH : MAP_STRETCH;
            const double exact =
                point_exact_fluence(albedo, r / stretch, r * stretch);
            const double spline =
                point_table_fluence(&t, r / stretch, r * stretch);
            require(fabs(spline / exact - 1) < point_table_error(stretch),
                    "the spline errs by more than it says", albedo, r);
        }
    }
}

static source_case source(double albedo, double g)
{
    return (source_case){albedo, g, albedo, (uint32_t)(1e4 * g + 1e3 * albedo)};
}

void cases_points(validation *v)
{
    check_table(.5);
    check_table(.9);
    const source_case quick[] = {source(.9, 0), source(.9, .75),
                                 source(.5, .75)};
    const source_case nightly[] = {source(.5, 0), source(.8, .5),
                                   source(.9, .9)};
    for (size_t i = 0; i < 3; ++i) {
        trace_tallies(v, &quick[i]);
    }
    for (size_t i = 0; !validation_is_quick(v) && i < 3; ++i) {
        trace_tallies(v, &nightly[i]);
    }
    const source_case by_map[] = {source(.5, 0), source(.8, .5)};
    for (size_t i = 0; i < 2; ++i) {
        trace_map(v, &by_map[i]);
    }
    trace_tallies(v, &(source_case){.5, .75, .51, 1});
    trace_map(v, &(source_case){.5, 0, .51, 2});
}
