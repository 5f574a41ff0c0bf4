/* Reads a field of extinction coefficients (netcdf/read.h): opens the file,
 * finds the variables and their axes (netcdf/variables.h), then the values at
 * the time. */
#include "netcdf/read.h"

#include "base/interval.h"
#include "netcdf/places.h"
#include "netcdf/variables.h"

#include <float.h>
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- values ---- */

/* A run of coordinates of an axis that are side by side in the file, too: their
 * number there, and among the coordinates that are read. */
typedef struct run {
    size_t start, count, first;
} run;

/* The runs of an axis: one, or two if it goes on at its beginning. */
static int find_runs(const murk_netcdf_axis *a, run out[2])
{
    const size_t before = a->cycle - a->first;
    const size_t count[2] = {a->n < before ? a->n : before,
                             a->n < before ? 0 : a->n - before};
    for (int i = 0; i < 2; ++i) {
        /* By rising coordinates, and as the file counts. */
        const size_t rising = i == 0 ? a->first : 0;
        out[i] = (run){.count = count[i],
                       .first = i == 0 ? 0 : count[0],
                       .start = a->is_falling ? a->length - rising - count[i]
                                              : rising};
    }
    return count[1] > 0 ? 2 : 1;
}

/* The place of values of the file among the values of the field, x fastest and
 * each axis rising. */
typedef struct order {
    int n; /* dimensions of the variable */
    size_t start[MURK_NETCDF_DIMENSIONS],
        count[MURK_NETCDF_DIMENSIONS];      /* in the file */
    ptrdiff_t step[MURK_NETCDF_DIMENSIONS]; /* in the field, from value to
                                               value */
    ptrdiff_t first;                        /* of the file's first value */
} order;

/* The order of a frame with one run of x. Fails unless the variable has the
 * axes X, Y and Z, each once, T at most, and otherwise dimensions of length 1.
 */
static murk_status find_order(const murk_netcdf_reader *r, int variable,
                              size_t frame, const run *of_x, order *out)
{
    int dimension[NC_MAX_VAR_DIMS];
    char name[NC_MAX_NAME + 1];
    const ptrdiff_t step[3] = {
        1, (ptrdiff_t)r->axis[MURK_NETCDF_X].n,
        (ptrdiff_t)(r->axis[MURK_NETCDF_X].n * r->axis[MURK_NETCDF_Y].n)};
    *out = (order){.count = {1, 1, 1, 1, 1, 1}};
    nc_inq_var(r->file, variable, name, NULL, &out->n, dimension, NULL);
    /* Find the axis of each dimension. */
    unsigned seen = 0;
    bool is_good = out->n >= 3 && out->n <= MURK_NETCDF_DIMENSIONS;
    for (int i = 0; is_good && i < out->n; ++i) {
        int which = MURK_NETCDF_X;
        while (
            which < MURK_NETCDF_AXES &&
            !(r->axis[which].at && r->axis[which].dimension == dimension[i])) {
            ++which;
        }
        if (which == MURK_NETCDF_AXES) {
            size_t length = 0;
            is_good =
                nc_inq_dimlen(r->file, dimension[i], &length) == NC_NOERR &&
                length == 1;
            continue;
        }
        is_good = !(seen >> which & 1);
        seen |= 1u << which;
        if (is_good && which == MURK_NETCDF_TIME) {
            out->start[i] = frame;
        } else if (is_good) {
            const murk_netcdf_axis *a = &r->axis[which];
            run part[2];
            find_runs(a, part);
            const run *own = which == MURK_NETCDF_X ? of_x : part;
            out->start[i] = own->start;
            out->count[i] = own->count;
            out->step[i] = a->is_falling ? -step[which] : step[which];
            out->first +=
                step[which] *
                (ptrdiff_t)(own->first + (a->is_falling ? own->count - 1 : 0));
        }
    }
    return is_good && (seen & 7) == 7
               ? MURK_OK
               : murk_netcdf_bad(r, MURK_BAD_FILE,
                                 ": must have the axes X, Y and Z "
                                 "of the first field, and T "
                                 "at most",
                                 name);
}

static murk_status no_memory(const murk_netcdf_reader *r, size_t n)
{
    return murk_no_memory(r->err, r->request->where,
                          "for a field of %zu values: the limit follows from "
                          "the size of the file, so a compressed one may have "
                          "to be stored without compression",
                          n);
}

/* Reads the values of a frame with one run of x into their places in out. */
static murk_status read_part(murk_netcdf_reader *r, int variable, size_t frame,
                             const run *of_x, double *out)
{
    char name[NC_MAX_NAME + 1] = "";
    order o;
    murk_status status = find_order(r, variable, frame, of_x, &o);
    if (status) {
        return status;
    }
    const size_t n =
        of_x->count * r->axis[MURK_NETCDF_Y].n * r->axis[MURK_NETCDF_Z].n;
    /* In the order of the file, which reads fast, then in that of the field. */
    double *raw = malloc(n * sizeof *raw);
    if (!raw) {
        return no_memory(r, n);
    }
    nc_inq_varname(r->file, variable, name);
    if (nc_get_vara_double(r->file, variable, o.start, o.count, raw) !=
        NC_NOERR) {
        status = murk_netcdf_bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    size_t at[MURK_NETCDF_DIMENSIONS] = {0};
    ptrdiff_t to = o.first;
    for (size_t i = 0; i < n && !status; ++i) {
        out[to] = raw[i];
        /* Count on, the last dimension first. */
        for (int k = o.n - 1; k >= 0; --k) {
            to += o.step[k];
            if (++at[k] < o.count[k]) {
                break;
            }
            to -= (ptrdiff_t)o.count[k] * o.step[k];
            at[k] = 0;
        }
    }
    free(raw);
    return status;
}

/* The values of a variable at a frame, x fastest, each axis rising; missing
 * ones are NAN. */
static murk_status read_frame(murk_netcdf_reader *r, int variable, size_t frame,
                              double *out)
{
    run part[2];
    const int parts = find_runs(&r->axis[MURK_NETCDF_X], part);
    murk_status status = MURK_OK;
    for (int i = 0; i < parts && !status; ++i) {
        status = read_part(r, variable, frame, &part[i], out);
    }
    if (!status) {
        murk_netcdf_unpack_values(r, variable, out,
                                  r->axis[MURK_NETCDF_X].n *
                                      r->axis[MURK_NETCDF_Y].n *
                                      r->axis[MURK_NETCDF_Z].n);
    }
    return status;
}

/* To g/m3 and um. */
static const murk_netcdf_unit waters[] = {
    {"g m-3", 1},     {"g/m3", 1},     {"kg m-3", 1000}, {"kg/m3", 1000},
    {"mg m-3", 1e-3}, {"mg/m3", 1e-3}, {NULL, 0}};
static const murk_netcdf_unit radii[] = {
    {"um", 1},          {"micron", 1},      {"microns", 1},
    {"micrometer", 1},  {"micrometers", 1}, {"micrometre", 1},
    {"micrometres", 1}, {"\xc2\xb5m", 1},   {"\xce\xbcm", 1},
    {"m", 1e6},         {NULL, 0}};

/* The variables from which the extinction follows. */
typedef struct sources {
    int first;  /* liquid water, or any variable */
    int radius; /* -1: no variable */
    double first_factor, radius_factor;
} sources;

static murk_status find_sources(const murk_netcdf_reader *r, sources *out)
{
    const murk_netcdf_asked *asked = &r->request->asked;
    *out = (sources){.radius = -1, .first_factor = 1, .radius_factor = 1};
    if (asked->variable && (asked->liquid_water || asked->effective_radius ||
                            asked->effective_radius_um > 0)) {
        return murk_netcdf_bad(r, MURK_BAD_VALUE,
                               "variable goes with neither liquid_water nor "
                               "effective_radius",
                               NULL);
    }
    if (asked->variable) {
        out->first_factor = asked->per_unit;
        return murk_netcdf_find_variable(r, asked->variable, "", &out->first);
    }
    /* Liquid water and, without a number for all, the radius. */
    murk_status status = murk_netcdf_find_variable(
        r, asked->liquid_water,
        "mass_concentration_of_cloud_liquid_water_in_air", &out->first);
    if (!status) {
        status = murk_netcdf_unit_of(r, out->first, waters, &out->first_factor);
    }
    if (!status && !(asked->effective_radius_um > 0)) {
        status = murk_netcdf_find_variable(
            r, asked->effective_radius,
            "effective_radius_of_cloud_liquid_water_particles", &out->radius);
        if (!status) {
            status =
                murk_netcdf_unit_of(r, out->radius, radii, &out->radius_factor);
        }
    }
    return status;
}

/* Effective radii where there is extinction [um]: the range, and sums over
 * extinction times the length, area or volume that a value stands for. */
typedef struct radii_found {
    double minimum, maximum;
    double weight,
        weighted; /* sums of the weight, and of weight times radius */
} radii_found;

/* Half the distance between the neighbours of coordinate i, or the length of
 * its cell: the share of the axis that a value stands for. */
static double share_of(const murk_field_block *block, int axis, size_t i)
{
    const double *edge = block->edge[axis];
    const size_t cells = block->cells[axis];
    if (!block->has_nodes) {
        return edge[i + 1] - edge[i];
    }
    return 0.5 * (edge[i < cells ? i + 1 : i] - edge[i > 0 ? i - 1 : i]);
}

/* Adds the radii of a frame of this weight. value[n] are extinctions. */
static void add_radii(radii_found *found, const murk_field_block *block,
                      const double *value, const double *radius, double factor,
                      double weight)
{
    const size_t more = block->has_nodes ? 1 : 0;
    const size_t nx = block->cells[0] + more, ny = block->cells[1] + more,
                 nz = block->cells[2] + more;
    for (size_t k = 0; k < nz; ++k) {
        for (size_t j = 0; j < ny; ++j) {
            const double share =
                weight * share_of(block, 2, k) * share_of(block, 1, j);
            for (size_t i = 0; i < nx; ++i) {
                const size_t at = (k * ny + j) * nx + i;
                if (value[at] > 0) {
                    const double um = factor * radius[at];
                    const double w = share * share_of(block, 0, i) * value[at];
                    found->minimum = fmin(found->minimum, um);
                    found->maximum = fmax(found->maximum, um);
                    found->weight += w;
                    found->weighted += w * um;
                }
            }
        }
    }
}

/* The density by a law. */
static double by_law(murk_netcdf_reader *r, const murk_netcdf_law *law,
                     double value)
{
    murk_bracket at;
    if (!murk_bracket_find(&at, law->value, law->n, value, 0)) {
        ++r->beyond;
        return law->density[value < law->value[0] ? 0 : law->n - 1];
    }
    return (1 - at.weight) * law->density[at.first] +
           at.weight * law->density[at.second];
}

/* Values below 0 that are so small a share of the largest one come from the
 * rounding of a model's transport and count as 0: a choice. */
#define NOISE 1e-4

/* Counts extinctions below 0 as 0, value[n], if they are small beside the
 * largest; `lowest` is the place of the smallest. */
static murk_status lift_negative(murk_netcdf_reader *r, double *value, size_t n,
                                 size_t lowest)
{
    double largest = 0;
    for (size_t i = 0; i < n; ++i) {
        largest = fmax(largest, value[i]);
    }
    if (!(value[lowest] >= -NOISE * largest)) {
        return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                         "value %zu is an extinction of %g /m, must be 0 or "
                         "more",
                         lowest, value[lowest]);
    }
    for (size_t i = 0; i < n; ++i) {
        r->below += value[i] < 0;
        value[i] = fmax(value[i], 0);
    }
    return MURK_OK;
}

/* Replaces the first source, value[n], by extinction coefficients. radius[n] is
 * NULL without a variable of the radius. */
static murk_status convert(murk_netcdf_reader *r, const sources *from,
                           double *value, const double *radius, size_t n)
{
    const murk_netcdf_asked *asked = &r->request->asked;
    size_t lowest = 0;
    for (size_t i = 0; i < n; ++i) {
        if (isnan(value[i])) {
            ++r->missing;
            value[i] = 0;
            continue;
        }
        double k = value[i] * from->first_factor;
        if (!asked->variable && k > 0) {
            const double um = radius ? radius[i] * from->radius_factor
                                     : asked->effective_radius_um;
            if (!(um > 0)) {
                return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                                 "value %zu has liquid water and no effective "
                                 "radius above 0",
                                 i);
            }
            /* 3 L / (2 rho r) with L in g/m3, r in um and water of 1 g/cm3. */
            k = 1.5 * k / um;
        }
        if (!(fabs(k) <= FLT_MAX)) {
            return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                             "value %zu is %g, too large", i, value[i]);
        }
        value[i] = asked->law.n > 0 ? by_law(r, &asked->law, k) : k;
        lowest = value[i] < value[lowest] ? i : lowest;
    }
    return n > 0 && value[lowest] < 0 ? lift_negative(r, value, n, lowest)
                                      : MURK_OK;
}

/* The extinction coefficients of a frame, whose radii are added to *found with
 * this weight. */
static murk_status read_extinction(murk_netcdf_reader *r, const sources *from,
                                   size_t frame, double *value, size_t n,
                                   const murk_field_block *block, double weight,
                                   radii_found *found)
{
    double *radius = from->radius >= 0 ? malloc(n * sizeof *radius) : NULL;
    murk_status status = radius || from->radius < 0
                             ? read_frame(r, from->first, frame, value)
                             : no_memory(r, n);
    if (!status && radius) {
        status = read_frame(r, from->radius, frame, radius);
    }
    if (!status) {
        status = convert(r, from, value, radius, n);
    }
    if (!status && radius) {
        add_radii(found, block, value, radius, from->radius_factor, weight);
    }
    free(radius);
    return status;
}

/* A time this close to that of a frame is the time of the frame: a share of the
 * time that is asked for, as users write times, and some roundings of the times
 * in the file, which may count from a year far away. */
#define SAME_TIME      1e-9
#define SAME_ROUNDINGS 4

/* The frames around the time, and the weight of the second. */
static murk_status choose_frames(const murk_netcdf_reader *r, murk_bracket *out)
{
    const murk_netcdf_axis *time = &r->axis[MURK_NETCDF_TIME];
    const double asked = r->request->asked.time_s;
    if (!time->at) {
        return asked == 0 ? MURK_OK
                          : murk_netcdf_bad(
                                r, MURK_BAD_VALUE,
                                "time_s must be 0 or left out: the field has "
                                "no time",
                                NULL);
    }
    /* Times after the first. */
    const double first = time->at[0], last = time->at[time->n - 1];
    const double same =
        SAME_TIME * fabs(asked) +
        SAME_ROUNDINGS * DBL_EPSILON * fmax(fabs(first), fabs(last));
    if (!murk_bracket_find(out, time->at, time->n, first + asked, same)) {
        return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                         "time_s is %.9g s, must be 0 to %.9g s, after the "
                         "first of %zu times",
                         asked, last - first, time->n);
    }
    /* Falling times were turned round. */
    if (time->is_falling) {
        out->first = time->n - 1 - out->first;
        out->second = time->n - 1 - out->second;
    }
    return MURK_OK;
}

/* Writes how the values were obtained: law, time and effective radii. */
static void describe(char *out, size_t size, const murk_netcdf_reader *r,
                     size_t frame, bool is_between, const radii_found *found,
                     double off_m)
{
    int n = snprintf(out, size, "%s",
                     r->request->asked.law.n > 0  ? "a word of the preset"
                     : r->request->asked.variable ? "a factor"
                                                  : "3 L / (2 r)");
    if (found->weight > 0) {
        n += snprintf(out + n, size - (size_t)n,
                      ", r %.3g..%.3g um, by extinction %.4g um in the mean",
                      found->minimum, found->maximum,
                      found->weighted / found->weight);
    }
    if (r->axis[MURK_NETCDF_TIME].at) {
        n += snprintf(out + n, size - (size_t)n, "; %s %zu of %zu",
                      is_between ? "between two times from" : "time", frame + 1,
                      r->axis[MURK_NETCDF_TIME].n);
    }
    if (r->axis[MURK_NETCDF_X].is_degrees) {
        snprintf(out + n, size - (size_t)n,
                 "; degrees as x and y within %.3g m", off_m);
    }
}

/* Tells how many values were not taken as they are. */
static void write_warning(const murk_netcdf_reader *r, char *out, size_t size)
{
    const struct {
        size_t n;
        const char *text;
    } counts[] = {
        {r->missing, "values are missing in the file and count as 0"},
        {r->below, "values are slightly below 0 and count as 0"},
        {r->beyond, "values beyond the range of the word count as its end"}};
    int length = 0;
    out[0] = '\0';
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i) {
        if (counts[i].n > 0) {
            length +=
                snprintf(out + length, size - (size_t)length, "%s%zu %s",
                         length > 0 ? "; " : "", counts[i].n, counts[i].text);
        }
    }
}

/* off_m: the error of places of axes in degrees. */
static murk_status read_values(murk_netcdf_reader *r, const sources *from,
                               double off_m, murk_field_block *block,
                               murk_field_head *head)
{
    const size_t n = r->axis[MURK_NETCDF_X].n * r->axis[MURK_NETCDF_Y].n *
                     r->axis[MURK_NETCDF_Z].n;
    murk_bracket time = {0};
    radii_found found = {.minimum = INFINITY};
    murk_status status = choose_frames(r, &time);
    const double weight = time.weight;
    double *value = malloc(n * sizeof *value);
    double *later = weight > 0 ? malloc(n * sizeof *later) : NULL;
    block->value = malloc(n * sizeof *block->value);
    if (!status && (!value || !block->value || (weight > 0 && !later))) {
        status = no_memory(r, n);
    }
    if (!status) {
        status = read_extinction(r, from, time.first, value, n, block,
                                 1 - weight, &found);
    }
    if (!status && later) {
        status = read_extinction(r, from, time.second, later, n, block, weight,
                                 &found);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        block->value[i] =
            (float)(later ? (1 - weight) * value[i] + weight * later[i]
                          : value[i]);
    }
    free(value);
    free(later);
    /* Texts for users. */
    char name[NC_MAX_NAME + 1] = "";
    nc_inq_varname(r->file, from->first, name);
    snprintf(head->name, sizeof head->name, "%.100s", name);
    describe(head->note, sizeof head->note, r, time.first, weight > 0, &found,
             off_m);
    head->effective_radius_um = found.weight > 0
                                    ? found.weighted / found.weight
                                    : r->request->asked.effective_radius_um;
    write_warning(r, head->warning, sizeof head->warning);
    return status;
}

/* ---- the block ---- */

/* The grid lines along an axis. Values at nodes: the coordinates. Values of
 * cells: the bounds, or the middles between coordinates, with cells of the same
 * length on both sides of the first and last coordinate. */
static murk_status set_edges(const murk_netcdf_reader *r, int which,
                             bool has_nodes, murk_field_block *block)
{
    const murk_netcdf_axis *a = &r->axis[which];
    const size_t n = a->n;
    double *edge = block->edge[which] = malloc((n + 1) * sizeof *edge);
    if (!edge) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    block->cells[which] = has_nodes ? n - 1 : n;
    if (has_nodes) {
        memcpy(edge, a->at, n * sizeof *edge);
        return n > 1 ? MURK_OK
                     : murk_netcdf_bad(
                           r, MURK_BAD_VALUE,
                           "one value along an axis cannot be interpolated",
                           NULL);
    }
    /* Middles, then the bounds if there are any. */
    for (size_t i = 1; i < n; ++i) {
        edge[i] = (a->at[i - 1] + a->at[i]) / 2;
    }
    if (n > 1) {
        edge[0] = 2 * a->at[0] - edge[1];
        edge[n] = 2 * a->at[n - 1] - edge[n - 1];
    }
    for (size_t i = 0; a->bound && i < n; ++i) {
        const double low = fmin(a->bound[2 * i], a->bound[2 * i + 1]),
                     high = fmax(a->bound[2 * i], a->bound[2 * i + 1]);
        if (i > 0 && fabs(low - edge[i]) > 1e-6 * (high - low)) {
            return murk_netcdf_bad(r, MURK_BAD_FILE,
                                   "bounds of cells with gaps or overlaps",
                                   NULL);
        }
        edge[i] = i > 0 ? edge[i] : low;
        edge[i + 1] = high;
    }
    return MURK_OK;
}

static murk_status read_open(murk_netcdf_reader *r, murk_field_head *head,
                             murk_field_block *block)
{
    /* Variables and their axes, the part of them, grid lines, then values. */
    sources from;
    const bool has_nodes = r->request->asked.is_linear;
    murk_status status = find_sources(r, &from);
    if (!status) {
        status = murk_netcdf_read_axes(r, from.first);
    }
    if (!status) {
        status = murk_netcdf_cut(r);
    }
    if (!status && r->axis[MURK_NETCDF_X].n > MURK_FIELD_VALUES_MAX /
                                                  r->axis[MURK_NETCDF_Y].n /
                                                  r->axis[MURK_NETCDF_Z].n) {
        status = murk_netcdf_bad(r, MURK_BAD_FILE, "has more than 2^31 values",
                                 NULL);
    }
    block->has_nodes = has_nodes;
    for (int i = MURK_NETCDF_X; i <= MURK_NETCDF_Z && !status; ++i) {
        status = set_edges(r, i, has_nodes, block);
    }
    double off_m = 0;
    if (!status) {
        status = murk_netcdf_place(r, block, &off_m);
    }
    return status ? status : read_values(r, &from, off_m, block, head);
}

murk_status murk_netcdf_read(murk_field_head *head, murk_field_block *block,
                             const murk_netcdf_request *request,
                             murk_error *err)
{
    murk_error own = {0};
    murk_netcdf_reader r = {.request = request, .err = err ? err : &own};
    murk_netcdf_release_axes(&r); /* marks them as not found */
    /* A path such as http://... would make the library ask a server. */
    struct stat facts;
    if (stat(request->path, &facts) != 0 || !S_ISREG(facts.st_mode) ||
        strstr(request->path, "://") || strchr(request->path, '#')) {
        return murk_netcdf_bad(&r, MURK_BAD_FILE, "is no file that can be read",
                               NULL);
    }
    const int opened = nc_open(request->path, NC_NOWRITE, &r.file);
    if (opened != NC_NOERR) {
        return murk_fail(r.err, MURK_BAD_FILE, request->where,
                         "is no NetCDF file that can be read: %s",
                         nc_strerror(opened));
    }
    const murk_status status = read_open(&r, head, block);
    nc_close(r.file);
    murk_netcdf_release_axes(&r);
    return status;
}
