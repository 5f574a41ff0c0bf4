/* Tests arbitrary points for free space, with up to two grids whose free space
 * is known (sensing/reach.h): tries the reached corners of the grid cells
 * around the point, then the places from which the light of the lamps
 * starts. */
#include "sensing/open_space.h"

#include "path/segment.h"
#include "sensing/reach.h"

#include <assert.h>
#include <stdlib.h>

struct murk_open_space {
    murk_reach reach; /* the lamps are not used after creation */
    size_t n_grids;
    murk_candidate_grid grid[MURK_OPEN_SPACE_GRIDS];
    murk_free_space free[MURK_OPEN_SPACE_GRIDS];
};

murk_status murk_open_space_create(murk_open_space **out,
                                   const murk_candidate_grid *grid,
                                   size_t n_grids,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err)
{
    assert(n_grids >= 1 && n_grids <= MURK_OPEN_SPACE_GRIDS);
    murk_open_space *space = calloc(1, sizeof *space);
    if (!space) {
        return murk_no_memory(err, where, "for the free space");
    }
    /* The free space of each grid. */
    space->reach = *reach;
    space->n_grids = n_grids;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n_grids && !status; ++i) {
        space->grid[i] = grid[i];
        space->grid[i].clearance_m = 0;
        status =
            murk_free_space_find(&space->free[i], &space->grid[i], surfaces,
                                 &space->reach, threads, where, err);
    }
    if (status) {
        murk_open_space_destroy(space);
        return status;
    }
    *out = space;
    return MURK_OK;
}

void murk_open_space_destroy(murk_open_space *space)
{
    for (size_t i = 0; space && i < space->n_grids; ++i) {
        murk_free_space_release(&space->free[i]);
    }
    free(space);
}

/* The start of a segment. */
typedef struct start {
    murk_vec3 point, normal;
} start;

/* True if an open segment leads from the start to the point `to`. A segment
 * that begins on the wrong side of the surface of the start must be excluded by
 * the normal, because surfaces at the ends of a segment do not block the
 * segment. */
static bool leads_to(const murk_open_space *space, const start *from,
                     murk_vec3 to)
{
    const murk_vec3 near =
        murk_path_nearest_image(&space->reach.domain, to, from->point);
    const murk_vec3 offset = murk_sub(near, from->point);
    const bool is_free = murk_dot(from->normal, from->normal) == 0;
    return (is_free || murk_dot(from->normal, offset) > 0) &&
           murk_free_segment_is_open(&space->free[0].segments, from->point,
                                     near);
}

/* The indices of the grid points of the cell around x and of the cells beside
 * it. */
static void cells_around(double x, double min, double max, size_t n,
                         size_t *first, size_t *last)
{
    const double step = n > 1 ? (max - min) / (double)(n - 1) : 1;
    const double at = fmin(fmax(floor((x - min) / step), 0), (double)(n - 1));
    *first = at > 0 ? (size_t)at - 1 : 0;
    *last = (size_t)fmin(at + 2, (double)(n - 1));
}

static bool leads_to_grid(const murk_open_space *space, size_t number,
                          const start *from)
{
    const murk_vec3 point = from->point;
    const murk_candidate_grid *grid = &space->grid[number];
    const size_t *n = grid->size;
    size_t first[3], last[3];
    cells_around(point.x, grid->min.x, grid->max.x, n[0], &first[0], &last[0]);
    cells_around(point.y, grid->min.y, grid->max.y, n[1], &first[1], &last[1]);
    cells_around(point.z, grid->min.z, grid->max.z, n[2], &first[2], &last[2]);
    for (size_t k = first[2]; k <= last[2]; ++k) {
        for (size_t j = first[1]; j <= last[1]; ++j) {
            for (size_t i = first[0]; i <= last[0]; ++i) {
                const size_t index = i + n[0] * (j + n[1] * k);
                if (space->free[number].is_reached[index] &&
                    leads_to(space, from,
                             murk_candidate_grid_point(grid, index))) {
                    return true;
                }
            }
        }
    }
    return false;
}

bool murk_open_space_holds(const murk_open_space *space, murk_vec3 point,
                           murk_vec3 normal)
{
    const start from = {point, normal};
    for (size_t i = 0; i < space->n_grids; ++i) {
        if (leads_to_grid(space, i, &from)) {
            return true;
        }
    }
    for (size_t i = 0; i < space->free[0].places; ++i) {
        if (leads_to(space, &from, space->free[0].place[i])) {
            return true;
        }
    }
    return false;
}
