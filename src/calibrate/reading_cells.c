/* Reads the cells of a table of readings, with messages that name file, line
 * and column. */
#include "calibrate/reading_cells.h"

#include "scene/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const NAMES[MURK_READING_COLUMNS] = {"kind",
                                                        "condition",
                                                        "x_m",
                                                        "y_m",
                                                        "z_m",
                                                        "x2_m",
                                                        "y2_m",
                                                        "z2_m",
                                                        "direction_x",
                                                        "direction_y",
                                                        "direction_z",
                                                        "radius_m",
                                                        "acceptance_deg",
                                                        "band_nm",
                                                        "sensor",
                                                        "heading_deg",
                                                        "tilt_deg",
                                                        "group",
                                                        "gain",
                                                        "unit",
                                                        "value",
                                                        "standard_error",
                                                        "use"};

const char *const murk_reading_kinds[MURK_READING_KINDS] = {
    [MURK_READ_COVERAGE] = "coverage",
    [MURK_READ_FLUENCE] = "fluence",
    [MURK_READ_IRRADIANCE] = "irradiance",
    [MURK_READ_TRANSMITTANCE] = "transmittance"};

/* ---- the header ---- */

static murk_status refuse(const murk_table *table, const char *text,
                          murk_error *err)
{
    char where[320];
    snprintf(where, sizeof where, "%.290s:%d", table->path, table->header_line);
    return murk_fail(err, MURK_BAD_FILE, where, "%s", text);
}

static bool is_known(const char *name)
{
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        if (strcmp(name, NAMES[i]) == 0) {
            return true;
        }
    }
    return false;
}

/* Fails because of an unknown column. known: number of known columns of the
 * table. */
static murk_status refuse_column(const murk_table *table, const char *name,
                                 size_t known, murk_error *err)
{
    char shown[64], text[256];
    murk_words_show(shown, sizeof shown, name);
    const char *meant = murk_words_meant(name, NAMES, MURK_READING_COLUMNS);
    if (!meant && known == 0) {
        snprintf(text, sizeof text,
                 "no table of readings: must have columns kind, value, "
                 "standard_error and what each kind needs, such as x_m, but "
                 "has %s",
                 shown);
    } else {
        snprintf(text, sizeof text, "column %s is none of a reading's%s%s%s",
                 shown, meant ? ", did you mean " : "", meant ? meant : "",
                 meant ? "?" : "");
    }
    return refuse(table, text, err);
}

murk_status murk_reading_columns(murk_reading_source *source, murk_error *err)
{
    static const murk_reading_column always[] = {
        MURK_COLUMN_KIND, MURK_COLUMN_VALUE, MURK_COLUMN_ERROR};
    const murk_table *table = source->table;
    /* Refuse unknown columns. */
    size_t known = 0;
    for (size_t i = 0; i < table->columns; ++i) {
        known += is_known(table->name[i]);
    }
    for (size_t i = 0; i < table->columns; ++i) {
        if (!is_known(table->name[i])) {
            return refuse_column(table, table->name[i], known, err);
        }
    }
    /* Find all columns; some must exist. */
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        source->column[i] = murk_table_column(table, NAMES[i]);
    }
    for (size_t i = 0; i < sizeof always / sizeof *always; ++i) {
        if (source->column[always[i]] < 0) {
            char text[128];
            snprintf(text, sizeof text,
                     "misses column %s, must have kind, value and "
                     "standard_error",
                     NAMES[always[i]]);
            return refuse(table, text, err);
        }
    }
    return MURK_OK;
}

/* ---- cells ---- */

void murk_reading_where(char out[320], const murk_table *table, int line,
                        murk_reading_column column)
{
    snprintf(out, 320, "%.240s:%d: %s", table->path, line, NAMES[column]);
}

const char *murk_reading_cell(const murk_reading_row *at,
                              murk_reading_column column)
{
    const murk_table *table = at->source->table;
    const long c = at->source->column[column];
    return c < 0 ? "" : table->cell[at->row * table->columns + (size_t)c];
}

murk_status murk_reading_fail(const murk_reading_row *at,
                              murk_reading_column column, const char *text)
{
    char where[320];
    murk_reading_where(where, at->source->table,
                       at->source->table->line[at->row], column);
    return murk_fail(at->err, MURK_BAD_VALUE, where, "%s", text);
}

murk_status murk_reading_number(const murk_reading_row *at,
                                murk_reading_column column, double *out)
{
    return murk_table_number(at->source->table, at->row,
                             at->source->column[column], NAN, out, at->err);
}

murk_status murk_reading_vector(const murk_reading_row *at,
                                murk_reading_column first, murk_vec3 *out)
{
    double x[3];
    for (int i = 0; i < 3; ++i) {
        const murk_status status = murk_reading_number(
            at, (murk_reading_column)((int)first + i), &x[i]);
        if (status) {
            return status;
        }
    }
    *out = murk_vec(x[0], x[1], x[2]);
    return MURK_OK;
}

/* Fails because a word is unknown, with a suggestion or the list of words. */
static murk_status not_one(const murk_reading_row *at,
                           murk_reading_column column, const char *const *known,
                           size_t n)
{
    const char *found = murk_reading_cell(at, column);
    char shown[64], text[480];
    murk_words_show(shown, sizeof shown, found);
    const char *meant = murk_words_meant(found, known, n);
    size_t used = (size_t)snprintf(text, sizeof text, "%s, must be one of ",
                                   shown[0] ? shown : "nothing");
    if (meant) {
        snprintf(text, sizeof text, "no %s, did you mean %s?", shown, meant);
    }
    for (size_t i = 0; !meant && i < n && used + 70 < sizeof text; ++i) {
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s",
                                 i ? ", " : "", known[i]);
    }
    return murk_reading_fail(at, column, text);
}

murk_status murk_reading_word(const murk_reading_row *at,
                              murk_reading_column column,
                              const char *const *known, size_t n, size_t *out)
{
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(murk_reading_cell(at, column), known[i]) == 0) {
            *out = i;
            return MURK_OK;
        }
    }
    return not_one(at, column, known, n);
}

murk_status murk_reading_name(const murk_reading_row *at,
                              murk_reading_column column, const char **out)
{
    *out = murk_reading_cell(at, column);
    for (const char *c = *out; *c; ++c) {
        if ((unsigned char)*c < 0x20 || *c == 0x7F) {
            return murk_reading_fail(at, column,
                                     "a control character, must be text");
        }
    }
    return strlen(*out) < 64
               ? MURK_OK
               : murk_reading_fail(at, column,
                                   "longer than 63 bytes, the most there may "
                                   "be");
}
