/* Scores a segment of a photon path in a grid tally: each cell gets the length
 * of the segment within the cell, times the quanta of the photon and the grid's
 * per_m. Parts of the segment outside of the grid do not count.
 *
 * A segment with both ends in one cell is scored at once. Any other is followed
 * from cell to cell by the traversal of Amanatides and Woo (Eurographics 1987,
 * doi:10.2312/egtp.19871000), always through the nearest face ahead. The
 * distance of each face is computed from the integer index of the face, so that
 * rounding errors do not accumulate. The piece in a cell begins at the distance
 * at which the last piece ended, so the pieces have neither gaps nor
 * overlaps. */
#include "transport/score.h"

#include <math.h>

/* Below this number of cells per metre, a segment of any length within the
 * domain stays in one layer of cells, and the inverse might be infinite. */
#define STILL 1e-290

typedef struct axis_walk {
    double at, pace, per_pace; /* start of the segment, in cells; cells per
                                  metre; metres per cell */
    int64_t cell, step;
    int64_t stride; /* of the cell number, to the next cell ahead */
    double next_m;  /* from the start of the segment to the face ahead */
} axis_walk;

static inline void see_ahead(axis_walk *w)
{
    w->next_m = ((double)(w->cell + (w->step > 0)) - w->at) * w->per_pace;
}

static inline axis_walk axis_walk_of(double at, double pace, double start_m,
                                     uint32_t size, uint32_t stride)
{
    axis_walk w = {.at = at, .pace = pace, .next_m = INFINITY};
    const double cell = floor(at + pace * start_m);
    w.cell = cell >= (double)size ? (int64_t)size - 1
             : cell > 0           ? (int64_t)cell
                                  : 0;
    if (fabs(pace) > STILL) {
        w.step = pace > 0 ? 1 : -1;
        w.stride = w.step * (int64_t)stride;
        w.per_pace = 1 / pace;
        see_ahead(&w);
    }
    return w;
}

static inline uint32_t cell_at(const murk_lattice *lattice, int64_t x,
                               int64_t y, int64_t z)
{
    return lattice->first +
           ((uint32_t)z * lattice->size[1] + (uint32_t)y) * lattice->size[0] +
           (uint32_t)x;
}

static void cross_cells(murk_score_path *path, const murk_lattice *lattice,
                        axis_walk w[3], double t, double end_m,
                        double quanta_per_m)
{
    int64_t cell = cell_at(lattice, w[0].cell, w[1].cell, w[2].cell);
    for (;;) {
        /* The face that the segment meets next. */
        const int nearest = w[0].next_m < w[1].next_m
                                ? (w[0].next_m < w[2].next_m ? 0 : 2)
                                : (w[1].next_m < w[2].next_m ? 1 : 2);
        axis_walk *const ahead = &w[nearest];
        const int64_t next = ahead->cell + ahead->step;
        const bool is_last = !(ahead->next_m < end_m) ||
                             (uint64_t)next >= lattice->size[nearest];
        const double until = is_last ? end_m : ahead->next_m;
        /* Score the length within the cell, then enter the next one. */
        if (until > t) {
            murk_score_add(path, (uint32_t)cell, (until - t) * quanta_per_m);
            t = until;
        }
        if (is_last) {
            return;
        }
        ahead->cell = next;
        cell += ahead->stride;
        see_ahead(ahead);
    }
}

/* True if both ends of the segment are in one cell, as for most segments in
 * dense media; then *cell is that cell. */
static inline bool stays(const murk_lattice *lattice, const double at[3],
                         const double pace[3], double length_m, uint32_t *cell)
{
    int64_t i[3];
    for (int a = 0; a < 3; ++a) {
        const double end = at[a] + pace[a] * length_m;
        if (!(at[a] >= 0 && at[a] < (double)lattice->size[a] && end >= 0 &&
              end < (double)lattice->size[a])) {
            return false;
        }
        i[a] = (int64_t)at[a];
        if (i[a] != (int64_t)end) {
            return false;
        }
    }
    *cell = cell_at(lattice, i[0], i[1], i[2]);
    return true;
}

void murk_score_lattice(murk_score_path *path, const murk_lattice *lattice,
                        murk_vec3 from, murk_vec3 direction, double length_m,
                        double quanta)
{
    /* The start and the direction in units of cells. */
    const double *const k = lattice->cells_per_m;
    const double at[3] = {(from.x - lattice->box.min.x) * k[0],
                          (from.y - lattice->box.min.y) * k[1],
                          (from.z - lattice->box.min.z) * k[2]};
    const double pace[3] = {direction.x * k[0], direction.y * k[1],
                            direction.z * k[2]};
    const double quanta_per_m = quanta * lattice->per_m;
    /* Most steps in dense media stay in one cell. */
    uint32_t cell;
    if (stays(lattice, at, pace, length_m, &cell)) {
        murk_score_add(path, cell, length_m * quanta_per_m);
        return;
    }
    /* Else from face to face through the part of the segment that lies in the
     * grid. */
    double begin_m = 0, end_m = length_m;
    if (!murk_box_clip(&lattice->box, from, direction, &begin_m, &end_m)) {
        return;
    }
    const uint32_t *const n = lattice->size;
    axis_walk w[3] = {axis_walk_of(at[0], pace[0], begin_m, n[0], 1),
                      axis_walk_of(at[1], pace[1], begin_m, n[1], n[0]),
                      axis_walk_of(at[2], pace[2], begin_m, n[2], n[0] * n[1])};
    cross_cells(path, lattice, w, begin_m, end_m, quanta_per_m);
}
