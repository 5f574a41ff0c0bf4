/* Cells of 128, 4096, ... voxels lie in one hash table; a cell that has smaller
 * ones in it is their parent. The bound of a cell holds all over it, so the
 * bound at a voxel is the largest on the way down from the top: a large value
 * can be noted at a parent without a look at what lies below. */
#include "medium/bricks.h"

#include "medium/nodes.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* log2 of the edges of cells, smallest first: blocks, the tree's root cells,
 * and so on by 32 up to where a few cells span all indices. */
#define LEVELS 5
static const int SHIFT[LEVELS] = {7, 12, 17, 22, 27};

#define BLOCK       128
#define FIRST_SLOTS 64 /* a power of two */
#define NO_TABLE    UINT32_MAX

typedef struct cell {
    int32_t at[3];  /* its lowest voxel, in edges */
    uint16_t level; /* into SHIFT */
    bool is_taken, is_parent;
    float bound;    /* all over it */
    uint32_t table; /* of a block's bricks, or NO_TABLE */
} cell;

struct murk_bricks {
    int edge_shift; /* log2 of a brick's edge */
    int below, above;
    cell *slot; /* hash table, open addressing */
    size_t n_slots, n_taken;
    float *bound; /* tables of bricks, x slowest */
    size_t n_tables, tables_room;
};

static size_t table_size(const murk_bricks *b)
{
    const size_t side = (size_t)BLOCK >> b->edge_shift;
    return side * side * side;
}

/* A brick's place in the table of its block. */
static inline size_t brick_in_block(int shift, const int32_t voxel[3])
{
    const size_t x = (size_t)((voxel[0] & (BLOCK - 1)) >> shift);
    const size_t y = (size_t)((voxel[1] & (BLOCK - 1)) >> shift);
    const size_t z = (size_t)((voxel[2] & (BLOCK - 1)) >> shift);
    const int side = 7 - shift;
    return (x << (2 * side)) | (y << side) | z;
}

/* Multiplies by odd constants and takes the high bits (Knuth, The Art of
 * Computer Programming 3, 2nd ed., 6.4). */
static inline size_t first_slot(const murk_bricks *b, int level,
                                const int32_t at[3])
{
    uint64_t h = (uint32_t)at[0] * UINT64_C(0x9e3779b97f4a7c15);
    h = (h ^ (uint32_t)at[1]) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (uint32_t)at[2]) * UINT64_C(0x94d049bb133111eb);
    h = (h ^ (uint32_t)level) * UINT64_C(0x9e3779b97f4a7c15);
    return (size_t)(h >> 32) & (b->n_slots - 1);
}

/* The slot of the cell, or the free one where it belongs. */
static inline cell *slot_of(const murk_bricks *b, int level,
                            const int32_t voxel[3])
{
    const int32_t at[3] = {voxel[0] >> SHIFT[level], voxel[1] >> SHIFT[level],
                           voxel[2] >> SHIFT[level]};
    size_t i = first_slot(b, level, at);
    for (;; i = (i + 1) & (b->n_slots - 1)) {
        cell *c = &b->slot[i];
        if (!c->is_taken || (c->at[0] == at[0] && c->at[1] == at[1] &&
                             c->at[2] == at[2] && c->level == level)) {
            return c;
        }
    }
}

/* ---- building: all that can fail returns false for want of memory ---- */

static bool grow(murk_bricks *b)
{
    murk_bricks larger = *b;
    larger.n_slots = b->n_slots ? 2 * b->n_slots : FIRST_SLOTS;
    larger.slot = calloc(larger.n_slots, sizeof *larger.slot);
    if (!larger.slot) {
        return false;
    }
    for (size_t i = 0; i < b->n_slots; ++i) {
        const cell *c = &b->slot[i];
        if (c->is_taken) {
            const int shift = SHIFT[c->level];
            const int32_t voxel[3] = {c->at[0] * (1 << shift),
                                      c->at[1] * (1 << shift),
                                      c->at[2] * (1 << shift)};
            *slot_of(&larger, c->level, voxel) = *c;
        }
    }
    free(b->slot);
    *b = larger;
    return true;
}

/* The cell, made with all its parents where it is new; NULL without memory.
 * Valid until the next call. */
static cell *cell_at(murk_bricks *b, int level, const int32_t voxel[3])
{
    for (int l = LEVELS - 1;; --l) {
        if (2 * (b->n_taken + 1) > b->n_slots && !grow(b)) {
            return NULL;
        }
        cell *c = slot_of(b, l, voxel);
        if (!c->is_taken) {
            *c = (cell){.at = {voxel[0] >> SHIFT[l], voxel[1] >> SHIFT[l],
                               voxel[2] >> SHIFT[l]},
                        .level = (uint16_t)l,
                        .is_taken = true,
                        .table = NO_TABLE};
            ++b->n_taken;
        }
        if (l == level) {
            return c;
        }
        c->is_parent = true;
    }
}

/* The table of the block around a voxel; NULL without memory. Valid until the
 * next call. */
static float *table_at(murk_bricks *b, const int32_t voxel[3])
{
    cell *block = cell_at(b, 0, voxel);
    if (!block) {
        return NULL;
    }
    const size_t size = table_size(b);
    if (block->table == NO_TABLE) {
        if (b->n_tables == b->tables_room) {
            const size_t room = b->tables_room + b->tables_room / 2 + 8;
            float *bound = realloc(b->bound, room * size * sizeof *bound);
            if (!bound) {
                return NULL;
            }
            b->bound = bound;
            b->tables_room = room;
        }
        block->table = (uint32_t)b->n_tables++;
        memset(b->bound + block->table * size, 0, size * sizeof *b->bound);
    }
    return b->bound + block->table * size;
}

static void raise(float *bound, float value)
{
    *bound = *bound < value ? value : *bound;
}

/* Raises all bricks that meet the inclusive box of voxels, which spans at most
 * two bricks along an axis. */
static bool raise_bricks(murk_bricks *b, const int32_t first[3],
                         const int32_t last[3], float value)
{
    const int s = b->edge_shift;
    for (int corner = 0; corner < 8; ++corner) {
        int32_t voxel[3];
        bool is_new = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool far = corner >> axis & 1;
            voxel[axis] = far ? last[axis] : first[axis];
            is_new &= !far || last[axis] >> s != first[axis] >> s;
        }
        if (is_new) {
            float *table = table_at(b, voxel);
            if (!table) {
                return false;
            }
            raise(&table[brick_in_block(s, voxel)], value);
        }
    }
    return true;
}

/* 0, 1, 2: the first, a middle, the last of a leaf's eight layers. */
static inline int part_of_leaf(int layer)
{
    return layer == 0 ? 0 : layer == 7 ? 2 : 1;
}

/* What only its outer layers hold is seen from next door. */
static bool add_leaf(murk_bricks *b, const int32_t at[3], const float *value)
{
    static const int part_first[3] = {0, 1, 7}, part_last[3] = {0, 6, 7};
    float most[3][3][3] = {{{0}}};
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            float *row = most[part_of_leaf(i)][part_of_leaf(j)];
            for (int k = 0; k < 8; ++k, ++value) {
                raise(&row[part_of_leaf(k)], *value);
            }
        }
    }
    for (int n = 0; n < 27; ++n) {
        const int part[3] = {n / 9, n / 3 % 3, n % 3};
        const float value_here = most[part[0]][part[1]][part[2]];
        int32_t first[3], last[3];
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = at[axis] + part_first[part[axis]] - b->above;
            last[axis] = at[axis] + part_last[part[axis]] + b->below;
        }
        if (value_here > 0 && !raise_bricks(b, first, last, value_here)) {
            return false;
        }
    }
    return true;
}

static bool add_small_tile(murk_bricks *b, const int32_t at[3], float value)
{
    float leaf[512];
    for (int i = 0; i < 512; ++i) {
        leaf[i] = value;
    }
    return add_leaf(b, at, leaf);
}

/* A large cell of one value, and those of its size from which it is seen. */
static bool add_large_tile(murk_bricks *b, int level, const int32_t at[3],
                           float value)
{
    const int32_t size = 1 << SHIFT[level];
    for (int n = 0; value > 0 && n < 27; ++n) {
        const int32_t step[3] = {n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
        int32_t voxel[3];
        bool sees = true;
        for (int axis = 0; axis < 3; ++axis) {
            voxel[axis] = at[axis] + step[axis] * size;
            sees &=
                step[axis] == 0 || (step[axis] < 0 ? b->above : b->below) > 0;
        }
        if (sees) {
            cell *c = cell_at(b, level, voxel);
            if (!c) {
                return false;
            }
            raise(&c->bound, value);
        }
    }
    return true;
}

/* The n-th of side^3 cells of an edge from `first` on. */
static void nth_cell(const int32_t first[3], int n, int side, int32_t edge,
                     int32_t at[3])
{
    at[0] = first[0] + n / (side * side) * edge;
    at[1] = first[1] + n / side % side * edge;
    at[2] = first[2] + n % side * edge;
}

static bool add_lower(murk_bricks *b, const unsigned char *node,
                      const int32_t first[3])
{
    for (int n = 0; n < 16 * 16 * 16; ++n) {
        int32_t at[3];
        nth_cell(first, n, 16, 8, at);
        const murk_cell c = murk_lower_cell(node, at[0], at[1], at[2]);
        const bool added = c.child ? add_leaf(b, at, murk_leaf_values(c.child))
                           : c.value > 0 ? add_small_tile(b, at, c.value)
                                         : true;
        if (!added) {
            return false;
        }
    }
    return true;
}

static bool add_upper(murk_bricks *b, const unsigned char *node,
                      const int32_t first[3])
{
    for (int n = 0; n < 32 * 32 * 32; ++n) {
        int32_t at[3];
        nth_cell(first, n, 32, BLOCK, at);
        const murk_cell c = murk_upper_cell(node, at[0], at[1], at[2]);
        if (!(c.child ? add_lower(b, c.child, at)
                      : add_large_tile(b, 0, at, c.value))) {
            return false;
        }
    }
    return true;
}

static bool add_tree(murk_bricks *b, const murk_tree *tree)
{
    for (size_t i = 0; i < tree->n_cells; ++i) {
        const murk_root_cell *c = &tree->cells[i];
        if (!(c->node ? add_upper(b, c->node, c->first)
                      : add_large_tile(b, 1, c->first, c->value))) {
            return false;
        }
    }
    return true;
}

murk_status murk_bricks_create(murk_bricks **out, const murk_tree *tree,
                               int32_t edge, int below, int above,
                               const char *where, murk_error *err)
{
    assert(edge >= MURK_BRICK_EDGE_MIN && edge <= MURK_BRICK_EDGE_MAX);
    assert((edge & (edge - 1)) == 0);
    assert(below >= 0 && below <= 1 && above >= 0 && above <= 1);
    murk_bricks *b = calloc(1, sizeof *b);
    if (b) {
        b->below = below;
        b->above = above;
        while (1 << b->edge_shift < edge) {
            ++b->edge_shift;
        }
    }
    if (!b || !grow(b) || !add_tree(b, tree)) {
        murk_bricks_destroy(b);
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for the bounds of a grid's bricks");
    }
    *out = b;
    return MURK_OK;
}

void murk_bricks_destroy(murk_bricks *bricks)
{
    if (bricks) {
        free(bricks->slot);
        free(bricks->bound);
        free(bricks);
    }
}

/* ---- looking ---- */

/* What bounds the values around a voxel: a table of bricks (their bounds at
 * least `bound`), or (NULL) one bound in a cell of 1 << shift. */
typedef struct sight {
    const float *table;
    float bound;
    int shift;
} sight;

static sight look(const murk_bricks *b, const int32_t voxel[3])
{
    float bound = 0;
    for (int l = LEVELS - 1;; --l) {
        const cell *c = slot_of(b, l, voxel);
        if (c->is_taken) {
            raise(&bound, c->bound);
            if (c->table != NO_TABLE) {
                return (sight){b->bound + c->table * table_size(b), bound,
                               b->edge_shift};
            }
        }
        if (!c->is_parent) {
            return (sight){NULL, bound, SHIFT[l]};
        }
    }
}

float murk_bricks_bound(const murk_bricks *bricks, const int32_t voxel[3])
{
    sight s = look(bricks, voxel);
    if (s.table) {
        raise(&s.bound, s.table[brick_in_block(bricks->edge_shift, voxel)]);
    }
    return s.bound;
}

murk_bricks_facts murk_bricks_describe(const murk_bricks *bricks)
{
    const murk_bricks *b = bricks;
    murk_bricks_facts facts = {
        .memory_bytes = sizeof *b + b->n_slots * sizeof *b->slot +
                        b->tables_room * table_size(b) * sizeof *b->bound};
    const size_t n = b->n_tables * table_size(b);
    const double brick = ldexp(1, 3 * b->edge_shift);
    for (size_t i = 0; i < n; ++i) {
        facts.volume += b->bound[i] > 0 ? brick : 0;
        facts.sum += (double)b->bound[i] * brick;
    }
    for (size_t i = 0; i < b->n_slots; ++i) {
        const cell *c = &b->slot[i];
        if (c->bound > 0) {
            const double volume = ldexp(1, 3 * SHIFT[c->level]);
            facts.volume += volume;
            facts.sum += (double)c->bound * volume;
        }
    }
    return facts;
}

/* ---- walking ---- */

/* One instruction each, where fmin() and fmax() are calls. */
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline int32_t voxel_at(double place, int32_t first, int32_t last)
{
    return !(place > first) ? first
           : place >= last  ? last
                            : (int32_t)floor(place);
}

/* The segment across a cell, as in march.c: the ray leaves through the face
 * that it meets first, and along the other axes it is held inside the cell, so
 * that rounding can neither skip a cell nor stall. */
static inline void cross(murk_brick_walk *w, int shift)
{
    double leave[3];
    int32_t first[3], last[3];
    for (int axis = 0; axis < 3; ++axis) {
        first[axis] = w->at[axis] & ~((1 << shift) - 1);
        last[axis] = first[axis] + (1 << shift) - 1;
        const double face = (double)first[axis] +
                            (w->inverse[axis] > 0 ? (double)(1 << shift) : 0);
        leave[axis] = w->inverse[axis] == 0
                          ? INFINITY
                          : (face - w->origin[axis]) * w->inverse[axis];
    }
    const double least = smaller(smaller(leave[0], leave[1]), leave[2]);
    for (int axis = 0; axis < 3; ++axis) {
        const double place = w->origin[axis] + least * w->direction[axis];
        w->at[axis] = leave[axis] > least || w->inverse[axis] == 0
                          ? voxel_at(place, first[axis], last[axis])
                      : w->inverse[axis] > 0 ? last[axis] + 1
                                             : first[axis] - 1;
    }
    w->to = smaller(larger(least, w->from), w->end);
}

static inline bool is_in_block(const murk_brick_walk *w)
{
    return (((w->block_first[0] ^ w->at[0]) | (w->block_first[1] ^ w->at[1]) |
             (w->block_first[2] ^ w->at[2])) &
            ~(BLOCK - 1)) == 0;
}

void murk_brick_walk_begin(murk_brick_walk *walk, const murk_bricks *bricks,
                           murk_vec3 origin, murk_vec3 direction, double t0,
                           double t1)
{
    murk_brick_walk *w = walk;
    const double o[3] = {origin.x, origin.y, origin.z};
    const double d[3] = {direction.x, direction.y, direction.z};
    w->bricks = bricks;
    w->end = smaller(t1, DBL_MAX); /* so that 0 * length is 0 */
    w->from = w->to = t0;
    w->block = NULL;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / d[axis];
        w->origin[axis] = o[axis];
        w->direction[axis] = d[axis];
        w->inverse[axis] = isfinite(inverse) ? inverse : 0;
        w->at[axis] = voxel_at(o[axis] + t0 * d[axis], -MURK_INDEX_MAX - 2,
                               MURK_INDEX_MAX + 2);
    }
}

bool murk_brick_walk_next(murk_brick_walk *walk)
{
    murk_brick_walk *w = walk;
    const murk_bricks *b = w->bricks;
    w->from = w->to;
    if (!(w->from < w->end)) {
        return false;
    }
    if (!w->block || !is_in_block(w)) {
        const sight s = look(b, w->at);
        w->block = s.table;
        w->block_least = s.bound;
        for (int axis = 0; axis < 3; ++axis) {
            w->block_first[axis] = w->at[axis] & ~(BLOCK - 1);
        }
        if (!s.table) {
            w->bound = (double)s.bound;
            cross(w, s.shift);
            return true;
        }
    }
    float bound = w->block[brick_in_block(b->edge_shift, w->at)];
    raise(&bound, w->block_least);
    w->bound = (double)bound;
    cross(w, b->edge_shift);
    return true;
}
