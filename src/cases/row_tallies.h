/* Tallies of one row of a study: photon density over the domain and in regions
 * of interest, the tallies of the scene as single numbers, and a grid of the
 * fluence rate over the domain.
 *
 * The density of a volume is the mean scalar irradiance over the free part of
 * the volume: track length divided by free volume (plan/free_space.h). */
#ifndef MURK_CASES_ROW_TALLIES_H
#define MURK_CASES_ROW_TALLIES_H

#include "cases/outputs.h"
#include "cases/row.h"
#include "lightmap/lightmap.h"
#include "plan/free_space.h"

#include <stdio.h>

typedef struct murk_row_tally {
    char name[MURK_ROW_NAME_SIZE]; /* name of the value, such as
                                      "density_pool" */
    murk_part part;                /* of a density: the box or sphere */
    bool is_density;
    double per_unit; /* factor on the value of the tally: for a plane 1 / area
                      * of the plane in the domain (NaN if there is none), else
                      * 1 */
} murk_row_tally;

typedef struct murk_row_tallies {
    const murk_study_file *study; /* borrowed */
    size_t n;
    murk_tally_desc *desc;     /* [n] tallies with one cell for each direction;
                                * the grid of the fluence rate has more */
    murk_row_tally *row_tally; /* [n] */
    size_t fluence;            /* number of the grid of the fluence rate in
                                * desc[]; SIZE_MAX: no grid */
    char note[MURK_ROW_TEXT_SIZE]; /* what cannot be measured; may be empty */
} murk_row_tallies;

/* The tallies that the outputs need, of a built stage. Release *out also after
 * a failure. */
murk_status murk_row_tallies_create(murk_row_tallies *out,
                                    const murk_stage *stage,
                                    const murk_outputs *outputs,
                                    murk_error *err);
void murk_row_tallies_release(murk_row_tallies *row_tallies);

/* The light that the tallies of a row are read from. */
typedef struct murk_row_light {
    const murk_tallies *tallies; /* NULL: the row is dark and values are 0 */
    const murk_tally *emitted;
    const double *packet_w; /* [light * bands + band] watts of a packet */
} murk_row_light;

/* Adds the values of all tallies but the grid of the fluence rate to the
 * row. */
murk_status murk_row_tallies_read(murk_study_row *row,
                                  const murk_row_tallies *row_tallies,
                                  const murk_stage *stage,
                                  const murk_row_light *light, unsigned threads,
                                  murk_error *err);

/* Writes the grid of the fluence rate in W/m2 as a .vdb file. */
murk_status murk_row_tallies_write_fluence(const char *path,
                                           const murk_row_tallies *row_tallies,
                                           const murk_scene_desc *scene,
                                           const murk_row_light *light,
                                           murk_error *err);

/* Prints the settings that the tallies of a row depend on, for a hash: within
 * one study, equal texts mean equal tallies in worlds that are otherwise
 * equal. */
void murk_row_tallies_sign(FILE *out, const murk_scene_desc *scene,
                           const murk_outputs *outputs);

#endif
