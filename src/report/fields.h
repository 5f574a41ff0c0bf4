/* Grid tallies of a result folder: slices through the middle of each.
 * Subprocesses read the grids, so murk_report_fields_read() must be called
 * before the program makes a thread or a ray device. */
#ifndef MURK_REPORT_FIELDS_H
#define MURK_REPORT_FIELDS_H

#include "report/data.h"
#include "report/results_in.h"
#include "scene/scene.h"

/* Largest number of fields that are read; a field is a tally in a band. Of
 * more, only the number is stated. */
#define MURK_REPORT_FIELDS_MAX 12

/* Largest number of cells along an axis of a map. If there are more, only every
 * n-th is taken. */
#define MURK_REPORT_CELLS_MAX 128

typedef struct murk_report_field {
    const murk_scene_tally *asked; /* in murk_report_fields.scene */
    double band_nm;
    double *value, *error; /* cells of the three slices, one slice after the
                              other; NULL if the file cannot be read, for the
                              reason in note */
    char note[320];
} murk_report_field;

typedef struct murk_report_fields {
    const murk_scene_desc *scene; /* of the results; NULL: none */
    murk_report_field field[MURK_REPORT_FIELDS_MAX];
    size_t fields, asked; /* read; in the folder */
} murk_report_fields;

/* Reads the grids. If a file cannot be read, the note of the field says so.
 * Fails with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_report_fields_read(murk_report_fields *out,
                                    const murk_results_in *results,
                                    murk_error *err);
void murk_report_fields_release(murk_report_fields *fields);

/* Adds the slices to the data of the page, as `fields` and `fields_asked`. */
void murk_report_fields_add(murk_data *data, const murk_report_fields *fields);

#endif
