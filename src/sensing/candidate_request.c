/* The points of a grid of candidates, the checks of a request for candidates
 * (clearance, sizes, places within the domain, offsets of mounts), and the test
 * whether the zones of the request exclude a point. */
#include "sensing/candidate_request.h"

#include "base/position.h"
#include "path/segment.h"

#define POINTS_MAX ((double)MURK_CANDIDATES_MAX)

static double coordinate(double min, double max, size_t i, size_t n)
{
    if (n == 1) {
        return min + (max - min) / 2;
    }
    return i + 1 == n ? max : min + (max - min) * (double)i / (double)(n - 1);
}

murk_candidate_grid murk_candidate_grid_fill(const murk_box *box, size_t points)
{
    const murk_vec3 extent = murk_sub(box->max, box->min);
    const double maximum = (double)points;
    const double step = cbrt(extent.x * extent.y * extent.z / maximum);
    const double n[3] = {fmin(fmax(1, round(extent.x / step)), maximum),
                         fmin(fmax(1, round(extent.y / step)), maximum),
                         fmin(fmax(1, round(extent.z / step)), maximum)};
    const murk_vec3 half = {extent.x / n[0] / 2, extent.y / n[1] / 2,
                            extent.z / n[2] / 2};
    return (murk_candidate_grid){
        .min = murk_add(box->min, half),
        .max = murk_sub(box->max, half),
        .size = {(size_t)n[0], (size_t)n[1], (size_t)n[2]}};
}

murk_vec3 murk_candidate_grid_point(const murk_candidate_grid *grid,
                                    size_t index)
{
    const size_t *n = grid->size;
    const size_t i = index % n[0], j = index / n[0] % n[1],
                 k = index / n[0] / n[1];
    return murk_vec(coordinate(grid->min.x, grid->max.x, i, n[0]),
                    coordinate(grid->min.y, grid->max.y, j, n[1]),
                    coordinate(grid->min.z, grid->max.z, k, n[2]));
}

static murk_status check_size(const murk_candidate_grid *grid,
                              const char *where, murk_error *err)
{
    double points = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid->size[axis] < 1) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "size is [%zu, %zu, %zu], must be 1 or more along "
                             "each axis",
                             grid->size[0], grid->size[1], grid->size[2]);
        }
        points *= (double)grid->size[axis];
    }
    if (!(points <= POINTS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "size [%zu, %zu, %zu] makes %.3g candidates, must be "
                         "%.3g at most",
                         grid->size[0], grid->size[1], grid->size[2], points,
                         POINTS_MAX);
    }
    return MURK_OK;
}

static murk_status check_place(const murk_candidate_grid *grid,
                               const murk_domain *domain, const char *where,
                               murk_error *err)
{
    const murk_vec3 a = grid->min, b = grid->max;
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    if (!murk_is_finite(a) || !murk_is_finite(b)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "min_m or max_m is not finite");
    }
    /* The grid must rise along each axis with several points, must not fall
     * along the others, and must lie in the domain. */
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_line = grid->size[axis] > 1;
        if (!(is_line ? from[axis] < to[axis] : from[axis] <= to[axis])) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%c runs from %g to %g m, must rise", "xyz"[axis],
                             from[axis], to[axis]);
        }
    }
    const size_t n = grid->size[0] * grid->size[1] * grid->size[2];
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = murk_candidate_grid_point(grid, i);
        if (!murk_box_contains(&domain->box, p)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "candidate %s m is outside the domain, %s to %s m",
                             murk_position_show(p).text,
                             murk_position_show(domain->box.min).text,
                             murk_position_show(domain->box.max).text);
        }
    }
    return MURK_OK;
}

static murk_status check_listed(const murk_candidate_desc *desc,
                                const murk_surfaces *surfaces,
                                const murk_domain *domain, const char *where,
                                murk_error *err)
{
    for (size_t i = 0; i < desc->points; ++i) {
        const murk_vec3 p = desc->point[i];
        if (!murk_box_contains(&domain->box, p)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "point %zu, %s m, is outside the domain", i,
                             murk_position_show(p).text);
        }
    }
    const double min_m = 2 * murk_path_surface_tolerance_m(surfaces, domain);
    for (size_t i = 0; i < desc->mounts; ++i) {
        if (!(desc->mount[i].offset_m > min_m)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "offset_m is %g m, must be more than %.3g m: less "
                             "is lost in rounding",
                             desc->mount[i].offset_m, min_m);
        }
    }
    return MURK_OK;
}

murk_status murk_candidate_desc_check(const murk_candidate_desc *desc,
                                      const murk_surfaces *surfaces,
                                      const murk_domain *domain,
                                      const char *where, murk_error *err)
{
    const murk_candidate_grid *grid = &desc->grid;
    if (!(grid->clearance_m >= 0 && isfinite(grid->clearance_m))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "clearance_m is %g m, must be 0 or more",
                         grid->clearance_m);
    }
    murk_status status = check_size(grid, where, err);
    if (!status) {
        status = check_place(grid, domain, where, err);
    }
    return status ? status : check_listed(desc, surfaces, domain, where, err);
}

bool murk_candidate_is_forbidden(const murk_candidate_desc *desc,
                                 murk_vec3 point)
{
    return (desc->avoid && murk_zones_contain(desc->avoid, point)) ||
           (desc->within && !murk_zones_contain(desc->within, point));
}
