/* Reads a field of extinction coefficients (netcdf/read.h): opens the file,
 * finds the variables, then their axes, then the values at the time. */
#include "netcdf/read.h"

#include <float.h>
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define TEXT_SIZE 256 /* of attributes that are looked at */

/* Values of missing_value that are looked at: a choice. */
#define MISSING_MAX 16

enum { X, Y, Z, TIME, AXES };

typedef struct axis {
    int dimension; /* of the file; -1: the variable has none */
    size_t n;
    double *at;      /* [n], in metres or seconds */
    double *bound;   /* [2 n], CF bounds; NULL: none */
    bool is_falling; /* the file has the values from high to low */
} axis;

typedef struct reader {
    int file;
    const murk_netcdf_request *request;
    murk_error *err;
    axis axis[AXES];
    size_t missing; /* values that are missing in the file */
} reader;

static murk_status bad(const reader *r, murk_status status, const char *text,
                       const char *name)
{
    return murk_fail(r->err, status, r->request->where, "%s%.80s",
                     name ? name : "", text);
}

/* ---- attributes ---- */

/* A text attribute; empty if there is none or it is longer. */
static void get_text(const reader *r, int variable, const char *name,
                     char out[TEXT_SIZE])
{
    size_t n = 0;
    nc_type type = NC_NAT;
    out[0] = '\0';
    if (nc_inq_att(r->file, variable, name, &type, &n) == NC_NOERR &&
        type == NC_CHAR && n < TEXT_SIZE &&
        nc_get_att_text(r->file, variable, name, out) == NC_NOERR) {
        out[n] = '\0';
    } else if (type == NC_STRING && n == 1) {
        char *text = NULL;
        if (nc_get_att_string(r->file, variable, name, &text) == NC_NOERR) {
            snprintf(out, TEXT_SIZE, "%s", text ? text : "");
            nc_free_string(1, &text);
        }
    }
}

/* A number of an attribute, or `otherwise` if there is none. */
static double get_number(const reader *r, int variable, const char *name,
                         double otherwise)
{
    size_t n = 0;
    double value = otherwise;
    const bool is_one =
        nc_inq_attlen(r->file, variable, name, &n) == NC_NOERR && n == 1;
    if (is_one &&
        nc_get_att_double(r->file, variable, name, &value) != NC_NOERR) {
        value = otherwise;
    }
    return value;
}

typedef struct unit {
    const char *name;
    double factor;
} unit;

/* The factor of a unit in a table that ends with NULL; 0: not in the table. */
static double factor_of(const unit *table, const char *name)
{
    while (table->name && strcmp(table->name, name) != 0) {
        ++table;
    }
    return table->name ? table->factor : 0;
}

static const unit lengths[] = {
    {"m", 1},      {"metre", 1}, {"meter", 1},        {"metres", 1},
    {"meters", 1}, {"km", 1000}, {"kilometer", 1000}, {"kilometre", 1000},
    {NULL, 0}};
static const unit times[] = {{"seconds", 1},  {"second", 1},  {"s", 1},
                             {"minutes", 60}, {"minute", 60}, {"min", 60},
                             {"hours", 3600}, {"hour", 3600}, {"h", 3600},
                             {"days", 86400}, {"day", 86400}, {"d", 86400},
                             {NULL, 0}};
/* To g/m3 and um. */
static const unit waters[] = {
    {"g m-3", 1},      {"g/m3", 1},      {"g m^-3", 1},
    {"g/m^3", 1},      {"kg m-3", 1000}, {"kg/m3", 1000},
    {"kg m^-3", 1000}, {"kg/m^3", 1000}, {NULL, 0}};
static const unit radii[] = {
    {"um", 1},          {"micron", 1},      {"microns", 1},
    {"micrometer", 1},  {"micrometers", 1}, {"micrometre", 1},
    {"micrometres", 1}, {"\xc2\xb5m", 1},   {"\xce\xbcm", 1},
    {"m", 1e6},         {NULL, 0}};

/* ---- variables ---- */

/* Lists the variables of three or more dimensions, for messages. */
static void list_variables(const reader *r, char *out, size_t size)
{
    int n = 0;
    size_t length = 0;
    out[0] = '\0';
    nc_inq_nvars(r->file, &n);
    for (int i = 0; i < n && length + NC_MAX_NAME + 3 < size; ++i) {
        char name[NC_MAX_NAME + 1];
        int dimensions = 0;
        if (nc_inq_var(r->file, i, name, NULL, &dimensions, NULL, NULL) ==
                NC_NOERR &&
            dimensions >= 3) {
            length += (size_t)snprintf(out + length, size - length, "%s%.60s",
                                       length ? ", " : "", name);
        }
    }
}

static murk_status no_variable(const reader *r, const char *wanted)
{
    char list[1024];
    list_variables(r, list, sizeof list);
    return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                     "has no variable %.80s; fields in it: %s", wanted,
                     list[0] ? list : "none");
}

/* Finds a variable by the name that the user gave, otherwise by its standard
 * name. */
static murk_status find_variable(const reader *r, const char *name,
                                 const char *standard, int *out)
{
    int n = 0;
    if (name) {
        return nc_inq_varid(r->file, name, out) == NC_NOERR
                   ? MURK_OK
                   : no_variable(r, name);
    }
    nc_inq_nvars(r->file, &n);
    for (int i = 0; i < n; ++i) {
        char text[TEXT_SIZE];
        get_text(r, i, "standard_name", text);
        if (strcmp(text, standard) == 0) {
            *out = i;
            return MURK_OK;
        }
    }
    return no_variable(r, standard);
}

/* ---- numbers ---- */

/* How the numbers of a variable are stored. */
typedef struct packing {
    double scale, offset;
    double
        fill; /* NAN: none; the default of the type, if the file has no other */
    double low, high; /* valid values, before they are unpacked */
    double missing[MISSING_MAX];
    size_t n_missing;
} packing;

/* The fill value of a variable: that of the file, or the default of the library
 * for the type; bytes and texts have none. */
static double fill_of(const reader *r, int variable)
{
    nc_type type = NC_NAT;
    size_t n = 0;
    nc_inq_vartype(r->file, variable, &type);
    if (nc_inq_attlen(r->file, variable, "_FillValue", &n) == NC_NOERR) {
        return get_number(r, variable, "_FillValue", NAN);
    }
    switch (type) {
    case NC_SHORT:
        return NC_FILL_SHORT;
    case NC_INT:
        return NC_FILL_INT;
    case NC_USHORT:
        return NC_FILL_USHORT;
    case NC_UINT:
        return NC_FILL_UINT;
    case NC_FLOAT:
        return (double)NC_FILL_FLOAT;
    case NC_DOUBLE:
        return NC_FILL_DOUBLE;
    default:
        return NAN;
    }
}

static packing packing_of(const reader *r, int variable)
{
    packing p = {.scale = get_number(r, variable, "scale_factor", 1),
                 .offset = get_number(r, variable, "add_offset", 0),
                 .fill = fill_of(r, variable),
                 .low = get_number(r, variable, "valid_min", -INFINITY),
                 .high = get_number(r, variable, "valid_max", INFINITY)};
    size_t n = 0;
    double range[2];
    if (nc_inq_attlen(r->file, variable, "valid_range", &n) == NC_NOERR &&
        n == 2 &&
        nc_get_att_double(r->file, variable, "valid_range", range) ==
            NC_NOERR) {
        p.low = range[0];
        p.high = range[1];
    }
    if (nc_inq_attlen(r->file, variable, "missing_value", &n) == NC_NOERR &&
        n <= MISSING_MAX &&
        nc_get_att_double(r->file, variable, "missing_value", p.missing) ==
            NC_NOERR) {
        p.n_missing = n;
    }
    return p;
}

/* Unpacks n numbers; those that are missing or not valid become NAN. */
static void unpack(const packing *p, double *value, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const double v = value[i];
        bool is_there =
            isfinite(v) && v != p->fill && v >= p->low && v <= p->high;
        for (size_t k = 0; k < p->n_missing; ++k) {
            is_there = is_there && v != p->missing[k];
        }
        value[i] = is_there ? v * p->scale + p->offset : NAN;
    }
}

/* ---- axes ---- */

/* The axis that a coordinate variable belongs to; -1 if it does not say. */
static int axis_of(const reader *r, int variable, const char *name)
{
    static const char *const letters[AXES] = {"X", "Y", "Z", "T"};
    static const struct {
        const char *standard;
        int axis;
    } names[] = {{"projection_x_coordinate", X},
                 {"projection_y_coordinate", Y},
                 {"longitude", X},
                 {"latitude", Y},
                 {"altitude", Z},
                 {"height", Z},
                 {"depth", Z},
                 {"time", TIME}};
    char text[TEXT_SIZE];
    get_text(r, variable, "axis", text);
    for (int i = 0; i < AXES; ++i) {
        if (strcmp(text, letters[i]) == 0) {
            return i;
        }
    }
    get_text(r, variable, "units", text);
    if (strstr(text, " since ")) {
        return TIME;
    }
    get_text(r, variable, "standard_name", text);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        if (strcmp(text, names[i].standard) == 0) {
            return names[i].axis;
        }
    }
    /* By the first letter, as files without attributes have it. */
    const char *const by_letter = strchr("xyzt", name[0]);
    return name[0] && by_letter ? (int)(by_letter - "xyzt") : -1;
}

/* The factor from the unit of an axis to metres or seconds. */
static murk_status find_factor(const reader *r, int variable, int which,
                               const char *name, double *factor)
{
    char text[TEXT_SIZE], word[TEXT_SIZE];
    get_text(r, variable, "units", text);
    snprintf(word, sizeof word, "%s", text);
    if (which == TIME) {
        word[strcspn(word, " ")] = '\0';
    }
    *factor = factor_of(which == TIME ? times : lengths, word);
    if (*factor > 0) {
        return MURK_OK;
    }
    return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                     "axis %.60s has the unit \"%.60s\", must be %s", name,
                     text,
                     which == TIME ? "seconds, minutes, hours or days since"
                                   : "m or km: other coordinates must be "
                                     "projected before");
}

/* Reads the bounds of cells of an axis, if it has any (CF 7.1). */
static murk_status read_bounds(const reader *r, int variable, double factor,
                               axis *a)
{
    char name[TEXT_SIZE];
    int bounds = 0, n = 0;
    get_text(r, variable, "bounds", name);
    if (!name[0] || nc_inq_varid(r->file, name, &bounds) != NC_NOERR ||
        nc_inq_varndims(r->file, bounds, &n) != NC_NOERR || n != 2) {
        return MURK_OK;
    }
    /* One pair for each coordinate. */
    int dimension[2];
    size_t length[2] = {0};
    nc_inq_vardimid(r->file, bounds, dimension);
    nc_inq_dimlen(r->file, dimension[0], &length[0]);
    nc_inq_dimlen(r->file, dimension[1], &length[1]);
    if (length[0] != a->n || length[1] != 2) {
        return bad(r, MURK_BAD_FILE, ": bounds of another size", name);
    }
    a->bound = malloc(2 * a->n * sizeof *a->bound);
    if (!a->bound) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    if (nc_get_var_double(r->file, bounds, a->bound) != NC_NOERR) {
        return bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    /* Bounds without packing of their own have that of the coordinates. */
    size_t length_of_scale = 0;
    const bool is_packed = nc_inq_attlen(r->file, bounds, "scale_factor",
                                         &length_of_scale) == NC_NOERR;
    const packing p = packing_of(r, is_packed ? bounds : variable);
    unpack(&p, a->bound, 2 * a->n);
    for (size_t i = 0; i < 2 * a->n; ++i) {
        a->bound[i] *= factor;
    }
    return MURK_OK;
}

/* Checks that coordinates rise or fall; those that fall are turned round. */
static murk_status order_axis(const reader *r, const char *name, axis *a)
{
    bool rises = isfinite(a->at[0]), falls = rises;
    for (size_t i = 1; i < a->n; ++i) {
        rises = rises && a->at[i] > a->at[i - 1];
        falls = falls && a->at[i] < a->at[i - 1];
    }
    if (!rises && !falls) {
        return bad(r, MURK_BAD_FILE, ": coordinates must rise or fall", name);
    }
    a->is_falling = falls && a->n > 1;
    for (size_t i = 0; a->is_falling && i < a->n / 2; ++i) {
        const double at = a->at[i];
        a->at[i] = a->at[a->n - 1 - i];
        a->at[a->n - 1 - i] = at;
    }
    /* Both bounds of all cells, in the reverse order. */
    for (size_t i = 0; a->bound && a->is_falling && i < a->n; ++i) {
        const double bound = a->bound[i];
        a->bound[i] = a->bound[2 * a->n - 1 - i];
        a->bound[2 * a->n - 1 - i] = bound;
    }
    return MURK_OK;
}

/* True if the coordinates of the vertical axis are depths. */
static bool points_down(const reader *r, int variable)
{
    char positive[TEXT_SIZE], name[TEXT_SIZE];
    get_text(r, variable, "positive", positive);
    get_text(r, variable, "standard_name", name);
    return positive[0] ? strcmp(positive, "down") == 0
                       : strcmp(name, "depth") == 0;
}

/* Reads the coordinate variable of a dimension. */
static murk_status read_axis(reader *r, int dimension)
{
    char name[NC_MAX_NAME + 1];
    size_t n = 0;
    int variable = 0, dimensions = 0, own = 0;
    nc_inq_dim(r->file, dimension, name, &n);
    if (nc_inq_varid(r->file, name, &variable) != NC_NOERR ||
        nc_inq_varndims(r->file, variable, &dimensions) != NC_NOERR ||
        dimensions != 1 ||
        nc_inq_vardimid(r->file, variable, &own) != NC_NOERR ||
        own != dimension) {
        return bad(r, MURK_BAD_FILE,
                   ": dimension without a variable of its name that has its "
                   "coordinates",
                   name);
    }
    const int which = axis_of(r, variable, name);
    if (which < 0 || r->axis[which].at || n == 0 || n > MURK_FIELD_CELLS_MAX) {
        return bad(r, MURK_BAD_FILE,
                   ": is none of the axes X, Y, Z and T, or one of them twice",
                   name);
    }
    /* Coordinates in metres or seconds, and bounds. */
    axis *a = &r->axis[which];
    double factor = 0;
    *a =
        (axis){.dimension = dimension, .n = n, .at = malloc(n * sizeof *a->at)};
    if (!a->at) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    murk_status status = find_factor(r, variable, which, name, &factor);
    if (!status && nc_get_var_double(r->file, variable, a->at) != NC_NOERR) {
        status = bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    if (!status) {
        const packing p = packing_of(r, variable);
        unpack(&p, a->at, n);
        factor *= which == Z && points_down(r, variable) ? -1 : 1;
    }
    for (size_t i = 0; i < n && !status; ++i) {
        a->at[i] *= factor;
    }
    if (!status && which != TIME) {
        status = read_bounds(r, variable, factor, a);
    }
    return status ? status : order_axis(r, name, a);
}

static murk_status read_axes(reader *r, int variable)
{
    int n = 0, dimension[NC_MAX_VAR_DIMS];
    char name[NC_MAX_NAME + 1];
    nc_inq_var(r->file, variable, name, NULL, &n, dimension, NULL);
    if (n != 3 && n != 4) {
        return bad(r, MURK_BAD_FILE,
                   ": must have the axes X, Y and Z, and T at most", name);
    }
    murk_status status = MURK_OK;
    for (int i = 0; i < n && !status; ++i) {
        status = read_axis(r, dimension[i]);
    }
    for (int i = X; i <= Z && !status; ++i) {
        if (!r->axis[i].at) {
            status = bad(r, MURK_BAD_FILE, ": misses one of X, Y and Z", name);
        } else if (r->axis[i].n < 2 && !r->axis[i].bound) {
            status = bad(r, MURK_BAD_FILE,
                         ": one coordinate along an axis, and no bounds", name);
        }
    }
    return status;
}

/* ---- values ---- */

/* The place of a value of the file among the values of the field, x fastest and
 * each axis rising. */
typedef struct order {
    int n;                     /* dimensions of the variable, 4 at most */
    size_t start[4], count[4]; /* of the frame */
    ptrdiff_t step[4];         /* in the field, from value to value */
    ptrdiff_t first;           /* of the file's first value */
} order;

/* Fails unless the variable has the axes X, Y and Z, each once, and T at most.
 */
static murk_status find_order(const reader *r, int variable, size_t frame,
                              order *out)
{
    int dimension[NC_MAX_VAR_DIMS];
    char name[NC_MAX_NAME + 1];
    const ptrdiff_t step[3] = {1, (ptrdiff_t)r->axis[X].n,
                               (ptrdiff_t)(r->axis[X].n * r->axis[Y].n)};
    *out = (order){.count = {1, 1, 1, 1}};
    nc_inq_var(r->file, variable, name, NULL, &out->n, dimension, NULL);
    /* Find the axis of each dimension. */
    unsigned seen = 0;
    bool is_good = out->n == 3 || out->n == 4;
    for (int i = 0; is_good && i < out->n; ++i) {
        int which = X;
        while (which < AXES && !(r->axis[which].at &&
                                 r->axis[which].dimension == dimension[i])) {
            ++which;
        }
        is_good = which < AXES && !(seen >> which & 1);
        seen |= 1u << which;
        if (is_good && which == TIME) {
            out->start[i] = frame;
        } else if (is_good) {
            const axis *a = &r->axis[which];
            out->count[i] = a->n;
            out->step[i] = a->is_falling ? -step[which] : step[which];
            out->first +=
                a->is_falling ? (ptrdiff_t)(a->n - 1) * step[which] : 0;
        }
    }
    return is_good && (seen & 7) == 7 ? MURK_OK
                                      : bad(r, MURK_BAD_FILE,
                                            ": must have the axes X, Y and Z "
                                            "of the first field, and T "
                                            "at most",
                                            name);
}

/* The values of a variable at a frame, x fastest, each axis rising; missing
 * ones are NAN. */
static murk_status read_frame(reader *r, int variable, size_t frame,
                              double *out)
{
    const size_t n = r->axis[X].n * r->axis[Y].n * r->axis[Z].n;
    char name[NC_MAX_NAME + 1] = "";
    order o;
    murk_status status = find_order(r, variable, frame, &o);
    if (status) {
        return status;
    }
    /* In the order of the file, which reads fast, then in that of the field. */
    double *raw = malloc(n * sizeof *raw);
    if (!raw) {
        return murk_no_memory(r->err, r->request->where, "for a field");
    }
    nc_inq_varname(r->file, variable, name);
    if (nc_get_vara_double(r->file, variable, o.start, o.count, raw) !=
        NC_NOERR) {
        status = bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    size_t at[4] = {0};
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
    const packing p = packing_of(r, variable);
    if (!status) {
        unpack(&p, out, n);
    }
    return status;
}

/* The factor from the unit of a variable, which must be in the table. */
static murk_status unit_of(const reader *r, int variable, const unit *table,
                           double *factor)
{
    char text[TEXT_SIZE], name[NC_MAX_NAME + 1] = "";
    get_text(r, variable, "units", text);
    nc_inq_varname(r->file, variable, name);
    *factor = factor_of(table, text);
    return *factor > 0
               ? MURK_OK
               : murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                           "%.60s has the unit \"%.60s\", must be %s or a "
                           "multiple of it",
                           name, text, table[0].name);
}

/* The variables from which the extinction follows. */
typedef struct sources {
    int first;  /* liquid water, or any variable */
    int radius; /* -1: no variable */
    double first_factor, radius_factor;
} sources;

static murk_status find_sources(const reader *r, sources *out)
{
    const murk_netcdf_asked *asked = &r->request->asked;
    *out = (sources){.radius = -1, .first_factor = 1, .radius_factor = 1};
    if (asked->variable && (asked->liquid_water || asked->effective_radius ||
                            asked->effective_radius_um > 0)) {
        return bad(r, MURK_BAD_VALUE,
                   "variable goes with neither liquid_water nor "
                   "effective_radius",
                   NULL);
    }
    if (asked->variable) {
        out->first_factor = asked->per_unit;
        return find_variable(r, asked->variable, "", &out->first);
    }
    /* Liquid water and, without a number for all, the radius. */
    murk_status status = find_variable(
        r, asked->liquid_water,
        "mass_concentration_of_cloud_liquid_water_in_air", &out->first);
    if (!status) {
        status = unit_of(r, out->first, waters, &out->first_factor);
    }
    if (!status && !(asked->effective_radius_um > 0)) {
        status = find_variable(
            r, asked->effective_radius,
            "effective_radius_of_cloud_liquid_water_particles", &out->radius);
        if (!status) {
            status = unit_of(r, out->radius, radii, &out->radius_factor);
        }
    }
    return status;
}

/* Replaces the first source, value[n], by extinction coefficients. radius[n] is
 * NULL without a variable of the radius. */
static murk_status convert(reader *r, const sources *from, double *value,
                           const double *radius, size_t n)
{
    const murk_netcdf_asked *asked = &r->request->asked;
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
        if (!(k >= 0 && k <= FLT_MAX)) {
            return murk_fail(r->err, MURK_BAD_FILE, r->request->where,
                             "value %zu is an extinction of %g /m, must be 0 "
                             "or more",
                             i, k);
        }
        value[i] = k;
    }
    return MURK_OK;
}

/* The extinction coefficients of a frame. */
static murk_status read_extinction(reader *r, const sources *from, size_t frame,
                                   double *value, size_t n)
{
    double *radius = from->radius >= 0 ? malloc(n * sizeof *radius) : NULL;
    murk_status status =
        radius || from->radius < 0
            ? read_frame(r, from->first, frame, value)
            : murk_no_memory(r->err, r->request->where, "for a field");
    if (!status && radius) {
        status = read_frame(r, from->radius, frame, radius);
    }
    if (!status) {
        status = convert(r, from, value, radius, n);
    }
    free(radius);
    return status;
}

/* The frames around the time, and the weight of the later. */
static murk_status choose_frames(const reader *r, size_t frame[2],
                                 double *weight)
{
    const axis *time = &r->axis[TIME];
    const double asked = r->request->asked.time_s;
    frame[0] = frame[1] = 0;
    *weight = 0;
    if (!time->at) {
        return asked == 0 ? MURK_OK
                          : bad(r, MURK_BAD_VALUE,
                                "time_s must be 0 or left out: the field has "
                                "no time",
                                NULL);
    }
    /* Times after the first. */
    const double t = time->at[0] + asked, last = time->at[time->n - 1];
    const double same = 1e-9 * fmax(1, fabs(last));
    if (!(t >= time->at[0] - same && t <= last + same)) {
        return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                         "time_s is %.9g s, must be 0 to %.9g s, after the "
                         "first of %zu times",
                         asked, last - time->at[0], time->n);
    }
    while (frame[0] + 1 < time->n && time->at[frame[0] + 1] <= t + same) {
        ++frame[0];
    }
    frame[1] = frame[0];
    if (frame[0] + 1 < time->n && t > time->at[frame[0]] + same) {
        ++frame[1];
        *weight = (t - time->at[frame[0]]) /
                  (time->at[frame[1]] - time->at[frame[0]]);
    }
    /* Falling times were turned round. */
    for (int i = 0; i < 2 && time->is_falling; ++i) {
        frame[i] = time->n - 1 - frame[i];
    }
    return MURK_OK;
}

static murk_status read_values(reader *r, const sources *from,
                               murk_field_block *block, murk_field_head *head)
{
    const size_t n = r->axis[X].n * r->axis[Y].n * r->axis[Z].n;
    size_t frame[2];
    double weight;
    murk_status status = choose_frames(r, frame, &weight);
    double *value = malloc(n * sizeof *value);
    double *later = weight > 0 ? malloc(n * sizeof *later) : NULL;
    block->value = malloc(n * sizeof *block->value);
    if (!status && (!value || !block->value || (weight > 0 && !later))) {
        status = murk_no_memory(r->err, r->request->where, "for a field");
    }
    if (!status) {
        status = read_extinction(r, from, frame[0], value, n);
    }
    if (!status && later) {
        status = read_extinction(r, from, frame[1], later, n);
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
    if (r->axis[TIME].at) {
        snprintf(head->note, sizeof head->note, "%.60s; %s %zu of %zu",
                 r->request->asked.variable ? "a factor" : "3 L / (2 r)",
                 weight > 0 ? "between two times from" : "time", frame[0] + 1,
                 r->axis[TIME].n);
    } else {
        snprintf(head->note, sizeof head->note, "%s",
                 r->request->asked.variable ? "a factor" : "3 L / (2 r)");
    }
    if (r->missing > 0) {
        snprintf(head->warning, sizeof head->warning,
                 "%zu values are missing in the file and count as 0",
                 r->missing);
    }
    return status;
}

/* ---- the block ---- */

/* The grid lines along an axis. Values at nodes: the coordinates. Values of
 * cells: the bounds, or the middles between coordinates, with cells of the same
 * length on both sides of the first and last coordinate. */
static murk_status set_edges(const reader *r, int which, bool has_nodes,
                             murk_field_block *block)
{
    const axis *a = &r->axis[which];
    const size_t n = a->n;
    double *edge = block->edge[which] = malloc((n + 1) * sizeof *edge);
    if (!edge) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    block->cells[which] = has_nodes ? n - 1 : n;
    if (has_nodes) {
        memcpy(edge, a->at, n * sizeof *edge);
        return n > 1 ? MURK_OK
                     : bad(r, MURK_BAD_VALUE,
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
            return bad(r, MURK_BAD_FILE,
                       "bounds of cells with gaps or overlaps", NULL);
        }
        edge[i] = i > 0 ? edge[i] : low;
        edge[i + 1] = high;
    }
    return MURK_OK;
}

static murk_status read_open(reader *r, murk_field_head *head,
                             murk_field_block *block)
{
    sources from;
    const bool has_nodes = r->request->asked.is_linear;
    murk_status status = find_sources(r, &from);
    if (!status) {
        status = read_axes(r, from.first);
    }
    if (!status &&
        r->axis[X].n > MURK_FIELD_VALUES_MAX / r->axis[Y].n / r->axis[Z].n) {
        status = bad(r, MURK_BAD_FILE, "has more than 2^31 values", NULL);
    }
    block->has_nodes = has_nodes;
    for (int i = X; i <= Z && !status; ++i) {
        status = set_edges(r, i, has_nodes, block);
    }
    return status ? status : read_values(r, &from, block, head);
}

murk_status murk_netcdf_read(murk_field_head *head, murk_field_block *block,
                             const murk_netcdf_request *request,
                             murk_error *err)
{
    murk_error own = {0};
    reader r = {.request = request, .err = err ? err : &own};
    for (int i = 0; i < AXES; ++i) {
        r.axis[i].dimension = -1;
    }
    /* A path such as http://... would make the library ask a server. */
    struct stat facts;
    if (stat(request->path, &facts) != 0 || !S_ISREG(facts.st_mode) ||
        strstr(request->path, "://") || strchr(request->path, '#')) {
        return bad(&r, MURK_BAD_FILE, "is no file that can be read", NULL);
    }
    const int opened = nc_open(request->path, NC_NOWRITE, &r.file);
    if (opened != NC_NOERR) {
        return murk_fail(r.err, MURK_BAD_FILE, request->where,
                         "is no NetCDF file that can be read: %s",
                         nc_strerror(opened));
    }
    const murk_status status = read_open(&r, head, block);
    nc_close(r.file);
    for (int i = 0; i < AXES; ++i) {
        free(r.axis[i].at);
        free(r.axis[i].bound);
    }
    return status;
}
