/* Converts readings into receivers (calibrate/histories.h), sensors grouped
 * into rows of coverage, and beams. */
#include "calibrate/instruments.h"

#include "base/log.h"
#include "base/position.h"

#include <math.h>
#include <stdio.h>

static void add_receiver(murk_instruments *p, const murk_reading *reading,
                         size_t row)
{
    const bool has_side = reading->kind == MURK_READ_IRRADIANCE;
    const double acceptance = reading->acceptance_rad;
    p->light_row[p->receivers] = row;
    p->quantity[p->receivers] = murk_reading_quantity(reading->unit);
    p->receiver[p->receivers++] = (murk_receiver){
        .center = reading->position,
        .radius_m = reading->radius_m,
        .normal = has_side ? reading->direction : murk_vec(0, 0, 0),
        .min_cosine = isnan(acceptance) ? 0 : fmax(0, cos(acceptance)),
        .band = reading->band};
}

static void add_group(murk_instruments *p, const murk_readings *measured,
                      size_t row)
{
    const murk_reading_row *r = &measured->row[row];
    for (size_t i = 0; i < r->n; ++i) {
        p->pose[p->poses] = measured->reading[r->first + i].pose;
        p->group[p->poses++] = p->groups;
    }
    p->light_row[p->receivers + p->groups++] = row;
}

/* The first reading of a row if the row belongs to the condition, else NULL. */
static const murk_reading *first_of(const murk_readings *measured, size_t row,
                                    size_t condition)
{
    const murk_reading *reading = murk_reading_of_row(measured, row);
    return reading->condition == condition ? reading : NULL;
}

murk_status murk_instruments_create(murk_instruments *out,
                                    const murk_readings *measured,
                                    size_t condition, murk_error *err)
{
    const size_t rows = measured->rows, readings = measured->readings;
    murk_arena arena = {0};
    *out = (murk_instruments){
        .receiver = murk_arena_array(&arena, rows, sizeof *out->receiver),
        .quantity = murk_arena_array(&arena, rows, sizeof *out->quantity),
        .pose = murk_arena_array(&arena, readings, sizeof *out->pose),
        .group = murk_arena_array(&arena, readings, sizeof *out->group),
        .light_row = murk_arena_array(&arena, rows, sizeof *out->light_row),
        .beam_row = murk_arena_array(&arena, rows, sizeof *out->beam_row)};
    out->arena = arena;
    if (arena.is_short) {
        return murk_no_memory(err, measured->path, "for %zu readings",
                              readings);
    }
    /* Beams and receivers, then groups of coverage. */
    for (size_t i = 0; i < measured->rows; ++i) {
        const murk_reading *reading = first_of(measured, i, condition);
        if (reading && !murk_reading_needs_light(reading->kind)) {
            out->beam_row[out->beams++] = i;
        } else if (reading && reading->kind != MURK_READ_COVERAGE) {
            add_receiver(out, reading, i);
        }
    }
    for (size_t i = 0; i < measured->rows; ++i) {
        const murk_reading *reading = first_of(measured, i, condition);
        if (reading && reading->kind == MURK_READ_COVERAGE) {
            add_group(out, measured, i);
        }
    }
    out->lights = out->receivers + out->groups;
    return MURK_OK;
}

void murk_instruments_release(murk_instruments *instruments)
{
    murk_arena_release(&instruments->arena);
    *instruments = (murk_instruments){0};
}

/* A receiver is reported only if a surface cuts off more than this share of the
 * radius of the sphere: a smaller cap has less than 7.5e-5 of the volume (3/4
 * of the square of the share). */
#define CUT_DEPTH .01

/* Number of receivers that warnings name one by one. */
#define CUT_NAMED 5

void murk_instruments_warn_of_cut(const murk_instruments *instruments,
                                  const murk_readings *measured,
                                  const murk_surfaces *surfaces)
{
    /* Warn of each receiver that is cut, up to a limit. */
    size_t cut = 0;
    for (size_t i = 0; i < instruments->receivers; ++i) {
        const murk_receiver *r = &instruments->receiver[i];
        if (!murk_surfaces_near(surfaces, r->center,
                                (1 - CUT_DEPTH) * r->radius_m) ||
            ++cut > CUT_NAMED) {
            continue;
        }
        char where[320];
        snprintf(
            where, sizeof where, "%s:%zu", measured->path,
            murk_reading_of_row(measured, instruments->light_row[i])->line);
        murk_warn(where,
                  "a surface cuts the receiver of %g m around %s m, behind "
                  "which it is dark: it reads low; take a smaller "
                  "radius_m, or a place farther from the surface",
                  r->radius_m, murk_position_show(r->center).text);
    }
    if (cut > CUT_NAMED) {
        murk_warn(measured->path,
                  "%zu more receivers are cut by surfaces and read low",
                  cut - CUT_NAMED);
    }
}
