/* Light under a level sea of index 1.34, the sun at 60 degrees from the zenith
 * and nothing else in the sky: canonical problems 1 (Rayleigh) and 2
 * (Petzold's average particle) of Mobley et al. 1993. Ed is the downward
 * irradiance, Eou the upward scalar irradiance, in W/m2.
 *
 * The sea is a half space with an index, 1 m deep per optical depth, and ends
 * at 60 m in nothing: what would come back from there to 10 m is less than
 * exp(-.2 * 100) of what is there (.2 per m being the slowest decay of these
 * waters, albedo .9 and Petzold). It is so wide that hardly any photon meets a
 * side, where the domain is periodic.
 *
 * Published means are those of seven models, with how far they differ. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cases/groups.h"
#include "cases/reference.h"
#include "medium/phase_table.h"
#include "scores.h"
#include "worlds.h"

#define INDEX        1.34
#define SUN_COSINE   0.5
#define ED_SURFACE   0.5
#define DEPTH_M      60.0
#define HALF_WIDTH_M 1e4
#define ROWS_MAX     64

/* Weights down to this in the dark waters: for the same time at tau 10 the
 * error of Ed is .7, that of Eou .35 of what roulette alone gives. Less yet,
 * and a few photons that were never scattered outweigh all others, whose
 * spread then tells nothing of theirs. */
#define DARK_WEIGHT .01

#define SOURCE                                                          \
    "adding-doubling, 90 to 240 nodes; published: Mobley et al. 1993, " \
    "table 5"

#define QUANTITIES_A_DEPTH 4
#define DEPTHS_MAX         3

/* One water and its depths. */
typedef struct water {
    int problem;
    double albedo;
    murk_phase phase;
    double index;
    const char *is_wrong;
    double traced_albedo; /* 0: the albedo */
} water;

/* The context of score(): Ed and Eou of each depth, each twice (against the
 * computed and the published value). */
typedef struct depths {
    size_t n;
    score_of of[2 * DEPTHS_MAX];
    char name[DEPTHS_MAX * QUANTITIES_A_DEPTH][48];
    validation_reference reference[DEPTHS_MAX * QUANTITIES_A_DEPTH];
} depths;

static void score(const void *context, const murk_event *before,
                  const murk_event *event, double *out)
{
    const depths *d = context;
    double share[2 * DEPTHS_MAX] = {0};
    scores_add(&(scores){d->of, 2 * d->n}, before, event, share);
    for (size_t i = 0; i < 2 * d->n; ++i) {
        out[2 * i] += ED_SURFACE * share[i];
        out[2 * i + 1] += ED_SURFACE * share[i];
    }
}

static validation_reference published(const murk_table *t, size_t row,
                                      const char *value, const char *differ,
                                      const char *name)
{
    validation_reference r = reference_value(t, row, value, name);
    r.uncertainty =
        hypot(r.uncertainty, r.value * reference_number(t, row, differ));
    return r;
}

static void add_depth(depths *d, const murk_table *t, size_t row)
{
    const double tau = reference_number(t, row, "tau");
    char(*name)[48] = &d->name[QUANTITIES_A_DEPTH * d->n];
    validation_reference *r = &d->reference[QUANTITIES_A_DEPTH * d->n];
    d->of[2 * d->n] = (score_of){.kind = SCORE_POWER, .side = -1, .z_m = -tau};
    d->of[2 * d->n + 1] =
        (score_of){.kind = SCORE_FLUENCE, .side = 1, .z_m = -tau};
    snprintf(name[0], sizeof name[0], "Ed at tau %g", tau);
    snprintf(name[1], sizeof name[1], "Ed at tau %g, published", tau);
    snprintf(name[2], sizeof name[2], "Eou at tau %g", tau);
    snprintf(name[3], sizeof name[3], "Eou at tau %g, published", tau);
    r[0] = reference_value(t, row, "ed", name[0]);
    r[1] = published(t, row, "published_ed", "differ_ed", name[1]);
    r[2] = reference_value(t, row, "eou", name[2]);
    r[3] = published(t, row, "published_eou", "differ_eou", name[3]);
    ++d->n;
}

static test_world sea_made(const water *w)
{
    const double sine = sqrt(1 - SUN_COSINE * SUN_COSINE);
    const murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                             .direction = {sine, 0, -SUN_COSINE},
                             .power_w = {{ED_SURFACE / SUN_COSINE}},
                             .where = "sun"};
    murk_medium medium =
        test_medium(1, w->traced_albedo > 0 ? w->traced_albedo : w->albedo, 0);
    medium.phase[0] = w->phase;
    const murk_region sea = {.shape = MURK_REGION_BELOW,
                             .to_world = murk_affine_identity(),
                             .ior = w->index,
                             .where = "sea"};
    const double half = HALF_WIDTH_M;
    return test_world_made(&(test_setup){
        .domain = {{{-half, -half, -DEPTH_M}, {half, half, 1}}, true},
        .lights = &sun,
        .n_lights = 1,
        .media = &medium,
        .n_media = 1,
        .regions = &sea,
        .n_regions = 1});
}

/* Depths that are traced together, and how small the absolute bound on their
 * errors is, next to that of all cases: where a thousandth or a millionth of
 * the light is left, the common one would say nothing. */
typedef struct stretch {
    const char *name;
    double tau_min, tau_max;
    double bound;
} stretch;

static void trace(validation *v, const murk_table *t, const water *w,
                  const stretch *at)
{
    char name[64];
    snprintf(name, sizeof name, "%s albedo %g, %s",
             w->problem == 1 ? "Rayleigh" : "Petzold", w->albedo, at->name);
    if (!validation_wants(v, name)) {
        return;
    }
    /* The depths of this stretch in the published table. */
    depths d = {0};
    for (size_t row = 0; row < t->rows; ++row) {
        const double tau = reference_number(t, row, "tau");
        if (reference_number(t, row, "problem") == w->problem &&
            reference_number(t, row, "albedo") == w->albedo &&
            tau >= at->tau_min && tau <= at->tau_max && d.n < DEPTHS_MAX) {
            add_depth(&d, t, row);
        }
    }
    /* Trace the sea once for all depths. */
    test_world world = sea_made(w);
    validation_trace(
        v, &(validation_case){.name = name,
                              .source = SOURCE,
                              .is_wrong = w->is_wrong,
                              .world = &world.world,
                              .reference = d.reference,
                              .quantities = QUANTITIES_A_DEPTH * d.n,
                              .score = score,
                              .context = &d,
                              .least_weight = w->albedo < .5 ? DARK_WEIGHT : 1,
                              .error_scale = ED_SURFACE * at->bound});
    test_world_unmade(&world);
}

static murk_phase_table *petzold_made(void)
{
    murk_table *t = reference_read("petzold.csv");
    double angle_deg[ROWS_MAX], phase_per_sr[ROWS_MAX];
    const size_t rows = t->rows < ROWS_MAX ? t->rows : ROWS_MAX;
    for (size_t i = 0; i < rows; ++i) {
        angle_deg[i] = reference_number(t, i, "angle_deg");
        phase_per_sr[i] = reference_number(t, i, "phase_per_sr");
    }
    murk_phase_table *table = NULL;
    murk_error err = {0};
    if (murk_phase_table_create(&table,
                                &(murk_phase_rows){.rows = rows,
                                                   .angle_deg = angle_deg,
                                                   .phase_per_sr = phase_per_sr,
                                                   .line = t->line,
                                                   .where = t->path},
                                &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        exit(1);
    }
    murk_table_destroy(t);
    return table;
}

void cases_sea(validation *v)
{
    murk_table *t = reference_read("sea.csv");
    murk_phase_table *petzold = petzold_made();
    const murk_phase phase[] = {murk_phase_rayleigh(),
                                murk_phase_tabulated(petzold)};
    const bool is_quick = validation_is_quick(v);
    /* Quick: 3e-5 W/m2, of which the beam brings half a one. */
    const stretch bright = {"all depths", 1, 10, is_quick ? 2 : 1};
    const stretch dark[] = {{"tau 1", 1, 1, 1},
                            {"tau 5", 5, 5, is_quick ? .2 : .05},
                            {"tau 10", 10, 10, .004}};
    for (int p = 0; p < 2; ++p) {
        for (size_t i = 0; i < (is_quick ? 2 : 3); ++i) {
            trace(v, t, &(water){p + 1, .2, phase[p], INDEX, NULL, 0},
                  &dark[i]);
        }
        trace(v, t, &(water){p + 1, .9, phase[p], INDEX, NULL, 0}, &bright);
    }
    trace(v, t, &(water){1, .2, phase[0], 1.30, "index 1.30", 0}, &dark[0]);
    const water wrong = {2, .9, phase[1], INDEX, "albedo .89", .89};
    trace(v, t, &wrong, &bright);
    murk_phase_table_destroy(petzold);
    murk_table_destroy(t);
}
