/* One condition at one set of values, built and lit: its rows of light there,
 * and re-weighted to others. */
#ifndef MURK_CALIBRATE_LIT_H
#define MURK_CALIBRATE_LIT_H

#include "calibrate/covered.h"
#include "calibrate/free_keys.h"
#include "calibrate/instruments.h"

/* What all lights of a condition share; borrowed. */
typedef struct murk_lit_desc {
    const murk_free_keys *keys;
    const murk_instruments *instruments;
    const murk_stage *base; /* imported: files are its own */
    size_t condition;       /* index into keys->condition */
    const size_t *medium;   /* [media] that keys re-weight */
    size_t media;
    bool keeps_cosines;
    size_t batches, runs; /* of photons; runs divides batches */
    unsigned threads;
} murk_lit_desc;

typedef struct murk_lit {
    const murk_lit_desc *desc;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_optics *optics;
    murk_followed *followed; /* NULL: no row asks for light */
    murk_covered *covered;   /* NULL: none for coverage */
    murk_spectrum *per_watt; /* [receivers][lights] to their units */
} murk_lit;

/* Its world, dark. Release also after a failure. */
murk_status murk_lit_build(murk_lit *out, const murk_lit_desc *desc,
                           const double *value, murk_error *err);
void murk_lit_release(murk_lit *lit);

/* Its light, where a row asks for any: of as many photons as the scene says, or
 * of so many (not 0). To be darkened, or released, also after a failure. */
murk_status murk_lit_light(murk_lit *lit, uint64_t photons, murk_error *err);
void murk_lit_darken(murk_lit *lit);

/* Both. Release also after a failure. */
murk_status murk_lit_create(murk_lit *out, const murk_lit_desc *desc,
                            const double *value, murk_error *err);

/* Rows of light, posts->lit of them: value[lit] in their units without gain;
 * slope[lit][keys], or NULL, by the keys of sides[keys]; batch[batches][lit]
 * whose totals are the values, run[runs][lit][keys] those of the slopes; share
 * as in murk_reweighed. */
typedef struct murk_lit_rows {
    double *value, *slope, *batch, *run;
    double share;
    murk_reweighed reweighed; /* room that the next reading uses again */
} murk_lit_rows;

/* Room for desc's rows; fails with MURK_NO_MEMORY; release it always. */
murk_status murk_lit_rows_create(murk_lit_rows *out, const murk_lit_desc *desc,
                                 size_t keys, murk_error *err);
void murk_lit_rows_release(murk_lit_rows *rows);

murk_status murk_lit_read(murk_lit_rows *out, const murk_lit *lit,
                          const murk_measurements *measured,
                          const murk_optics *at, const murk_optics_sides *sides,
                          size_t keys, murk_error *err);

#endif
