/* Scores a segment of a photon path in a grid tally: each cell gets the length
 * of the segment within the cell, times the quanta of the photon and the grid's
 * per_m. Parts of the segment outside of the grid do not count.
 *
 * A segment with both ends in one cell is scored at once. A segment with both
 * ends in the grid crosses a number of faces that is known from the two cells.
 * Any other is clipped to the grid. Both are followed from cell to cell by the
 * traversal of Amanatides and Woo (Eurographics 1987,
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

/* The cell of a coordinate in cells, if it lies in the grid. */
static inline bool cell_of(double at, uint32_t size, int64_t *cell)
{
    const bool is_within = at >= 0 && at < (double)size;
    *cell = is_within ? (int64_t)at : 0;
    return is_within;
}

/* One axis of a segment that begins and ends in the grid. */
typedef struct axis_faces {
    double at, per_pace;  /* as in axis_walk */
    double face, step;    /* the face ahead, and the step to the next, +1, -1 */
    double next_m;        /* to the face ahead; INFINITY beyond the last one */
    int64_t stride, left; /* faces that are still to cross */
} axis_faces;

static inline axis_faces axis_faces_of(double at, double pace, int64_t from,
                                       int64_t to, uint32_t stride)
{
    const bool is_up = to > from;
    axis_faces f = {.at = at,
                    .per_pace = 1 / pace,
                    .face = (double)(is_up ? from + 1 : from),
                    .step = is_up ? 1 : -1,
                    .next_m = INFINITY,
                    .stride = is_up ? (int64_t)stride : -(int64_t)stride,
                    .left = is_up ? to - from : from - to};
    if (f.left > 0) {
        f.next_m = (f.face - at) * f.per_pace;
    }
    return f;
}

/* Scores a segment from cell to cell, both in the grid. The number of faces
 * that the segment crosses is known in advance, so the way is not clipped to
 * the grid and cannot leave it. */
static void cross_faces(murk_score_path *path, axis_faces f[3], int64_t cell,
                        double length_m, double quanta_per_m)
{
    double t = 0;
    for (int64_t n = f[0].left + f[1].left + f[2].left; n > 0; --n) {
        /* The face that the segment meets next. */
        const int nearest = f[0].next_m < f[1].next_m
                                ? (f[0].next_m < f[2].next_m ? 0 : 2)
                                : (f[1].next_m < f[2].next_m ? 1 : 2);
        axis_faces *const ahead = &f[nearest];
        const double until =
            ahead->next_m < length_m ? ahead->next_m : length_m;
        /* Score the length up to the face, then enter the next cell. */
        const double reached = until > t ? until : t;
        murk_score_list(path, (uint32_t)cell, (reached - t) * quanta_per_m);
        t = reached;
        cell += ahead->stride;
        ahead->face += ahead->step;
        --ahead->left;
        ahead->next_m = ahead->left > 0
                            ? (ahead->face - ahead->at) * ahead->per_pace
                            : INFINITY;
    }
    murk_score_list(path, (uint32_t)cell, (length_m - t) * quanta_per_m);
}

void murk_score_lattice(murk_score_path *path, const murk_lattice *lattice,
                        murk_vec3 from, murk_vec3 direction, double length_m,
                        double quanta)
{
    /* The start and the direction in units of cells. */
    const double *const k = lattice->cells_per_m;
    const uint32_t *const n = lattice->size;
    const double at[3] = {(from.x - lattice->box.min.x) * k[0],
                          (from.y - lattice->box.min.y) * k[1],
                          (from.z - lattice->box.min.z) * k[2]};
    const double pace[3] = {direction.x * k[0], direction.y * k[1],
                            direction.z * k[2]};
    const double quanta_per_m = quanta * lattice->per_m;
    /* Most segments begin and end in the grid. */
    int64_t first[3], last[3];
    bool is_within = length_m > 0;
    for (int a = 0; a < 3; ++a) {
        is_within = is_within && cell_of(at[a], n[a], &first[a]) &&
                    cell_of(at[a] + pace[a] * length_m, n[a], &last[a]);
    }
    if (is_within) {
        const uint32_t cell = cell_at(lattice, first[0], first[1], first[2]);
        if (first[0] == last[0] && first[1] == last[1] && first[2] == last[2]) {
            murk_score_list(path, cell, length_m * quanta_per_m);
            return;
        }
        axis_faces f[3] = {
            axis_faces_of(at[0], pace[0], first[0], last[0], 1),
            axis_faces_of(at[1], pace[1], first[1], last[1], n[0]),
            axis_faces_of(at[2], pace[2], first[2], last[2], n[0] * n[1])};
        cross_faces(path, f, cell, length_m, quanta_per_m);
        return;
    }
    /* Else from face to face through the part of the segment that lies in the
     * grid. */
    double begin_m = 0, end_m = length_m;
    if (!murk_box_clip(&lattice->box, from, direction, &begin_m, &end_m)) {
        return;
    }
    axis_walk w[3] = {axis_walk_of(at[0], pace[0], begin_m, n[0], 1),
                      axis_walk_of(at[1], pace[1], begin_m, n[1], n[0]),
                      axis_walk_of(at[2], pace[2], begin_m, n[2], n[0] * n[1])};
    cross_cells(path, lattice, w, begin_m, end_m, quanta_per_m);
}
