/* Reads targets from a CSV table: position, optional normal, optional weight. A
 * point with a normal is a record on a surface; a point without a normal, or
 * with the normal 0, is a record in the volume. */
#include "base/position.h"
#include "plan/on_ground.h"
#include "plan/target_records.h"

#include <stdio.h>

/* The columns beside those of the place; all may be missing. */
enum { NORMAL_X, NORMAL_Y, NORMAL_Z, WEIGHT, COLUMNS };

static const char *const NAMES[COLUMNS] = {"normal_x", "normal_y", "normal_z",
                                           "weight"};

/* Largest weight that the manual permits. */
#define WEIGHT_MAX 1e6

/* A point without a normal must be further from any surface than this multiple
 * of the step by which rays leave a surface, or rounding could hide the point
 * behind that surface. */
#define ON_SURFACE_STEPS 2

typedef struct list {
    murk_target_records *to;
    const murk_stage *stage; /* of `to` */
    const murk_table *table;
    murk_table_places places;
    long column[COLUMNS]; /* -1 if the table does not have the column */
    double step_m;
    double weight; /* sum over all targets */
} list;

/* Finds the columns; a normal needs all three columns. */
static murk_status find_columns(list *l, murk_error *err)
{
    int normals = 0;
    const murk_status status = murk_table_places_find(
        &l->places, l->table, l->stage->scene, true, err);
    if (status) {
        return status;
    }
    for (int i = 0; i < COLUMNS; ++i) {
        l->column[i] = murk_table_column(l->table, NAMES[i]);
        normals += i <= NORMAL_Z && l->column[i] >= 0;
    }
    return normals == 0 || normals == 3
               ? MURK_OK
               : murk_fail(err, MURK_BAD_FILE, l->table->path,
                           "has some of the columns normal_x, normal_y, "
                           "normal_z, must have all three or none");
}

/* Checks the values of a row. */
static murk_status check_row(const list *l, size_t row, murk_vec3 place,
                             murk_vec3 normal, double weight, murk_error *err)
{
    const murk_box *box = &l->stage->world.domain.box;
    char where[320];
    snprintf(where, sizeof where, "%.300s:%d", l->table->path,
             l->table->line[row]);
    /* Position and weight. */
    if (!murk_box_contains(box, place)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "target at %s m lies outside of the domain",
                         murk_position_show(place).text);
    }
    if (!(weight >= 0 && weight <= WEIGHT_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "weight is %g, must be 0..1e6", weight);
    }
    /* Normal: of finite length, and above 0 if the point lies on a surface. */
    const double length = murk_length(normal);
    if (!isfinite(length)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "normal is too long, must be of finite length");
    }
    if (!(length > 0) && murk_surfaces_near(l->stage->surfaces, place,
                                            ON_SURFACE_STEPS * l->step_m)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "target at %s m lies on a surface, must have a normal "
                         "to the side it is seen from",
                         murk_position_show(place).text);
    }
    return MURK_OK;
}

/* The material of the surface that a point with a normal lies on;
 * MURK_TARGET_IN_NONE if no surface is that near. */
static uint8_t material_at(const list *l, murk_vec3 place, murk_vec3 normal)
{
    murk_hit hit;
    const murk_vec3 off =
        murk_surfaces_leave(l->stage->surfaces, place, normal);
    return murk_surfaces_hit(l->stage->surfaces, off, murk_scale(-1, normal),
                             ON_SURFACE_STEPS * l->step_m, &hit)
               ? hit.material
               : MURK_TARGET_IN_NONE;
}

/* Reads one row into a record. */
static murk_status read_row(list *l, size_t row, murk_error *err)
{
    double value[COLUMNS];
    /* Read the values; a missing weight is 1. */
    for (int i = 0; i < COLUMNS; ++i) {
        const murk_status status = murk_table_number(
            l->table, row, l->column[i], i == WEIGHT ? 1 : 0, &value[i], err);
        if (status) {
            return status;
        }
    }
    /* The place, and checks. */
    murk_vec3 place;
    murk_vec3 normal = {value[NORMAL_X], value[NORMAL_Y], value[NORMAL_Z]};
    murk_status status =
        murk_place_on_ground(&place, l->stage, &l->places, row, err);
    if (!status) {
        status = check_row(l, row, place, normal, value[WEIGHT], err);
    }
    if (status) {
        return status;
    }
    /* Store the record with weight and material or medium. */
    const bool is_volume = !(murk_length(normal) > 0);
    normal = is_volume ? (murk_vec3){0, 0, 0} : murk_unit(normal);
    const int band = l->to->band;
    murk_photon photon =
        murk_target_of(place, normal, band,
                       is_volume ? murk_target_medium(l->stage, band, place)
                                 : material_at(l, place, normal));
    murk_photon_set_power_w(&photon, value[WEIGHT]);
    l->weight += value[WEIGHT];
    return murk_record_list_put(is_volume ? &l->to->volume : &l->to->surface,
                                &photon, err);
}

murk_status murk_targets_read(murk_target_records *records, murk_error *err)
{
    const murk_stage *stage = records->stage;
    murk_table *table = NULL;
    murk_status status =
        murk_table_read(&table, stage->scene->placement.targets.points, err);
    if (status) {
        return status;
    }
    list l = {.to = records,
              .stage = stage,
              .table = table,
              .step_m = murk_surfaces_leave_step_m(stage->surfaces)};
    status = find_columns(&l, err);
    for (size_t row = 0; row < table->rows && !status; ++row) {
        status = read_row(&l, row, err);
    }
    /* At least one target must have a weight. */
    if (!status && !(l.weight > 0)) {
        status = murk_fail(err, MURK_BAD_FILE, table->path,
                           "%zu targets, must be one or more with a weight "
                           "above 0",
                           table->rows);
    }
    records->facts.points = table->rows;
    murk_table_destroy(table);
    return status;
}
