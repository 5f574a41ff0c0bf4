/* Integral of a field with trilinear interpolation along a ray
 * (medium/linear.h).
 *
 * The ray is followed from cell to cell, which is a chain of comparisons and
 * additions, and the cells are listed. When the list is full, the means of the
 * field in all of its cells are computed side by side in vectors, and their
 * contributions are added one by one. The result does not depend on the length
 * of the list. This file has what is done once for each ray or collision; the
 * loops over cells are in linear_cells.h, for each set of vector
 * instructions. */
#include "base/lanes.h"
#include "medium/linear.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/* Cells in the list before their contributions are added: many, because the
 * processor is then seldom surprised by the end of the list. With a limit most
 * rays end soon. */
#define CELLS_MAX        32
#define CELLS_WITH_LIMIT 4

/* Cells side by side in a vector. */
#define GROUP 4

typedef double numbers __attribute__((vector_size(GROUP * sizeof(double))));
typedef int64_t masks __attribute__((vector_size(GROUP * sizeof(int64_t))));
typedef float singles __attribute__((vector_size(4 * sizeof(float))));
typedef uint64_t words __attribute__((vector_size(2 * sizeof(uint64_t))));
typedef double pair __attribute__((vector_size(2 * sizeof(double))));
typedef int64_t pair_masks __attribute__((vector_size(2 * sizeof(int64_t))));

/* Cells that the ray crosses one after the other. */
typedef struct cells {
    size_t n;
    double from[CELLS_MAX + GROUP], to[CELLS_MAX + GROUP];
    double low[3][CELLS_MAX + GROUP]; /* lowest points, relative to the origin
                                         of the ray */
    /* The values at the lowest corners, in blocks of the grid. */
    const float *corner[CELLS_MAX + GROUP];
    double mean[CELLS_MAX + GROUP], density[CELLS_MAX + GROUP],
        depth[CELLS_MAX + GROUP];
} cells;

/* The state of an integration. */
typedef struct tally {
    double scale, offset, limit, reached;
    /* The longest possible segment in a cell, with a margin of 1e-3 for
     * rounding. Origins so far away that rounding exceeds the margin lose the
     * second-order term only. */
    double longest;
    /* The change of the place in a block at a step along the axes of a bit
     * mask, as step_index() has it. */
    int64_t step[16];
} tally;

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

/* Moves the walk to a cell of the list, in which the limit is reached. */
static void stop_in_cell(murk_linear *m, const cells *c, size_t i, tally *sum)
{
    /* The block, and the cell in the block. */
    const size_t value = (size_t)(c->corner[i] - m->blocks->value);
    const murk_linear_block *block =
        &m->blocks->block[value / MURK_BLOCK_VALUES];
    const int at = (int)(value % MURK_BLOCK_VALUES);
    const int in_block[3] = {at / MURK_CORNER_X,
                             at % MURK_CORNER_X / MURK_CORNER_Y,
                             at % MURK_CORNER_Y};
    for (int axis = 0; axis < 3; ++axis) {
        m->low[axis] = (double)block->first[axis] + in_block[axis];
    }
    murk_linear_load_corners(m->corner, c->corner[i]);
    m->ray.from = c->from[i];
    m->ray.to = c->to[i];
    stop_in_segment(m, sum, c->mean[i]);
}

/* ---- places in a block ---- */

/* A place in a block: the numbers 0..7 of a cell along the axes, 10 bits each,
 * so that a step beyond the block shows in bit 3 of a number; and in the upper
 * 32 bits the index of the cell in the values of the block. */
#define PLACE_AT(x, y, z)                               \
    ((int64_t)(x) * (1 << 20) + (y) * (1 << 10) + (z) + \
     (int64_t)MURK_CELL_AT(x, y, z) * ((int64_t)1 << 32))

/* The place that is 1 along each axis, without the index. */
#define PLACE_ONES (1 << 20 | 1 << 10 | 1)

/* The numbers of the cell along the axes, -1..8: with 1 added to each of them
 * there are no borrows. */
static inline int place_x(int64_t place)
{
    return ((int)((uint32_t)place + PLACE_ONES) >> 20) - 1;
}

static inline int place_y(int64_t place)
{
    return ((int)((uint32_t)place + PLACE_ONES) >> 10 & 1023) - 1;
}

static inline int place_z(int64_t place)
{
    return ((int)((uint32_t)place + PLACE_ONES) & 1023) - 1;
}

static inline bool is_beyond(int64_t place)
{
    return (place & PLACE_ONES << 3) != 0;
}

/* A number for each axis: x and y in a pair, z twice. */
typedef struct axes {
    pair xy, zz;
} axes;

static inline axes axes_of(const double number[3])
{
    return (axes){{number[0], number[1]}, {number[2], number[2]}};
}

static inline pair chosen(pair_masks is_first, pair a, pair b)
{
    return (pair)(((pair_masks)a & is_first) | ((pair_masks)b & ~is_first));
}

#if defined(__x86_64__)
#define STEP_Z 12 /* both bits of the second mask */

static inline pair smaller(pair a, pair b)
{
    return (pair)_mm_min_pd((__m128d)a, (__m128d)b);
}

static inline pair larger(pair a, pair b)
{
    return (pair)_mm_max_pd((__m128d)a, (__m128d)b);
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
    return chosen(a < b, a, b);
}

static inline pair larger(pair a, pair b)
{
    return chosen(a > b, a, b);
}

static inline int step_index(pair_masks xy, pair_masks zz)
{
    return (int)((xy[0] & 1) | (xy[1] & 2) | (zz[0] & STEP_Z));
}
#endif

static void set_steps(tally *sum, const int step[3])
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

/* ---- segments ---- */

static bool is_zero(const double corner[8])
{
    bool zero = true;
    for (int i = 0; i < 8; ++i) {
        zero &= corner[i] == 0;
    }
    return zero;
}

/* Adds the integral over the current segment, a box of cells. True if the limit
 * is reached. */
static bool add_segment(murk_linear *m, tally *sum)
{
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

/* ---- the sets of vector instructions ---- */

#define MURK_CELLS          integrate_baseline
#define MURK_CELLS_TARGET   MURK_TARGET_BASELINE
#define MURK_CELLS_WIDEN(a) __builtin_convertvector(a, numbers)
#define MURK_CELLS_SELECT(m, a, b) \
    ((numbers)(((masks)(a) & (m)) | ((masks)(b) & ~(m))))
#define MURK_CELLS_SMALLER(a, b) MURK_CELLS_SELECT((a) < (b), a, b)
#define MURK_CELLS_LARGER(a, b)  MURK_CELLS_SELECT((a) > (b), a, b)
#include "medium/linear_cells.h"

#if defined(__x86_64__)
#define MURK_CELLS          integrate_avx2
#define MURK_CELLS_TARGET   MURK_TARGET_AVX2
#define MURK_CELLS_WIDEN(a) ((numbers)_mm256_cvtps_pd((__m128)(a)))
#define MURK_CELLS_SMALLER(a, b) \
    ((numbers)_mm256_min_pd((__m256d)(a), (__m256d)(b)))
#define MURK_CELLS_LARGER(a, b) \
    ((numbers)_mm256_max_pd((__m256d)(a), (__m256d)(b)))
#include "medium/linear_cells.h"
#endif

bool murk_linear_integrate(murk_linear *linear, double scale, double offset,
                           double limit, double *sum)
{
    const double *d = linear->ray.direction;
    tally t;
    t.scale = scale;
    t.offset = offset;
    t.limit = limit;
    t.reached = *sum;
    t.longest =
        1.001 / murk_larger(murk_larger(fabs(d[0]), fabs(d[1])), fabs(d[2]));
    set_steps(&t, linear->ray.step);
    bool stops;
#if defined(__x86_64__)
    if (linear->blocks->set != MURK_LANES_BASELINE) {
        stops = integrate_avx2(linear, &t);
    } else {
        stops = integrate_baseline(linear, &t);
    }
#else
    stops = integrate_baseline(linear, &t);
#endif
    *sum = t.reached;
    return stops;
}
