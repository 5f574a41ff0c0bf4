/* Marks the cells that segments cross: slab by slab along the first axis, and
 * in each slab all cells between the ends of the segment there. Some cells
 * beside a slanted segment are marked, too, and none is left out: the ends are
 * enlarged for rounding. */
#include "lightmap/path_cells.h"

#include <math.h>
#include <stdlib.h>

/* Rounding of positions and lengths, relative to the coordinates. */
#define ROUNDING 1e-9

/* A segment that runs a smaller share of a slab across it may lie on a side of
 * the slab, where rounding would decide to which of two slabs it belongs. */
#define ALONG_SIDE 1e-6

murk_status murk_path_cells_create(murk_path_cells **out, const murk_box *box,
                                   uint64_t photons, murk_error *err)
{
    murk_path_cells *cells = calloc(1, sizeof *cells);
    if (cells) {
        *cells = (murk_path_cells){
            .box = *box, .size = {1, 1, 1}, .photons = photons};
        cells->crossed = calloc(photons + 1, sizeof *cells->crossed);
    }
    if (!cells || !cells->crossed) {
        murk_path_cells_destroy(cells);
        return murk_no_memory(err, "", "for the paths of %llu photons",
                              (unsigned long long)photons);
    }
    /* Halve the longest edge of the cells until there are enough. */
    murk_vec3 edge = murk_sub(box->max, box->min);
    for (int n = 1; n < MURK_PATH_CELLS; n *= 2) {
        int axis = edge.y > edge.x ? 1 : 0;
        axis = edge.z > murk_component(edge, axis) ? 2 : axis;
        cells->size[axis] *= 2;
        murk_component_set(&edge, axis, murk_component(edge, axis) / 2);
    }
    *out = cells;
    return MURK_OK;
}

void murk_path_cells_destroy(murk_path_cells *cells)
{
    if (cells) {
        free(cells->crossed);
        free(cells);
    }
}

/* A range of cells along an axis; empty if first > last. */
typedef struct range {
    int first, last;
} range;

/* The cells along an axis that lie between two coordinates. */
static range range_of(const murk_path_cells *cells, int axis, double a,
                      double b)
{
    const double min = murk_component(cells->box.min, axis),
                 max = murk_component(cells->box.max, axis);
    const double more = ROUNDING * (fabs(min) + fabs(max) + fabs(a) + fabs(b));
    const int n = cells->size[axis];
    const double scale = n / (max - min);
    const double low = (fmin(a, b) - more - min) * scale,
                 high = (fmax(a, b) + more - min) * scale;
    if (!(high >= 0 && low <= n)) {
        return (range){1, 0};
    }
    return (range){low > 0 ? (int)fmin(low, n - 1) : 0,
                   high < n ? (int)high : n - 1};
}

/* The bits of a block of cells. */
static uint64_t block(const murk_path_cells *cells, range x, range y, range z)
{
    uint64_t bits = 0;
    for (int k = z.first; k <= z.last; ++k) {
        for (int j = y.first; j <= y.last; ++j) {
            for (int i = x.first; i <= x.last; ++i) {
                bits |= UINT64_C(1)
                        << (i + cells->size[0] * (j + cells->size[1] * k));
            }
        }
    }
    return bits;
}

/* The cells that a segment crosses. */
static uint64_t cross(const murk_path_cells *cells, murk_vec3 from,
                      murk_vec3 to)
{
    const range x = range_of(cells, 0, from.x, to.x),
                y = range_of(cells, 1, from.y, to.y),
                z = range_of(cells, 2, from.z, to.z);
    uint64_t bits = 0;
    if (x.first > x.last || y.first > y.last || z.first > z.last) {
        return 0;
    }
    /* One slab of x; or several, for a segment almost along a side of them. */
    const double min = cells->box.min.x,
                 step = (cells->box.max.x - min) / cells->size[0];
    const murk_vec3 along = murk_sub(to, from);
    if (x.first == x.last || fabs(along.x) < ALONG_SIDE * step) {
        return block(cells, x, y, z);
    }
    /* The part of the segment in each slab of x. */
    for (int i = x.first; i <= x.last; ++i) {
        const double t0 = (min + i * step - from.x) / along.x,
                     t1 = (min + (i + 1) * step - from.x) / along.x;
        const double first = fmin(fmax(fmin(t0, t1) - ROUNDING, 0), 1),
                     last = fmax(fmin(fmax(t0, t1) + ROUNDING, 1), 0);
        const murk_vec3 a = murk_along(from, first, along),
                        b = murk_along(from, last, along);
        bits |= block(cells, (range){i, i}, range_of(cells, 1, a.y, b.y),
                      range_of(cells, 2, a.z, b.z));
    }
    return bits;
}

void murk_path_cells_add(murk_path_cells *cells, const murk_domain *domain,
                         const murk_event *event)
{
    uint64_t *crossed = &cells->crossed[event->photon];
    if (event->kind == MURK_EVENT_LOST ||
        (event->kind == MURK_EVENT_WRAPPED &&
         murk_trace_may_jump(domain, event->direction_in))) {
        *crossed = UINT64_MAX;
    } else if (event->kind == MURK_EVENT_EMITTED) {
        *crossed |= cross(cells, event->position, event->position);
    } else {
        const murk_vec3 from =
            murk_along(event->position, -event->path_m, event->direction_in);
        *crossed |= cross(cells, from, event->position);
    }
}

bool murk_path_cells_of(uint64_t *out, const murk_path_cells *cells,
                        const murk_box_list *list, const murk_box *domain)
{
    bool is_inside = !list->are_all;
    *out = 0;
    for (size_t i = 0; i < list->n && is_inside; ++i) {
        const murk_box part = murk_box_meet(list->box[i], *domain);
        if (part.min.x > part.max.x || part.min.y > part.max.y ||
            part.min.z > part.max.z) {
            continue; /* outside of the domain */
        }
        is_inside = murk_box_contains(&cells->box, part.min) &&
                    murk_box_contains(&cells->box, part.max);
        *out |= block(cells, range_of(cells, 0, part.min.x, part.max.x),
                      range_of(cells, 1, part.min.y, part.max.y),
                      range_of(cells, 2, part.min.z, part.max.z));
    }
    return is_inside;
}
