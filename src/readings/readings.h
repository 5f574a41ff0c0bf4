/* The readings of a file, and the rows of a fit that they form.
 *
 * Columns and meanings: doc/reference/calibration.md. A row of a fit is one
 * reading, or all readings of coverage of one `group` in one condition
 * together. Values stay in the unit of the file; the prediction of the model is
 * converted to it (murk_reading_in_unit() of readings/units.h). */
#ifndef MURK_READINGS_READINGS_H
#define MURK_READINGS_READINGS_H

#include "base/arena.h"
#include "readings/line.h"

/* Limits of a file: more readings than field campaigns have, and as many
 * factors as a fit may have parameters (MURK_FREE_MAX in
 * calibrate/free_keys.h). */
#define MURK_READINGS_MAX      100000
#define MURK_READING_GAINS_MAX 512

typedef struct murk_reading_row {
    size_t first, n; /* readings of the row, adjacent in reading[] */
} murk_reading_row;

typedef struct murk_readings {
    char *path;            /* of the file whose lines the readings have */
    murk_reading *reading; /* [readings]; those of a row are adjacent */
    size_t readings;
    murk_reading_row *row; /* [rows]; in the order of their first lines */
    size_t rows, held_out; /* held_out: number of rows that are held out */
    char (
        *group)[MURK_READING_NAME_SIZE]; /* [rows]; empty: none. Coverage of one
                                          * group and condition is one row; for
                                          * other kinds the group is a label */
    char (*gain)[MURK_READING_NAME_SIZE]; /* [gains]; names of free factors */
    size_t gains;
    bool is_mapped;   /* a mapping file made the readings */
    char sha256[65];  /* of the file; with a mapping, of both files */
    murk_arena arena; /* of all arrays but the path */
} murk_readings;

/* The first reading of a row, which has the kind, unit, value, error, factor
 * and condition of the row. */
static inline const murk_reading *
murk_reading_of_row(const murk_readings *readings, size_t row)
{
    return &readings->reading[readings->row[row].first];
}

/* Reads a CSV file of readings, or the file of measurements that a mapping file
 * names (readings/mapping.h), and checks it against the scene (conditions,
 * bands, sensor types) and the domain; the message for an error in a line has
 * the line number. If readings are in a unit that is derived from a
 * transmittance, a note with the formula is logged. The caller owns *out
 * (murk_readings_destroy()). */
murk_status murk_readings_read(murk_readings **out, const char *path,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err);
void murk_readings_destroy(murk_readings *measured); /* NULL is fine */

#endif
