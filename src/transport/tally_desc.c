/* Shapes and checks of tally descriptions: numbers of cells, axes of the bins
 * of a plane, and refusal of tallies that cannot be measured. */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "base/position.h"
#include "transport/tallies.h"

/* Relative rounding error of a sum or difference of two lengths: a sphere that
 * touches a side of the domain is inside. */
#define ROUNDING (4 * DBL_EPSILON)

size_t murk_tally_directions(const murk_tally_desc *desc)
{
    return desc->type == MURK_TALLY_PLANE ||
                   (desc->type == MURK_TALLY_SPHERE && desc->hemispheres)
               ? 2
               : 1;
}

size_t murk_tally_cells(const murk_tally_desc *desc)
{
    const size_t directions = murk_tally_directions(desc);
    switch (desc->type) {
    case MURK_TALLY_PLANE:
        return desc->bins[0] * desc->bins[1] * desc->angle_bins * directions;
    case MURK_TALLY_GRID:
        return desc->size[0] * desc->size[1] * desc->size[2];
    default:
        return directions;
    }
}

void murk_tally_axes(const murk_tally_desc *desc, int axes[2])
{
    const double n[3] = {fabs(desc->normal.x), fabs(desc->normal.y),
                         fabs(desc->normal.z)};
    const int along = n[2] >= n[1] && n[2] >= n[0] ? 2 : n[1] >= n[0] ? 1 : 0;
    axes[0] = along == 0 ? 1 : 0;
    axes[1] = along == 2 ? 1 : 2;
}

/* ---- checks ---- */

static murk_status check_name(const murk_tally_desc *desc, murk_error *err)
{
    bool is_safe = isalnum((unsigned char)desc->name[0]);
    for (const char *c = desc->name; *c; ++c) {
        is_safe &= isalnum((unsigned char)*c) || strchr("._-", *c) != NULL;
    }
    return is_safe ? MURK_OK
                   : murk_fail(err, MURK_BAD_VALUE, desc->where,
                               "name \"%s\", must be letters, digits, . _ -, "
                               "a letter or digit first: files are named by it",
                               desc->name);
}

static bool is_error_of(const murk_tally_desc *error,
                        const murk_tally_desc *grid)
{
    const size_t n = strlen(grid->name);
    return error->type == MURK_TALLY_GRID && grid->type == MURK_TALLY_GRID &&
           strncmp(error->name, grid->name, n) == 0 &&
           strcmp(error->name + n, "_error") == 0;
}

static murk_status check_pair(const murk_tally_desc *a,
                              const murk_tally_desc *b, murk_error *err)
{
    if (strcmp(a->name, b->name) == 0) {
        return murk_fail(err, MURK_BAD_VALUE, b->where,
                         "name \"%s\" is also that of another tally", b->name);
    }
    if (is_error_of(a, b) || is_error_of(b, a)) {
        return murk_fail(err, MURK_BAD_VALUE, b->where,
                         "name \"%s\": its files are also those of the tally "
                         "\"%s\"",
                         b->name, a->name);
    }
    return MURK_OK;
}

static double rounding_of(const murk_box *box)
{
    return ROUNDING * murk_box_largest_coordinate(box);
}

/* True if the box from min to max lies in the domain `box`, to rounding; false
 * if a coordinate is NaN. */
static bool is_inside(const murk_box *box, murk_vec3 min, murk_vec3 max)
{
    const double r = rounding_of(box);
    return min.x >= box->min.x - r && min.y >= box->min.y - r &&
           min.z >= box->min.z - r && max.x <= box->max.x + r &&
           max.y <= box->max.y + r && max.z <= box->max.z + r;
}

static murk_status outside(const murk_tally_desc *desc, const murk_box *box,
                           const char *what, murk_error *err)
{
    return murk_fail(err, MURK_BAD_VALUE, desc->where,
                     "%s outside the domain, which is %s to %s m", what,
                     murk_position_show(box->min).text,
                     murk_position_show(box->max).text);
}

static murk_status check_plane(const murk_tally_desc *d, const murk_box *box,
                               murk_error *err)
{
    const double length = murk_length(d->normal);
    if (!(length > 0 && isfinite(length))) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "normal is [%g, %g, %g], must point somewhere",
                         d->normal.x, d->normal.y, d->normal.z);
    }
    const double bins =
        (double)d->bins[0] * (double)d->bins[1] * (double)d->angle_bins;
    if (!(bins >= 1 && bins <= MURK_PLANE_CELLS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "bins and angle_bins make %.9g bins, must be 1..%d",
                         bins, MURK_PLANE_CELLS_MAX);
    }
    return is_inside(box, d->point, d->point)
               ? MURK_OK
               : outside(d, box, "point_m is", err);
}

static murk_status check_grid(const murk_tally_desc *d, const murk_box *box,
                              murk_error *err)
{
    const murk_vec3 a = d->box.min, b = d->box.max;
    if (!(a.x < b.x && a.y < b.y && a.z < b.z)) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "min_m must be less than max_m on each axis");
    }
    const double cells =
        (double)d->size[0] * (double)d->size[1] * (double)d->size[2];
    if (!(cells >= 1 && cells <= (double)MURK_TALLY_CELLS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "size makes %.9g cells, must be 1..%.9g", cells,
                         (double)MURK_TALLY_CELLS_MAX);
    }
    return is_inside(box, a, b) ? MURK_OK : outside(d, box, "reaches", err);
}

static murk_status check_sphere(const murk_tally_desc *d, const murk_box *box,
                                murk_error *err)
{
    const double r = d->radius_m;
    const murk_vec3 c = d->center;
    if (!(r > 0 && isfinite(r))) {
        return murk_fail(err, MURK_BAD_VALUE, d->where,
                         "radius_m is %g, must be more than 0 m", r);
    }
    return is_inside(box, murk_vec(c.x - r, c.y - r, c.z - r),
                     murk_vec(c.x + r, c.y + r, c.z + r))
               ? MURK_OK
               : outside(d, box, "reaches", err);
}

murk_status murk_tallies_check(const murk_tally_desc *descs, size_t n,
                               const murk_domain *domain, murk_error *err)
{
    double cells = 0;
    if (n > MURK_TALLIES_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, descs[0].where,
                         "%zu tallies, must be at most %d", n,
                         MURK_TALLIES_MAX);
    }
    /* Check each tally by itself, and its name against the names before. */
    for (size_t i = 0; i < n; ++i) {
        const murk_tally_desc *d = &descs[i];
        murk_status status = check_name(d, err);
        for (size_t j = 0; j < i && !status; ++j) {
            status = check_pair(&descs[j], d, err);
        }
        if (!status) {
            status = d->type == MURK_TALLY_PLANE
                         ? check_plane(d, &domain->box, err)
                     : d->type == MURK_TALLY_GRID
                         ? check_grid(d, &domain->box, err)
                         : check_sphere(d, &domain->box, err);
        }
        if (status) {
            return status;
        }
        /* All cells together. */
        cells += (double)murk_tally_cells(d);
        if (!(cells <= (double)MURK_TALLY_CELLS_MAX)) {
            return murk_fail(err, MURK_BAD_VALUE, d->where,
                             "the tallies up to it have %.9g cells, must be "
                             "at most %.9g",
                             cells, (double)MURK_TALLY_CELLS_MAX);
        }
    }
    return MURK_OK;
}
