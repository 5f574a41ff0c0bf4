/* Reads one line of a file of readings: checks which columns the kind of
 * reading needs and allows, then reads place, unit, value and error. */
#include "calibrate/reading_row.h"

#include "calibrate/reading_place.h"
#include "calibrate/reading_units.h"
#include "scene/words.h"

#include <math.h>
#include <stdio.h>

static const char *const USES[] = {"fit", "hold_out"};

#define BIT(column)   (1u << (MURK_COLUMN_##column))
#define THREE(column) (7u << (MURK_COLUMN_##column))

/* Bit sets of columns: those that every reading needs, those that every reading
 * may have, and both by kind. */
static const unsigned ALWAYS = BIT(KIND) | THREE(X) | BIT(VALUE) | BIT(ERROR);
static const unsigned ANY =
    BIT(CONDITION) | BIT(GROUP) | BIT(GAIN) | BIT(UNIT) | BIT(USE);
static const unsigned NEEDED[] = {
    [MURK_READ_COVERAGE] = 0,
    [MURK_READ_FLUENCE] = BIT(RADIUS) | BIT(UNIT),
    [MURK_READ_IRRADIANCE] = BIT(RADIUS) | BIT(UNIT) | THREE(DIRECTION_X),
    [MURK_READ_TRANSMITTANCE] = THREE(X2)};
static const unsigned ALLOWED[] = {
    [MURK_READ_COVERAGE] = BIT(SENSOR) | BIT(HEADING) | BIT(TILT),
    [MURK_READ_FLUENCE] = BIT(BAND),
    [MURK_READ_IRRADIANCE] = BIT(BAND) | BIT(ACCEPTANCE),
    [MURK_READ_TRANSMITTANCE] = BIT(BAND) | BIT(ACCEPTANCE)};

/* ---- columns of a kind ---- */

/* Fails if a needed cell is empty, or if a cell is not empty that the kind does
 * not have. */
static murk_status check_cells(const murk_reading_row *at,
                               murk_reading_kind kind)
{
    const unsigned needed = ALWAYS | NEEDED[kind];
    const unsigned known = needed | ANY | ALLOWED[kind];
    char shown[48], text[128];
    for (int i = 0; i < MURK_READING_COLUMNS; ++i) {
        const bool is_there =
            murk_reading_cell(at, (murk_reading_column)i)[0] != '\0';
        if (!is_there && (needed & (1u << i))) {
            snprintf(text, sizeof text, "nothing, but a reading of %s needs it",
                     murk_reading_kinds[kind]);
            return murk_reading_fail(at, (murk_reading_column)i, text);
        }
        if (is_there && !(known & (1u << i))) {
            murk_words_show(shown, sizeof shown,
                            murk_reading_cell(at, (murk_reading_column)i));
            snprintf(text, sizeof text,
                     "%s, but a reading of %s has none, must be empty", shown,
                     murk_reading_kinds[kind]);
            return murk_reading_fail(at, (murk_reading_column)i, text);
        }
    }
    return MURK_OK;
}

static murk_status read_condition(murk_reading *out, const murk_reading_row *at)
{
    const murk_scene_desc *scene = at->source->scene;
    const char *known[MURK_SCENE_CONDITIONS_MAX];
    out->condition = SIZE_MAX;
    if (murk_reading_cell(at, MURK_COLUMN_CONDITION)[0] == '\0') {
        return MURK_OK;
    }
    if (scene->n_conditions == 0) {
        return murk_reading_fail(at, MURK_COLUMN_CONDITION,
                                 "the scene has no conditions, must be empty");
    }
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        known[i] = scene->conditions[i].name;
    }
    return murk_reading_word(at, MURK_COLUMN_CONDITION, known,
                             scene->n_conditions, &out->condition);
}

/* ---- value ---- */

/* Largest value and error: squares and inverse squares remain representable. */
#define LARGEST 1e30

static murk_status read_value(murk_reading *out, const murk_reading_row *at)
{
    char where[320], text[96];
    murk_status status =
        murk_reading_number(at, MURK_COLUMN_VALUE, &out->value);
    if (!status && !(fabs(out->value) <= LARGEST)) {
        snprintf(text, sizeof text, "%.9g, must be %g..%g", out->value,
                 -LARGEST, LARGEST);
        return murk_reading_fail(at, MURK_COLUMN_VALUE, text);
    }
    if (!status) {
        murk_reading_where(where, at->source->table,
                           at->source->table->line[at->row], MURK_COLUMN_VALUE);
        status = murk_reading_unit_check(out->unit, out->value, where, at->err);
    }
    return status;
}

static murk_status read_error(murk_reading *out, const murk_reading_row *at)
{
    char text[128];
    const murk_status status =
        murk_reading_number(at, MURK_COLUMN_ERROR, &out->standard_error);
    const double e = out->standard_error;
    if (!status && !(e >= 1 / LARGEST && e <= LARGEST)) {
        snprintf(text, sizeof text,
                 "%.9g, must be more than 0 (%g to %g), in the value's unit", e,
                 1 / LARGEST, LARGEST);
        return murk_reading_fail(at, MURK_COLUMN_ERROR, text);
    }
    return status;
}

/* Reads the unit; units of relative light need a factor, and units per length
 * permit none. */
static murk_status read_unit(murk_reading *out, const murk_reading_row *at)
{
    /* Find the unit. */
    char where[320], text[200];
    murk_reading_where(where, at->source->table,
                       at->source->table->line[at->row], MURK_COLUMN_UNIT);
    const murk_status status = murk_reading_unit_find(
        &out->unit, murk_reading_cell(at, MURK_COLUMN_UNIT), out->kind, where,
        at->err);
    if (status) {
        return status;
    }
    /* Compare with the column of factors. */
    const bool has_gain = murk_reading_cell(at, MURK_COLUMN_GAIN)[0] != '\0';
    if (!has_gain && murk_reading_unit_needs_gain(out->unit, out->kind)) {
        snprintf(text, sizeof text,
                 "nothing, but light in %s has a free factor, must be its "
                 "name NAME, for --free gain.NAME",
                 murk_reading_unit_name(out->unit));
        return murk_reading_fail(at, MURK_COLUMN_GAIN, text);
    }
    if (has_gain && !murk_reading_unit_takes_gain(out->unit)) {
        snprintf(text, sizeof text,
                 "a free factor of what is in %s, must be empty: factors are "
                 "of fractions, percents and light",
                 murk_reading_unit_name(out->unit));
        return murk_reading_fail(at, MURK_COLUMN_GAIN, text);
    }
    return MURK_OK;
}

/* Fails for a unit in which the bands count nothing, such as lux of infrared
 * light. */
static murk_status check_counts(const murk_reading *out,
                                const murk_reading_row *at)
{
    const murk_scene_desc *scene = at->source->scene;
    const murk_spectrum count = murk_reading_per_watt(out->unit, scene);
    double sum = 0;
    for (int b = 0; b < scene->bands; ++b) {
        sum += out->band < 0 || out->band == b ? count.band[b] : 0;
    }
    char text[128];
    snprintf(text, sizeof text, "%s, but light of %s counts nothing in it",
             murk_reading_unit_name(out->unit),
             out->band < 0 ? "all of the scene's bands" : "this band");
    return sum > 0 ? MURK_OK : murk_reading_fail(at, MURK_COLUMN_UNIT, text);
}

murk_status murk_reading_read(murk_reading *out, const char **group,
                              const char **gain,
                              const murk_reading_source *source, size_t row,
                              murk_error *err)
{
    const murk_reading_row at = {source, row, err};
    size_t kind = 0, use = 0;
    /* The kind determines the columns. */
    murk_status status = murk_reading_word(
        &at, MURK_COLUMN_KIND, murk_reading_kinds, MURK_READING_KINDS, &kind);
    if (status) {
        return status;
    }
    *out = (murk_reading){.kind = (murk_reading_kind)kind,
                          .line = (size_t)source->table->line[row],
                          .gain = SIZE_MAX};
    /* Read each part. */
    if ((status = check_cells(&at, out->kind)) ||
        (status = read_condition(out, &at)) ||
        (status = murk_reading_place(out, &at)) ||
        (status = read_unit(out, &at)) || (status = check_counts(out, &at)) ||
        (status = read_value(out, &at)) || (status = read_error(out, &at)) ||
        (status = murk_reading_name(&at, MURK_COLUMN_GROUP, group)) ||
        (status = murk_reading_name(&at, MURK_COLUMN_GAIN, gain))) {
        return status;
    }
    /* Whether the reading is held out. */
    if (murk_reading_cell(&at, MURK_COLUMN_USE)[0] != '\0') {
        status = murk_reading_word(&at, MURK_COLUMN_USE, USES, 2, &use);
    }
    out->is_held_out = use == 1;
    return status;
}
