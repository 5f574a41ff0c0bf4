/* Reads candidate points from CSV tables and from the list of the scene; the
 * coordinates of tables are converted to the local origin of the scene. */
#include "plan/sites.h"

#include "base/position.h"
#include "scene/table.h"

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
static murk_status read_row(const murk_table *table, size_t row,
                            const long column[3], murk_vec3 origin,
                            const murk_box *box, murk_vec3 *out,
                            murk_error *err)
{
    double x[3];
    for (int axis = 0; axis < 3; ++axis) {
        const murk_status status =
            murk_table_number(table, row, column[axis], NAN, &x[axis], err);
        if (status) {
            return status;
        }
    }
    *out = murk_sub(murk_vec(x[0], x[1], x[2]), origin);
    if (!murk_box_contains(box, *out)) {
        char where[MURK_SCENE_WHERE_SIZE];
        snprintf(where, sizeof where, "%.300s:%d", table->path,
                 table->line[row]);
        return refuse_outside(where, *out, box, err);
    }
    return MURK_OK;
}

/* Finds the numbers of the columns. Fails if a column is missing or the table
 * has no rows. */
static murk_status check_table(const murk_table *table, long column[3],
                               murk_error *err)
{
    static const char *const NAME[3] = {"x_m", "y_m", "z_m"};
    for (int axis = 0; axis < 3; ++axis) {
        column[axis] = murk_table_column(table, NAME[axis]);
        if (column[axis] < 0) {
            return murk_fail(err, MURK_BAD_FILE, table->path,
                             "misses column %s, must have x_m, y_m and z_m",
                             NAME[axis]);
        }
    }
    return table->rows > 0
               ? MURK_OK
               : murk_fail(err, MURK_BAD_FILE, table->path,
                           "lists no points, must have one or more");
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
                             const murk_table *table, murk_vec3 origin,
                             const murk_box *box, size_t maximum,
                             murk_error *err)
{
    long column[3];
    murk_status status = check_table(table, column, err);
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
        status =
            read_row(table, row, column, origin, box, &(*point)[*n + row], err);
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
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, size_t maximum,
                                  murk_error *err)
{
    const murk_scene_points *points = &scene->sensors.candidates.points;
    const murk_vec3 origin = scene->origin;
    murk_vec3 *point = NULL;
    murk_status status = MURK_OK;
    *n = 0;
    /* Files first, then the list. */
    for (size_t i = 0; i < points->files && !status; ++i) {
        murk_table *table = NULL;
        status = murk_table_read(&table, points->file[i], err);
        if (!status) {
            status =
                add_table(&point, n, table, origin, &domain->box, maximum, err);
        }
        murk_table_destroy(table);
    }
    if (!status) {
        status = add_listed(&point, n, points, &domain->box, maximum, err);
    }
    if (status) {
        free(point);
        return status;
    }
    *out = point;
    return MURK_OK;
}
