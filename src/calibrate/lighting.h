/* One condition at one set of parameter values: the world, the traced light,
 * and the rows that need light ("light rows"), which can be re-weighted to
 * other values. */
#ifndef MURK_CALIBRATE_LIGHTING_H
#define MURK_CALIBRATE_LIGHTING_H

#include "base/arena.h"
#include "calibrate/covered.h"
#include "calibrate/free_keys.h"
#include "calibrate/instruments.h"

/* The settings that each traced light of one condition has: that of the fit,
 * and those for the slopes of world keys (calibrate/world_slopes.h). The
 * pointers are borrowed. */
typedef struct murk_lighting_desc {
    const murk_free_keys *keys;
    const murk_instruments *instruments;
    const murk_stage *base; /* imported; the files belong to it */
    size_t condition;       /* index into keys->condition */
    const size_t *medium;   /* [media]; media that keys re-weight */
    size_t media;
    bool keeps_cosines;
    size_t batches, runs; /* batches and runs of photons; runs divides batches
                           */
    unsigned threads;
} murk_lighting_desc;

typedef struct murk_lighting {
    const murk_lighting_desc *desc;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_optics *optics;
    murk_histories *histories; /* NULL: no row needs light */
    murk_covered *covered;     /* NULL: no row of coverage */
    murk_spectrum *per_watt;   /* [receivers][light sources]; factors by band
                                * from watts to the units of the receivers */
} murk_lighting;

/* Builds the world without light. Release also after a failure. */
murk_status murk_lighting_build(murk_lighting *out,
                                const murk_lighting_desc *desc,
                                const double *value, murk_error *err);
void murk_lighting_release(murk_lighting *lighting);

/* Traces the light if any row needs it, with the number of photons of the
 * scene, or with `photons` if that is not 0. Call murk_lighting_darken() or
 * release also after a failure. */
murk_status murk_lighting_trace(murk_lighting *lighting, uint64_t photons,
                                murk_error *err);
void murk_lighting_darken(murk_lighting *lighting);

/* The light rows, instruments->lights of them: sums in the units of the rows,
 * without factors of readings. share: the effective share of murk_reweighed. */
typedef struct murk_lighting_rows {
    double *value, *slope, *batch, *run; /* as in murk_row_sums */
    double share;
    murk_reweighed reweighed; /* workspace that the next evaluation reuses */
    murk_arena arena;         /* of all arrays */
} murk_lighting_rows;

/* Allocates the rows of desc. Fails with MURK_NO_MEMORY; release in any case.
 */
murk_status murk_lighting_rows_create(murk_lighting_rows *out,
                                      const murk_lighting_desc *desc,
                                      size_t keys, murk_error *err);
void murk_lighting_rows_release(murk_lighting_rows *rows);

/* Ranks (base/ranks.h) divide the evaluation of so many contributions or more,
 * and of one for each MURK_LIGHTING_SUMS_EACH sums that are exchanged: an
 * exchange takes as long as some ten thousand contributions, and that of a sum
 * a few nanoseconds, where a contribution takes some hundred. */
#define MURK_LIGHTING_DIVIDED   16384
#define MURK_LIGHTING_SUMS_EACH 16

/* Evaluates the light rows of a traced condition at the optics `at`;
 * sides[keys] as in murk_reweigh(). Fails as murk_reweigh() and
 * murk_covered_read(). Collective if ranks divide it. */
murk_status murk_lighting_read(murk_lighting_rows *out,
                               const murk_lighting *lighting,
                               const murk_readings *measured,
                               const murk_optics *at,
                               const murk_optics_sides *sides, size_t keys,
                               murk_error *err);

#endif
