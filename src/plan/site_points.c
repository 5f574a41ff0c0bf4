/* Reads candidate points from CSV tables and from the list of the scene; the
 * coordinates of tables are converted to the local origin of the scene, from
 * longitude and latitude if a table has these. */
#include "plan/sites.h"

#include "base/position.h"
#include "plan/on_ground.h"

#include <stdio.h>
#include <stdlib.h>

static murk_status refuse_outside(const char *where, murk_vec3 p,
                                  const murk_box *box, murk_error *err)
{
    return murk_fail(
        err, MURK_BAD_VALUE, where, "%s m is outside the domain, %s to %s m",
        murk_position_show(p).text, murk_position_show(box->min).text,
        murk_position_show(box->max).text);
}

/* Reads one row; the point must lie in the domain. */
static murk_status read_row(const murk_table_places *places, size_t row,
                            const murk_stage *stage, murk_vec3 *out,
                            murk_error *err)
{
    const murk_table *table = places->table;
    const murk_box *box = &stage->world.domain.box;
    const murk_status status =
        murk_place_on_ground(out, stage, places, row, err);
    if (status) {
        return status;
    }
    if (!murk_box_contains(box, *out)) {
        char where[MURK_SCENE_WHERE_SIZE];
        snprintf(where, sizeof where, "%.300s:%d", table->path,
                 table->line[row]);
        return refuse_outside(where, *out, box, err);
    }
    return MURK_OK;
}

/* Grows a list to n points. */
static murk_status reserve(murk_vec3 **point, size_t n, const char *where,
                           murk_error *err)
{
    murk_vec3 *grown = realloc(*point, (n + 1) * sizeof *grown);
    if (!grown) {
        return murk_no_memory(err, where, "for %zu points", n);
    }
    *point = grown;
    return MURK_OK;
}

/* Appends the points of a table to the *n points read so far. */
static murk_status add_table(murk_vec3 **point, size_t *n,
                             const murk_table *table, const murk_stage *stage,
                             size_t maximum, murk_error *err)
{
    murk_table_places places;
    murk_status status =
        murk_table_places_find(&places, table, stage->scene, true, err);
    if (!status && table->rows == 0) {
        status = murk_fail(err, MURK_BAD_FILE, table->path,
                           "lists no points, must have one or more");
    }
    if (status) {
        return status;
    }
    /* Check the limit and allocate. */
    if (table->rows > maximum - *n) {
        return murk_fail(err, MURK_BAD_VALUE, table->path,
                         "%zu points, with those before it more than %zu, the "
                         "most there may be",
                         table->rows, maximum);
    }
    status = reserve(point, *n + table->rows, table->path, err);
    /* Read the points. */
    for (size_t row = 0; row < table->rows && !status; ++row) {
        status = read_row(&places, row, stage, &(*point)[*n + row], err);
    }
    *n += table->rows;
    return status;
}

/* Appends the points listed in the scene. */
static murk_status add_listed(murk_vec3 **point, size_t *n,
                              const murk_scene_points *points,
                              const murk_box *box, size_t maximum,
                              murk_error *err)
{
    if (points->positions > maximum - *n) {
        return murk_fail(err, MURK_BAD_VALUE, points->where,
                         "more than %zu points, the most there may be",
                         maximum);
    }
    const murk_status status =
        reserve(point, *n + points->positions, points->where, err);
    for (size_t i = 0; i < points->positions && !status; ++i) {
        if (!murk_box_contains(box, points->position[i])) {
            return refuse_outside(points->where, points->position[i], box, err);
        }
        (*point)[(*n)++] = points->position[i];
    }
    return status;
}

murk_status murk_site_points_read(murk_vec3 **out, size_t *n,
                                  const murk_stage *stage, size_t maximum,
                                  murk_error *err)
{
    const murk_scene_points *points = &stage->scene->sensors.candidates.points;
    murk_vec3 *point = NULL;
    murk_status status = MURK_OK;
    *n = 0;
    /* Files first, then the list. */
    for (size_t i = 0; i < points->files && !status; ++i) {
        murk_table *table = NULL;
        status = murk_table_read(&table, points->file[i], err);
        if (!status) {
            status = add_table(&point, n, table, stage, maximum, err);
        }
        murk_table_destroy(table);
    }
    if (!status) {
        status = add_listed(&point, n, points, &stage->world.domain.box,
                            maximum, err);
    }
    if (status) {
        free(point);
        return status;
    }
    *out = point;
    return MURK_OK;
}
