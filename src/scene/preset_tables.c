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
static murk_status open_table(const murk_preset_walk *walk,
                              const murk_yaml *node, murk_table **out)
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
    return murk_table_parse(out, file->name, text, file->size, walk->err);
}

static murk_status read_column(const murk_preset_walk *walk,
                               const murk_table *csv, long column, double *out)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < csv->rows && !status; ++i) {
        status = murk_table_number(csv, i, column, NAN, &out[i], walk->err);
    }
    return status;
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

static murk_status read_lists(const murk_preset_walk *walk,
                              const murk_yaml *map, columns *out)
{
    const char *known[KNOWN_MAX];
    for (int c = 0; c <= COLUMNS; ++c) {
        known[c] = COLUMN[c].name;
    }
    murk_status status = murk_preset_check_keys(walk, map, known);
    const murk_yaml *nm = status ? NULL : murk_yaml_get(map, COLUMN[NM].name);
    out->n = nm && nm->kind == MURK_YAML_LIST ? nm->n : 1;
    for (int c = 0; c < COLUMNS && !status; ++c) {
        const murk_yaml *list = murk_yaml_get(map, COLUMN[c].name);
        if (list) {
            out->value[c] = calloc(out->n + 1, sizeof(double));
            status = out->value[c] ? murk_preset_numbers(walk, list, out->n,
                                                         out->value[c])
                                   : murk_preset_no_memory(walk);
        }
    }
    return status;
}

static murk_status read_csv(const murk_preset_walk *walk, const murk_yaml *node,
                            columns *out)
{
    murk_table *csv = NULL;
    murk_status status = open_table(walk, node, &csv);
    if (status) {
        return status;
    }
    out->n = csv->rows;
    for (int c = 0; c < COLUMNS && !status; ++c) {
        const long column = murk_table_column(csv, COLUMN[c].name);
        if (column >= 0) {
            out->value[c] = calloc(out->n + 1, sizeof(double));
            status = out->value[c]
                         ? read_column(walk, csv, column, out->value[c])
                         : murk_preset_no_memory(walk);
        }
    }
    murk_table_destroy(csv);
    return status;
}

/* Checks that values are in range, and that wavelengths rise and span those
 * of the preset. */
static murk_status check_columns(const murk_preset_walk *walk,
                                 const murk_yaml *node, const columns *in)
{
    const double *nm = in->value[NM], *range = walk->preset->wavelength_nm;
    if (!nm || in->n == 0) {
        return murk_preset_fail(walk, node, "misses wavelength_nm");
    }
    /* Range of every value. */
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
    /* Wavelengths. */
    for (size_t i = 1; i < in->n; ++i) {
        if (!(nm[i] > nm[i - 1])) {
            return murk_preset_fail(walk, node, "%.9g nm after %.9g, must rise",
                                    nm[i], nm[i - 1]);
        }
    }
    if (!(nm[0] <= range[0] && nm[in->n - 1] >= range[1])) {
        return murk_preset_fail(walk, node,
                                "spans %.9g..%.9g nm, less than wavelength_nm",
                                nm[0], nm[in->n - 1]);
    }
    return MURK_OK;
}

/* Converts extinction and albedo to absorption and scattering, in place. */
static murk_status split(const murk_preset_walk *walk, const murk_yaml *node,
                         columns *in)
{
    double **value = in->value;
    if (!value[EXTINCTION] && !value[ALBEDO]) {
        return value[ABSORPTION] || value[SCATTERING] || value[DIFFUSE]
                   ? MURK_OK
                   : murk_preset_fail(walk, node, "has no coefficients");
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
    return MURK_OK;
}

murk_status murk_preset_read_table(const murk_preset_walk *walk,
                                   const murk_yaml *node,
                                   murk_preset_table *out)
{
    columns in = {0};
    murk_status status = node->kind == MURK_YAML_SCALAR
                             ? read_csv(walk, node, &in)
                             : read_lists(walk, node, &in);
    if (!status) {
        /* Range, order and completeness. */
        status = check_columns(walk, node, &in);
    }
    if (!status) {
        status = split(walk, node, &in);
    }
    if (!status) {
        *out =
            (murk_preset_table){.n = in.n,
                                .wavelength_nm = in.value[NM],
                                .absorption_per_m = in.value[ABSORPTION],
                                .scattering_per_m = in.value[SCATTERING],
                                .mean_cosine = in.value[COSINE],
                                .diffuse_attenuation_per_m = in.value[DIFFUSE]};
        return MURK_OK;
    }
    for (int c = 0; c < COLUMNS; ++c) {
        free(in.value[c]);
    }
    return status;
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

static murk_status fill_by_wavelength(const murk_preset_walk *walk,
                                      const murk_yaml *node,
                                      const murk_table *csv,
                                      murk_preset_angles *out)
{
    const double *range = walk->preset->wavelength_nm;
    double *nm = out->wavelength_nm;
    murk_status status = MURK_OK;
    size_t n = 0;
    /* One column for each wavelength, in the order of the file. */
    for (size_t c = 0; c < csv->columns && !status; ++c) {
        if (wavelength_of(csv->name[c]) > 0) {
            nm[n] = wavelength_of(csv->name[c]);
            status = read_column(walk, csv, (long)c,
                                 out->phase_per_sr + n++ * out->angles);
        }
    }
    /* Wavelengths must rise and span those of the preset. */
    for (size_t i = 1; i < n && !status; ++i) {
        if (!(nm[i] > nm[i - 1])) {
            status = murk_preset_fail(walk, node, "its wavelengths must rise");
        }
    }
    if (!status && !(nm[0] <= range[0] && nm[n - 1] >= range[1])) {
        status = murk_preset_fail(walk, node,
                                  "spans %.9g..%.9g nm, less than "
                                  "wavelength_nm",
                                  nm[0], nm[n - 1]);
    }
    return status;
}

murk_status murk_preset_read_angles(const murk_preset_walk *walk,
                                    const murk_yaml *node,
                                    murk_preset_angles **out)
{
    murk_table *csv = NULL;
    murk_preset_angles *angles = NULL;
    if (node->kind != MURK_YAML_SCALAR) {
        return murk_preset_fail(walk, node, "must be the name of a csv file");
    }
    murk_status status = open_table(walk, node, &csv);
    if (status) {
        return status;
    }
    /* Either one phase function for all wavelengths, or one for each of
     * several. */
    const long angle = murk_table_column(csv, "angle_deg");
    const long plain = murk_table_column(csv, "phase_per_sr");
    size_t n = 0;
    for (size_t c = 0; c < csv->columns; ++c) {
        n += wavelength_of(csv->name[c]) > 0;
    }
    if (angle < 0 || (plain >= 0) == (n > 0) || csv->rows < 2) {
        status = murk_preset_fail(walk, node,
                                  "must have angle_deg and either "
                                  "phase_per_sr or columns such as 450_nm");
        goto done;
    }
    status =
        murk_preset_angles_create(&angles, csv->rows, n ? n : 1, n, walk->err);
    if (!status) {
        status = read_column(walk, csv, angle, angles->angle_deg);
    }
    if (!status) {
        status = n ? fill_by_wavelength(walk, node, csv, angles)
                   : read_column(walk, csv, plain, angles->phase_per_sr);
    }
    if (!status) {
        *out = angles;
        angles = NULL;
    }
done:
    murk_preset_angles_destroy(angles);
    murk_table_destroy(csv);
    return status;
}
