/* Meshes of heights: the error of every point of the grid, by a search for the
 * triangle that has it; no gaps; holes where heights are missing; and few
 * triangles where the ground is plain. Everything here is exact but for
 * rounding, so there is no false alarm. */
#include "base/rng.h"
#include "check.h"
#include "terrain/height_mesh.h"

#include <stdlib.h>

/* Rounding of the arithmetic of planes over heights of some 100 m. */
#define ROUNDING_M 1e-9

typedef double shape(size_t x, size_t y);

static double flat(size_t x, size_t y)
{
    (void)x, (void)y;
    return 12.5;
}

static double slope(size_t x, size_t y)
{
    return 0.25 * (double)x - 0.5 * (double)y;
}

static double spike(size_t x, size_t y)
{
    return x == 13 && y == 7 ? 5 : 0;
}

static double hills(size_t x, size_t y)
{
    const murk_random4 r = murk_random(3, MURK_TEST, x, (uint32_t)y, 0);
    return 20 * sin((double)x / 9) * cos((double)y / 7) + 0.2 * r.u[0];
}

/* Heights that a middle of edges does not see: a ridge one point wide that
 * passes between the middles of all large triangles. */
static double ridge(size_t x, size_t y)
{
    return x + 2 * y == 37 ? 3 : 0;
}

/* A lake without heights, and one point alone without. */
static double holes(size_t x, size_t y)
{
    const bool is_lake = hypot((double)x - 20, (double)y - 15) < 6;
    return is_lake || (x == 3 && y == 4) ? NAN : hills(x, y);
}

static double islands(size_t x, size_t y)
{
    return (x == 5 && y == 5) || (x > 10 && y > 6) ? hills(x, y) : NAN;
}

static double *make_heights(size_t columns, size_t rows, shape *of)
{
    double *h = malloc(columns * rows * sizeof *h);
    for (size_t i = 0; i < columns * rows; ++i) {
        h[i] = of(i % columns, i / columns);
    }
    return h;
}

static void place(const murk_height_grid *g, const murk_height_mesh *mesh,
                  size_t triangle, double x[3], double y[3], double z[3])
{
    for (size_t i = 0; i < 3; ++i) {
        const size_t at = mesh->at[mesh->corner[3 * triangle + i]];
        x[i] = (double)(at % g->columns);
        y[i] = (double)(at / g->columns);
        z[i] = (double)(float)g->height_m[at];
    }
}

static double twice_area(const double x[3], const double y[3])
{
    return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

/* The largest error of the points that a triangle has, by its three weights;
 * -1 where it has none. Each triangle is asked for each point. */
static double largest_error(const murk_height_grid *g,
                            const murk_height_mesh *mesh, size_t *without)
{
    double largest = 0;
    *without = 0;
    for (size_t at = 0; at < g->columns * g->rows; ++at) {
        const double px = (double)(at % g->columns),
                     py = (double)(at / g->columns);
        bool is_covered = false;
        for (size_t i = 0; i < mesh->triangles; ++i) {
            double x[3], y[3], z[3], sum = 0;
            place(g, mesh, i, x, y, z);
            /* Inside or on an edge: no weight is negative. */
            bool is_inside = true;
            for (int k = 0; k < 3; ++k) {
                const double ex[3] = {px, x[(k + 1) % 3], x[(k + 2) % 3]},
                             ey[3] = {py, y[(k + 1) % 3], y[(k + 2) % 3]};
                const double weight = twice_area(ex, ey) / twice_area(x, y);
                is_inside = is_inside && weight >= 0;
                sum += weight * z[k];
            }
            if (is_inside) {
                is_covered = true;
                CHECK(!isnan(g->height_m[at]));
                largest = fmax(largest, fabs(sum - g->height_m[at]));
            }
        }
        *without += !is_covered && !isnan(g->height_m[at]);
    }
    return largest;
}

/* True if an edge from a to b has triangles on one side alone and must not:
 * edges at the border of the grid and beside unknown heights may. */
static bool is_torn(const murk_height_grid *g, size_t a, size_t b)
{
    const long ax = (long)(a % g->columns), ay = (long)(a / g->columns),
               bx = (long)(b % g->columns), by = (long)(b / g->columns);
    const long last_x = (long)g->columns - 1, last_y = (long)g->rows - 1;
    if ((ax == bx && (ax == 0 || ax == last_x)) ||
        (ay == by && (ay == 0 || ay == last_y))) {
        return false;
    }
    /* Beside unknown heights edges are of the smallest size. */
    if (labs(ax - bx) > 1 || labs(ay - by) > 1) {
        return true;
    }
    for (long y = ay - 1; y <= ay + 1; ++y) {
        for (long x = ax - 1; x <= ax + 1; ++x) {
            if (x >= 0 && y >= 0 && x <= last_x && y <= last_y &&
                isnan(g->height_m[(size_t)y * g->columns + (size_t)x])) {
                return false;
            }
        }
    }
    return true;
}

static size_t torn_edges(const murk_height_grid *g,
                         const murk_height_mesh *mesh)
{
    size_t torn = 0;
    for (size_t i = 0; i < 3 * mesh->triangles; ++i) {
        const uint32_t a = mesh->corner[i],
                       b = mesh->corner[i - i % 3 + (i + 1) % 3];
        bool has_other = false;
        for (size_t k = 0; k < 3 * mesh->triangles && !has_other; ++k) {
            has_other = mesh->corner[k] == b &&
                        mesh->corner[k - k % 3 + (k + 1) % 3] == a;
        }
        torn += !has_other && is_torn(g, mesh->at[a], mesh->at[b]);
    }
    return torn;
}

/* Checks a mesh, and returns the number of its triangles. */
static size_t check_mesh(size_t columns, size_t rows, shape *of, double error_m)
{
    double *h = make_heights(columns, rows, of);
    const murk_height_grid g = {.columns = columns,
                                .rows = rows,
                                .height_m = h,
                                .error_m = error_m,
                                .triangles_max = SIZE_MAX,
                                .bend = {.shift_max_m = 1}};
    murk_height_mesh mesh;
    CHECK(murk_height_mesh_make(&mesh, &g));
    size_t without;
    const double largest = largest_error(&g, &mesh, &without);
    /* Single precision of heights below 128 m. */
    CHECK(largest <= fmax(error_m, 4e-6));
    CHECK_NEAR(mesh.error_m, largest, ROUNDING_M);
    CHECK(without == mesh.bare);
    CHECK(torn_edges(&g, &mesh) == 0);
    /* All triangles turn the same way and together have the area of the grid.
     */
    double area = 0, all = 0;
    for (size_t i = 0; i < mesh.triangles; ++i) {
        double x[3], y[3], z[3];
        place(&g, &mesh, i, x, y, z);
        CHECK(twice_area(x, y) > 0);
        area += twice_area(x, y) / 2;
    }
    /* Halves of the smallest squares, of which some have no triangle. */
    for (size_t y = 0; y + 1 < rows; ++y) {
        for (size_t x = 0; x + 1 < columns; ++x) {
            const size_t at = y * columns + x;
            const int known = !isnan(h[at]) + !isnan(h[at + 1]) +
                              !isnan(h[at + columns]) +
                              !isnan(h[at + columns + 1]);
            all += known == 4 ? 1 : 0;
        }
    }
    size_t known = 0;
    for (size_t i = 0; i < columns * rows; ++i) {
        known += isnan(h[i]) ? 0 : 1;
    }
    CHECK(mesh.known == known);
    if (known == columns * rows) {
        CHECK(area == all);
    } else {
        CHECK(area >= all);
    }
    const size_t triangles = mesh.triangles;
    murk_height_mesh_release(&mesh);
    free(h);
    return triangles;
}

static void test_shapes(void)
{
    static const size_t sizes[][2] = {{2, 2},   {3, 2},   {17, 17}, {33, 17},
                                      {40, 31}, {31, 40}, {34, 34}, {50, 5},
                                      {2, 19},  {18, 33}};
    static shape *const shapes[] = {flat,  slope, spike,  hills,
                                    ridge, holes, islands};
    static const double errors[] = {0, 0.3, 4};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        for (size_t k = 0; k < sizeof shapes / sizeof *shapes; ++k) {
            for (size_t e = 0; e < 3; ++e) {
                check_mesh(sizes[i][0], sizes[i][1], shapes[k], errors[e]);
            }
        }
    }
}

static void test_numbers(void)
{
    /* Plain ground: two triangles for each largest square. */
    CHECK(check_mesh(17, 17, flat, 0) == 2);
    CHECK(check_mesh(33, 17, slope, 0) == 4);
    /* Every height exactly: all squares in two. */
    CHECK(check_mesh(40, 31, hills, 0) == 2 * 39 * 30);
    /* One spike: fine around it, coarse elsewhere. */
    const size_t of_spike = check_mesh(33, 33, spike, 1);
    CHECK(of_spike > 20 && of_spike < 150);
    CHECK(check_mesh(33, 33, spike, 5) == 2);
    CHECK(check_mesh(65, 65, hills, 4) < check_mesh(65, 65, hills, 1));
}

/* Curved lines of the grid: the shift of points counts as an error by the slope
 * of the ground, and no triangle shifts them further than allowed. */
static void test_bend(void)
{
    double *h = make_heights(33, 33, slope);
    murk_height_grid g = {
        .columns = 33,
        .rows = 33,
        .height_m = h,
        .error_m = 0.1,
        .triangles_max = SIZE_MAX,
        .bend = {1e-3, 0, 2e-3, .per_m = 1, .shift_max_m = 9}};
    murk_height_mesh mesh;
    /* The whole square: 32 * 32 * 3e-3 / 6 = 0.512 m times a slope of 0.559. A
     * quarter of that is above 0.1 for no triangle half as long. */
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles > 2 && mesh.triangles <= 16);
    CHECK(mesh.error_m > 0.01 && mesh.error_m <= 0.1);
    murk_height_mesh_release(&mesh);
    g.error_m = 1;
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles == 2);
    CHECK_NEAR(mesh.error_m, 0.512 * hypot(0.25, 0.5), 1e-9);
    murk_height_mesh_release(&mesh);
    g.bend.shift_max_m = 0.2;
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles > 2);
    murk_height_mesh_release(&mesh);
    free(h);
}

/* A mesh of more triangles than allowed ends with the next one. */
static void test_triangles_max(void)
{
    double *h = make_heights(40, 31, hills);
    murk_height_grid g = {.columns = 40,
                          .rows = 31,
                          .height_m = h,
                          .triangles_max = 2 * 39 * 30,
                          .bend = {.shift_max_m = 1}};
    murk_height_mesh mesh;
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles == g.triangles_max);
    murk_height_mesh_release(&mesh);
    g.triangles_max -= 1;
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles == g.triangles_max + 1);
    murk_height_mesh_release(&mesh);
    g.triangles_max = 100;
    CHECK(murk_height_mesh_make(&mesh, &g));
    CHECK(mesh.triangles == 101);
    murk_height_mesh_release(&mesh);
    free(h);
}

int main(void)
{
    test_shapes();
    test_numbers();
    test_bend();
    test_triangles_max();
    return check_done();
}
