/* Reads one line of a file of readings: the kind and the columns that it needs
 * (readings/cells.h), then place, instrument, unit, value and error.
 */
#include "readings/line.h"

#include "base/position.h"
#include "base/words.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#define SENSOR_TYPES_MAX 64 /* sensor types that a scene may have */
#define RAD_PER_DEG      (MURK_PI / 180) /* radians in a degree */

/* Largest value and largest error, in any unit; the inverse is the smallest
 * error. Squares and inverse squares remain representable. */
#define LARGEST 1e30

static const char *const USES[] = {"fit", "hold_out"};

/* ---- place and instrument ---- */

static murk_status outside(const murk_reading_line *at,
                           murk_reading_column column, const char *what,
                           murk_vec3 p)
{
    const murk_box *box = &at->source->domain->box;
    return murk_reading_fail(
        at, column, "%s %s m is outside the domain, %s to %s m", what,
        murk_position_show(p).text, murk_position_show(box->min).text,
        murk_position_show(box->max).text);
}

/* Reads a position, which must lie in the domain; *out is local to the origin
 * of the scene. */
static murk_status inside(const murk_reading_line *at,
                          murk_reading_column column, murk_vec3 *out)
{
    const murk_status status = murk_reading_vector(at, column, out);
    *out = status ? *out : murk_scene_local(at->source->scene, *out);
    return status || murk_box_contains(&at->source->domain->box, *out)
               ? status
               : outside(at, column, "the place", *out);
}

/* Reads the band: the one that contains the wavelength; empty means all. */
static murk_status read_band(murk_reading *out, const murk_reading_line *at)
{
    const murk_scene_desc *scene = at->source->scene;
    double nm = NAN;
    /* Empty: all bands. */
    out->band = -1;
    if (murk_reading_is_empty(at, MURK_COLUMN_BAND)) {
        return MURK_OK;
    }
    /* The band that contains the wavelength. */
    const murk_status status = murk_reading_number(at, MURK_COLUMN_BAND, &nm);
    if (status) {
        return status;
    }
    out->band = murk_scene_band_of(scene, nm);
    if (out->band >= 0) {
        return MURK_OK;
    }
    /* Suggest the nearest band. */
    int near = 0;
    for (int b = 1; b < scene->bands; ++b) {
        near = fabs(scene->band_nm[b] - nm) < fabs(scene->band_nm[near] - nm)
                   ? b
                   : near;
    }
    return murk_reading_fail(
        at, MURK_COLUMN_BAND,
        "%.9g nm is in no band of the scene, did you mean %.9g?", nm,
        scene->band_nm[near]);
}

/* Reads an angle that the sensor type requires. */
static murk_status read_angle(const murk_reading_line *at,
                              murk_reading_column column, double max_deg,
                              double *rad)
{
    double deg = NAN;
    if (murk_reading_is_empty(at, column)) {
        return murk_reading_fail(at, column,
                                 "nothing, but a sensor of this type needs it");
    }
    const murk_status status = murk_reading_number(at, column, &deg);
    if (!status && !(fabs(deg) <= max_deg)) {
        return murk_reading_fail(at, column, "%.9g, must be %g..%g degrees",
                                 deg, -max_deg, max_deg);
    }
    *rad = deg * RAD_PER_DEG;
    return status;
}

/* Reads the type of a sensor, and heading and tilt unless the type sees in all
 * directions. */
static murk_status read_sensor(murk_reading *out, const murk_reading_line *at)
{
    const murk_scene_sensors *sensors = &at->source->scene->sensors;
    const char *known[SENSOR_TYPES_MAX];
    size_t k = 0;
    /* The type may be left out if there is only one. */
    if (sensors->types == 0) {
        return murk_reading_fail(
            at, MURK_COLUMN_KIND,
            "coverage, but the scene has no sensors, must have their types");
    }
    for (size_t i = 0; i < sensors->types; ++i) {
        known[i] = sensors->type[i].name;
    }
    if (!murk_reading_is_empty(at, MURK_COLUMN_SENSOR) || sensors->types > 1) {
        const murk_status status = murk_reading_word(at, MURK_COLUMN_SENSOR,
                                                     known, sensors->types, &k);
        if (status) {
            return status;
        }
    }
    out->pose = (murk_pose){.type = (uint32_t)k, .position = out->position};
    if (sensors->type[k].view == MURK_VIEW_SPHERE) {
        return MURK_OK;
    }
    /* A type that does not see in all directions needs heading and tilt. */
    const murk_status status =
        read_angle(at, MURK_COLUMN_HEADING, 360, &out->pose.heading_rad);
    return status ? status
                  : read_angle(at, MURK_COLUMN_TILT, 90, &out->pose.tilt_rad);
}

/* Reads a receiver, whose sphere must lie in the domain entirely: there is no
 * light outside. */
static murk_status read_receiver(murk_reading *out, const murk_reading_line *at)
{
    const murk_box *box = &at->source->domain->box;
    const murk_vec3 p = out->position;
    /* Radius. */
    murk_status status =
        murk_reading_number(at, MURK_COLUMN_RADIUS, &out->radius_m);
    const double r = out->radius_m;
    char text[64];
    if (status) {
        return status;
    }
    if (!(r > 0 && r <= 1e9)) {
        return murk_reading_fail(at, MURK_COLUMN_RADIUS,
                                 "%.9g, must be more than 0 m", r);
    }
    /* Tolerance for rounding: a few units in the last place of the coordinates.
     */
    const double slack =
        4 * DBL_EPSILON * fmax(murk_length(box->min), murk_length(box->max));
    if (!(p.x - r >= box->min.x - slack && p.x + r <= box->max.x + slack &&
          p.y - r >= box->min.y - slack && p.y + r <= box->max.y + slack &&
          p.z - r >= box->min.z - slack && p.z + r <= box->max.z + slack)) {
        snprintf(text, sizeof text, "with a radius of %.6g m the sphere at", r);
        return outside(at, MURK_COLUMN_RADIUS, text, p);
    }
    if (out->kind == MURK_READ_FLUENCE) {
        return MURK_OK;
    }
    /* Irradiance needs the normal of the receiving side. */
    status = murk_reading_vector(at, MURK_COLUMN_DIRECTION_X, &out->direction);
    const double length = murk_length(out->direction);
    if (!status && !(length > 0 && isfinite(length))) {
        return murk_reading_fail(
            at, MURK_COLUMN_DIRECTION_X,
            "direction_x, _y, _z have no length, must point outward "
            "from the receiver");
    }
    out->direction = murk_scale(1 / length, out->direction);
    return status;
}

static murk_status read_segment(murk_reading *out, const murk_reading_line *at)
{
    const murk_status status = inside(at, MURK_COLUMN_X2, &out->to);
    return status || murk_length(murk_sub(out->to, out->position)) > 0
               ? status
               : murk_reading_fail(
                     at, MURK_COLUMN_X2,
                     "x2_m, y2_m, z2_m are the place itself, must be the "
                     "segment's other end");
}

/* Reads the acceptance angle, which may be empty. */
static murk_status read_acceptance(murk_reading *out,
                                   const murk_reading_line *at)
{
    const double maximum = out->kind == MURK_READ_IRRADIANCE ? 90 : 180;
    double deg = NAN;
    out->acceptance_rad = NAN;
    if (murk_reading_is_empty(at, MURK_COLUMN_ACCEPTANCE)) {
        return MURK_OK;
    }
    const murk_status status =
        murk_reading_number(at, MURK_COLUMN_ACCEPTANCE, &deg);
    const bool is_good = out->kind == MURK_READ_IRRADIANCE ? deg > 0 : deg >= 0;
    if (!status && !(is_good && deg <= maximum)) {
        return murk_reading_fail(
            at, MURK_COLUMN_ACCEPTANCE, "%.9g, must be %s %g degrees", deg,
            maximum < 180 ? "more than 0 and at most" : "0 to", maximum);
    }
    out->acceptance_rad = deg * RAD_PER_DEG;
    return status;
}

/* Reads position, band, acceptance, and the properties of the kind of reading:
 * a sensor, a sphere, a segment or a point. */
static murk_status read_place(murk_reading *out, const murk_reading_line *at)
{
    murk_status status = MURK_OK;
    if ((status = inside(at, MURK_COLUMN_X, &out->position)) ||
        (status = read_band(out, at)) || (status = read_acceptance(out, at))) {
        return status;
    }
    switch (out->kind) {
    case MURK_READ_COVERAGE:
        return read_sensor(out, at);
    case MURK_READ_TRANSMITTANCE:
        return read_segment(out, at);
    case MURK_READ_EXTINCTION:
        out->to = out->position;
        return MURK_OK;
    default:
        return read_receiver(out, at);
    }
}

static murk_status read_condition(murk_reading *out,
                                  const murk_reading_line *at)
{
    const murk_scene_desc *scene = at->source->scene;
    const char *known[MURK_SCENE_CONDITIONS_MAX];
    out->condition = SIZE_MAX;
    if (murk_reading_is_empty(at, MURK_COLUMN_CONDITION)) {
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

static murk_status read_value(murk_reading *out, const murk_reading_line *at)
{
    const murk_status status =
        murk_reading_number(at, MURK_COLUMN_VALUE, &out->value);
    if (!status && !(fabs(out->value) <= LARGEST)) {
        return murk_reading_fail(at, MURK_COLUMN_VALUE, "%.9g, must be %g..%g",
                                 out->value, -LARGEST, LARGEST);
    }
    return status ? status
                  : murk_reading_unit_check(
                        out->unit, out->value,
                        murk_reading_where_of(at, MURK_COLUMN_VALUE).text,
                        at->err);
}

static murk_status read_error(murk_reading *out, const murk_reading_line *at)
{
    const murk_status status =
        murk_reading_number(at, MURK_COLUMN_ERROR, &out->standard_error);
    const double e = out->standard_error;
    if (!status && !(e >= 1 / LARGEST && e <= LARGEST)) {
        return murk_reading_fail(
            at, MURK_COLUMN_ERROR,
            "%.9g, must be more than 0 (%g to %g), in the value's unit", e,
            1 / LARGEST, LARGEST);
    }
    return status;
}

/* Reads the unit; light in percent or relative units needs a factor, and units
 * with a law (murk_reading_unit_law()) permit none. */
static murk_status read_unit(murk_reading *out, const murk_reading_line *at)
{
    /* Find the unit. */
    const murk_status status = murk_reading_unit_find(
        &out->unit, murk_reading_cell(at, MURK_COLUMN_UNIT), out->kind,
        murk_reading_where_of(at, MURK_COLUMN_UNIT).text, at->err);
    if (status) {
        return status;
    }
    /* Compare with the column of factors. */
    const bool has_gain = !murk_reading_is_empty(at, MURK_COLUMN_GAIN);
    if (!has_gain && murk_reading_unit_needs_gain(out->unit, out->kind)) {
        return murk_reading_fail(
            at, MURK_COLUMN_GAIN,
            "is empty, but light with the unit %s has an unknown factor: name "
            "the factor in this column, and make gain.NAME a free key",
            murk_reading_unit_name(out->unit));
    }
    if (has_gain && murk_reading_unit_law(out->unit)) {
        return murk_reading_fail(
            at, MURK_COLUMN_GAIN,
            "a free factor of what is in %s, must be empty: factors are of "
            "fractions, percents and light",
            murk_reading_unit_name(out->unit));
    }
    return MURK_OK;
}

/* Fails for a unit in which the band of the reading, or every band if it has
 * none, counts nothing, such as lux of infrared light. */
static murk_status check_counts(const murk_reading *out,
                                const murk_reading_line *at)
{
    const murk_scene_desc *scene = at->source->scene;
    const murk_spectrum count = murk_reading_per_watt(out->unit, scene);
    double sum = 0;
    for (int b = 0; b < scene->bands; ++b) {
        sum += out->band < 0 || out->band == b ? count.band[b] : 0;
    }
    return sum > 0
               ? MURK_OK
               : murk_reading_fail(at, MURK_COLUMN_UNIT,
                                   "%s, but light of %s counts nothing in it",
                                   murk_reading_unit_name(out->unit),
                                   out->band < 0 ? "all of the scene's bands"
                                                 : "this band");
}

murk_status murk_reading_read(murk_reading *out, const char **group,
                              const char **gain,
                              const murk_reading_source *source, size_t row,
                              murk_error *err)
{
    const murk_reading_line at = {source, row, err};
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
    if ((status = murk_reading_check_cells(&at, out->kind)) ||
        (status = read_condition(out, &at)) ||
        (status = read_place(out, &at)) || (status = read_unit(out, &at)) ||
        (status = check_counts(out, &at)) || (status = read_value(out, &at)) ||
        (status = read_error(out, &at)) ||
        (status = murk_reading_name(&at, MURK_COLUMN_GROUP, group)) ||
        (status = murk_reading_name(&at, MURK_COLUMN_GAIN, gain))) {
        return status;
    }
    /* Whether the reading is held out. */
    if (!murk_reading_is_empty(&at, MURK_COLUMN_USE)) {
        status = murk_reading_word(&at, MURK_COLUMN_USE, USES, 2, &use);
    }
    out->is_held_out = use == 1;
    return status;
}
