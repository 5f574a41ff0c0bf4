#include "sensing/candidates.h"

#include "sensing/reach.h"

#include <assert.h>
#include <stdlib.h>

#define POINTS_MAX 1e8

static double coordinate(double min, double max, size_t i, size_t n)
{
    if (n == 1) {
        return min + (max - min) / 2;
    }
    return i + 1 == n ? max : min + (max - min) * (double)i / (double)(n - 1);
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
            const murk_vec3 min = domain->box.min, max = domain->box.max;
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "candidate [%g, %g, %g] m is outside the domain, "
                             "[%g, %g, %g] to [%g, %g, %g] m",
                             p.x, p.y, p.z, min.x, min.y, min.z, max.x, max.y,
                             max.z);
        }
    }
    return MURK_OK;
}

static murk_status check(const murk_candidate_grid *grid,
                         const murk_domain *domain, const char *where,
                         murk_error *err)
{
    if (!(grid->clearance_m >= 0 && isfinite(grid->clearance_m))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "clearance_m is %g m, must be 0 or more",
                         grid->clearance_m);
    }
    const murk_status status = check_size(grid, where, err);
    return status ? status : check_place(grid, domain, where, err);
}

static bool is_usable(const murk_free_space *space, size_t i)
{
    return space->is_reached[i] && space->closeness[i] < MURK_TOO_CLOSE;
}

static void count(murk_candidates *c, const murk_free_space *space)
{
    c->doubtful = space->doubtful;
    for (size_t i = 0; i < c->asked; ++i) {
        if (is_usable(space, i)) {
            ++c->usable;
            c->doubtful += space->closeness[i] == MURK_BARELY_CLEAR;
        } else if (space->is_reached[i] ||
                   space->closeness[i] == MURK_ON_SURFACE) {
            ++c->too_close;
        } else {
            ++c->unreached;
        }
    }
}

static murk_status keep_usable(murk_candidates *c,
                               const murk_candidate_grid *grid,
                               const murk_free_space *space, const char *where,
                               murk_error *err)
{
    if (c->usable == 0) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "none of the %zu candidates is usable: %zu out of "
                         "reach of any light, %zu on a surface or nearer to "
                         "one than %g m",
                         c->asked, c->unreached, c->too_close,
                         grid->clearance_m);
    }
    c->position = malloc(c->usable * sizeof *c->position);
    if (!c->position) {
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for %zu candidates", c->usable);
    }
    size_t kept = 0;
    for (size_t i = 0; i < c->asked; ++i) {
        if (is_usable(space, i)) {
            c->position[kept++] = murk_candidate_grid_point(grid, i);
        }
    }
    return MURK_OK;
}

murk_status murk_candidates_create(murk_candidates **out,
                                   const murk_candidate_grid *grid,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err)
{
    assert(out && grid && surfaces && reach && threads >= 1 && where);
    murk_candidates *candidates = NULL;
    murk_free_space space = {0};
    murk_status status = check(grid, &reach->domain, where, err);
    if (status) {
        goto done;
    }
    status = murk_free_space_find(&space, grid, surfaces, reach, threads, where,
                                  err);
    if (status) {
        goto done;
    }
    candidates = calloc(1, sizeof *candidates);
    if (!candidates) {
        status =
            murk_fail(err, MURK_NO_MEMORY, where, "no memory for candidates");
        goto done;
    }
    candidates->asked = grid->size[0] * grid->size[1] * grid->size[2];
    count(candidates, &space);
    status = keep_usable(candidates, grid, &space, where, err);
    if (status) {
        goto done;
    }
    *out = candidates;
    candidates = NULL;
done:
    murk_candidates_destroy(candidates);
    murk_free_space_release(&space);
    return status;
}

void murk_candidates_destroy(murk_candidates *candidates)
{
    if (candidates) {
        free(candidates->position);
        free(candidates);
    }
}
