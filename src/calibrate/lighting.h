/* One condition at one set of parameter values: the world, the traced light,
 * and the rows that need light ("lit rows"), which can be re-weighted to other
 * values. */
#ifndef MURK_CALIBRATE_LIT_H
#define MURK_CALIBRATE_LIT_H

#include "calibrate/covered.h"
#include "calibrate/free_keys.h"
#include "calibrate/instruments.h"

/* The properties that all lights of a condition share; borrowed. */
typedef struct murk_lit_desc {
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
} murk_lit_desc;

typedef struct murk_lit {
    const murk_lit_desc *desc;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_optics *optics;
    murk_followed *followed; /* NULL: no row needs light */
    murk_covered *covered;   /* NULL: no row of coverage */
    murk_spectrum *per_watt; /* [receivers][lights]; factors to the units of the
                              * receivers */
} murk_lit;

/* Builds the world without light. Release also after a failure. */
murk_status murk_lit_build(murk_lit *out, const murk_lit_desc *desc,
                           const double *value, murk_error *err);
void murk_lit_release(murk_lit *lit);

/* Traces the light if any row needs it, with the number of photons of the
 * scene, or with `photons` if that is not 0. Call murk_lit_darken() or release
 * also after a failure. */
murk_status murk_lit_light(murk_lit *lit, uint64_t photons, murk_error *err);
void murk_lit_darken(murk_lit *lit);

/* Both. Release also after a failure. */
murk_status murk_lit_create(murk_lit *out, const murk_lit_desc *desc,
                            const double *value, murk_error *err);

/* The lit rows, instruments->lit of them. value[lit] in the units of the rows,
 * without factors of readings; slope[lit][keys], or NULL, with respect to the
 * keys of sides[keys]; batch[batches][lit], which add up to the values;
 * run[runs][lit][keys], which add up to the slopes; share as in murk_reweighed.
 */
typedef struct murk_lit_rows {
    double *value, *slope, *batch, *run;
    double share;
    murk_reweighed reweighed; /* workspace that the next evaluation reuses */
} murk_lit_rows;

/* Allocates the rows of desc. Fails with MURK_NO_MEMORY; release in any case.
 */
murk_status murk_lit_rows_create(murk_lit_rows *out, const murk_lit_desc *desc,
                                 size_t keys, murk_error *err);
void murk_lit_rows_release(murk_lit_rows *rows);

/* Evaluates the lit rows at the optics `at`. */
murk_status murk_lit_read(murk_lit_rows *out, const murk_lit *lit,
                          const murk_measurements *measured,
                          const murk_optics *at, const murk_optics_sides *sides,
                          size_t keys, murk_error *err);

#endif
