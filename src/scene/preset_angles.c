/* Reads the phase functions of presets, tabulated by angle: one for all
 * wavelengths, or one for each of several, from a CSV file in media/. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "preset/files.h"
#include "scene/keys_preset.h"
#include "scene/table.h"
#include "scene/value.h"

/* The end of the name of a column with a phase function at one wavelength. */
#define NANOMETRES "_nm"

/* Parses a built-in table; the caller owns it. */
static murk_status open_table(murk_table **out, const murk_built_in_file *file,
                              murk_error *err)
{
    char *text = malloc(file->size + 1);
    if (!text) {
        return murk_no_memory(err, file->name, "for a table");
    }
    memcpy(text, file->text, file->size + 1);
    return murk_table_parse(out, file->name, text, file->size, err);
}

static murk_status read_column(const murk_table *csv, long column, double *out,
                               murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < csv->rows && !status; ++i) {
        status = murk_table_number(csv, i, column, NAN, &out[i], err);
    }
    return status;
}

/* The wavelength in a column name such as "450_nm"; 0 for other names. */
static double wavelength_of(const char *name)
{
    char number[MURK_NUMBER_SIZE];
    const size_t length = strlen(name), end = strlen(NANOMETRES);
    double nm = 0;
    if (length <= end || length - end >= sizeof number ||
        strcmp(name + length - end, NANOMETRES) != 0) {
        return 0;
    }
    memcpy(number, name, length - end);
    number[length - end] = '\0';
    return murk_number_parse(number, &nm) ? nm : 0;
}

/* Reads one column for each wavelength, in the order of the file. */
static murk_status read_by_wavelength(murk_preset_angles *out,
                                      const murk_table *csv, murk_error *err)
{
    size_t n = 0;
    murk_status status = MURK_OK;
    for (size_t c = 0; c < csv->columns && !status; ++c) {
        const double nm = wavelength_of(csv->name[c]);
        if (nm > 0) {
            out->wavelength_nm[n] = nm;
            status = read_column(csv, (long)c,
                                 out->phase_per_sr + n++ * out->angles, err);
        }
    }
    return status;
}

/* Reads either one phase function for all wavelengths, or one for each of
 * several. */
static murk_status read_phases(murk_key_reader *walk, const murk_yaml *node,
                               const murk_table *csv, murk_preset_angles **out)
{
    const long angle = murk_table_column(csv, "angle_deg");
    const long plain = murk_table_column(csv, "phase_per_sr");
    size_t n = 0;
    for (size_t c = 0; c < csv->columns; ++c) {
        n += wavelength_of(csv->name[c]) > 0;
    }
    if (angle < 0 || (plain >= 0) == (n > 0) || csv->rows < 2) {
        return murk_walk_fail(walk, node,
                              "must have angle_deg and either phase_per_sr "
                              "or columns such as 450_nm");
    }
    murk_status status =
        murk_preset_angles_create(out, csv->rows, n ? n : 1, n, walk->err);
    if (!status) {
        status = read_column(csv, angle, (*out)->angle_deg, walk->err);
    }
    if (!status) {
        status = n ? read_by_wavelength(*out, csv, walk->err)
                   : read_column(csv, plain, (*out)->phase_per_sr, walk->err);
    }
    return status;
}

murk_status murk_preset_read_angles(murk_key_reader *walk, const murk_key *key,
                                    murk_yaml *node, void *angles)
{
    murk_table *csv = NULL;
    if (node->kind != MURK_YAML_SCALAR) {
        return murk_value_wrong(walk, key, node);
    }
    const murk_built_in_file *file =
        murk_built_in_find(&murk_media_files, node->text);
    if (!file) {
        return murk_walk_fail(walk, node, "no file %.100s in media",
                              node->text);
    }
    murk_status status = open_table(&csv, file, walk->err);
    if (!status) {
        status = read_phases(walk, node, csv, angles);
    }
    murk_table_destroy(csv);
    return status;
}
