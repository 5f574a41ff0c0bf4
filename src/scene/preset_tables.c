/* Reads the tables of a preset: coefficients by wavelength, from lists in
 * the YAML file or from a CSV file, and phase functions by angle from a CSV
 * file. */
#include "scene/preset_walk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "preset/files.h"
#include "scene/table.h"

#define KNOWN_MAX (COLUMNS + 1) /* one more for the end of the list */

/* The ending of a column of a phase function at one wavelength. */
#define NANOMETRES "_nm"

/* Opens and parses the table that a node names; the caller owns it. */
static bool open_table(murk_preset_walk *walk, const murk_yaml *node,
                       murk_table **out)
{
    const murk_media_file *file = murk_media_file_find(node->text);
    if (!file) {
        return murk_preset_fail(walk, node, "no file %.100s in media",
                                node->text);
    }
    char *text = malloc(file->size + 1);
    if (!text) {
        return murk_preset_no_memory(walk);
    }
    memcpy(text, file->text, file->size + 1);
    walk->status =
        murk_table_parse(out, file->name, text, file->size, walk->err);
    return !walk->status;
}

static bool read_column(murk_preset_walk *walk, const murk_table *csv,
                        long column, double *out)
{
    for (size_t i = 0; i < csv->rows && !walk->status; ++i) {
        walk->status =
            murk_table_number(csv, i, column, NAN, &out[i], walk->err);
    }
    return !walk->status;
}

/* Checks that wavelengths rise and span those of the preset. */
static bool check_wavelengths(murk_preset_walk *walk, const murk_yaml *node,
                              const double *nm, size_t n)
{
    const double *range = walk->preset->wavelength_nm;
    for (size_t i = 1; i < n; ++i) {
        if (!(nm[i] > nm[i - 1])) {
            return murk_preset_fail(walk, node, "%.9g nm after %.9g, must rise",
                                    nm[i], nm[i - 1]);
        }
    }
    return (nm[0] <= range[0] && nm[n - 1] >= range[1]) ||
           murk_preset_fail(walk, node,
                            "spans %.9g..%.9g nm, less than wavelength_nm",
                            nm[0], nm[n - 1]);
}

/* ---- coefficients ---- */

enum {
    NM,
    ABSORPTION,
    SCATTERING,
    EXTINCTION,
    ALBEDO,
    COSINE,
    DIFFUSE,
    COLUMNS
};

static const struct {
    const char *name;
    double min, max;
} COLUMN[KNOWN_MAX] = {{"wavelength_nm", 1e-9, 1e9},
                       {"absorption_per_m", 0, 1e9},
                       {"scattering_per_m", 0, 1e9},
                       {"extinction_per_m", 0, 1e9},
                       {"albedo", 0, 1},
                       {"mean_cosine", -.999999, .999999},
                       {"diffuse_attenuation_per_m", 0, 1e9},
                       {NULL, 0, 0}};

typedef struct columns {
    size_t n; /* rows */
    double *value[COLUMNS];
} columns;

/* Reads the columns that a map of lists or a CSV file has. */
static bool read_columns(murk_preset_walk *walk, const murk_yaml *node,
                         columns *out)
{
    murk_table *csv = NULL;
    const murk_yaml *nm = murk_yaml_get(node, COLUMN[NM].name);
    const char *known[KNOWN_MAX];
    for (int c = 0; c <= COLUMNS; ++c) {
        known[c] = COLUMN[c].name;
    }
    /* A file, or a map; the number of rows. */
    bool is_read = node->kind == MURK_YAML_SCALAR
                       ? open_table(walk, node, &csv)
                       : murk_preset_check_keys(walk, node, known);
    out->n = csv ? csv->rows : nm && nm->kind == MURK_YAML_LIST ? nm->n : 1;
    for (int c = 0; c < COLUMNS && is_read; ++c) {
        const long column = csv ? murk_table_column(csv, COLUMN[c].name) : -1;
        const murk_yaml *list = murk_yaml_get(node, COLUMN[c].name);
        if (column < 0 && !list) {
            continue;
        }
        out->value[c] = calloc(out->n + 1, sizeof(double));
        is_read = !out->value[c] ? murk_preset_no_memory(walk)
                  : csv
                      ? read_column(walk, csv, column, out->value[c])
                      : murk_preset_numbers(walk, list, out->n, out->value[c]);
    }
    murk_table_destroy(csv);
    return is_read;
}

/* Checks wavelengths and the range of every value. */
static bool check_columns(murk_preset_walk *walk, const murk_yaml *node,
                          const columns *in)
{
    if (!in->value[NM] || in->n == 0) {
        return murk_preset_fail(walk, node, "misses wavelength_nm");
    }
    for (int c = 0; c < COLUMNS; ++c) {
        for (size_t i = 0; in->value[c] && i < in->n; ++i) {
            if (!(in->value[c][i] >= COLUMN[c].min &&
                  in->value[c][i] <= COLUMN[c].max)) {
                return murk_preset_fail(
                    walk, node, "%s %.9g, must be %.6g..%.6g", COLUMN[c].name,
                    in->value[c][i], COLUMN[c].min, COLUMN[c].max);
            }
        }
    }
    return check_wavelengths(walk, node, in->value[NM], in->n);
}

/* Converts extinction and albedo to absorption and scattering, in place. */
static bool split(murk_preset_walk *walk, const murk_yaml *node, columns *in)
{
    double **value = in->value;
    if (!value[EXTINCTION] && !value[ALBEDO]) {
        return value[ABSORPTION] || value[SCATTERING] || value[DIFFUSE] ||
               murk_preset_fail(walk, node, "has no coefficients");
    }
    if (!value[EXTINCTION] || !value[ALBEDO] || value[ABSORPTION] ||
        value[SCATTERING]) {
        return murk_preset_fail(walk, node,
                                "must have extinction_per_m and albedo, or "
                                "absorption_per_m and scattering_per_m");
    }
    for (size_t i = 0; i < in->n; ++i) {
        const double scattering = value[EXTINCTION][i] * value[ALBEDO][i];
        value[ALBEDO][i] = scattering;
        value[EXTINCTION][i] -= scattering;
    }
    value[ABSORPTION] = value[EXTINCTION];
    value[SCATTERING] = value[ALBEDO];
    value[EXTINCTION] = value[ALBEDO] = NULL;
    return true;
}

bool murk_preset_read_table(murk_preset_walk *walk, const murk_yaml *node,
                            murk_preset_table *out)
{
    columns in = {0};
    const bool is_read = read_columns(walk, node, &in) &&
                         check_columns(walk, node, &in) &&
                         split(walk, node, &in);
    /* The preset owns the columns, even if they are refused. */
    *out = (murk_preset_table){.n = in.n,
                               .wavelength_nm = in.value[NM],
                               .absorption_per_m = in.value[ABSORPTION],
                               .scattering_per_m = in.value[SCATTERING],
                               .mean_cosine = in.value[COSINE],
                               .diffuse_attenuation_per_m = in.value[DIFFUSE]};
    free(in.value[EXTINCTION]);
    free(in.value[ALBEDO]);
    return is_read;
}

/* ---- phase functions ---- */

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
static bool read_by_wavelength(murk_preset_walk *walk, const murk_yaml *node,
                               const murk_table *csv, murk_preset_angles *out)
{
    size_t n = 0;
    bool is_read = true;
    for (size_t c = 0; c < csv->columns && is_read; ++c) {
        const double nm = wavelength_of(csv->name[c]);
        if (nm > 0) {
            out->wavelength_nm[n] = nm;
            is_read = read_column(walk, csv, (long)c,
                                  out->phase_per_sr + n++ * out->angles);
        }
    }
    return is_read && check_wavelengths(walk, node, out->wavelength_nm, n);
}

/* Reads either one phase function for all wavelengths, or one for each of
 * several. */
static bool read_phases(murk_preset_walk *walk, const murk_yaml *node,
                        const murk_table *csv, murk_preset_angles **out)
{
    const long angle = murk_table_column(csv, "angle_deg");
    const long plain = murk_table_column(csv, "phase_per_sr");
    size_t n = 0;
    for (size_t c = 0; c < csv->columns; ++c) {
        n += wavelength_of(csv->name[c]) > 0;
    }
    if (angle < 0 || (plain >= 0) == (n > 0) || csv->rows < 2) {
        return murk_preset_fail(walk, node,
                                "must have angle_deg and either phase_per_sr "
                                "or columns such as 450_nm");
    }
    walk->status =
        murk_preset_angles_create(out, csv->rows, n ? n : 1, n, walk->err);
    return !walk->status && read_column(walk, csv, angle, (*out)->angle_deg) &&
           (n ? read_by_wavelength(walk, node, csv, *out)
              : read_column(walk, csv, plain, (*out)->phase_per_sr));
}

bool murk_preset_read_angles(murk_preset_walk *walk, const murk_yaml *node,
                             murk_preset_angles **out)
{
    murk_table *csv = NULL;
    if (node->kind != MURK_YAML_SCALAR) {
        return murk_preset_fail(walk, node, "must be the name of a csv file");
    }
    const bool is_read =
        open_table(walk, node, &csv) && read_phases(walk, node, csv, out);
    murk_table_destroy(csv);
    return is_read;
}
