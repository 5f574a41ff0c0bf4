/* Makes a right-triangulated irregular network (terrain/height_mesh.h).
 *
 * The nodes of the hierarchy are the points of a lattice of squares, each of
 * 2^k by 2^k steps, that covers the grid. A node is the middle of the longest
 * edge of one or two triangles. It is used if one of them may not stay whole.
 * Nodes are visited from the smallest triangles to the largest, and a used node
 * makes its parents used, the nodes by which its triangles come into being; so
 * a triangle is whole exactly if the node of its longest edge is not used. */
#include "terrain/height_mesh.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#define NO_VERTEX UINT32_MAX

typedef struct node {
    size_t x, y; /* of the lattice */
} node;

typedef struct maker {
    const murk_height_grid *grid;
    size_t side;            /* of the largest squares, a power of two */
    size_t nx, ny;          /* points of the lattice */
    unsigned char *used;    /* [ny][nx] */
    uint32_t *vertex;       /* [rows][columns] of points; NO_VERTEX: none */
    unsigned char *covered; /* [rows][columns] in a triangle */
    murk_height_mesh *out;
    size_t vertex_capacity, triangle_capacity;
    bool has_memory;
} maker;

/* ---- one triangle ---- */

/* A triangle on the grid: lattice points beyond the border are on it. */
typedef struct triangle {
    long x[3], y[3];
    double height[3];                /* in single precision */
    bool is_known;                   /* all heights are */
    double slope_x, slope_y, bend_m; /* no meaning unless is_known and the
                                      * triangle has an area */
    long twice_area;
} triangle;

static double height_at(const maker *m, long x, long y)
{
    return m->grid->height_m[(size_t)y * m->grid->columns + (size_t)x];
}

/* Largest distance of the place of a point from where it would be if the
 * triangle were flat on the grid. */
static double shift_m(const maker *m, const triangle *t)
{
    const murk_height_bend *bend = &m->grid->bend;
    double c = 0, r = 0;
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        c = fmax(c, fabs((double)(t->x[k] - t->x[i])));
        r = fmax(r, fabs((double)(t->y[k] - t->y[i])));
    }
    return (bend->cc_m * c * c + 2 * bend->cr_m * c * r + bend->rr_m * r * r) /
           6;
}

static triangle triangle_of(const maker *m, node a, node b, node c)
{
    const node corner[3] = {a, b, c};
    const size_t last_x = m->grid->columns - 1, last_y = m->grid->rows - 1;
    triangle t = {.is_known = true};
    for (int i = 0; i < 3; ++i) {
        t.x[i] = (long)(corner[i].x < last_x ? corner[i].x : last_x);
        t.y[i] = (long)(corner[i].y < last_y ? corner[i].y : last_y);
        t.height[i] = (double)(float)height_at(m, t.x[i], t.y[i]);
        t.is_known = t.is_known && isfinite(t.height[i]);
    }
    const long ux = t.x[1] - t.x[0], uy = t.y[1] - t.y[0], vx = t.x[2] - t.x[0],
               vy = t.y[2] - t.y[0];
    t.twice_area = ux * vy - uy * vx;
    if (t.is_known && t.twice_area != 0) {
        /* The plane through the corners. */
        const double u = t.height[1] - t.height[0],
                     v = t.height[2] - t.height[0], area = (double)t.twice_area;
        t.slope_x = (u * (double)vy - v * (double)uy) / area;
        t.slope_y = (v * (double)ux - u * (double)vx) / area;
        t.bend_m =
            shift_m(m, &t) * m->grid->bend.per_m * hypot(t.slope_x, t.slope_y);
    }
    return t;
}

/* floor(a / b) for b > 0. */
static long floor_of(long a, long b)
{
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/* The columns [*first, *last] of a row that the triangle covers. */
static void span(const triangle *t, long y, long *first, long *last)
{
    *first = LONG_MAX;
    *last = LONG_MIN;
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        const int low = t->y[i] <= t->y[k] ? i : k, high = i + k - low;
        if (y < t->y[low] || y > t->y[high]) {
            continue;
        }
        /* Where the edge meets the row, rounded into the triangle; an edge
         * along the row counts by its ends, which other edges have, too. */
        const long rise = t->y[high] - t->y[low];
        const long run =
            rise > 0 ? (y - t->y[low]) * (t->x[high] - t->x[low]) : 0;
        const long unit = rise > 0 ? rise : 1;
        const long up = t->x[low] - floor_of(-run, unit),
                   down = t->x[low] + floor_of(run, unit);
        *first = up < *first ? up : *first;
        *last = down > *last ? down : *last;
    }
}

/* The rows of a triangle. */
static void rows_of(const triangle *t, long *first, long *last)
{
    *first = *last = t->y[0];
    for (int i = 1; i < 3; ++i) {
        *first = t->y[i] < *first ? t->y[i] : *first;
        *last = t->y[i] > *last ? t->y[i] : *last;
    }
}

/* The error of a point; NAN if the point has no height. */
static double error_at(const maker *m, const triangle *t, long x, long y)
{
    const double plane = t->height[0] + t->slope_x * (double)(x - t->x[0]) +
                         t->slope_y * (double)(y - t->y[0]);
    return fabs(plane - height_at(m, x, y));
}

/* True if a triangle may stay whole: either all of its points have heights that
 * are right within the error, or none has a height. */
static bool may_stay(const maker *m, node a, node b, node c)
{
    const triangle t = triangle_of(m, a, b, c);
    if (t.twice_area == 0) {
        return true;
    }
    if (t.is_known && shift_m(m, &t) > m->grid->bend.shift_max_m) {
        return false;
    }
    const double allowed = m->grid->error_m - (t.is_known ? t.bend_m : 0);
    long y, last_y;
    rows_of(&t, &y, &last_y);
    for (; y <= last_y; ++y) {
        long x, last_x;
        span(&t, y, &x, &last_x);
        for (; x <= last_x; ++x) {
            /* Written so that NAN fails. */
            if (t.is_known ? !(error_at(m, &t, x, y) <= allowed)
                           : !isnan(height_at(m, x, y))) {
                return false;
            }
        }
    }
    return true;
}

/* ---- which nodes are used ---- */

static bool is_used(const maker *m, size_t x, size_t y)
{
    return m->used[y * m->nx + x] != 0;
}

static void use(maker *m, size_t x, size_t y)
{
    m->used[y * m->nx + x] = 1;
}

/* Visits the middle of an edge of squares of the size `s`: the edge from `a` to
 * `b`, along x or y. The middles of the squares on both sides are the third
 * corners of its triangles and its parents. */
static void visit_edge(maker *m, node a, bool is_along_x, size_t s)
{
    const size_t h = s / 2;
    const node b = {a.x + (is_along_x ? s : 0), a.y + (is_along_x ? 0 : s)},
               middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    const size_t across = is_along_x ? a.y : a.x,
                 end = is_along_x ? m->ny - 1 : m->nx - 1;
    /* There is one side at the border of the lattice. */
    node side[2];
    int sides = 0;
    if (across >= h && across > 0) {
        side[sides++] =
            is_along_x ? (node){middle.x, a.y - h} : (node){a.x - h, middle.y};
    }
    if (across < end) {
        side[sides++] =
            is_along_x ? (node){middle.x, a.y + h} : (node){a.x + h, middle.y};
    }
    bool stays = !is_used(m, middle.x, middle.y);
    for (int i = 0; i < sides && stays; ++i) {
        stays = may_stay(m, a, b, side[i]);
    }
    if (!stays) {
        use(m, middle.x, middle.y);
        for (int i = 0; i < sides; ++i) {
            use(m, side[i].x, side[i].y);
        }
    }
}

/* The diagonal of a square passes through the middle of the square of twice the
 * size in which it lies. Ends of the diagonal, then the other corners. */
static void corners_of(node corner[4], node low, size_t s)
{
    const node high = {low.x + s, low.y + s};
    const bool rises = (low.x / s + low.y / s) % 2 == 0;
    corner[0] = rises ? low : (node){high.x, low.y};
    corner[1] = rises ? high : (node){low.x, high.y};
    corner[2] = rises ? (node){low.x, high.y} : low;
    corner[3] = rises ? (node){high.x, low.y} : high;
}

/* Visits the middle of a square. The other corners are its parents. */
static void visit_square(maker *m, node low, size_t s)
{
    node corner[4];
    corners_of(corner, low, s);
    const size_t x = low.x + s / 2, y = low.y + s / 2;
    const bool stays = !is_used(m, x, y) &&
                       may_stay(m, corner[0], corner[1], corner[2]) &&
                       may_stay(m, corner[1], corner[0], corner[3]);
    if (!stays) {
        use(m, x, y);
        for (int i = 2; i < 4 && s < m->side; ++i) {
            use(m, corner[i].x, corner[i].y);
        }
    }
}

/* From the smallest triangles to the largest. */
static void find_used(maker *m)
{
    for (size_t s = 2; s <= m->side; s *= 2) {
        for (size_t y = 0; y < m->ny; y += s) {
            for (size_t x = 0; x + 1 < m->nx; x += s) {
                visit_edge(m, (node){x, y}, true, s);
            }
        }
        for (size_t y = 0; y + 1 < m->ny; y += s) {
            for (size_t x = 0; x < m->nx; x += s) {
                visit_edge(m, (node){x, y}, false, s);
            }
        }
        for (size_t y = 0; y + 1 < m->ny; y += s) {
            for (size_t x = 0; x + 1 < m->nx; x += s) {
                visit_square(m, (node){x, y}, s);
            }
        }
    }
}

/* ---- the mesh ---- */

/* Makes space for one item more. */
static bool reserve(uint32_t **array, size_t width, size_t n, size_t *capacity)
{
    if (n < *capacity) {
        return true;
    }
    const size_t more = *capacity ? 2 * *capacity : 1024;
    uint32_t *grown = realloc(*array, more * width * sizeof *grown);
    if (grown) {
        *array = grown;
        *capacity = more;
    }
    return grown != NULL;
}

static uint32_t vertex_at(maker *m, long x, long y)
{
    murk_height_mesh *out = m->out;
    const size_t at = (size_t)y * m->grid->columns + (size_t)x;
    if (m->vertex[at] == NO_VERTEX) {
        m->has_memory = m->has_memory && reserve(&out->at, 1, out->vertices,
                                                 &m->vertex_capacity);
        if (m->has_memory) {
            out->at[out->vertices] = (uint32_t)at;
            m->vertex[at] = (uint32_t)out->vertices++;
        }
    }
    return m->vertex[at];
}

/* Measures the error of a triangle of the mesh, and marks its points. */
static void measure(maker *m, const triangle *t)
{
    long y, last_y;
    rows_of(t, &y, &last_y);
    for (; y <= last_y; ++y) {
        long x, last_x;
        span(t, y, &x, &last_x);
        for (; x <= last_x; ++x) {
            m->out->error_m =
                fmax(m->out->error_m, error_at(m, t, x, y) + t->bend_m);
            m->covered[(size_t)y * m->grid->columns + (size_t)x] = 1;
        }
    }
}

/* Adds a triangle whose corners have heights. */
static void add_triangle(maker *m, node a, node b, node c)
{
    triangle t = triangle_of(m, a, b, c);
    if (t.twice_area == 0 || !t.is_known) {
        return;
    }
    murk_height_mesh *out = m->out;
    m->has_memory = m->has_memory && reserve(&out->corner, 3, out->triangles,
                                             &m->triangle_capacity);
    uint32_t corner[3];
    for (int i = 0; i < 3; ++i) {
        corner[i] = vertex_at(m, t.x[i], t.y[i]);
    }
    if (!m->has_memory) {
        return;
    }
    for (int i = 0; i < 3; ++i) {
        out->corner[3 * out->triangles + (size_t)i] = corner[i];
    }
    ++out->triangles;
    /* The smallest triangles cover no points but their corners. */
    if (t.twice_area == 1 || t.twice_area == -1) {
        t.bend_m = 0;
    }
    measure(m, &t);
}

/* Adds a triangle with the longest edge from a to b, whole or in parts. The
 * depth is at most 2 log2(side) + 1. */
static void add(maker *m, node a, node b, node c)
{
    const node middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    const bool is_smallest = (a.x + b.x) % 2 == 1;
    if (m->out->triangles > m->grid->triangles_max) {
        return;
    }
    if (!is_smallest && is_used(m, middle.x, middle.y)) {
        add(m, c, a, middle);
        add(m, b, c, middle);
    } else {
        add_triangle(m, a, b, c);
    }
}

static void make(maker *m)
{
    find_used(m);
    for (size_t y = 0; y + 1 < m->ny; y += m->side) {
        for (size_t x = 0; x + 1 < m->nx; x += m->side) {
            node corner[4];
            corners_of(corner, (node){x, y}, m->side);
            add(m, corner[0], corner[1], corner[2]);
            add(m, corner[1], corner[0], corner[3]);
        }
    }
    const size_t n = m->grid->columns * m->grid->rows;
    for (size_t i = 0; i < n; ++i) {
        const bool is_known = !isnan(m->grid->height_m[i]);
        m->out->known += is_known;
        m->out->bare += is_known && !m->covered[i];
    }
}

bool murk_height_mesh_make(murk_height_mesh *out, const murk_height_grid *grid)
{
    const size_t steps_x = grid->columns - 1, steps_y = grid->rows - 1,
                 shorter = steps_x < steps_y ? steps_x : steps_y,
                 n = grid->columns * grid->rows;
    *out = (murk_height_mesh){0};
    /* Squares as large as the shorter side of the grid, or a little larger. */
    maker m = {.grid = grid, .side = 1, .out = out, .has_memory = true};
    while (m.side < shorter) {
        m.side *= 2;
    }
    m.nx = (steps_x + m.side - 1) / m.side * m.side + 1;
    m.ny = (steps_y + m.side - 1) / m.side * m.side + 1;
    m.used = calloc(m.nx * m.ny, 1);
    m.covered = calloc(n, 1);
    m.vertex = malloc(n * sizeof *m.vertex);
    m.has_memory = m.used && m.covered && m.vertex;
    if (m.has_memory) {
        for (size_t i = 0; i < n; ++i) {
            m.vertex[i] = NO_VERTEX;
        }
        make(&m);
    }
    free(m.used);
    free(m.covered);
    free(m.vertex);
    if (!m.has_memory) {
        murk_height_mesh_release(out);
    }
    return m.has_memory;
}

void murk_height_mesh_release(murk_height_mesh *mesh)
{
    free(mesh->at);
    free(mesh->corner);
    *mesh = (murk_height_mesh){0};
}
