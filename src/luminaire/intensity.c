/* Luminous intensity over directions, bilinear in the angles of a table.
 *
 * The three goniometer types are one case: a polar angle theta from some axis
 * of the lamp and an azimuth phi about this axis, with the solid angle
 * sin(theta) dtheta dphi. Type C: theta = gamma from -z, phi = C. Type A: theta
 * = V + 90 degrees from -x, phi = H. Type B: theta = H + 90 degrees from y, phi
 * = V. Rows of the table are values of theta, columns are values of phi.
 *
 * Integrals are in closed form. Over phi a row is piecewise linear, so its
 * integral is a sum of trapezoids, which is linear in theta between two rows.
 * Over theta a linear function times the sine is integrated by parts. A
 * direction is drawn in two steps, each an inversion of a cumulative
 * distribution: theta from the marginal one, whose inverse between two rows is
 * found by Newton's method within a bracket that shrinks, then phi from the
 * conditional one, by the root of a quadratic. */
#include "luminaire/intensity.h"

#include <assert.h>
#include <math.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/file.h"

#define RAD       (MURK_PI / 180) /* radians in a degree */
#define RIGHT_DEG 90.0            /* a right angle */
#define TURN      (2 * MURK_PI)   /* a full turn */

/* Directions beyond the table by rounding alone count as the edge of the
 * table. */
#define EDGE_RAD 1e-12

/* Bound on the steps of the inversion. Every second step at least halves the
 * bracket, so 128 steps exhaust the digits of a double. */
#define STEPS_MAX 128

/* Newton's method squares the error: after a step of this share of the width of
 * a row the error is rounding. */
#define STEP_MIN 1e-8

struct murk_intensity {
    murk_goniometer type;
    size_t rows, columns;
    double *row_deg, *column_deg; /* [rows], [columns] angles of the file */
    double *theta, *phi;          /* [rows], [columns] radians, rising */
    double *candela;              /* [rows * columns] */
    double *up_to; /* [rows * columns] integral of a row over phi from the
                    * first column [cd rad]; the last is that of the row */
    double *end;   /* [rows] integral from the first row [lm]; end[0] is 0 */
    double max;
    murk_vec3 pole, zero, right; /* theta = 0; phi = 0 and 90 degrees at the
                                  * equator */
    atomic_uint further_owners;
};

/* ---- creation ---- */

static void set_axes(murk_intensity *t)
{
    const murk_vec3 x = {1, 0, 0}, y = {0, 1, 0}, down = {0, 0, -1};
    switch (t->type) {
    case MURK_GONIOMETER_C:
        t->pole = down;
        t->zero = x;
        t->right = y;
        break;
    case MURK_GONIOMETER_A:
        t->pole = murk_scale(-1, x);
        t->zero = down;
        t->right = murk_scale(-1, y);
        break;
    case MURK_GONIOMETER_B:
        t->pole = y;
        t->zero = down;
        t->right = x;
        break;
    }
}

/* The polar angle and the azimuth [rad] of angles of the file. */
static double theta_of(murk_goniometer type, double vertical_deg,
                       double horizontal_deg)
{
    return type == MURK_GONIOMETER_C   ? vertical_deg * RAD
           : type == MURK_GONIOMETER_A ? (vertical_deg + RIGHT_DEG) * RAD
                                       : (horizontal_deg + RIGHT_DEG) * RAD;
}

static double phi_of(murk_goniometer type, double vertical_deg,
                     double horizontal_deg)
{
    return (type == MURK_GONIOMETER_B ? vertical_deg : horizontal_deg) * RAD;
}

/* Copies angles and values; for type B rows are horizontal angles. */
static void fill(murk_intensity *t, const murk_intensity_grid *grid)
{
    /* Angles, then values. */
    const bool by_h = grid->type == MURK_GONIOMETER_B;
    for (size_t r = 0; r < t->rows; ++r) {
        const double deg =
            by_h ? grid->horizontal_deg[r] : grid->vertical_deg[r];
        t->row_deg[r] = deg;
        t->theta[r] = theta_of(grid->type, deg, deg);
    }
    for (size_t c = 0; c < t->columns; ++c) {
        const double deg =
            by_h ? grid->vertical_deg[c] : grid->horizontal_deg[c];
        t->column_deg[c] = deg;
        t->phi[c] = phi_of(grid->type, deg, deg);
    }
    for (size_t r = 0; r < t->rows; ++r) {
        for (size_t c = 0; c < t->columns; ++c) {
            const size_t h = by_h ? r : c, v = by_h ? c : r;
            const double value =
                grid->scale *
                grid->candela[grid->plane[h] * grid->verticals + v];
            t->candela[r * t->columns + c] = value;
            t->max = fmax(t->max, value);
        }
    }
}

/* The integral of (from + slope t) sin(begin + t) over t in 0..width. The first
 * term is that of the value at the beginning, the second one the rest of the
 * integral by parts. */
static double sine_integral(double begin, double width, double from,
                            double slope)
{
    const double half = sin(width / 2), middle = begin + width / 2;
    return from * 2 * sin(middle) * half +
           slope * (2 * cos(middle) * half - width * cos(begin + width));
}

/* The integral of row r over phi [cd rad]. */
static double row_sum(const murk_intensity *t, size_t r)
{
    return t->up_to[r * t->columns + t->columns - 1];
}

static void integrate(murk_intensity *t)
{
    for (size_t r = 0; r < t->rows; ++r) {
        double *sum = t->up_to + r * t->columns;
        const double *cd = t->candela + r * t->columns;
        sum[0] = 0;
        for (size_t c = 1; c < t->columns; ++c) {
            sum[c] = sum[c - 1] +
                     (t->phi[c] - t->phi[c - 1]) * (cd[c - 1] + cd[c]) / 2;
        }
    }
    t->end[0] = 0;
    for (size_t r = 1; r < t->rows; ++r) {
        const double width = t->theta[r] - t->theta[r - 1];
        const double from = row_sum(t, r - 1), to = row_sum(t, r);
        t->end[r] =
            t->end[r - 1] + fmax(0, sine_integral(t->theta[r - 1], width, from,
                                                  (to - from) / width));
    }
}

murk_status murk_intensity_create(murk_intensity **out,
                                  const murk_intensity_grid *grid,
                                  const char *where, murk_error *err)
{
    assert(grid->verticals >= 2 && grid->horizontals >= 2 && grid->scale > 0);
    const bool by_h = grid->type == MURK_GONIOMETER_B;
    const size_t rows = by_h ? grid->horizontals : grid->verticals;
    const size_t columns = by_h ? grid->verticals : grid->horizontals;
    /* Memory for rows and columns. */
    murk_intensity *t = calloc(1, sizeof *t);
    if (t) {
        t->type = grid->type;
        t->rows = rows;
        t->columns = columns;
        t->row_deg = calloc(rows, sizeof *t->row_deg);
        t->column_deg = calloc(columns, sizeof *t->column_deg);
        t->theta = calloc(rows, sizeof *t->theta);
        t->phi = calloc(columns, sizeof *t->phi);
        t->candela = calloc(rows * columns, sizeof *t->candela);
        t->up_to = calloc(rows * columns, sizeof *t->up_to);
        t->end = calloc(rows, sizeof *t->end);
        atomic_init(&t->further_owners, 0);
    }
    if (!t || !t->row_deg || !t->column_deg || !t->theta || !t->phi ||
        !t->candela || !t->up_to || !t->end) {
        murk_intensity_destroy(t);
        return murk_no_memory(err, where, "for a table of %zu intensities",
                              rows * columns);
    }
    /* Values and integrals. */
    set_axes(t);
    fill(t, grid);
    integrate(t);
    const double lumens = murk_intensity_lumens(t);
    if (!(lumens > 0 && isfinite(lumens))) {
        murk_intensity_destroy(t);
        return murk_fail(err, MURK_BAD_FILE, where,
                         "the intensities add up to %g lm, must be above 0 lm "
                         "and finite",
                         lumens);
    }
    *out = t;
    return MURK_OK;
}

murk_intensity *murk_intensity_share(const murk_intensity *table)
{
    murk_intensity *shared = (murk_intensity *)(uintptr_t)table;
    if (shared) {
        atomic_fetch_add(&shared->further_owners, 1);
    }
    return shared;
}

void murk_intensity_destroy(murk_intensity *table)
{
    if (table && atomic_fetch_sub(&table->further_owners, 1) == 0) {
        free(table->row_deg);
        free(table->column_deg);
        free(table->theta);
        free(table->phi);
        free(table->candela);
        free(table->up_to);
        free(table->end);
        free(table);
    }
}

void murk_intensity_checksum(const murk_intensity *table, uint64_t out[2])
{
    uint64_t part[4][2] = {{(uint64_t)table->type}};
    const size_t size = sizeof(double);
    murk_checksum(table->theta, table->rows * size, part[1]);
    murk_checksum(table->phi, table->columns * size, part[2]);
    murk_checksum(table->candela, table->rows * table->columns * size, part[3]);
    murk_checksum(part, sizeof part, out);
}

double murk_intensity_lumens(const murk_intensity *table)
{
    return table->end[table->rows - 1];
}

double murk_intensity_max_candela(const murk_intensity *table)
{
    return table->max;
}

/* ---- lookup ---- */

/* The index i of the interval node[i] <= at < node[i + 1] of n rising nodes,
 * the last interval for `at` at or beyond the end. */
static size_t find(const double *node, size_t n, double at)
{
    size_t low = 0, high = n - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (node[middle] <= at) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* a at t = 0 and b at t = 1, both exactly. */
static double mix(double a, double b, double t)
{
    return (1 - t) * a + t * b;
}

/* Moves an angle beyond the nodes by rounding to the edge. Returns false if the
 * angle is farther beyond. */
static bool to_edge(const double *node, size_t n, double *at)
{
    if (!(*at >= node[0] - EDGE_RAD && *at <= node[n - 1] + EDGE_RAD)) {
        return false;
    }
    *at = fmin(fmax(*at, node[0]), node[n - 1]);
    return true;
}

static double candela_at(const murk_intensity *t, double theta, double phi)
{
    if (!to_edge(t->theta, t->rows, &theta)) {
        return 0;
    }
    /* Type C: the azimuth is periodic. */
    if (t->type == MURK_GONIOMETER_C) {
        const double beyond = phi - t->phi[0];
        const double turn = t->phi[t->columns - 1] - t->phi[0];
        phi -= beyond < 0 || beyond > turn ? TURN * floor(beyond / TURN) : 0;
    }
    if (!to_edge(t->phi, t->columns, &phi)) {
        return 0;
    }
    const size_t r = find(t->theta, t->rows, theta);
    const size_t c = find(t->phi, t->columns, phi);
    const double s = (theta - t->theta[r]) / (t->theta[r + 1] - t->theta[r]);
    const double q = (phi - t->phi[c]) / (t->phi[c + 1] - t->phi[c]);
    const double *cd = t->candela + r * t->columns + c;
    return mix(mix(cd[0], cd[1], q), mix(cd[t->columns], cd[t->columns + 1], q),
               s);
}

murk_intensity_angles murk_intensity_angles_of(const murk_intensity *table)
{
    const bool by_h = table->type == MURK_GONIOMETER_B;
    return (murk_intensity_angles){
        .verticals = by_h ? table->columns : table->rows,
        .horizontals = by_h ? table->rows : table->columns,
        .vertical_deg = by_h ? table->column_deg : table->row_deg,
        .horizontal_deg = by_h ? table->row_deg : table->column_deg};
}

double murk_intensity_at_angles(const murk_intensity *table,
                                double vertical_deg, double horizontal_deg)
{
    return candela_at(table,
                      theta_of(table->type, vertical_deg, horizontal_deg),
                      phi_of(table->type, vertical_deg, horizontal_deg));
}

double murk_intensity_candela(const murk_intensity *table, murk_vec3 direction)
{
    const double up = murk_dot(direction, table->pole);
    const double x = murk_dot(direction, table->zero);
    const double y = murk_dot(direction, table->right);
    return candela_at(table, atan2(hypot(x, y), up), atan2(y, x));
}

/* ---- sampling ---- */

/* Solves the integral of a function that is a at 0 and b at `width`, linear
 * between, from 0 to x for x, in the form that does not cancel. */
static double linear_inverse(double a, double b, double width, double integral)
{
    const double root = sqrt(fmax(0, a * a + 2 * (b - a) / width * integral));
    return a + root > 0 ? fmin(2 * integral / (a + root), width) : 0;
}

/* The row whose flux holds `wanted` lumens, counted from the first row. */
static size_t find_row(const murk_intensity *t, double wanted)
{
    size_t r = find(t->end, t->rows, wanted);
    while (r > 0 && !(t->end[r + 1] > t->end[r])) {
        --r; /* rounding has led into a dark row at the end */
    }
    return r;
}

/* The polar angle up to which the flux of the table is u times the whole; sets
 * the row before it. */
static double draw_theta(const murk_intensity *t, double u, size_t *row)
{
    const double wanted = u * murk_intensity_lumens(t);
    const size_t r = *row = find_row(t, wanted);
    const double begin = t->theta[r], width = t->theta[r + 1] - begin;
    const double from = row_sum(t, r), to = row_sum(t, r + 1);
    const double slope = (to - from) / width;
    const double rest = wanted - t->end[r], whole = t->end[r + 1] - t->end[r];
    /* Begin as if the density were linear over the row. */
    const double first = from * sin(begin), last = to * sin(begin + width);
    double at = linear_inverse(first, last, width,
                               rest / whole * width * (first + last) / 2);
    /* Newton's method, or bisection where a step leaves the bracket or has not
     * halved it. */
    double low = 0, high = width;
    for (int i = 0; i < STEPS_MAX && low < high; ++i) {
        at = at > low && at < high ? at : low + (high - low) / 2;
        const double error = sine_integral(begin, at, from, slope) - rest;
        const double before = high - low;
        if (error > 0) {
            high = at;
        } else {
            low = at;
        }
        /* Not a number where the density is 0: then bisection. */
        const double step = error / ((from + slope * at) * sin(begin + at));
        if (fabs(step) <= width * STEP_MIN) {
            at -= step;
            break;
        }
        at = i % 2 && i > 4 && high - low > before / 2 ? low + (high - low) / 2
                                                       : at - step;
    }
    return begin + fmin(fmax(at, 0), width);
}

/* The azimuth up to which the integral over phi at that polar angle is u times
 * the whole. Between two rows values and integrals are linear in theta. */
static double draw_phi(const murk_intensity *t, size_t r, double theta,
                       double u)
{
    const double s = (theta - t->theta[r]) / (t->theta[r + 1] - t->theta[r]);
    const double *sum = t->up_to + r * t->columns, *next = sum + t->columns;
    const size_t last = t->columns - 1;
    const double wanted = u * mix(sum[last], next[last], s);
    /* The interval that holds the wanted integral. */
    size_t low = 0, high = last;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (mix(sum[middle], next[middle], s) <= wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    const double *cd = t->candela + r * t->columns + low;
    const double rest = fmax(0, wanted - mix(sum[low], next[low], s));
    return t->phi[low] + linear_inverse(mix(cd[0], cd[t->columns], s),
                                        mix(cd[1], cd[t->columns + 1], s),
                                        t->phi[low + 1] - t->phi[low], rest);
}

murk_vec3 murk_intensity_draw(const murk_intensity *table, double u_polar,
                              double u_azimuth)
{
    size_t row;
    const double theta = draw_theta(table, u_polar, &row);
    const double phi = draw_phi(table, row, theta, u_azimuth);
    murk_vec3 d = murk_scale(cos(theta), table->pole);
    d = murk_along(d, sin(theta) * cos(phi), table->zero);
    return murk_unit(murk_along(d, sin(theta) * sin(phi), table->right));
}

bool murk_intensity_points_to_zero(const murk_intensity *table)
{
    /* In types A and B the rear half is dark. The median of gamma tells the
     * rest. */
    size_t row;
    return table->type != MURK_GONIOMETER_C ||
           draw_theta(table, 0.5, &row) <= RIGHT_DEG * RAD;
}
