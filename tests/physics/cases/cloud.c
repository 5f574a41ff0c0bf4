/* The step cloud of I3RC phase 1, case 1, experiments 1, 2 and 4, as a scene
 * file with a .vdb and tallies: shares of the light that are reflected,
 * transmitted and absorbed, of the whole cloud and column by column.
 *
 * Nightly: 4e6 photons; means lie within MEAN_SIGMAS, and the columns' root
 * mean square difference from the consensus is at most that of murk's own
 * errors plus ALLOWED_RMS. Each of the 6 means has a .27 % chance of a false
 * alarm with another seed. Quick: 2e5 photons, where own errors are far larger
 * than what is between the models: the limit of the run for the means, and the
 * same root mean square, in own errors, is 1 within the spread of 32 squares.
 *
 * The consensus has no errors of its own; its digits are what counts. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cases/groups.h"
#include "cases/reference.h"
#include "lightmap/lightmap.h"
#include "world/stage_build.h"

#define SCENE            "tests/physics/scenes/step-cloud.yaml"
#define SOURCE           "I3RC consensus, Cahalan et al. 2005"
#define COLUMNS          32
#define PHOTONS          UINT64_C(4000000)
#define PHOTONS_QUICK    UINT64_C(200000)
#define THICK_M          250.0
#define AREA_M2          (500.0 * 500.0)
#define EXTINCTION_PER_M 0.008 /* times densities 1 and 9 */

#define MEAN_SIGMAS 3
#define ALLOWED_RMS .001

/* Of the consensus, beyond its rounding: the means of its columns. */
#define MEAN_UNCERTAINTY 1e-5

#define OVERRIDES_MAX 6

typedef struct experiment {
    int number;
    const char *is_wrong;
    const char *overrides[OVERRIDES_MAX]; /* NULL ends them */
} experiment;

/* Shares of the light on the cloud; absorbed: of that on the column, too. */
typedef struct column {
    murk_estimate share[COLUMNS];
} column;

typedef enum part { REFLECTED, TRANSMITTED, ABSORBED, PARTS } part;

static const char *const PART_NAME[PARTS] = {"reflected", "transmitted",
                                             "absorbed"};

typedef struct lit_cloud {
    column part[PARTS];
    uint64_t photons;
} lit_cloud;

static _Noreturn void die(const murk_error *err)
{
    fprintf(stderr, "%s: %s\n", err->where, err->text);
    exit(1);
}

static murk_estimate scaled(murk_estimate e, double factor)
{
    return (murk_estimate){factor * e.value, factor * e.standard_error};
}

/* Tallies 0 and 1 are the planes above and below (forward cells first), 2 the
 * fluence rate by column. Irradiance on the cloud is 1 W/m2. */
static void read_columns(const murk_traced *light, double albedo,
                         lit_cloud *out)
{
    for (size_t i = 0; i < COLUMNS; ++i) {
        murk_estimate e[PARTS];
        for (size_t k = 0; k < PARTS; ++k) {
            e[k] = murk_tallies_read(light->tallies, k, 0, i,
                                     light->ledger->emitted, light->packet_w);
        }
        const double density = i < COLUMNS / 2 ? 1 : 9;
        out->part[REFLECTED].share[i] = scaled(e[0], COLUMNS / AREA_M2);
        out->part[TRANSMITTED].share[i] = scaled(e[1], COLUMNS / AREA_M2);
        out->part[ABSORBED].share[i] =
            scaled(e[2], (1 - albedo) * EXTINCTION_PER_M * density * THICK_M);
    }
    out->photons = light->emitted;
}

static lit_cloud light_up(const validation *v, const experiment *x)
{
    /* Photons, seed and the overrides of the experiment. */
    char emit[64], seed[64];
    snprintf(emit, sizeof emit, "photons.emit=%" PRIu64,
             validation_is_quick(v) ? PHOTONS_QUICK : PHOTONS);
    snprintf(seed, sizeof seed, "seed=%" PRIu32,
             validation_seed(v) + (uint32_t)x->number);
    murk_override list[OVERRIDES_MAX + 2] = {{.text = emit}, {.text = seed}};
    size_t n = 2;
    for (size_t i = 0; i < OVERRIDES_MAX && x->overrides[i]; ++i) {
        list[n++].text = x->overrides[i];
    }
    murk_error err = {0};
    murk_scene_desc *scene = NULL;
    murk_stage *stage = NULL;
    murk_traced *light = NULL;
    /* Trace the scene, and score the columns of the cloud from the maps. */
    if (murk_scene_desc_read(&scene, SCENE, list, n, &err) ||
        murk_stage_create(&stage, scene, &err) ||
        murk_lightmap_trace(&light, stage, 0, validation_threads(v), &err)) {
        die(&err);
    }
    lit_cloud out = {0};
    read_columns(light, scene->media[0].albedo.band[0], &out);
    murk_traced_destroy(light);
    murk_stage_destroy(stage);
    murk_scene_desc_destroy(scene);
    return out;
}

/* A photon is reflected, transmitted or absorbed once: the whole cloud's shares
 * are binomial. (That of the absorbed by track length is better than that.) */
static void check_mean(validation *v, const experiment *x, const char *name,
                       part p, const lit_cloud *got, const double *want)
{
    double mean = 0, reference = 0;
    for (size_t i = 0; i < COLUMNS; ++i) {
        mean += got->part[p].share[i].value / COLUMNS;
        reference += want[i] / COLUMNS;
    }
    char quantity[48];
    snprintf(quantity, sizeof quantity, "%s, mean", PART_NAME[p]);
    validation_check(
        v, name, SOURCE, x->is_wrong,
        &(validation_reference){quantity, reference, MEAN_UNCERTAINTY},
        (murk_estimate){
            mean, sqrt(reference * (1 - reference) / (double)got->photons)},
        got->photons);
    if (!validation_is_quick(v)) {
        validation_mark_limit(v, MEAN_SIGMAS);
    }
}

static void check_rms(validation *v, const experiment *x, const char *name,
                      part p, const lit_cloud *got, const double *want)
{
    double square = 0, own = 0;
    for (size_t i = 0; i < COLUMNS; ++i) {
        const murk_estimate e = got->part[p].share[i];
        square += pow(e.value - want[i], 2) / COLUMNS;
        own += pow(e.standard_error, 2) / COLUMNS;
    }
    const bool is_quick = validation_is_quick(v);
    const double unit = is_quick ? sqrt(own) : 1;
    const double allowed = is_quick ? 0 : ALLOWED_RMS;
    char quantity[64];
    snprintf(quantity, sizeof quantity, "%s, rms of 32 columns%s", PART_NAME[p],
             is_quick ? ", in own errors" : "");
    validation_check(
        v, name, SOURCE, x->is_wrong,
        &(validation_reference){quantity, sqrt(own) / unit + allowed, 0},
        (murk_estimate){sqrt(square) / unit,
                        sqrt(own) / unit / sqrt(2.0 * COLUMNS)},
        got->photons);
    if (!is_quick) {
        validation_mark_bound(v);
    }
}

static void run(validation *v, const murk_table *t, const experiment *x)
{
    char name[64];
    snprintf(name, sizeof name, "step cloud, experiment %d", x->number);
    if (!validation_wants(v, name)) {
        return;
    }
    const lit_cloud got = light_up(v, x);
    for (part p = 0; p < PARTS; ++p) {
        double want[COLUMNS];
        size_t n = 0;
        for (size_t row = 0; row < t->rows; ++row) {
            if (reference_number(t, row, "experiment") == x->number &&
                n < COLUMNS) {
                want[n++] = reference_number(t, row, PART_NAME[p]);
            }
        }
        if (n == COLUMNS && !isnan(want[0])) {
            check_mean(v, x, name, p, &got, want);
            check_rms(v, x, name, p, &got, want);
        }
    }
}

#define LOW_SUN                                         \
    "lights.0.direction=[0.8660254037844386, 0, -0.5]", \
        "lights.0.irradiance_w_per_m2=2"

void cases_cloud(validation *v)
{
    murk_table *t = reference_read("step_cloud.csv");
    const experiment experiments[] = {
        {1, NULL, {NULL}},
        {2, NULL, {LOW_SUN}},
        {4, NULL, {LOW_SUN, "media.cloud.albedo=0.99"}},
        {4,
         "g .83",
         {LOW_SUN, "media.cloud.albedo=0.99", "media.cloud.phase={hg: 0.83}"}}};
    for (size_t i = 0; i < sizeof experiments / sizeof experiments[0]; ++i) {
        run(v, t, &experiments[i]);
    }
    murk_table_destroy(t);
}
