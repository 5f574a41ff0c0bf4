/* Fields on rectilinear grids: three blocks of stretched cells, two of them
 * with a face in common and one at a distance, values at nodes or cells. The
 * reference for integrals finds all crossings with edges by sorting, and sums
 * each piece by a rule of Gauss, which is exact for cubics; the value at a
 * point comes from a search of its own. Deterministic. */
#include "base/rng.h"
#include "check.h"
#include "medium/clip.h"
#include "medium/grid_internal.h"
#include "medium/media.h"
#include "medium/rectilinear.h"

#include <stdlib.h>

#define BLOCKS     3
#define CELLS_MAX  7
#define NODES_MAX  512
#define PIECES_MAX 64
#define RAYS       400

static const double LOW[BLOCKS][3] = {{-3, -2, 0}, {1, -2, 0}, {1, 2.5, 1}};
static const double HIGH[BLOCKS][3] = {{1, 2, 3}, {4, 2, 3}, {4, 4, 3}};
static const size_t CELLS[BLOCKS][3] = {{5, 4, 7}, {3, 6, 2}, {4, 1, 3}};

static const murk_box DOMAIN = {{-9, -9, -9}, {9, 9, 9}};

typedef struct plain_block {
    double edge[3][CELLS_MAX + 1];
    float value[NODES_MAX];
    bool has_nodes;
} plain_block;

static plain_block blocks[BLOCKS];

static double draw(uint32_t seed, uint32_t i, uint32_t k)
{
    return murk_random(seed, MURK_TEST, i, k, 0).u[0];
}

/* Makes the blocks: edges at uneven distances, a third of the values 0. */
static void make_blocks(bool has_nodes, uint32_t seed)
{
    for (uint32_t b = 0; b < BLOCKS; ++b) {
        plain_block *block = &blocks[b];
        block->has_nodes = has_nodes;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const size_t n = CELLS[b][axis];
            const double power = 1 + 2 * draw(seed, b, axis);
            for (size_t i = 0; i <= n; ++i) {
                block->edge[axis][i] =
                    LOW[b][axis] + (HIGH[b][axis] - LOW[b][axis]) *
                                       pow((double)i / (double)n, power);
            }
        }
        for (uint32_t i = 0; i < NODES_MAX; ++i) {
            const double u = draw(seed, i, 10 + b);
            block->value[i] = u < 0.33 ? 0 : (float)u;
        }
    }
}

/* Packs the first n blocks; returns the number of bytes. */
static size_t pack(unsigned char *out, size_t n)
{
    unsigned char *to = out + sizeof(murk_field_head);
    const uint64_t count = n;
    memset(out, 0, sizeof(murk_field_head));
    memcpy(to, &count, sizeof count);
    to += sizeof count;
    /* Sizes, edges and values, each of all blocks. */
    for (size_t b = 0; b < n; ++b) {
        const murk_field_size size = {
            .cells = {CELLS[b][0], CELLS[b][1], CELLS[b][2]},
            .has_nodes = blocks[b].has_nodes};
        memcpy(to, &size, sizeof size);
        to += sizeof size;
    }
    for (size_t b = 0; b < n; ++b) {
        for (int axis = 0; axis < 3; ++axis) {
            const size_t bytes = (CELLS[b][axis] + 1) * sizeof(double);
            memcpy(to, blocks[b].edge[axis], bytes);
            to += bytes;
        }
    }
    for (size_t b = 0; b < n; ++b) {
        const murk_field_size size = {
            .cells = {CELLS[b][0], CELLS[b][1], CELLS[b][2]},
            .has_nodes = blocks[b].has_nodes};
        const size_t bytes =
            murk_field_values(&size) * sizeof blocks[b].value[0];
        memcpy(to, blocks[b].value, bytes);
        to += bytes;
    }
    return (size_t)(to - out);
}

/* The value at a point, found by a search through all cells. */
static double plain_value(const double p[3])
{
    for (size_t b = 0; b < BLOCKS; ++b) {
        size_t cell[3];
        double share[3];
        bool holds = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double *edge = blocks[b].edge[axis];
            holds = holds && p[axis] >= LOW[b][axis] && p[axis] < HIGH[b][axis];
            cell[axis] = 0;
            while (cell[axis] + 1 < CELLS[b][axis] &&
                   p[axis] >= edge[cell[axis] + 1]) {
                ++cell[axis];
            }
            share[axis] = (p[axis] - edge[cell[axis]]) /
                          (edge[cell[axis] + 1] - edge[cell[axis]]);
        }
        if (!holds) {
            continue;
        }
        /* The sum over corners, each weighted by the opposite part. */
        const size_t more = blocks[b].has_nodes ? 1 : 0;
        double sum = 0;
        for (size_t corner = 0; corner < (more ? 8u : 1u); ++corner) {
            double weight = 1;
            size_t at[3];
            for (int axis = 0; axis < 3; ++axis) {
                const size_t up = corner >> axis & 1;
                at[axis] = cell[axis] + up;
                weight *= !more ? 1 : up ? share[axis] : 1 - share[axis];
            }
            sum +=
                weight *
                (double)blocks[b].value[(at[2] * (CELLS[b][1] + more) + at[1]) *
                                            (CELLS[b][0] + more) +
                                        at[0]];
        }
        return sum;
    }
    return 0;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The integral from `from` to `to`. */
static double plain_integral(const double from[3], const double to[3])
{
    double cut[2 + BLOCKS * 3 * (CELLS_MAX + 1)] = {0, 1};
    size_t n = 2;
    double length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = to[axis] - from[axis];
        length += d * d;
        for (size_t b = 0; b < BLOCKS; ++b) {
            for (size_t i = 0; i <= CELLS[b][axis]; ++i) {
                const double t = (blocks[b].edge[axis][i] - from[axis]) / d;
                if (t > 0 && t < 1) {
                    cut[n++] = t;
                }
            }
        }
    }
    /* Two points of Gauss in each piece. */
    qsort(cut, n, sizeof *cut, by_size);
    double sum = 0;
    for (size_t i = 0; i + 1 < n; ++i) {
        const double half = (cut[i + 1] - cut[i]) / 2;
        for (int side = -1; side <= 1; side += 2) {
            const double t = cut[i] + half * (1 + side / sqrt(3));
            double p[3];
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = from[axis] + t * (to[axis] - from[axis]);
            }
            sum += half * plain_value(p);
        }
    }
    return sum * sqrt(length);
}

static murk_grid *make_grid(void)
{
    static _Alignas(8) unsigned char bytes[16 * NODES_MAX];
    murk_grid *grid = NULL;
    murk_error err = {0};
    const size_t size = pack(bytes, BLOCKS);
    CHECK(murk_grid_from_field(&grid, bytes, size, "test", &err) == MURK_OK);
    return grid;
}

static murk_media *make_media(const murk_grid *grid)
{
    const murk_medium medium = {.extinction_per_m = murk_spectrum_flat(1, 1),
                                .albedo = murk_spectrum_flat(0.5, 1),
                                .grid = grid};
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity()};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &DOMAIN, &err) ==
          MURK_OK);
    return media;
}

static murk_vec3 point_of(uint32_t seed, uint32_t i, double out[3])
{
    for (uint32_t axis = 0; axis < 3; ++axis) {
        out[axis] = -4 + 9 * draw(seed, i, 100 + axis);
    }
    return murk_vec(out[0], out[1], out[2]);
}

/* Optical depths, parts of them, collisions and values at points. */
static void test_rays(bool has_nodes, uint32_t seed)
{
    make_blocks(has_nodes, seed);
    murk_grid *grid = make_grid();
    murk_media *media = make_media(grid);
    size_t n_met = 0, n_collisions = 0;
    for (uint32_t i = 0; i < RAYS; ++i) {
        double a[3], b[3], middle[3];
        const murk_vec3 from = point_of(seed, 2 * i, a),
                        to = point_of(seed, 2 * i + 1, b);
        const murk_vec3 along = murk_sub(to, from);
        const double length = murk_length(along);
        const murk_vec3 direction = murk_scale(1 / length, along);
        const double depth =
            murk_media_optical_depth(media, 0, 0, from, direction, length);
        const double plain = plain_integral(a, b);
        CHECK_NEAR(depth, plain, 1e-12 * (1 + plain));
        n_met += plain > 0;
        /* A collision is where the depth to it is the one asked for. */
        murk_collision hit;
        const double tau = 0.4 * plain;
        if (tau > 0 && murk_media_fly(media, 0, 0, from, direction, length, tau,
                                      0.5, &hit)) {
            const double reached = murk_media_optical_depth(
                media, 0, 0, from, direction, hit.distance_m);
            CHECK_NEAR(reached, tau, 1e-12 * (1 + plain));
            ++n_collisions;
        }
        for (int axis = 0; axis < 3; ++axis) {
            middle[axis] = (a[axis] + b[axis]) / 2;
        }
        CHECK_NEAR(murk_media_extinction(
                       media, 0, 0, murk_vec(middle[0], middle[1], middle[2])),
                   plain_value(middle), 1e-14);
    }
    CHECK(n_met > RAYS / 2 && n_collisions > RAYS / 2);
    murk_media_destroy(media);
    murk_grid_destroy(grid);
}

/* Rays along faces and edges: a face in common counts once, and the upper faces
 * of the outermost cells do not count. */
static void test_faces(void)
{
    make_blocks(false, 5);
    murk_grid *grid = make_grid();
    murk_media *media = make_media(grid);
    const double y = blocks[0].edge[1][2];
    double on_face = 0;
    for (size_t k = 0; k < CELLS[1][2]; ++k) {
        const double p[3] = {
            1, -1.999, (blocks[1].edge[2][k] + blocks[1].edge[2][k + 1]) / 2};
        on_face +=
            plain_value(p) * (blocks[1].edge[2][k + 1] - blocks[1].edge[2][k]);
    }
    const murk_vec3 up = {0, 0, 1}, ahead = {1, 0, 0};
    CHECK_NEAR(
        murk_media_optical_depth(media, 0, 0, murk_vec(1, -1.999, -1), up, 8),
        on_face, 1e-12);
    CHECK(on_face > 0);
    CHECK_NEAR(
        murk_media_optical_depth(media, 0, 0, murk_vec(-8, 2, 1), ahead, 16), 0,
        0);
    /* Along an edge between cells the upper cells count. */
    double sum = 0;
    for (size_t i = 0; i < CELLS[0][0]; ++i) {
        const double p[3] = {
            (blocks[0].edge[0][i] + blocks[0].edge[0][i + 1]) / 2, y, 0.5};
        sum +=
            plain_value(p) * (blocks[0].edge[0][i + 1] - blocks[0].edge[0][i]);
    }
    CHECK_NEAR(
        murk_media_optical_depth(media, 0, 0, murk_vec(-8, y, 0.5), ahead, 9),
        sum, 1e-12);
    murk_media_destroy(media);
    murk_grid_destroy(grid);
}

/* Differences are listed where they are. */
static void test_changes(void)
{
    make_blocks(true, 7);
    murk_grid *before = make_grid();
    murk_box_list changed = {0};
    murk_rectilinear_changes(&changed, murk_grid_rectilinear(before),
                             murk_grid_rectilinear(before));
    CHECK(changed.n == 0 && !changed.are_all);
    blocks[2].value[0] += 1;
    murk_grid *after = make_grid();
    murk_rectilinear_changes(&changed, murk_grid_rectilinear(before),
                             murk_grid_rectilinear(after));
    CHECK(changed.n == 1 && !changed.are_all);
    CHECK(changed.box[0].min.x == LOW[2][0] && changed.box[0].min.y == 2.5);
    blocks[1].edge[0][1] += 1e-9;
    murk_grid *other = make_grid();
    murk_rectilinear_changes(&changed, murk_grid_rectilinear(before),
                             murk_grid_rectilinear(other));
    CHECK(changed.are_all);
    murk_grid_destroy(before);
    murk_grid_destroy(after);
    murk_grid_destroy(other);
}

/* Bytes that describe no field are refused. */
static void test_refused(void)
{
    static _Alignas(8) unsigned char bytes[16 * NODES_MAX];
    make_blocks(true, 9);
    const size_t size = pack(bytes, BLOCKS);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_from_field(&grid, bytes, size - 1, "", &err) ==
          MURK_BAD_FILE);
    CHECK(murk_grid_from_field(&grid, bytes, 7, "", &err) == MURK_BAD_FILE);
    blocks[0].value[3] = -1;
    CHECK(murk_grid_from_field(&grid, bytes, pack(bytes, BLOCKS), "", &err) ==
          MURK_BAD_FILE);
    blocks[0].value[3] = NAN;
    CHECK(murk_grid_from_field(&grid, bytes, pack(bytes, BLOCKS), "", &err) ==
          MURK_BAD_FILE);
    blocks[0].value[3] = 0;
    blocks[1].edge[0][0] -= 0.1; /* overlaps the first block */
    CHECK(murk_grid_from_field(&grid, bytes, pack(bytes, BLOCKS), "", &err) ==
          MURK_BAD_FILE);
    CHECK(grid == NULL);
}

/* ---- many blocks ---- */

/* Blocks of one cell each, in columns and layers with gaps between some, in an
 * order without a pattern. */
#define SIDE  7
#define MANY  (SIDE * SIDE * 3)
#define WALKS 3000

static murk_rectilinear many;
static unsigned char many_bytes[8 + MANY * (sizeof(murk_field_size) + 52)];

static void make_many(void)
{
    unsigned char *to = many_bytes;
    const uint64_t n = MANY;
    const murk_field_size size = {.cells = {1, 1, 1}};
    memcpy(to, &n, sizeof n);
    to += sizeof n;
    for (int b = 0; b < MANY; ++b, to += sizeof size) {
        memcpy(to, &size, sizeof size);
    }
    for (int b = 0; b < MANY; ++b) {
        const int place = b * 64 % MANY; /* no common divisor */
        const int at[3] = {place % SIDE, place / SIDE % SIDE,
                           place / SIDE / SIDE};
        for (int axis = 0; axis < 3; ++axis) {
            const double edge[2] = {at[axis], at[axis] + (place % 5 ? 1 : .75)};
            memcpy(to, edge, sizeof edge);
            to += sizeof edge;
        }
    }
    for (int b = 0; b < MANY; ++b, to += sizeof(float)) {
        const float value = (float)(1 + b);
        memcpy(to, &value, sizeof value);
    }
    murk_error err = {0};
    CHECK(murk_rectilinear_open(&many, many_bytes, (size_t)(to - many_bytes),
                                "many", &err) == MURK_OK);
}

/* The block that a walk enters next, by a scan of all blocks in their order. */
static size_t plain_next(const murk_rectilinear_walk *walk, double *at)
{
    const murk_vec3 o = {walk->origin[0], walk->origin[1], walk->origin[2]},
                    d = {walk->direction[0], walk->direction[1],
                         walk->direction[2]};
    size_t number = many.n;
    *at = INFINITY;
    for (size_t i = 0; i < many.n; ++i) {
        double t0 = -INFINITY, t1 = walk->end;
        murk_clip_box(&many.block[i].box, o, d, &t0, &t1);
        const bool is_later = walk->latest == many.n || t0 > walk->entered ||
                              (t0 == walk->entered && i > walk->latest);
        if (t0 < t1 && t1 > walk->from && is_later && t0 < *at) {
            number = i;
            *at = t0;
        }
    }
    return number;
}

/* Each block is entered as a scan of all blocks tells, with the same bits, also
 * by rays along edges and faces. */
static void test_many_blocks(void)
{
    make_many();
    size_t entered = 0, wrong = 0;
    for (uint32_t i = 0; i < WALKS; ++i) {
        murk_vec3 o = {SIDE * draw(31, i, 0), SIDE * draw(31, i, 1),
                       3 * draw(31, i, 2)};
        murk_vec3 d = {2 * draw(31, i, 3) - 1, 2 * draw(31, i, 4) - 1,
                       2 * draw(31, i, 5) - 1};
        if (i % 4 == 1) { /* from corners, along diagonals and axes */
            o = murk_vec(floor(o.x), floor(o.y), floor(o.z));
            d = murk_vec(d.x > 0 ? 1 : 0, d.y > 0 ? 1 : -1, i % 8 > 4 ? 1 : 0);
        }
        murk_rectilinear_walk walk;
        murk_rectilinear_begin(&walk, &many, o, murk_unit(d), 0, 20);
        for (size_t steps = 0; steps < 20 * MANY; ++steps) {
            murk_rectilinear_walk before = walk;
            before.from = before.to;
            if (!murk_rectilinear_next(&walk)) {
                break;
            }
            if (walk.latest != before.latest) {
                double at;
                const size_t number = plain_next(&before, &at);
                wrong += number != walk.latest ||
                         memcmp(&at, &walk.entered, sizeof at) != 0;
                entered += number < many.n;
            }
        }
        /* A point, and the first block that holds it. */
        double density = -1;
        const murk_vec3 p = murk_along(o, 2, d);
        size_t first = 0;
        while (first < many.n && !murk_box_holds(&many.block[first].box, p)) {
            ++first;
        }
        if (murk_rectilinear_density(&many, p, &density)) {
            wrong += density != (first < many.n ? (double)(first + 1) : 0);
        }
    }
    CHECK(entered > 3 * WALKS && wrong == 0);
    murk_rectilinear_close(&many);
}

int main(void)
{
    test_rays(true, 1);
    test_rays(false, 2);
    test_faces();
    test_changes();
    test_refused();
    test_many_blocks();
    return check_done();
}
