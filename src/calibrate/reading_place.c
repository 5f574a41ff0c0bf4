/* Reads and checks the columns of a reading that describe the instrument. */
#include "calibrate/reading_place.h"

#include "base/position.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define SENSOR_TYPES_MAX 64 /* sensor types that a scene may have */
#define RAD_PER_DEG      (MURK_PI / 180) /* radians in a degree */

static murk_status outside(const murk_reading_row *at,
                           murk_reading_column column, const char *what,
                           murk_vec3 p)
{
    const murk_box *box = &at->source->domain->box;
    char text[320];
    snprintf(text, sizeof text, "%s %s m is outside the domain, %s to %s m",
             what, murk_position_show(p).text,
             murk_position_show(box->min).text,
             murk_position_show(box->max).text);
    return murk_reading_fail(at, column, text);
}

/* Reads a position, which must lie in the domain. */
static murk_status inside(const murk_reading_row *at,
                          murk_reading_column column, murk_vec3 *out)
{
    const murk_status status = murk_reading_vector(at, column, out);
    *out = status ? *out : murk_scene_local(at->source->scene, *out);
    return status || murk_box_contains(&at->source->domain->box, *out)
               ? status
               : outside(at, column, "the place", *out);
}

/* Reads the band: the one that contains the wavelength; empty means all. */
static murk_status read_band(murk_reading *out, const murk_reading_row *at)
{
    const murk_scene_desc *scene = at->source->scene;
    double nm = NAN;
    /* Empty: all bands. */
    out->band = -1;
    if (murk_reading_cell(at, MURK_COLUMN_BAND)[0] == '\0') {
        return MURK_OK;
    }
    /* The band that contains the wavelength. */
    const murk_status status = murk_reading_number(at, MURK_COLUMN_BAND, &nm);
    for (int b = 0; b < scene->bands && !status; ++b) {
        const bool is_it = scene->has_edges
                               ? nm >= scene->band_edge_nm[b] &&
                                     nm < scene->band_edge_nm[b + 1]
                               : nm == scene->band_nm[b];
        if (is_it) {
            out->band = b;
            return MURK_OK;
        }
    }
    /* Suggest the nearest band. */
    char text[128];
    int near = 0;
    for (int b = 1; b < scene->bands; ++b) {
        near = fabs(scene->band_nm[b] - nm) < fabs(scene->band_nm[near] - nm)
                   ? b
                   : near;
    }
    snprintf(text, sizeof text,
             "%.9g nm is in no band of the scene, did you mean %.9g?", nm,
             scene->band_nm[near]);
    return status ? status : murk_reading_fail(at, MURK_COLUMN_BAND, text);
}

/* Reads an angle that the sensor type requires. */
static murk_status read_angle(const murk_reading_row *at,
                              murk_reading_column column, double max_deg,
                              double *rad)
{
    double deg = NAN;
    char text[96];
    if (murk_reading_cell(at, column)[0] == '\0') {
        return murk_reading_fail(at, column,
                                 "nothing, but a sensor of this type needs it");
    }
    const murk_status status = murk_reading_number(at, column, &deg);
    if (!status && !(fabs(deg) <= max_deg)) {
        snprintf(text, sizeof text, "%.9g, must be %g..%g degrees", deg,
                 -max_deg, max_deg);
        return murk_reading_fail(at, column, text);
    }
    *rad = deg * RAD_PER_DEG;
    return status;
}

/* Reads type, heading and tilt of a sensor. */
static murk_status read_sensor(murk_reading *out, const murk_reading_row *at)
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
    if (murk_reading_cell(at, MURK_COLUMN_SENSOR)[0] != '\0' ||
        sensors->types > 1) {
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
    /* A type with a view needs heading and tilt. */
    const murk_status status =
        read_angle(at, MURK_COLUMN_HEADING, 360, &out->pose.heading_rad);
    return status ? status
                  : read_angle(at, MURK_COLUMN_TILT, 90, &out->pose.tilt_rad);
}

/* Reads a receiver, whose sphere must lie in the domain entirely: there is no
 * light outside. */
static murk_status read_receiver(murk_reading *out, const murk_reading_row *at)
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
        snprintf(text, sizeof text, "%.9g, must be more than 0 m", r);
        return murk_reading_fail(at, MURK_COLUMN_RADIUS, text);
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

static murk_status read_segment(murk_reading *out, const murk_reading_row *at)
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
                                   const murk_reading_row *at)
{
    const double maximum = out->kind == MURK_READ_IRRADIANCE ? 90 : 180;
    double deg = NAN;
    char text[96];
    out->acceptance_rad = NAN;
    if (murk_reading_cell(at, MURK_COLUMN_ACCEPTANCE)[0] == '\0') {
        return MURK_OK;
    }
    const murk_status status =
        murk_reading_number(at, MURK_COLUMN_ACCEPTANCE, &deg);
    const bool is_good = out->kind == MURK_READ_IRRADIANCE ? deg > 0 : deg >= 0;
    if (!status && !(is_good && deg <= maximum)) {
        snprintf(text, sizeof text, "%.9g, must be %s %g degrees", deg,
                 maximum < 180 ? "more than 0 and at most" : "0 to", maximum);
        return murk_reading_fail(at, MURK_COLUMN_ACCEPTANCE, text);
    }
    out->acceptance_rad = deg * RAD_PER_DEG;
    return status;
}

murk_status murk_reading_place(murk_reading *out, const murk_reading_row *at)
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
    default:
        return read_receiver(out, at);
    }
}
