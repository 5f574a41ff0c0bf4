/* Variables, numbers and axes of a NetCDF file (netcdf/variables.h): attributes
 * with units and packing, and coordinate variables with their bounds. */
#include "netcdf/variables.h"

#include "base/field_blocks.h"

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_SIZE 256 /* of attributes that are looked at */

/* Values of missing_value that are looked at: a choice. */
#define MISSING_MAX 16

murk_status murk_netcdf_bad(const murk_netcdf_reader *r, murk_status status,
                            const char *text, const char *name)
{
    return murk_fail(r->err, status, r->request->where, "%s%.80s",
                     name ? name : "", text);
}

/* ---- attributes ---- */

/* A text attribute; empty if there is none or it is longer. */
static void get_text(const murk_netcdf_reader *r, int variable,
                     const char *name, char out[TEXT_SIZE])
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
static double get_number(const murk_netcdf_reader *r, int variable,
                         const char *name, double otherwise)
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

/* Writes a unit in the form of the tables: without blanks around it and without
 * signs of powers, as in "kg m-3" for " kg m**-3". */
static void simplify_unit(const char *unit, char out[TEXT_SIZE])
{
    size_t n = 0;
    for (; *unit && n + 1 < TEXT_SIZE; ++unit) {
        const bool is_dropped =
            *unit == '^' || *unit == '*' || (n == 0 && *unit == ' ');
        if (!is_dropped) {
            out[n++] = *unit;
        }
    }
    while (n > 0 && out[n - 1] == ' ') {
        --n;
    }
    out[n] = '\0';
}

/* The factor of a unit in a table that ends with NULL; 0: not in the table. */
static double factor_of(const murk_netcdf_unit *table, const char *unit)
{
    char name[TEXT_SIZE];
    simplify_unit(unit, name);
    while (table->name && strcmp(table->name, name) != 0) {
        ++table;
    }
    return table->name ? table->factor : 0;
}

static const murk_netcdf_unit lengths[] = {
    {"m", 1},      {"metre", 1}, {"meter", 1},        {"metres", 1},
    {"meters", 1}, {"km", 1000}, {"kilometer", 1000}, {"kilometre", 1000},
    {NULL, 0}};
/* Of X and Y as CF names them (4.1 and 4.2). */
static const murk_netcdf_unit degrees[2][7] = {{{"degrees_east", 1},
                                                {"degree_east", 1},
                                                {"degrees_E", 1},
                                                {"degree_E", 1},
                                                {"degreesE", 1},
                                                {"degreeE", 1},
                                                {NULL, 0}},
                                               {{"degrees_north", 1},
                                                {"degree_north", 1},
                                                {"degrees_N", 1},
                                                {"degree_N", 1},
                                                {"degreesN", 1},
                                                {"degreeN", 1},
                                                {NULL, 0}}};
static const murk_netcdf_unit times[] = {
    {"seconds", 1}, {"second", 1},   {"s", 1},        {"minutes", 60},
    {"minute", 60}, {"min", 60},     {"hours", 3600}, {"hour", 3600},
    {"h", 3600},    {"days", 86400}, {"day", 86400},  {"d", 86400},
    {NULL, 0}};

/* ---- variables ---- */

/* Lists the variables of three or more dimensions, for messages. */
static void list_variables(const murk_netcdf_reader *r, char *out, size_t size)
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

static murk_status no_variable(const murk_netcdf_reader *r, const char *wanted)
{
    char list[1024];
    list_variables(r, list, sizeof list);
    return murk_fail(r->err, MURK_BAD_VALUE, r->request->where,
                     "has no variable %.80s; fields in it: %s", wanted,
                     list[0] ? list : "none");
}

murk_status murk_netcdf_find_variable(const murk_netcdf_reader *r,
                                      const char *name, const char *standard,
                                      int *out)
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

murk_status murk_netcdf_unit_of(const murk_netcdf_reader *r, int variable,
                                const murk_netcdf_unit *table, double *factor)
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

/* ---- numbers ---- */

/* How the numbers of a variable are stored. */
typedef struct packing {
    double scale, offset;
    double
        fill; /* NAN: none; the default of the type, if the file has no other */
    double low, high; /* valid values, before they are unpacked */
    double missing[MISSING_MAX];
    size_t n_missing;
    double turn; /* added to negative numbers, which are unsigned ones that the
                    type of the file cannot have; 0: none */
} packing;

/* The turn of a variable. Files in the classic format have no unsigned types,
 * and mark them by an attribute (NetCDF users' guide, "Best practices"). */
static double turn_of(const murk_netcdf_reader *r, int variable)
{
    char text[TEXT_SIZE];
    nc_type type = NC_NAT;
    get_text(r, variable, "_Unsigned", text);
    nc_inq_vartype(r->file, variable, &type);
    return strcmp(text, "true") != 0 && strcmp(text, "True") != 0 ? 0
           : type == NC_BYTE                                      ? 0x1p8
           : type == NC_SHORT                                     ? 0x1p16
           : type == NC_INT                                       ? 0x1p32
                                                                  : 0;
}

static double turned(double value, double turn)
{
    return value < 0 && turn > 0 && value > -INFINITY ? value + turn : value;
}

/* The fill value of a variable: that of the file, or the default of the library
 * for the type; bytes and texts have none. */
static double fill_of(const murk_netcdf_reader *r, int variable)
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

static packing packing_of(const murk_netcdf_reader *r, int variable)
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
    /* All of them as the file has them, until here. */
    p.turn = turn_of(r, variable);
    p.fill = turned(p.fill, p.turn);
    p.low = turned(p.low, p.turn);
    p.high = turned(p.high, p.turn);
    for (size_t i = 0; i < p.n_missing; ++i) {
        p.missing[i] = turned(p.missing[i], p.turn);
    }
    return p;
}

void murk_netcdf_unpack_values(const murk_netcdf_reader *r, int variable,
                               double *value, size_t n)
{
    const packing p = packing_of(r, variable);
    for (size_t i = 0; i < n; ++i) {
        const double v = turned(value[i], p.turn);
        bool is_there = isfinite(v) && v != p.fill && v >= p.low && v <= p.high;
        for (size_t k = 0; k < p.n_missing; ++k) {
            is_there = is_there && v != p.missing[k];
        }
        value[i] = is_there ? v * p.scale + p.offset : NAN;
    }
}

/* ---- axes ---- */

/* The axis that a coordinate variable belongs to; -1 if it does not say. */
static int axis_of(const murk_netcdf_reader *r, int variable, const char *name)
{
    static const char *const letters[MURK_NETCDF_AXES] = {"X", "Y", "Z", "T"};
    static const struct {
        const char *standard;
        int axis;
    } names[] = {{"projection_x_coordinate", MURK_NETCDF_X},
                 {"projection_y_coordinate", MURK_NETCDF_Y},
                 {"longitude", MURK_NETCDF_X},
                 {"latitude", MURK_NETCDF_Y},
                 {"altitude", MURK_NETCDF_Z},
                 {"height", MURK_NETCDF_Z},
                 {"height_above_mean_sea_level", MURK_NETCDF_Z},
                 {"height_above_reference_ellipsoid", MURK_NETCDF_Z},
                 {"depth", MURK_NETCDF_Z},
                 {"time", MURK_NETCDF_TIME}};
    char text[TEXT_SIZE];
    get_text(r, variable, "axis", text);
    for (int i = 0; i < MURK_NETCDF_AXES; ++i) {
        if (strcmp(text, letters[i]) == 0) {
            return i;
        }
    }
    get_text(r, variable, "units", text);
    if (strstr(text, " since ")) {
        return MURK_NETCDF_TIME;
    }
    for (int i = MURK_NETCDF_X; i <= MURK_NETCDF_Y; ++i) {
        if (factor_of(degrees[i], text) > 0) {
            return i;
        }
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

/* The factor from the unit of an axis to metres, degrees or seconds. */
static murk_status find_factor(const murk_netcdf_reader *r, int variable,
                               int which, const char *name, double *factor,
                               bool *is_degrees)
{
    char text[TEXT_SIZE], word[TEXT_SIZE];
    get_text(r, variable, "units", text);
    snprintf(word, sizeof word, "%s", text);
    if (which == MURK_NETCDF_TIME) {
        word[strcspn(word, " ")] = '\0';
    }
    *factor = factor_of(which == MURK_NETCDF_TIME ? times : lengths, word);
    /* Degrees go with X and Y alone. */
    *is_degrees = which <= MURK_NETCDF_Y && factor_of(degrees[which], word) > 0;
    if (*is_degrees) {
        *factor = 1;
    }
    if (*factor > 0) {
        return MURK_OK;
    }
    return murk_fail(
        r->err, MURK_BAD_VALUE, r->request->where,
        "axis %.60s has the unit \"%.60s\", must be %s", name, text,
        which == MURK_NETCDF_TIME ? "seconds, minutes, hours or days since"
        : which == MURK_NETCDF_Z
            ? "m or km: levels of another kind must be converted to heights "
              "before"
            : "m, km, or degrees_east and degrees_north: other coordinates "
              "must be projected before");
}

/* Fails for a dimension that has no coordinates of its own. */
static murk_status no_coordinates(const murk_netcdf_reader *r, int dimension,
                                  const char *name)
{
    int n = 0;
    nc_inq_nvars(r->file, &n);
    for (int i = 0; i < n; ++i) {
        int dimensions = 0, own[2] = {-1, -1};
        char unit[TEXT_SIZE];
        if (nc_inq_varndims(r->file, i, &dimensions) != NC_NOERR ||
            dimensions != 2 || nc_inq_vardimid(r->file, i, own) != NC_NOERR) {
            continue;
        }
        /* Longitudes or latitudes along two dimensions. */
        get_text(r, i, "units", unit);
        if ((own[0] == dimension || own[1] == dimension) &&
            (factor_of(degrees[MURK_NETCDF_X], unit) > 0 ||
             factor_of(degrees[MURK_NETCDF_Y], unit) > 0)) {
            return murk_fail(
                r->err, MURK_BAD_FILE, r->request->where,
                "%.60s: dimension of a curvilinear grid, with longitudes and "
                "latitudes over two dimensions: must be brought to axes of "
                "one before (cdo remapbil)",
                name);
        }
    }
    return murk_netcdf_bad(r, MURK_BAD_FILE,
                           ": dimension without a variable of its name that "
                           "has its coordinates",
                           name);
}

/* Makes longitudes and their bounds go on beyond 180 or 360 degrees, in the
 * order of the file. */
static void join_longitudes(murk_netcdf_axis *a)
{
    for (size_t i = 0; i < a->n; ++i) {
        if (i > 0) {
            a->at[i] = a->at[i - 1] + remainder(a->at[i] - a->at[i - 1], 360);
        }
        for (size_t k = 2 * i; a->bound && k < 2 * i + 2; ++k) {
            a->bound[k] = a->at[i] + remainder(a->bound[k] - a->at[i], 360);
        }
    }
}

/* Reads the bounds of cells of an axis, if it has any (CF 7.1). */
static murk_status read_bounds(const murk_netcdf_reader *r, int variable,
                               double factor, murk_netcdf_axis *a)
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
        return murk_netcdf_bad(r, MURK_BAD_FILE, ": bounds of another size",
                               name);
    }
    a->bound = malloc(2 * a->n * sizeof *a->bound);
    if (!a->bound) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    if (nc_get_var_double(r->file, bounds, a->bound) != NC_NOERR) {
        return murk_netcdf_bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    /* Bounds without packing of their own have that of the coordinates. */
    size_t length_of_scale = 0;
    const bool is_packed = nc_inq_attlen(r->file, bounds, "scale_factor",
                                         &length_of_scale) == NC_NOERR;
    murk_netcdf_unpack_values(r, is_packed ? bounds : variable, a->bound,
                              2 * a->n);
    for (size_t i = 0; i < 2 * a->n; ++i) {
        a->bound[i] *= factor;
    }
    return MURK_OK;
}

/* Checks that coordinates rise or fall; those that fall are turned round. */
static murk_status order_axis(const murk_netcdf_reader *r, const char *name,
                              murk_netcdf_axis *a)
{
    bool rises = isfinite(a->at[0]), falls = rises;
    for (size_t i = 1; i < a->n; ++i) {
        rises = rises && a->at[i] > a->at[i - 1];
        falls = falls && a->at[i] < a->at[i - 1];
    }
    if (!rises && !falls) {
        return murk_netcdf_bad(r, MURK_BAD_FILE,
                               ": coordinates must rise or fall", name);
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
static bool points_down(const murk_netcdf_reader *r, int variable)
{
    char positive[TEXT_SIZE], name[TEXT_SIZE];
    get_text(r, variable, "positive", positive);
    get_text(r, variable, "standard_name", name);
    return positive[0] ? strcmp(positive, "down") == 0
                       : strcmp(name, "depth") == 0;
}

/* True if the heights of the vertical axis count from the sea, by their
 * standard name. */
static bool counts_from_sea(const murk_netcdf_reader *r, int variable)
{
    char name[TEXT_SIZE];
    get_text(r, variable, "standard_name", name);
    return strcmp(name, "altitude") == 0 ||
           strcmp(name, "height_above_mean_sea_level") == 0 ||
           strcmp(name, "height_above_reference_ellipsoid") == 0;
}

/* Reads the coordinate variable of a dimension. */
static murk_status read_axis(murk_netcdf_reader *r, int dimension)
{
    char name[NC_MAX_NAME + 1];
    size_t n = 0;
    int variable = 0, dimensions = 0, own = 0;
    nc_inq_dim(r->file, dimension, name, &n);
    const bool has_own =
        nc_inq_varid(r->file, name, &variable) == NC_NOERR &&
        nc_inq_varndims(r->file, variable, &dimensions) == NC_NOERR &&
        dimensions == 1 &&
        nc_inq_vardimid(r->file, variable, &own) == NC_NOERR &&
        own == dimension;
    const int which = has_own ? axis_of(r, variable, name) : -1;
    /* Such as the one member of an ensemble. */
    if (n == 1 && which < 0) {
        return MURK_OK;
    }
    if (!has_own) {
        return no_coordinates(r, dimension, name);
    }
    if (which < 0 || r->axis[which].at || n == 0 || n > MURK_FIELD_CELLS_MAX) {
        return murk_netcdf_bad(
            r, MURK_BAD_FILE,
            ": is none of the axes X, Y, Z and T, or one of them twice", name);
    }
    /* Coordinates in metres, degrees or seconds, and bounds. */
    murk_netcdf_axis *a = &r->axis[which];
    double factor = 0;
    *a = (murk_netcdf_axis){.dimension = dimension,
                            .n = n,
                            .length = n,
                            .cycle = n,
                            .at = malloc(n * sizeof *a->at)};
    if (!a->at) {
        return murk_no_memory(r->err, r->request->where, "for an axis");
    }
    murk_status status =
        find_factor(r, variable, which, name, &factor, &a->is_degrees);
    if (!status && nc_get_var_double(r->file, variable, a->at) != NC_NOERR) {
        status = murk_netcdf_bad(r, MURK_BAD_FILE, ": cannot be read", name);
    }
    if (!status) {
        murk_netcdf_unpack_values(r, variable, a->at, n);
        factor *= which == MURK_NETCDF_Z && points_down(r, variable) ? -1 : 1;
        a->is_above_sea =
            which == MURK_NETCDF_Z && counts_from_sea(r, variable);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        a->at[i] *= factor;
    }
    if (!status && which != MURK_NETCDF_TIME) {
        status = read_bounds(r, variable, factor, a);
    }
    if (!status && a->is_degrees && which == MURK_NETCDF_X) {
        join_longitudes(a);
    }
    return status ? status : order_axis(r, name, a);
}

murk_status murk_netcdf_read_axes(murk_netcdf_reader *r, int variable)
{
    int n = 0, dimension[NC_MAX_VAR_DIMS];
    char name[NC_MAX_NAME + 1];
    nc_inq_var(r->file, variable, name, NULL, &n, dimension, NULL);
    if (n < 3 || n > MURK_NETCDF_DIMENSIONS) {
        return murk_netcdf_bad(r, MURK_BAD_FILE,
                               ": must have the axes X, Y and Z, and T at most",
                               name);
    }
    /* Each axis, then the three that must be there. */
    murk_status status = MURK_OK;
    for (int i = 0; i < n && !status; ++i) {
        status = read_axis(r, dimension[i]);
    }
    for (int i = MURK_NETCDF_X; i <= MURK_NETCDF_Z && !status; ++i) {
        if (!r->axis[i].at) {
            status = murk_netcdf_bad(r, MURK_BAD_FILE,
                                     ": misses one of X, Y and Z", name);
        } else if (r->axis[i].n < 2 && !r->axis[i].bound) {
            status = murk_netcdf_bad(
                r, MURK_BAD_FILE,
                ": one coordinate along an axis, and no bounds", name);
        }
    }
    return status;
}

void murk_netcdf_release_axes(murk_netcdf_reader *r)
{
    for (int i = 0; i < MURK_NETCDF_AXES; ++i) {
        free(r->axis[i].at);
        free(r->axis[i].bound);
        r->axis[i] = (murk_netcdf_axis){.dimension = -1};
    }
}
