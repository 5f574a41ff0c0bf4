/* What a row of a study measures of its light: photon density over the domain
 * and in regions of interest, and the scene's own tallies as single numbers.
 *
 * Density is the mean scalar irradiance over what is free of the place: track
 * lengths over its free volume (plan/free_share.h). */
#ifndef MURK_CASES_ROW_TALLIES_H
#define MURK_CASES_ROW_TALLIES_H

#include "cases/outputs.h"
#include "cases/row.h"
#include "lightmap/lightmap.h"
#include "plan/free_share.h"

typedef struct murk_row_tally {
    char name[MURK_ROW_NAME_SIZE]; /* of the value: "density_pool" */
    murk_part part;                /* of a density */
    bool is_density;
    double per_unit; /* what a tally's value counts times: 1 / area of planes */
} murk_row_tally;

typedef struct murk_row_tallies {
    const murk_study_file *study; /* borrowed */
    size_t n;
    murk_tally_desc *desc;         /* [n] tallies of as few cells as can be */
    murk_row_tally *row_tally;     /* [n] */
    size_t fluence;                /* the grid's number; n: none */
    char note[MURK_ROW_TEXT_SIZE]; /* what cannot be measured, or empty */
} murk_row_tallies;

/* Of a built stage. Release also after a failure. */
murk_status murk_row_tallies_create(murk_row_tallies *out,
                                    const murk_stage *stage,
                                    const murk_outputs *outputs,
                                    murk_error *err);
void murk_row_tallies_release(murk_row_tallies *row_tallies);

/* Adds their values to the row: those of `tallies`, with packets worth
 * packet_w; tallies NULL: it is dark. */
murk_status
murk_row_tallies_read(murk_study_row *row, const murk_row_tallies *row_tallies,
                      const murk_stage *stage, const murk_tallies *tallies,
                      const murk_tally *emitted, const double *packet_w,
                      unsigned threads, murk_error *err);

/* Writes the grid's values, W/m2, as a .vdb file. */
murk_status murk_row_tallies_write_fluence(
    const char *path, const murk_row_tallies *row_tallies,
    const murk_scene_desc *scene, const murk_tallies *tallies,
    const murk_tally *emitted, const double *packet_w, murk_error *err);

/* Text for free() that tells apart what is measured with the tracing, of the
 * scene alone; NULL when out of memory. */
char *murk_row_tallies_sign(const murk_scene_desc *scene,
                            const murk_outputs *outputs);

#endif
