/* Grid tallies of a result folder: slices through the middle of each.
 *
 * Grids are read by child processes, so before the report makes any thread or
 * ray device. */
#ifndef MURK_REPORT_FIELDS_H
#define MURK_REPORT_FIELDS_H

#include "report/data.h"
#include "report/results_in.h"
#include "scene/scene.h"

/* Of all tallies and bands; more are said to be there. */
#define MURK_REPORT_FIELDS_MAX 12

/* Cells along an axis of a map at most; a field of more is thinned. */
#define MURK_REPORT_CELLS_MAX 128

typedef struct murk_report_field {
    const murk_scene_tally *asked; /* of the scene below */
    double band_nm;
    double *value, *error; /* of all cells of the slices, below; NULL where
                              the file cannot be read: then note says why */
    char note[320];
} murk_report_field;

typedef struct murk_report_fields {
    const murk_scene_desc *scene; /* of the results */
    murk_report_field field[MURK_REPORT_FIELDS_MAX];
    size_t fields, asked; /* read, and that there are */
} murk_report_fields;

/* What cannot be read is said in a note. Fails with MURK_NO_MEMORY. Release in
 * any case. */
murk_status murk_report_fields_read(murk_report_fields *out,
                                    const murk_results_in *results,
                                    murk_error *err);
void murk_report_fields_release(murk_report_fields *fields);

/* Slices as data of the page: `fields` and `fields_asked`. */
void murk_report_fields_add(murk_data *data, const murk_report_fields *fields);

#endif
