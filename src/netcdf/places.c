/* Axes of longitude and latitude (netcdf/places.h).
 *
 * A grid of longitudes and latitudes is not rectilinear on a map: meridians
 * come closer to each other towards the poles, and parallels are bent. Over a
 * box of some kilometres the difference is small beside the cells of a model;
 * it is measured at the crossings of the grid lines. */
#include "netcdf/places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points on each side of the box, whose longitudes and latitudes bound it.
 * Between them a side is straight within 1/32^2 of its bend, which the line
 * added at each border covers. */
#define SIDE_POINTS 33

/* Lines of the other axis at which a grid line is looked at, the first and the
 * last among them: all if there are not more. Between lines a place is off by
 * at most 1/32^2 more, because its error grows with the square of the distance
 * from the middle. */
#define LOOKED_AT 33

/* ---- the part that is asked for ---- */

/* Turns longitudes by full turns so that they surround the site. An axis around
 * the whole earth begins at the point opposite to the site. */
static murk_status turn(const murk_netcdf_reader *r, murk_netcdf_axis *a)
{
    const double site = r->request->asked.frame.longitude_deg;
    const double span = a->at[a->n - 1] - a->at[0];
    const double step = a->n > 1 ? span / (double)(a->n - 1) : 360;
    if (!(span < 360 + step / 2)) {
        return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                         "has longitudes that span %g degrees, must be at most "
                         "360",
                         span);
    }
    /* The last longitude may repeat the first. */
    a->n -= fabs(span - 360) < step / 2 ? 1 : 0;
    a->cycle = a->n;
    size_t first = 0;
    double middle = a->at[0] + span / 2;
    if (a->n > 1 && span > 360 - 1.5 * step) {
        for (size_t i = 1; i < a->n; ++i) {
            if (remainder(a->at[i] - site, 360) <
                remainder(a->at[first] - site, 360)) {
                first = i;
            }
        }
        middle = a->at[first] + (360 - step) / 2;
    }
    /* In the new order, each by whole turns from the one before. */
    double *at = malloc(a->n * sizeof *at),
           *bound = a->bound ? malloc(2 * a->n * sizeof *bound) : NULL;
    if (!at || (a->bound && !bound)) {
        free(at);
        free(bound);
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    for (size_t i = 0; i < a->n; ++i) {
        const size_t from = (first + i) % a->n;
        const double by =
            360 * (nearbyint((site - middle) / 360) + (from < first ? 1 : 0));
        at[i] = a->at[from] + by;
        for (size_t k = 0; bound && k < 2; ++k) {
            bound[2 * i + k] = a->bound[2 * from + k] + by;
        }
    }
    free(a->at);
    free(a->bound);
    a->at = at;
    a->bound = bound;
    a->first = first;
    return MURK_OK;
}

/* The range of longitudes and latitudes of the box. */
static void box_in_degrees(const murk_netcdf_asked *asked, double low[2],
                           double high[2])
{
    const double *box = asked->within_m, site = asked->frame.longitude_deg;
    low[0] = low[1] = INFINITY;
    high[0] = high[1] = -INFINITY;
    for (int i = 0; i < 4 * SIDE_POINTS; ++i) {
        /* Points along the sides of the box. */
        const double u = (double)(i % SIDE_POINTS) / (SIDE_POINTS - 1);
        const int side = i / SIDE_POINTS;
        const double at[2] = {
            side < 2 ? box[0] + u * (box[2] - box[0]) : box[side == 2 ? 0 : 2],
            side < 2 ? box[side == 0 ? 1 : 3] : box[1] + u * (box[3] - box[1])};
        double place[2];
        murk_geographic_from_local(&asked->frame, at, &place[1], &place[0]);
        place[0] = site + remainder(place[0] - site, 360);
        for (int k = 0; k < 2; ++k) {
            low[k] = fmin(low[k], place[k]);
            high[k] = fmax(high[k], place[k]);
        }
    }
}

/* Half the distance to the neighbour of the first (or last) coordinate, as far
 * as the cell of that coordinate goes. */
static double half_step(const murk_netcdf_axis *a, bool at_end)
{
    if (a->n > 1) {
        const size_t i = at_end ? a->n - 1 : 1;
        return (a->at[i] - a->at[i - 1]) / 2;
    }
    return a->bound ? fabs(a->bound[1] - a->bound[0]) / 2 : 0;
}

/* Leaves the coordinates of a range, and one more on each side; false if the
 * range is beyond the cells of the axis. */
static bool cut_axis(murk_netcdf_axis *a, double low, double high)
{
    if (high < a->at[0] - half_step(a, false) ||
        low > a->at[a->n - 1] + half_step(a, true)) {
        return false;
    }
    /* The last coordinate up to the range, and the first one from its end. */
    size_t from = 0, to = a->n - 1;
    while (from + 1 < a->n && a->at[from + 1] <= low) {
        ++from;
    }
    while (to > 0 && a->at[to - 1] >= high) {
        --to;
    }
    from = from > 0 ? from - 1 : 0;
    to = to + 1 < a->n ? to + 1 : to;
    a->n = to - from + 1;
    memmove(a->at, a->at + from, a->n * sizeof *a->at);
    if (a->bound) {
        memmove(a->bound, a->bound + 2 * from, 2 * a->n * sizeof *a->bound);
    }
    a->first = (a->first + from) % a->cycle;
    return true;
}

/* Fails unless the request can place axes in degrees. */
static murk_status check_frame(const murk_netcdf_reader *r)
{
    const murk_netcdf_axis *x = &r->axis[MURK_NETCDF_X],
                           *y = &r->axis[MURK_NETCDF_Y];
    const murk_netcdf_asked *asked = &r->request->asked;
    if (!x->is_degrees || !y->is_degrees) {
        return murk_netcdf_bad(r, MURK_BAD_FILE,
                               "has one axis in degrees and one in metres",
                               NULL);
    }
    if (!(y->at[0] >= -90 && y->at[y->n - 1] <= 90)) {
        return murk_netcdf_bad(r, MURK_BAD_FILE,
                               "has latitudes beyond 90 degrees", NULL);
    }
    if (!asked->has_frame) {
        return murk_fail(
            r->err, MURK_BAD_VALUE, r->request->where,
            "has axes in degrees and needs site.latitude_deg and "
            "site.longitude_deg; the middle of the file is at latitude %.6g, "
            "longitude %.6g",
            (y->at[0] + y->at[y->n - 1]) / 2,
            remainder((x->at[0] + x->at[x->n - 1]) / 2, 360));
    }
    /* The region of the medium is turned after the field has been placed. */
    if (asked->frame.north[0] != 0 || !(asked->frame.north[1] > 0)) {
        return murk_netcdf_bad(r, MURK_BAD_VALUE,
                               "has axes in degrees and needs north: [0, 1, 0]",
                               NULL);
    }
    for (int i = 0; i < 4 && asked->has_within; ++i) {
        if (!(fabs(asked->within_m[i]) <= MURK_LOCAL_MAX_M)) {
            return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                             "within_m has %.9g m, must be within %g m of the "
                             "site",
                             asked->within_m[i], MURK_LOCAL_MAX_M);
        }
    }
    return MURK_OK;
}

murk_status murk_netcdf_cut(murk_netcdf_reader *r)
{
    murk_netcdf_axis *x = &r->axis[MURK_NETCDF_X], *y = &r->axis[MURK_NETCDF_Y];
    const murk_netcdf_asked *asked = &r->request->asked;
    const bool is_degrees = x->is_degrees || y->is_degrees;
    murk_status status = is_degrees ? check_frame(r) : MURK_OK;
    if (!status && is_degrees) {
        status = turn(r, x);
    }
    if (status || !asked->has_within) {
        return status;
    }
    const double *box = asked->within_m;
    double low[2] = {box[0], box[1]}, high[2] = {box[2], box[3]};
    if (is_degrees) {
        box_in_degrees(asked, low, high);
    }
    return cut_axis(x, low[0], high[0]) && cut_axis(y, low[1], high[1])
               ? MURK_OK
               : murk_netcdf_bad(r, MURK_BAD_VALUE,
                                 "has no values inside of within_m", NULL);
}

/* ---- places ---- */

/* The number of the i-th of the lines that are looked at, of n lines. */
static size_t looked_at(size_t i, size_t n)
{
    return n <= LOOKED_AT ? i : i * (n - 1) / (LOOKED_AT - 1);
}

static size_t looks(size_t n)
{
    return n < LOOKED_AT ? n : LOOKED_AT;
}

/* The place of a crossing of grid lines in the frame. */
static murk_status find_place(const murk_netcdf_reader *r, double longitude,
                              double latitude, double at[2])
{
    if (murk_local_from_geographic(&r->request->asked.frame, latitude,
                                   longitude, at)) {
        return MURK_OK;
    }
    return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                     "has the place longitude %.6g, latitude %.6g degrees, "
                     "must be within %.0f km of the site: within_m must cut "
                     "out a part",
                     longitude, latitude, MURK_LOCAL_MAX_M / 1000);
}

/* Lines along one axis, in degrees, and some of the other axis. */
typedef struct lines {
    int axis; /* 0: lines of longitude, 1: of latitude */
    size_t n, n_other;
    const double *line, *other; /* [n], [n_other] */
} lines;

/* The place of line i at the k-th of the others that are looked at. */
static murk_status find_crossing(const murk_netcdf_reader *r, const lines *l,
                                 size_t i, size_t k, double at[2])
{
    const double other = l->other[looked_at(k, l->n_other)];
    return l->axis == 0 ? find_place(r, l->line[i], other, at)
                        : find_place(r, other, l->line[i], at);
}

/* The coordinate of each line, out[n]: the middle of the range that its points
 * have. */
static murk_status find_coordinates(const murk_netcdf_reader *r, const lines *l,
                                    double *out)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < l->n && !status; ++i) {
        double low = INFINITY, high = -INFINITY, at[2];
        for (size_t k = 0; k < looks(l->n_other) && !status; ++k) {
            status = find_crossing(r, l, i, k, at);
            if (!status) {
                low = fmin(low, at[l->axis]);
                high = fmax(high, at[l->axis]);
            }
        }
        out[i] = (low + high) / 2;
    }
    return status;
}

/* Raises *off_m to the largest distance of a crossing of these lines from
 * (own, other), the coordinates of the lines of both axes. */
static murk_status find_distance(const murk_netcdf_reader *r, const lines *l,
                                 const double *own, const double *other,
                                 double *off_m)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < l->n && !status; ++i) {
        for (size_t k = 0; k < looks(l->n_other) && !status; ++k) {
            double at[2];
            status = find_crossing(r, l, i, k, at);
            if (!status) {
                const size_t number = looked_at(k, l->n_other);
                *off_m = fmax(*off_m, hypot(at[l->axis] - own[i],
                                            at[1 - l->axis] - other[number]));
            }
        }
    }
    return status;
}

/* The smallest distance between neighbours; not above 0 if they do not rise. */
static double smallest_step(const double *at, size_t n)
{
    double out = INFINITY;
    for (size_t i = 1; i < n; ++i) {
        out = fmin(out, at[i] - at[i - 1]);
    }
    return out;
}

/* Replaces the grid lines by coordinates in the frame, x[] and y[]. */
static murk_status place_lines(const murk_netcdf_reader *r,
                               murk_field_block *block, double *x, double *y,
                               double *off_m)
{
    const size_t nx = block->cells[0] + 1, ny = block->cells[1] + 1;
    const lines along_x = {0, nx, ny, block->edge[0], block->edge[1]},
                along_y = {1, ny, nx, block->edge[1], block->edge[0]};
    murk_status status = find_coordinates(r, &along_x, x);
    if (!status) {
        status = find_coordinates(r, &along_y, y);
    }
    if (!status) {
        status = find_distance(r, &along_x, x, y, off_m);
    }
    if (!status) {
        status = find_distance(r, &along_y, y, x, off_m);
    }
    if (status) {
        return status;
    }
    /* Beyond half a cell a value lies where its neighbour belongs. */
    const double half = fmin(smallest_step(x, nx), smallest_step(y, ny)) / 2;
    if (!(half > 0 && *off_m <= half)) {
        return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                         "has axes in degrees, which differ by %.3g m from "
                         "axes of x and y, must be at most half a cell, %.3g "
                         "m: within_m must cut out a smaller part near the "
                         "site",
                         *off_m, fmax(half, 0));
    }
    memcpy(block->edge[0], x, nx * sizeof *x);
    memcpy(block->edge[1], y, ny * sizeof *y);
    return MURK_OK;
}

static murk_status place_degrees(const murk_netcdf_reader *r,
                                 murk_field_block *block, double *off_m)
{
    double *x = malloc((block->cells[0] + 1) * sizeof *x),
           *y = malloc((block->cells[1] + 1) * sizeof *y);
    /* Cells at a pole may end beyond it. */
    for (int i = 0; i < 2; ++i) {
        double *edge = &block->edge[1][i == 0 ? 0 : block->cells[1]];
        *edge = fmax(-90, fmin(90, *edge));
    }
    const murk_status status =
        x && y ? place_lines(r, block, x, y, off_m)
               : murk_no_memory(r->err, r->request->where, "for an axis");
    free(x);
    free(y);
    const double down_m =
        r->axis[MURK_NETCDF_Z].is_above_sea ? r->request->asked.altitude_m : 0;
    for (size_t i = 0; i <= block->cells[2]; ++i) {
        block->edge[2][i] -= down_m;
    }
    return status;
}

murk_status murk_netcdf_place(murk_netcdf_reader *r, murk_field_block *block,
                              double *off_m)
{
    *off_m = 0;
    return r->axis[MURK_NETCDF_X].is_degrees ? place_degrees(r, block, off_m)
                                             : MURK_OK;
}
