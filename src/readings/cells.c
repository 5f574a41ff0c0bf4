/* Reads the cells of a table of readings, with messages that name file, line
 * and column. */
#include "readings/cells.h"

#include "base/words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Sets of kinds. */
#define COVERAGE   MURK_READING_KIND_BIT(MURK_READ_COVERAGE)
#define IRRADIANCE MURK_READING_KIND_BIT(MURK_READ_IRRADIANCE)
#define BEAM       MURK_READING_KIND_BIT(MURK_READ_TRANSMITTANCE)
#define POINT      MURK_READING_KIND_BIT(MURK_READ_EXTINCTION)
#define LIGHT      (MURK_READING_KIND_BIT(MURK_READ_FLUENCE) | IRRADIANCE)
#define ALL        (COVERAGE | LIGHT | BEAM | POINT)

/* The columns: the kinds that need a value, and those that may have one. */
static const struct {
    const char *name;
    unsigned needed, allowed;
    bool is_text;
} COLUMNS[MURK_READING_COLUMNS] = {
    {"kind", ALL, ALL, true},
    {"condition", 0, ALL, true},
    {"x_m", ALL, ALL, false},
    {"y_m", ALL, ALL, false},
    {"z_m", ALL, ALL, false},
    {"x2_m", BEAM, BEAM, false},
    {"y2_m", BEAM, BEAM, false},
    {"z2_m", BEAM, BEAM, false},
    {"direction_x", IRRADIANCE, IRRADIANCE, false},
    {"direction_y", IRRADIANCE, IRRADIANCE, false},
    {"direction_z", IRRADIANCE, IRRADIANCE, false},
    {"radius_m", LIGHT, LIGHT, false},
    {"acceptance_deg", 0, IRRADIANCE | BEAM | POINT, false},
    {"band_nm", 0, LIGHT | BEAM | POINT, false},
    {"sensor", 0, COVERAGE, true},
    {"heading_deg", 0, COVERAGE, false},
    {"tilt_deg", 0, COVERAGE, false},
    {"group", 0, ALL, true},
    {"gain", 0, ALL, true},
    {"unit", LIGHT, ALL, true},
    {"value", ALL, ALL, false},
    {"standard_error", ALL, ALL, false},
    {"use", 0, ALL, true},
};

/* ---- the header ---- */

const char *murk_reading_column_name(murk_reading_column column)
{
    return COLUMNS[column].name;
}

murk_reading_column murk_reading_column_find(const char *name)
{
    int i = 0;
    while (i < MURK_READING_COLUMNS && strcmp(name, COLUMNS[i].name) != 0) {
        ++i;
    }
    return (murk_reading_column)i;
}

bool murk_reading_column_is_text(murk_reading_column column)
{
    return COLUMNS[column].is_text;
}

/* Fails because of an unknown column. known: number of known columns of the
 * table. */
static murk_status refuse_column(const char *where, const char *name,
                                 size_t known, murk_error *err)
{
    const char *names[MURK_READING_COLUMNS];
    char shown[64];
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        names[i] = COLUMNS[i].name;
    }
    murk_words_show(shown, sizeof shown, name);
    const murk_suggestion suggestion =
        murk_words_suggest(name, names, MURK_READING_COLUMNS);
    if (!suggestion.text[0] && known == 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "no table of readings: must have columns kind, value, "
                         "standard_error and what each kind needs, such as "
                         "x_m, but has %s",
                         shown);
    }
    return murk_fail(err, MURK_BAD_FILE, where,
                     "column %s is none of a reading's%s", shown,
                     suggestion.text);
}

murk_status murk_reading_columns(murk_reading_source *source, murk_error *err)
{
    static const murk_reading_column always[] = {
        MURK_COLUMN_KIND, MURK_COLUMN_VALUE, MURK_COLUMN_ERROR};
    const murk_table *table = source->table;
    char where[320];
    snprintf(where, sizeof where, "%.290s:%d", table->path, table->header_line);
    /* Refuse unknown columns. */
    size_t known = 0;
    for (size_t i = 0; i < table->columns; ++i) {
        known +=
            murk_reading_column_find(table->name[i]) < MURK_READING_COLUMNS;
    }
    for (size_t i = 0; i < table->columns; ++i) {
        if (murk_reading_column_find(table->name[i]) == MURK_READING_COLUMNS) {
            return refuse_column(where, table->name[i], known, err);
        }
    }
    /* Find all columns; some must exist. */
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        source->column[i] = murk_table_column(table, COLUMNS[i].name);
    }
    for (size_t i = 0; i < sizeof always / sizeof *always; ++i) {
        if (source->column[always[i]] < 0) {
            return murk_fail(err, MURK_BAD_FILE, where,
                             "misses column %s, must have kind, value and "
                             "standard_error",
                             COLUMNS[always[i]].name);
        }
    }
    return MURK_OK;
}

/* ---- cells ---- */

murk_reading_where murk_reading_where_at(const murk_table *table, int line,
                                         murk_reading_column column)
{
    murk_reading_where out;
    snprintf(out.text, sizeof out.text, "%.240s:%d: %s", table->path, line,
             COLUMNS[column].name);
    return out;
}

murk_reading_where murk_reading_where_of(const murk_reading_line *at,
                                         murk_reading_column column)
{
    const murk_table *table = at->source->table;
    return murk_reading_where_at(table, table->line[at->row], column);
}

murk_status murk_reading_fail(const murk_reading_line *at,
                              murk_reading_column column, const char *format,
                              ...)
{
    char text[sizeof at->err->text];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return murk_fail(at->err, MURK_BAD_VALUE,
                     murk_reading_where_of(at, column).text, "%s", text);
}

const char *murk_reading_cell(const murk_reading_line *at,
                              murk_reading_column column)
{
    const murk_table *table = at->source->table;
    const long c = at->source->column[column];
    return c < 0 ? "" : table->cell[at->row * table->columns + (size_t)c];
}

bool murk_reading_is_empty(const murk_reading_line *at,
                           murk_reading_column column)
{
    return murk_reading_cell(at, column)[0] == '\0';
}

murk_status murk_reading_check_cells(const murk_reading_line *at,
                                     murk_reading_kind kind)
{
    const unsigned bit = MURK_READING_KIND_BIT(kind);
    char shown[48];
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        const murk_reading_column column = (murk_reading_column)i;
        const bool is_empty = murk_reading_is_empty(at, column);
        if (is_empty && (COLUMNS[i].needed & bit)) {
            return murk_reading_fail(at, column,
                                     "nothing, but a reading of %s needs it",
                                     murk_reading_kinds[kind]);
        }
        if (!is_empty && !(COLUMNS[i].allowed & bit)) {
            murk_words_show(shown, sizeof shown, murk_reading_cell(at, column));
            return murk_reading_fail(
                at, column, "%s, but a reading of %s has none, must be empty",
                shown, murk_reading_kinds[kind]);
        }
    }
    return MURK_OK;
}

murk_status murk_reading_number(const murk_reading_line *at,
                                murk_reading_column column, double *out)
{
    return murk_table_number(at->source->table, at->row,
                             at->source->column[column], NAN, out, at->err);
}

murk_status murk_reading_vector(const murk_reading_line *at,
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
static murk_status not_one(const murk_reading_line *at,
                           murk_reading_column column, const char *const *known,
                           size_t n)
{
    const char *found = murk_reading_cell(at, column);
    char shown[64], text[480];
    murk_words_show(shown, sizeof shown, found);
    const char *meant = murk_words_meant(found, known, n);
    if (meant) {
        return murk_reading_fail(at, column, "no %s, did you mean %s?", shown,
                                 meant);
    }
    size_t used = (size_t)snprintf(text, sizeof text, "%s, must be one of ",
                                   shown[0] ? shown : "nothing");
    for (size_t i = 0; i < n && used + 70 < sizeof text; ++i) {
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s",
                                 i ? ", " : "", known[i]);
    }
    return murk_reading_fail(at, column, "%s", text);
}

murk_status murk_reading_word(const murk_reading_line *at,
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

murk_status murk_reading_name(const murk_reading_line *at,
                              murk_reading_column column, const char **out)
{
    *out = murk_reading_cell(at, column);
    for (const char *c = *out; *c; ++c) {
        if ((unsigned char)*c < 0x20 || *c == 0x7F) {
            return murk_reading_fail(at, column,
                                     "a control character, must be text");
        }
    }
    return strlen(*out) < MURK_READING_NAME_SIZE
               ? MURK_OK
               : murk_reading_fail(at, column,
                                   "longer than 63 bytes, the most there may "
                                   "be");
}
