/* Integral of a field with trilinear interpolation along a ray
 * (medium/linear.h).
 *
 * The ray is followed from cell to cell, which is a chain of comparisons and
 * additions, and the cells are listed. When the list is full, the means of the
 * field in all of its cells are computed side by side in vectors
 * (linear_means.h), and their contributions are added one by one. The result
 * does not depend on the length of the list. */
#include "base/lanes.h"
#include "medium/linear.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/* Cells in the list before their contributions are added: so many that the
 * vectors are full, and that the processor follows the ray while it waits for
 * values of the cells before. With a limit most rays end soon. */
#define CELLS_MAX        8
#define CELLS_WITH_LIMIT 2

/* Cells side by side in a vector. */
#define GROUP 4

/* Compiles the function with the instructions of AVX2, too; the program selects
 * a version when it starts. Clang and the sanitizers get the plain version
 * only. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define WIDE_CLONES
#endif

/* Inlined into each version. */
#define INTO_COPIES inline __attribute__((always_inline))

/* Distances of neighbours along x and y in the values of a leaf. */
#define LEAF_X 64
#define LEAF_Y 8

typedef double numbers __attribute__((vector_size(GROUP * sizeof(double))));
typedef int64_t masks __attribute__((vector_size(GROUP * sizeof(int64_t))));
typedef float singles __attribute__((vector_size(4 * sizeof(float))));
typedef float couple __attribute__((vector_size(2 * sizeof(float))));
typedef uint64_t words __attribute__((vector_size(2 * sizeof(uint64_t))));

/* Cells that the ray crosses one after the other. */
typedef struct cells {
    size_t n;
    double from[CELLS_MAX], to[CELLS_MAX];
    double low[3][CELLS_MAX]; /* lowest points, relative to the origin of the
                                 ray */
    /* The value at the lowest corner; those at the other corners follow as in a
     * leaf. It points into a leaf, or to `gathered` if the corners are in
     * several nodes. */
    const float *corner[CELLS_MAX];
    float gathered[CELLS_MAX][LEAF_X + LEAF_Y + 2];
    int64_t place[CELLS_MAX]; /* in the block, packed */
    /* The blocks of the list: lowest cell, and number of cells up to the end of
     * the block. */
    size_t n_blocks, block_end[CELLS_MAX];
    int32_t block_first[CELLS_MAX][3];
    double mean[CELLS_MAX], density[CELLS_MAX],
        depth[CELLS_MAX]; /* by linear_means.h */
} cells;

/* The state of an integration. */
typedef struct tally {
    double scale, offset, limit, reached;
    /* The longest possible segment in a cell, with a margin of 1e-3 for
     * rounding. Origins so far away that rounding exceeds the margin lose the
     * second-order term only. */
    double longest;
    /* The change of the place in a block at a step; the bits of the index are
     * those of step_index(). */
    int64_t step[16];
} tally;

/* ---- means ---- */

#define MURK_MEANS          means_baseline
#define MURK_MEANS_TARGET   MURK_TARGET_BASELINE
#define MURK_MEANS_WIDEN(a) __builtin_convertvector(a, numbers)
#include "medium/linear_means.h"

#if defined(__x86_64__)
#define MURK_MEANS          means_avx2
#define MURK_MEANS_TARGET   MURK_TARGET_AVX2
#define MURK_MEANS_WIDEN(a) (numbers) _mm256_cvtps_pd((__m128)(a))
#include "medium/linear_means.h"
#endif

static void compute_means(cells *c, const double direction[3], const tally *sum)
{
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        means_avx2(c, direction, sum);
        return;
    }
#endif
    means_baseline(c, direction, sum);
}

/* ---- the limit ---- */

/* The limit is reached in the current segment, in which the field has the given
 * mean: moves m->ray.to back. If rounding makes the field 0 at the new
 * m->ray.to (at an end of the segment), m->value is the mean, so that a
 * collision has a medium. */
static void stop_in_segment(murk_linear *m, tally *sum, double mean)
{
    const double length = m->ray.to - m->ray.from;
    const double density = sum->scale * mean + sum->offset;
    const murk_cubic field = murk_linear_cubic(m, m->ray.from, m->ray.to);
    murk_cubic whole = {{sum->offset, 0, 0, 0}};
    murk_cubic_add(&whole, sum->scale, &field);
    const double s = murk_cubic_reach(&whole, (sum->limit - sum->reached) /
                                                  (density * length));
    m->ray.to = murk_smaller(m->ray.to, m->ray.from + s * length);
    m->value = murk_cubic_value(&field, s);
    m->value = m->value > 0 ? m->value : mean;
    sum->reached = sum->limit;
}

/* ---- steps along x and y in pairs, along z twice ---- */

typedef double pair __attribute__((vector_size(16)));
typedef int64_t pair_masks __attribute__((vector_size(16)));

#if defined(__x86_64__)
#define STEP_Z 12 /* both bits of the second mask */

static inline pair smaller(pair a, pair b)
{
    return (pair)_mm_min_pd((__m128d)a, (__m128d)b);
}

/* The axes with a set mask as bits: 1 x, 2 y, STEP_Z z. */
static inline int step_index(pair_masks xy, pair_masks zz)
{
    return _mm_movemask_pd((__m128d)xy) + 4 * _mm_movemask_pd((__m128d)zz);
}
#else
#define STEP_Z 4 /* the bit after those of x and y */

static inline pair smaller(pair a, pair b)
{
    const pair_masks is_less = a < b;
    return (pair)(((pair_masks)a & is_less) | ((pair_masks)b & ~is_less));
}

static inline int step_index(pair_masks xy, pair_masks zz)
{
    return (int)((xy[0] & 1) | (xy[1] & 2) | (zz[0] & STEP_Z));
}
#endif

/* ---- places in a block ---- */

/* A place in a block: the numbers 0..7 of a cell along the axes, 10 bits each,
 * so that a step beyond the block shows in bit 3 of a number; and in the upper
 * 32 bits the offset of the cell in the values of a leaf. */
#define PLACE_AT(x, y, z)                               \
    ((int64_t)(x) * (1 << 20) + (y) * (1 << 10) + (z) + \
     ((int64_t)(x)*LEAF_X + (y)*LEAF_Y + (z)) * ((int64_t)1 << 32))

/* One voxel along each axis, and eight. */
#define PLACE_ONES   (1 << 20 | 1 << 10 | 1)
#define PLACE_EIGHTS (PLACE_ONES << 3)

static inline void unpack_place(int64_t place, int in_block[3])
{
    int left = (int)(uint32_t)place;
    for (int axis = 2; axis >= 0; --axis) {
        in_block[axis] = ((left + 1) & 1023) - 1; /* -1..8 */
        left = (left - in_block[axis]) >> 10;
    }
}

/* True if the upper corners of the cell are beyond the block. */
static inline bool is_at_end(int64_t place)
{
    return ((place + PLACE_ONES) & PLACE_EIGHTS) != 0;
}

static inline bool is_beyond(int64_t place)
{
    return (place & PLACE_EIGHTS) != 0;
}

static inline void set_steps(tally *sum, const int step[3])
{
    const int64_t x = PLACE_AT(step[0], 0, 0), y = PLACE_AT(0, step[1], 0);
    const int64_t z = PLACE_AT(0, 0, step[2]);
    sum->step[0] = 0;
    sum->step[1] = x;
    sum->step[2] = y;
    sum->step[3] = x + y;
    for (int i = 0; i < 4; ++i) {
        sum->step[STEP_Z + i] = sum->step[i] + z;
    }
}

/* ---- the list ---- */

/* Moves the walk to a cell of the list, in which the limit is reached. */
static void stop_in_cell(murk_linear *m, const cells *c, size_t i, tally *sum)
{
    int in_block[3];
    size_t block = 0;
    while (c->block_end[block] <= i) {
        ++block;
    }
    unpack_place(c->place[i], in_block);
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = (double)c->block_first[block][axis] + in_block[axis];
    }
    for (int k = 0; k < 8; ++k) {
        m->corner[k] = (double)c->corner[i][(k >> 2) * LEAF_X +
                                            (k >> 1 & 1) * LEAF_Y + (k & 1)];
    }
    m->ray.from = c->from[i];
    m->ray.to = c->to[i];
    stop_in_segment(m, sum, c->mean[i]);
}

/* Adds the integrals over the cells of the list and empties the list. True if
 * the limit is reached in one of them. */
static bool add_cells(murk_linear *m, cells *c, tally *sum)
{
    const size_t n = c->n;
    /* Fill the last group with segments of length 0. */
    for (size_t i = n; i % GROUP > 0; ++i) {
        c->from[i] = c->to[i] = c->to[n - 1];
        c->low[0][i] = c->low[1][i] = c->low[2][i] = 0;
        c->corner[i] = c->corner[n - 1];
    }
    compute_means(c, m->ray.direction, sum);
    c->n = 0;
    c->n_blocks = 0;
    for (size_t first = 0; first < n; first += GROUP) {
        /* Depths are 0 or more, so no cell of the group reaches the limit if
         * all cells together do not. */
        const double *depth = &c->depth[first];
        double more = sum->reached;
        for (int i = 0; i < GROUP; ++i) {
            more += depth[i];
        }
        if (!(more >= sum->limit)) {
            sum->reached = more;
            continue;
        }
        for (size_t i = first; i < n && i < first + GROUP; ++i) {
            more = sum->reached + c->depth[i];
            if (more >= sum->limit && c->density[i] > 0) {
                stop_in_cell(m, c, i, sum);
                return true;
            }
            sum->reached = more;
        }
    }
    return false;
}

/* ---- cells of a block ---- */

static inline void end_block(cells *c, size_t n, const int32_t block_first[3])
{
    c->n = c->block_end[c->n_blocks] = n;
    memcpy(c->block_first[c->n_blocks++], block_first,
           sizeof c->block_first[0]);
}

/* Copies the corners of a cell, of which some are beyond the block. */
static INTO_COPIES void gather_corners(murk_linear *m, unsigned offset,
                                       float *to)
{
    const murk_linear_corners *at = murk_linear_know_corners(m, offset);
    const couple c00 = {murk_linear_corner(m, at, offset, 0),
                        murk_linear_corner(m, at, offset, 1)};
    const couple c01 = {murk_linear_corner(m, at, offset, 2),
                        murk_linear_corner(m, at, offset, 3)};
    const couple c10 = {murk_linear_corner(m, at, offset, 4),
                        murk_linear_corner(m, at, offset, 5)};
    const couple c11 = {murk_linear_corner(m, at, offset, 6),
                        murk_linear_corner(m, at, offset, 7)};
    memcpy(to, &c00, sizeof c00);
    memcpy(to + LEAF_Y, &c01, sizeof c01);
    memcpy(to + LEAF_X, &c10, sizeof c10);
    memcpy(to + LEAF_X + LEAF_Y, &c11, sizeof c11);
}

/* Lists the cells up to the end of the block or of the ray: the work of
 * murk_grid_ray_cross_in_block(), murk_grid_ray_step_in_block() and
 * murk_grid_ray_leave_block(). Adds the cells when there are `capacity` or
 * more, and inside of the block if there are that many. True if the limit is
 * reached. */
static INTO_COPIES bool list_block(murk_linear *m, cells *c, tally *sum)
{
    murk_grid_ray *r = &m->ray;
    const double end = r->end;
    /* Along x and y in pairs, along z twice. */
    const pair stride_xy = {r->stride[0], r->stride[1]};
    const pair stride_zz = {r->stride[2], r->stride[2]};
    const pair step_xy = {r->step[0], r->step[1]};
    const pair step_zz = {r->step[2], r->step[2]};
    double from = r->from, to;
    const double face_z = murk_larger(r->cross[2], from);
    pair face_xy = {murk_larger(r->cross[0], from),
                    murk_larger(r->cross[1], from)};
    pair face_zz = {face_z, face_z};
    const double low_z = r->at[2] - r->origin[2];
    pair low_xy = {r->at[0] - r->origin[0], r->at[1] - r->origin[1]};
    pair low_zz = {low_z, low_z};
    int64_t place = PLACE_AT(r->in_block[0], r->in_block[1], r->in_block[2]);
    const float *leaf = murk_linear_leaf(m);
    const size_t capacity =
        sum->limit < INFINITY ? CELLS_WITH_LIMIT : CELLS_MAX;
    size_t n = c->n;
    for (;;) {
        /* Add the cell to the list. */
        if (!leaf || is_at_end(place)) {
            gather_corners(m, (unsigned)(place >> 32), c->gathered[n]);
            c->corner[n] = c->gathered[n];
        } else {
            c->corner[n] = leaf + (place >> 32);
        }
        c->low[0][n] = low_xy[0];
        c->low[1][n] = low_xy[1];
        c->low[2][n] = low_zz[0];
        c->place[n] = place;
        pair face = smaller(face_xy, face_zz);
        face = smaller(face, (pair){face[1], face[0]});
        to = murk_smaller(face[0], end);
        c->from[n] = from;
        c->to[n] = to;
        ++n;
        if (face[0] >= end) {
            break;
        }
        /* Advance to the next cell along every axis whose face was reached. */
        from = to;
        const pair_masks is_xy = face_xy <= face, is_zz = face_zz <= face;
        face_xy += (pair)(is_xy & (pair_masks)stride_xy);
        face_zz += (pair)(is_zz & (pair_masks)stride_zz);
        low_xy += (pair)(is_xy & (pair_masks)step_xy);
        low_zz += (pair)(is_zz & (pair_masks)step_zz);
        place += sum->step[step_index(is_xy, is_zz)];
        if (is_beyond(place)) {
            break;
        }
        if (n == capacity) {
            end_block(c, n, r->block_first);
            if (add_cells(m, c, sum)) {
                return true;
            }
            n = 0;
        }
    }
    /* Store the state. */
    end_block(c, n, r->block_first);
    r->from = from;
    r->to = to;
    int in_block[3];
    unpack_place(place, in_block);
    for (int axis = 0; axis < 3; ++axis) {
        r->at[axis] = r->block_first[axis] + in_block[axis];
    }
    r->is_in_block = false;
    return c->n >= capacity && add_cells(m, c, sum);
}

/* ---- segments ---- */

static bool is_zero(const double corner[8])
{
    bool zero = true;
    for (int i = 0; i < 8; ++i) {
        zero &= corner[i] == 0;
    }
    return zero;
}

/* Adds the integral over the current segment, a box of cells, after those over
 * the cells of the list. True if the limit is reached. */
static bool add_segment(murk_linear *m, cells *c, tally *sum)
{
    if (sum->offset == 0 && is_zero(m->corner)) {
        return false;
    }
    if (c->n > 0 && add_cells(m, c, sum)) {
        return true;
    }
    const murk_cubic field = murk_linear_cubic(m, m->ray.from, m->ray.to);
    const double mean = murk_larger(murk_cubic_integral(&field, 1), 0);
    const double density = sum->scale * mean + sum->offset;
    const double more = sum->reached + density * (m->ray.to - m->ray.from);
    if (more >= sum->limit && density > 0) {
        stop_in_segment(m, sum, mean);
        return true;
    }
    sum->reached = more;
    return false;
}

WIDE_CLONES
bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum)
{
    murk_linear *m = linear;
    const double *d = m->ray.direction;
    cells c; /* not initialised as a whole: the list is long */
    c.n = c.n_blocks = 0;
    tally t;
    t.scale = scale;
    t.offset = offset;
    t.limit = limit;
    t.reached = *sum;
    t.longest =
        1.001 / murk_larger(murk_larger(fabs(d[0]), fabs(d[1])), fabs(d[2]));
    set_steps(&t, m->ray.step);
    bool stops = false;
    while (!stops && m->ray.to < m->ray.end) {
        m->ray.from = m->ray.to;
        if (murk_linear_enter(m)) {
            stops = list_block(m, &c, &t);
        } else {
            stops = add_segment(m, &c, &t);
        }
    }
    stops = stops || (c.n > 0 && add_cells(m, &c, &t));
    *sum = t.reached;
    return stops;
}
