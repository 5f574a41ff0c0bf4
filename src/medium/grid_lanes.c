/* Walks of several rays through a grid at once (medium/grid_lanes.h): the
 * operations of medium/grid_ray.h and medium/march.c as loops over lanes. */
#include "medium/grid_lanes.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "medium/march.h"

/* ---- into the space of the grid ---- */

/* murk_clip_axis(); *fits becomes 0 if nothing is left. */
static inline void clip_axis(double low, double high, double origin,
                             double inverse, double *t0, double *t1,
                             double *fits)
{
    const double a = (low - origin) * inverse;
    const double b = (high - origin) * inverse;
    const double enter = inverse > 0 ? a : b, leave = inverse > 0 ? b : a;
    const double from = *t0 > enter ? *t0 : enter;
    const double to = *t1 < leave ? *t1 : leave;
    const bool is_parallel = inverse == 0;
    const bool is_between = (origin >= low) & (origin < high);
    const double is_left = murk_truth(from < to);
    *fits *= is_parallel ? murk_truth(is_between) : is_left;
    *t0 = is_parallel ? *t0 : from;
    *t1 = is_parallel ? *t1 : to;
}

/* murk_invert() without a branch. */
static inline double inverted(double d)
{
    const double inverse = 1 / d;
    return fabs(inverse) <= DBL_MAX ? inverse : 0;
}

MURK_LANE_KERNEL clip(murk_grid_lanes *restrict g, const murk_lane_grid *grid,
                      const double *const ray[6], double *restrict from,
                      double *restrict to, size_t n)
{
    const murk_affine map = grid->to_index;
    const int32_t *first = grid->tree->first, *last = grid->tree->last;
    const double low_x = first[0], low_y = first[1], low_z = first[2];
    const double high_x = (double)last[0] + 1, high_y = (double)last[1] + 1,
                 high_z = (double)last[2] + 1;
    const double *restrict x = ray[0], *restrict y = ray[1],
                           *restrict z = ray[2];
    const double *restrict dx = ray[3], *restrict dy = ray[4],
                           *restrict dz = ray[5];
    const double has_cells = murk_truth(grid->tree->n_cells > 0);
    MURK_FOR_LANES(n)
    {
        /* The ray in index space. */
        const murk_vec3 o = murk_affine_point(&map, murk_vec(x[i], y[i], z[i]));
        const murk_vec3 d =
            murk_affine_direction(&map, murk_vec(dx[i], dy[i], dz[i]));
        const murk_vec3 inverse = {inverted(d.x), inverted(d.y), inverted(d.z)};
        g->x[i] = o.x;
        g->y[i] = o.y;
        g->z[i] = o.z;
        g->dx[i] = d.x;
        g->dy[i] = d.y;
        g->dz[i] = d.z;
        g->inverse_x[i] = inverse.x;
        g->inverse_y[i] = inverse.y;
        g->inverse_z[i] = inverse.z;
        /* The part of it in the box of active voxels. */
        double t0 = from[i], t1 = to[i], fits = has_cells;
        clip_axis(low_x, high_x, o.x, inverse.x, &t0, &t1, &fits);
        clip_axis(low_y, high_y, o.y, inverse.y, &t0, &t1, &fits);
        clip_axis(low_z, high_z, o.z, inverse.z, &t0, &t1, &fits);
        from[i] = t0;
        to[i] = fits != 0 ? t1 : -INFINITY;
    }
}

/* ---- the walk ---- */

/* murk_voxel_at(), as a number. */
static inline double cell_at(double place, double first, double last)
{
    const double cell = place >= last ? last : floor(place);
    return place > first ? cell : first;
}

/* The voxels up to the end of a leaf, from the voxel in the leaf. */
static inline double left_of(double in_leaf, double inverse)
{
    return inverse < 0 ? in_leaf + 1 : MURK_LEAF_EDGE - in_leaf;
}

/* The leaves and voxels in which the walks begin. */
MURK_LANE_KERNEL begin(murk_grid_lanes *restrict g, const murk_lane_grid *grid,
                       size_t n)
{
    const murk_tree *tree = grid->tree;
    const double first_x = tree->first[0], last_x = tree->last[0];
    const double first_y = tree->first[1], last_y = tree->last[1];
    const double first_z = tree->first[2], last_z = tree->last[2];
    const murk_leaf_table table = *grid->leaves;
    const double table_x = table.first[0], table_y = table.first[1],
                 table_z = table.first[2];
    const double stride_x = (double)table.stride[0],
                 stride_y = (double)table.stride[1];
    MURK_FOR_LANES(n)
    {
        /* The voxel and its leaf. */
        const double t = g->from[i], given = g->end[i];
        const double end = given < DBL_MAX ? given : DBL_MAX;
        const double x = cell_at(g->x[i] + t * g->dx[i], first_x, last_x);
        const double y = cell_at(g->y[i] + t * g->dy[i], first_y, last_y);
        const double z = cell_at(g->z[i] + t * g->dz[i], first_z, last_z);
        const double leaf_x = floor(x / MURK_LEAF_EDGE) * MURK_LEAF_EDGE;
        const double leaf_y = floor(y / MURK_LEAF_EDGE) * MURK_LEAF_EDGE;
        const double leaf_z = floor(z / MURK_LEAF_EDGE) * MURK_LEAF_EDGE;
        const double in_x = x - leaf_x, in_y = y - leaf_y, in_z = z - leaf_z;
        /* The state of the walk there. */
        g->end[i] = end;
        g->starts[i] = murk_truth((g->walks[i] != 0) & (t < end));
        g->leaf_x[i] = leaf_x;
        g->leaf_y[i] = leaf_y;
        g->leaf_z[i] = leaf_z;
        g->entry[i] = ((leaf_x - table_x) * stride_x +
                       (leaf_y - table_y) * stride_y + (leaf_z - table_z)) /
                      MURK_LEAF_EDGE;
        g->number[i] = in_x * 64 + in_y * 8 + in_z;
        g->left_x[i] = left_of(in_x, g->inverse_x[i]);
        g->left_y[i] = left_of(in_y, g->inverse_y[i]);
        g->left_z[i] = left_of(in_z, g->inverse_z[i]);
    }
}

/* Follows the ray of a lane to its end, from the given voxel. */
static void walk_alone(murk_grid_lanes *g, const murk_tree *tree, size_t i,
                       const double voxel[3])
{
    murk_march march;
    murk_march_begin(&march, tree, murk_vec(g->x[i], g->y[i], g->z[i]),
                     murk_vec(g->dx[i], g->dy[i], g->dz[i]), g->from[i],
                     g->end[i]);
    for (int axis = 0; axis < 3; ++axis) {
        march.ray.at[axis] = (int32_t)voxel[axis];
    }
    const bool stops = murk_march_integrate(&march, g->scale[i], g->offset[i],
                                            g->limit[i], &g->sum[i]);
    g->stops[i] = murk_truth(stops);
    g->to[i] = march.ray.to;
    g->value[i] = march.value;
}

/* ---- the sets of vector instructions ---- */

/* For grid_lanes_walk.h: a vector of the group from an array of the lanes, and
 * back. */
#define LOAD(name)         memcpy(&name, &g->name[lane], sizeof name)
#define STORE(name, given) memcpy(&g->name[lane], &(given), sizeof(given))

#define LOAD_WHOLE(name)                                  \
    do {                                                  \
        NUMBERS of_name;                                  \
        memcpy(&of_name, &g->name[lane], sizeof of_name); \
        name = WHOLE(of_name);                            \
    } while (0)

#define SELECT_WHOLE(m, a, b) (((m) & (a)) | (~(m) & (b)))
#define LARGER(a, b)          SELECT((a) > (b), a, b)
#define MASKED(m, a)          ((NUMBERS)((m) & (WHOLES)(a)))
#define MAGNITUDE(a)          ((NUMBERS)((WHOLES)(a)&INT64_MAX))

/* The integer of a whole number from 0 to 2^52 - 1, and back: the last bits of
 * the sum with 2^52. */
#define TWO_52       0x4330000000000000
#define WHOLE(a)     ((WHOLES)((a) + 0x1p52) ^ TWO_52)
#define NUMBER_OF(a) ((NUMBERS)((a) | TWO_52) - 0x1p52)

#define PLAIN_SELECT(m, a, b) \
    ((NUMBERS)SELECT_WHOLE(m, (WHOLES)(a), (WHOLES)(b)))

typedef double numbers_2 __attribute__((vector_size(16)));
typedef int64_t wholes_2 __attribute__((vector_size(16)));
#define WALK   walk_group_baseline
#define TARGET MURK_TARGET_BASELINE
/* A register has 128 bits, so 2 doubles. */
#define WIDTH         2
#define NUMBERS       numbers_2
#define WHOLES        wholes_2
#define SELECT        PLAIN_SELECT
#define SMALLER(a, b) SELECT((a) < (b), a, b)
#define BITS(m)       ((unsigned)(((m)[0] & 1) | ((m)[1] & 2)))
#include "medium/grid_lanes_walk.h"

#if defined(__x86_64__)
typedef double numbers_4 __attribute__((vector_size(32)));
typedef int64_t wholes_4 __attribute__((vector_size(32)));
#define WALK   walk_group_avx2
#define TARGET MURK_TARGET_AVX2
/* A register has 256 bits, so 4 doubles. */
#define WIDTH   4
#define NUMBERS numbers_4
#define WHOLES  wholes_4
#define SELECT(m, a, b) \
    ((numbers_4)_mm256_blendv_pd((__m256d)(b), (__m256d)(a), (__m256d)(m)))
#define SMALLER(a, b) ((numbers_4)_mm256_min_pd((__m256d)(a), (__m256d)(b)))
#define BITS(m)       ((unsigned)_mm256_movemask_pd((__m256d)(m)))
#include "medium/grid_lanes_walk.h"

typedef double numbers_8 __attribute__((vector_size(64)));
typedef int64_t wholes_8 __attribute__((vector_size(64)));
#define WALK   walk_group_avx512
#define TARGET MURK_TARGET_AVX512
/* A register has 512 bits, so 8 doubles. */
#define WIDTH         8
#define NUMBERS       numbers_8
#define WHOLES        wholes_8
#define SELECT        PLAIN_SELECT
#define SMALLER(a, b) ((numbers_8)_mm512_min_pd((__m512d)(a), (__m512d)(b)))
#define BITS(m)       ((unsigned)_mm512_movepi64_mask((__m512i)(m)))
#include "medium/grid_lanes_walk.h"
#endif

/* Walks in groups of `width` lanes. */
#define MURK_COMPILED_FOR(set, target, width)                           \
    target static void clip_##set(                                      \
        murk_grid_lanes *lanes, const murk_lane_grid *grid,             \
        const double *const ray[6], double *from, double *to, size_t n) \
    {                                                                   \
        clip(lanes, grid, ray, from, to, n);                            \
    }                                                                   \
    target static void walk_##set(murk_grid_lanes *lanes,               \
                                  const murk_lane_grid *grid, size_t n) \
    {                                                                   \
        begin(lanes, grid, n);                                          \
        for (size_t lane = 0; lane < n; lane += (width)) {              \
            walk_group_##set(lanes, grid, lane);                        \
        }                                                               \
    }

MURK_COMPILED_FOR(baseline, MURK_TARGET_BASELINE, 2)
#if defined(__x86_64__)
MURK_COMPILED_FOR(avx2, MURK_TARGET_AVX2, 4)
MURK_COMPILED_FOR(avx512, MURK_TARGET_AVX512, 8)
#endif

const murk_grid_lane_steps *murk_grid_lane_steps_for(murk_lane_set set)
{
    static const murk_grid_lane_steps steps[MURK_LANE_SETS] = {
        [MURK_LANES_BASELINE] = {clip_baseline, walk_baseline},
#if defined(__x86_64__)
        [MURK_LANES_AVX2] = {clip_avx2, walk_avx2},
        [MURK_LANES_AVX512] = {clip_avx512, walk_avx512},
#endif
    };
    return &steps[set];
}
