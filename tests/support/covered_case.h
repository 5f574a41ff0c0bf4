/* A place with two media, light followed in it, and sensors that see it; with
 * the optics of any parameters by hand. */
#ifndef MURK_TESTS_COVERED_CASE_H
#define MURK_TESTS_COVERED_CASE_H

#include "calibrate/covered.h"
#include "check.h"
#include "stage_text.h"

#include <stdlib.h>

#define MEDIA    2
#define CHANNELS 4

/* Fog of two bands, smoke in a part of it, a pane, a pillar, a floor. */
static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 550]\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0.2], edge1_m: [8, 0, 0],"
    " edge2_m: [0, 6, 0]}, material: floor}\n"
    "  - {rect: {corner_m: [4, 0, 0.2], edge1_m: [0, 3, 0],"
    " edge2_m: [0, 0, 2]}, material: pane}\n"
    "  - {box: {min_m: [5, 4, 0.3], max_m: [5.5, 4.5, 2.5]},"
    " material: floor}\n"
    "materials: {floor: {diffuse: 0.7},"
    " pane: {transmit: [0.8, 0.6], specular: 0.1}}\n"
    "media:\n"
    "  fog: {extinction_per_m: [0.3, 0.2], albedo: 0.95, phase: {hg: 0.7}}\n"
    "  smoke: {extinction_per_m: 0.9, albedo: 0.6, phase: {hg: 0.4}}\n"
    "regions:\n"
    "  - {medium: fog}\n"
    "  - {medium: smoke, box: {min_m: [2, 1, 0], max_m: [5, 4, 2]}}\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2.5], power_w: [8, 4]}\n"
    "  - {type: point, position_m: [6, 5, 2], power_w: 3}\n"
    "photons: {emit: 3000}\n"
    "sensors:\n"
    "  types:\n"
    "    - {name: node, range_m: 6}\n"
    "    - {name: eye, range_m: 5, acceptance_deg: 20}\n"
    "    - {name: cam, range_m: 8, view: {cone_deg: 100}, bands: [550]}\n"
    "placement:\n"
    "  interest: [{name: gate, box: {min_m: [0, 0, 0], max_m: [3, 3, 3]},"
    " weight: 2.5}]\n";

#define POSES  7
#define GROUPS 3
static const murk_pose poses[POSES] = {
    {0, {1.5, 1.2, 1}, 0, 0}, {1, {2.5, 3, 1.5}, 0, 0}, {0, {6, 2, 1}, 0, 0},
    {2, {7.5, 5.5, 2}, 4, 0}, {1, {6, 3, 2.5}, 0, 0},   {0, {3, 2, 1}, 0, 0},
    {1, {3.2, 2, 1}, 0, 0}};
static const size_t group_of[POSES] = {0, 1, 1, 1, 1, 2, 2};

/* ---- optics by hand ---- */

typedef enum key { FOG, SMOKE, SMOKE_ALBEDO, FOG_G, NOTHING, KEYS } key;

/* What the scene says of its keys. */
static const double as_traced[KEYS] = {1, 0.9, 0.6, 0.7, 0};

typedef struct optics {
    murk_spectrum extinction[MEDIA], albedo[MEDIA];
    murk_phase phase[MEDIA][MURK_BANDS_MAX];
    murk_phases phases;
    double power_w[CHANNELS];
    murk_optics optics;
} optics;

static inline void set_optics(optics *o, const double value[KEYS])
{
    *o = (optics){.extinction = {{{0.3 * value[FOG], 0.2 * value[FOG]}},
                                 {{value[SMOKE], value[SMOKE]}}},
                  .albedo = {{{0.95, 0.95}},
                             {{value[SMOKE_ALBEDO], value[SMOKE_ALBEDO]}}}};
    for (int band = 0; band < 2; ++band) {
        o->phase[0][band] = murk_phase_hg(value[FOG_G]);
        o->phase[1][band] = murk_phase_hg(0.4);
    }
    for (int channel = 0; channel < CHANNELS; ++channel) {
        o->power_w[channel] = 1;
    }
    o->phases.medium = o->phase;
    o->optics = (murk_optics){.media = MEDIA,
                              .channels = CHANNELS,
                              .bands = 2,
                              .extinction_per_m = o->extinction,
                              .albedo = o->albedo,
                              .phases = &o->phases,
                              .power_w = o->power_w};
}

/* ---- re-weighting, and its twin: factor by factor ---- */

static inline double ratio_of(const murk_histories *f, size_t i,
                              const murk_optics *from, const murk_optics *to)
{
    const murk_contribution *c = &f->contribution[i];
    const int band = c->band;
    double ratio = 1;
    for (size_t m = 0; m < f->media; ++m) {
        const size_t medium = f->medium[m];
        const double was = from->extinction_per_m[medium].band[band];
        const double is = to->extinction_per_m[medium].band[band];
        ratio *= pow(is * to->albedo[medium].band[band] /
                         (was * from->albedo[medium].band[band]),
                     f->count[i * f->media + m]);
        ratio *= exp((was - is) * (double)f->path_m[i * f->media + m]);
    }
    for (size_t t = c->first; t < c->first + c->turns; ++t) {
        const size_t medium = f->medium[f->turn_medium[t]];
        const double mu = 1 - (double)f->turn[t];
        ratio *= murk_phase_density(&to->phases->medium[medium][band], mu) /
                 murk_phase_density(&from->phases->medium[medium][band], mu);
    }
    return ratio;
}

static inline murk_reweighed reweigh(const murk_histories *f,
                                     const murk_optics *traced,
                                     const murk_optics *at,
                                     const murk_optics_sides sides[KEYS])
{
    murk_reweighed out = {0};
    murk_error err = {0};
    CHECK(!murk_reweigh(&out, f, traced, at, sides, KEYS, 2, &err));
    CHECK_TEXT(err.text, "");
    return out;
}

/* ---- a case: light followed, and what sensors see of it ---- */

typedef struct lit {
    murk_stage *stage;
    murk_histories *followed;
    murk_covered *covered;
    optics *traced;
} lit;

static const size_t both_media[MEDIA] = {1, 0};

static inline murk_status make_covered(lit *l, const murk_pose *pose, size_t n,
                                       unsigned threads, murk_error *err)
{
    const murk_visible_desc desc = {.stage = l->stage,
                                    .optics = &l->traced->optics,
                                    .histories = l->followed,
                                    .pose = pose,
                                    .group = group_of,
                                    .poses = n,
                                    .groups = group_of[n - 1] + 1,
                                    .threads = threads};
    return murk_covered_create(&l->covered, &desc, err);
}

static inline lit lit_with(const char *const *overrides, size_t media)
{
    lit l = {.stage = stage_text_create(scene_text, overrides)};
    murk_error err = {0};
    const murk_histories_desc desc = {.stage = l.stage,
                                      .threads = 2,
                                      .medium = both_media,
                                      .media = media,
                                      .keeps_cosines = true,
                                      .keeps_records = true};
    CHECK(l.stage && !murk_histories_trace(&l.followed, &desc, &err));
    CHECK_TEXT(err.text, "");
    l.traced = malloc(sizeof *l.traced);
    set_optics(l.traced, as_traced);
    l.traced->optics.scene = (murk_scene_desc *)(uintptr_t)l.stage->scene;
    return l;
}

static inline lit lit_and_seen(const char *const *overrides)
{
    lit l = lit_with(overrides, MEDIA);
    murk_error err = {0};
    CHECK(!make_covered(&l, poses, POSES, 2, &err));
    CHECK_TEXT(err.text, "");
    return l;
}

static inline void put_out(lit *l)
{
    murk_covered_destroy(l->covered);
    murk_histories_destroy(l->followed);
    free(l->traced);
    stage_text_destroy(l->stage);
}

typedef struct read_out {
    double value[GROUPS], slope[GROUPS][KEYS], *batch;
    murk_status status;
    murk_error err;
} read_out;

/* Evaluates the groups; of 64 batches of its own where batch is NULL. */
static inline murk_status
read_covered(double value[GROUPS], double slope[GROUPS][KEYS], double *batch,
             size_t batches, const lit *l, const murk_reweighed *reweighed,
             const murk_optics *at, const murk_optics_sides *sides,
             murk_error *err)
{
    static double own[64 * GROUPS], run[4 * GROUPS * KEYS];
    const murk_row_sums sums = {.value = value,
                                .slope = slope[0],
                                .batch = batches ? batch : own,
                                .run = run,
                                .rows = GROUPS,
                                .batches = batches ? batches : 64,
                                .runs = 4};
    return murk_covered_read(&sums, 0, l->covered, reweighed,
                             &l->traced->optics, at, sides, err);
}

static inline read_out read_at(const lit *l, const double at[KEYS], double step,
                               size_t batches)
{
    read_out out = {.batch =
                        malloc((batches * GROUPS + 1) * sizeof *out.batch)};
    optics here, low[KEYS], high[KEYS];
    murk_optics_sides sides[KEYS] = {{0}};
    /* Media at the point, and at both sides of it for each parameter. */
    set_optics(&here, at);
    for (size_t k = 0; k < NOTHING; ++k) {
        double value[KEYS];
        memcpy(value, at, sizeof value);
        value[k] = at[k] * (1 - step);
        set_optics(&low[k], value);
        value[k] = at[k] * (1 + step);
        set_optics(&high[k], value);
        sides[k] = (murk_optics_sides){&low[k].optics, &high[k].optics,
                                       2 * step * at[k]};
    }
    /* Re-weight the traced light, and sum coverage with slopes. */
    murk_reweighed reweighed =
        reweigh(l->followed, &l->traced->optics, &here.optics, sides);
    out.status = read_covered(out.value, out.slope, out.batch, batches, l,
                              &reweighed, &here.optics, sides, &out.err);
    murk_reweighed_release(&reweighed);
    return out;
}

#define STEP 1e-4

#endif
