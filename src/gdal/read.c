/* Reads GeoTIFF files with the library GDAL (gdal/read.h).
 *
 * The projection of the file is inverted by PROJ, through GDAL; the local frame
 * is that of terrain/local_frame.h. Heights pass through unit, scale and offset
 * of the band; masks and values for missing heights make them NAN. */
#include "gdal/read.h"

#include "base/vector.h"
#include "terrain/height_mesh.h"
#include "terrain/units.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <math.h>
#include <ogr_srs_api.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/* Heights outside of this range are mistakes: the deepest sea has 10,935 m
 * (Greenaway and others 2021, doi:10.1016/j.dsr.2021.103644), the highest
 * mountain 8849 m, and systems differ by some 100 m. */
#define LOWEST_M  -12000
#define HIGHEST_M 9000

/* Rows that are read at a time: a choice, few calls and little memory. */
#define ROWS 64

/* Memory for blocks of the file [bytes], of the 2 GB that a reader may use. */
#define BLOCK_MEMORY 64000000

/* Points on each side of a box that is converted to columns and rows. Between
 * them the side is straight within 1/64^2 of its bend, which the line added at
 * each border of the window covers. */
#define SIDE_POINTS 33

struct murk_gdal_file {
    const murk_geotiff_request *request;
    GDALDatasetH data;
    GDALRasterBandH band;
    GDALRasterBandH alpha; /* 0: no height there; NULL: there is none */
    double to_system[6], to_pixel[6]; /* corners of pixels and coordinates of
                                       * the file's system */
    size_t columns, rows;
    double turn; /* of longitude in the file's system; 0: it has none */
    OGRCoordinateTransformationH to_earth, from_earth;
    double unit_m, scale, offset;
    bool is_depth; /* heights count downwards */
    bool has_mask, has_nodata;
    char unit_from[sizeof((murk_terrain_facts *)0)->unit_from];
    char crs[sizeof((murk_terrain_facts *)0)->crs];
};

static murk_status bad(const murk_gdal_file *f, murk_error *err,
                       const char *text)
{
    return murk_fail(err, MURK_BAD_FILE, f->request->where, "%s", text);
}

/* Adds the reason that the library gives, in one line. */
static murk_status bad_by(const murk_gdal_file *f, murk_error *err,
                          const char *text)
{
    char why[160];
    snprintf(why, sizeof why, "%s", CPLGetLastErrorMsg());
    for (char *c = why; *c; ++c) {
        *c = (unsigned char)*c < ' ' ? ' ' : *c;
    }
    return murk_fail(err, MURK_BAD_FILE, f->request->where, "%s%s%s", text,
                     why[0] ? ": " : "", why);
}

void murk_gdal_begin(void)
{
    static const char *const options[][2] = {
        {"GDAL_PAM_ENABLED", "NO"}, /* FILE.aux.xml */
        {"GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR"},
        {"GDAL_GEOREF_SOURCES", "INTERNAL"},
        {"GDAL_NUM_THREADS", "1"},
        {"GTIFF_POINT_GEO_IGNORE", "NO"},
        {"CPL_TMPDIR", "/nonexistent"}};
    for (size_t i = 0; i < sizeof options / sizeof *options; ++i) {
        CPLSetConfigOption(options[i][0], options[i][1]);
    }
    CPLPushErrorHandler(CPLQuietErrorHandler);
    OSRSetPROJEnableNetwork(0);
    GDALSetCacheMax64(BLOCK_MEMORY);
    GDALRegister_GTiff();
}

/* ---- opening ---- */

typedef struct unit {
    const char *name;
    double m;
} unit;

/* Names of units as files have them. */
static const unit units[] = {{"m", 1},
                             {"metre", 1},
                             {"meter", 1},
                             {"metres", 1},
                             {"meters", 1},
                             {"cm", 0.01},
                             {"centimetre", 0.01},
                             {"centimeter", 0.01},
                             {"centimetres", 0.01},
                             {"centimeters", 0.01},
                             {"dm", 0.1},
                             {"mm", 0.001},
                             {"ft", MURK_FOOT_M},
                             {"foot", MURK_FOOT_M},
                             {"feet", MURK_FOOT_M},
                             {"us-ft", MURK_US_FOOT_M},
                             {"ftUS", MURK_US_FOOT_M},
                             {"US survey foot", MURK_US_FOOT_M},
                             {NULL, 0}};

/* Coordinates are in metres if their unit is this close to one: a choice. */
#define NOT_METRES 1e-6

/* The unit of heights: that of the request, of the band, or of the vertical
 * part of the system; otherwise metres, if coordinates are in metres or
 * degrees. */
static murk_status find_unit(murk_gdal_file *f, OGRSpatialReferenceH system,
                             murk_error *err)
{
    const char *name = GDALGetRasterUnitType(f->band);
    const char *from = "none";
    f->unit_m = 1;
    /* The request comes before the file. */
    if (f->request->asked.unit_m > 0) {
        f->unit_m = f->request->asked.unit_m;
        from = "key";
    } else if (name && name[0]) {
        /* A name that is not in the table is not taken for metres. */
        const unit *known = units;
        while (known->name && strcasecmp(known->name, name) != 0) {
            ++known;
        }
        if (!known->name) {
            char shown[64];
            snprintf(shown, sizeof shown, "%.40s", name);
            for (char *c = shown; *c; ++c) {
                *c = (unsigned char)*c < ' ' ? '?' : *c;
            }
            return murk_fail(err, MURK_BAD_FILE, f->request->where,
                             "has heights in \"%s\", which is no unit that "
                             "murk knows: height_unit must be given",
                             shown);
        }
        f->unit_m = known->m;
        from = "band";
    } else if (OSRIsVertical(system)) {
        f->unit_m = OSRGetTargetLinearUnits(system, "VERT_CS", NULL);
        from = "CRS";
    } else if (OSRIsProjected(system) &&
               fabs(OSRGetLinearUnits(system, NULL) - 1) > NOT_METRES) {
        return murk_fail(err, MURK_BAD_FILE, f->request->where,
                         "has coordinates in units of %.7g m and states no "
                         "unit of heights: height_unit must be given",
                         OSRGetLinearUnits(system, NULL));
    }
    if (OSRIsVertical(system)) {
        OGRAxisOrientation up = OAO_Up;
        OSRGetAxis(system, "VERT_CS", 0, &up);
        f->is_depth = up == OAO_Down;
    }
    snprintf(f->unit_from, sizeof f->unit_from, "%s", from);
    return f->unit_m > 0 && isfinite(f->unit_m)
               ? MURK_OK
               : bad(f, err,
                     "has a vertical system without unit: height_unit "
                     "must be given");
}

/* The transformations between the horizontal part of the system and WGS84. */
static murk_status find_transformations(murk_gdal_file *f,
                                        OGRSpatialReferenceH system,
                                        murk_error *err)
{
    OGRSpatialReferenceH flat = OSRClone(system),
                         earth = OSRNewSpatialReference(NULL);
    bool is_made =
        flat && earth && OSRSetWellKnownGeogCS(earth, "WGS84") == OGRERR_NONE;
    if (is_made && OSRIsCompound(flat)) {
        is_made = OSRStripVertical(flat) == OGRERR_NONE;
    }
    if (is_made) {
        OSRSetAxisMappingStrategy(flat, OAMS_TRADITIONAL_GIS_ORDER);
        OSRSetAxisMappingStrategy(earth, OAMS_TRADITIONAL_GIS_ORDER);
        f->to_earth = OCTNewCoordinateTransformation(flat, earth);
        f->from_earth = OCTNewCoordinateTransformation(earth, flat);
    }
    OSRDestroySpatialReference(flat);
    OSRDestroySpatialReference(earth);
    return f->to_earth && f->from_earth
               ? MURK_OK
               : bad_by(f, err,
                        "has a coordinate reference system that cannot "
                        "be converted to longitude and latitude");
}

static murk_status find_system(murk_gdal_file *f, murk_error *err)
{
    const OGRSpatialReferenceH system = GDALGetSpatialRef(f->data);
    if (GDALGetGeoTransform(f->data, f->to_system) != CE_None ||
        !GDALInvGeoTransform(f->to_system, f->to_pixel)) {
        return bad(f, err,
                   "does not say where its pixels lie (a GeoTIFF "
                   "transform), must be georeferenced");
    }
    for (int i = 0; i < 6; ++i) {
        if (!isfinite(f->to_system[i]) || !isfinite(f->to_pixel[i])) {
            return bad(f, err, "has a transform that is not finite");
        }
    }
    if (!system || !(OSRIsProjected(system) || OSRIsGeographic(system))) {
        return bad(f, err,
                   "has no coordinate reference system on the earth, "
                   "must state one (gdal_edit.py -a_srs EPSG:NUMBER)");
    }
    const char *name = OSRGetName(system);
    snprintf(f->crs, sizeof f->crs, "%s", name ? name : "");
    if (OSRIsGeographic(system)) {
        f->turn = 2 * MURK_PI / OSRGetAngularUnits(system, NULL);
    }
    /* Facts alone need no unit. */
    const murk_status status =
        f->request->asked.has_frame ? find_unit(f, system, err) : MURK_OK;
    return status ? status : find_transformations(f, system, err);
}

static murk_status find_size(murk_gdal_file *f, murk_error *err)
{
    f->columns = (size_t)GDALGetRasterXSize(f->data);
    f->rows = (size_t)GDALGetRasterYSize(f->data);
    return f->columns >= 2 && f->rows >= 2
               ? MURK_OK
               : murk_fail(
                     err, MURK_BAD_FILE, f->request->where,
                     "has %zu by %zu pixels, must be 2 or more on each side",
                     f->columns, f->rows);
}

static murk_status find_band(murk_gdal_file *f, murk_error *err)
{
    const int bands = GDALGetRasterCount(f->data);
    const uint64_t asked = f->request->asked.band, band = asked ? asked : 1;
    if (band > (uint64_t)bands) {
        return murk_fail(err, MURK_BAD_VALUE, f->request->where,
                         "band is %llu, must be 1..%d",
                         (unsigned long long)band, bands);
    }
    f->band = GDALGetRasterBand(f->data, (int)band);
    if (!f->band || GDALDataTypeIsComplex(GDALGetRasterDataType(f->band)) ||
        GDALGetRasterColorInterpretation(f->band) == GCI_AlphaBand) {
        return bad(f, err, "has no heights in that band");
    }
    /* Colours are heights only if the request says so. */
    const GDALColorInterp colour = GDALGetRasterColorInterpretation(f->band);
    if (asked == 0 && colour != GCI_Undefined && colour != GCI_GrayIndex) {
        return murk_fail(err, MURK_BAD_FILE, f->request->where,
                         "is a picture: its first band is \"%s\"; band must "
                         "be given if that has heights",
                         GDALGetColorInterpretationName(colour));
    }
    /* Scale and offset, and missing values. */
    int has = 0;
    f->scale = GDALGetRasterScale(f->band, &has);
    f->scale = has ? f->scale : 1;
    f->offset = GDALGetRasterOffset(f->band, &has);
    f->offset = has ? f->offset : 0;
    if (!(fabs(f->scale) > 0 && isfinite(f->scale) && isfinite(f->offset))) {
        return bad(f, err, "has a scale or an offset that is no number");
    }
    /* The library's mask has alpha bands of some types alone. */
    for (int i = 1; i <= bands; ++i) {
        const GDALRasterBandH other = GDALGetRasterBand(f->data, i);
        if (GDALGetRasterColorInterpretation(other) == GCI_AlphaBand) {
            f->alpha = other;
        }
    }
    f->has_mask = !(GDALGetMaskFlags(f->band) & GMF_ALL_VALID);
    GDALGetRasterNoDataValue(f->band, &has);
    f->has_nodata = has || f->request->asked.has_nodata;
    return MURK_OK;
}

/* Paths that the library takes for something else than a file. */
static bool is_plain(const char *path)
{
    struct stat is;
    return stat(path, &is) == 0 && S_ISREG(is.st_mode) &&
           strncmp(path, "/vsi", 4) != 0 && !strstr(path, "://") &&
           strncmp(path, "GTIFF_", 6) != 0 && path[0] != '<';
}

murk_status murk_gdal_open(murk_gdal_file **out,
                           const murk_geotiff_request *request, murk_error *err)
{
    static const char *const drivers[] = {"GTiff", NULL};
    murk_gdal_file *f = calloc(1, sizeof *f);
    if (!f) {
        return murk_no_memory(err, request->where, "for a file");
    }
    f->request = request;
    murk_status status = MURK_OK;
    /* The file, then its parts. */
    if (!is_plain(request->path)) {
        status = bad(f, err, "is no file that can be read");
    }
    if (!status) {
        CPLErrorReset();
        f->data = GDALOpenEx(
            request->path, GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_INTERNAL,
            drivers, NULL, NULL);
        status = f->data
                     ? MURK_OK
                     : bad_by(f, err, "is no GeoTIFF file that can be read");
    }
    if (!status) {
        status = find_size(f, err);
    }
    if (!status && request->asked.has_frame) {
        status = find_band(f, err);
    }
    if (!status) {
        status = find_system(f, err);
    }
    if (status) {
        murk_gdal_close(f);
        return status;
    }
    *out = f;
    return MURK_OK;
}

void murk_gdal_close(murk_gdal_file *f)
{
    if (f) {
        if (f->to_earth) {
            OCTDestroyCoordinateTransformation(f->to_earth);
        }
        if (f->from_earth) {
            OCTDestroyCoordinateTransformation(f->from_earth);
        }
        if (f->data) {
            GDALClose(f->data);
        }
        free(f);
    }
}

/* ---- places ---- */

/* Converts columns and rows to longitudes and latitudes. */
static murk_status to_earth(const murk_gdal_file *f, double *x, double *y,
                            size_t n, murk_error *err)
{
    const double *t = f->to_system;
    for (size_t i = 0; i < n; ++i) {
        /* The middle of the pixel (0, 0) is at (0.5, 0.5) of its corners. */
        const double c = x[i] + 0.5, r = y[i] + 0.5;
        x[i] = t[0] + c * t[1] + r * t[2];
        y[i] = t[3] + c * t[4] + r * t[5];
    }
    /* The library counts points by int. */
    const size_t block = 1 << 20;
    for (size_t i = 0; i < n; i += block) {
        const size_t some = n - i < block ? n - i : block;
        CPLErrorReset();
        if (!OCTTransform(f->to_earth, (int)some, x + i, y + i, NULL)) {
            return bad_by(f, err, "has pixels that lie nowhere on the earth");
        }
    }
    for (size_t i = 0; i < n; ++i) {
        if (!(fabs(x[i]) <= 720 && fabs(y[i]) <= 90)) {
            return bad(f, err, "has pixels that lie nowhere on the earth");
        }
    }
    return MURK_OK;
}

static murk_status to_frame(const murk_gdal_file *f,
                            const murk_local_frame *frame, double *x, double *y,
                            size_t n, murk_error *err)
{
    murk_status status = to_earth(f, x, y, n, err);
    for (size_t i = 0; i < n && !status; ++i) {
        double at[2];
        if (murk_local_from_geographic(frame, y[i], x[i], at)) {
            x[i] = at[0];
            y[i] = at[1];
        } else {
            status = murk_fail(err, MURK_BAD_FILE, f->request->where,
                               "has a pixel at longitude %.6f, latitude %.6f "
                               "degrees, must be within %.0f km of the site",
                               x[i], y[i], MURK_LOCAL_MAX_M / 1000);
        }
    }
    return status;
}

murk_status murk_gdal_places(const murk_gdal_file *f, double *x, double *y,
                             size_t n, murk_error *err)
{
    return to_frame(f, &f->request->asked.frame, x, y, n, err);
}

murk_status murk_gdal_facts(const murk_gdal_file *f, murk_terrain_facts *out,
                            murk_error *err)
{
    *out = (murk_terrain_facts){.columns = f->columns,
                                .rows = f->rows,
                                .unit_m = f->unit_m,
                                .is_depth = f->is_depth};
    memcpy(out->unit_from, f->unit_from, sizeof out->unit_from);
    memcpy(out->crs, f->crs, sizeof out->crs);
    /* The middle, and steps of one column and one row there. */
    const double c = ((double)f->columns - 1) / 2,
                 r = ((double)f->rows - 1) / 2;
    double x[3] = {c, c + 0.5, c}, y[3] = {r, r, r + 0.5}, longitude = c,
           latitude = r;
    murk_status status = to_earth(f, &longitude, &latitude, 1, err);
    if (status) {
        return status;
    }
    out->longitude_deg = remainder(longitude, 360);
    out->latitude_deg = latitude;
    const murk_local_frame frame =
        murk_local_frame_at(latitude, longitude, 0, 1);
    status = to_frame(f, &frame, x, y, 3, err);
    for (int i = 0; i < 2 && !status; ++i) {
        out->spacing_m[i] = 2 * hypot(x[1 + i] - x[0], y[1 + i] - y[0]);
    }
    return status;
}

/* ---- the part that is asked for ---- */

/* Converts a place in the frame to a column and a row. */
static bool to_pixel(const murk_gdal_file *f, const double at[2], double *c,
                     double *r)
{
    double latitude, longitude;
    murk_geographic_from_local(&f->request->asked.frame, at, &latitude,
                               &longitude);
    double x = longitude, y = latitude;
    if (!OCTTransform(f->from_earth, 1, &x, &y, NULL)) {
        return false;
    }
    if (f->turn > 0) {
        /* The longitude nearest to the middle of the file, which may cross 180
         * degrees, or count to 360. */
        const double *to = f->to_system;
        const double middle = to[0] + (double)f->columns / 2 * to[1] +
                              (double)f->rows / 2 * to[2];
        x = middle + remainder(x - middle, f->turn);
    }
    const double *t = f->to_pixel;
    *c = t[0] + x * t[1] + y * t[2] - 0.5;
    *r = t[3] + x * t[4] + y * t[5] - 0.5;
    return isfinite(*c) && isfinite(*r);
}

/* The first and the number of lines among n that a range has, with one more at
 * each border; fewer than 2 if it has none. */
static void clip(double low, double high, size_t n, size_t *first,
                 size_t *count)
{
    const double last = (double)n - 1;
    low = fmin(fmax(floor(low) - 1, 0), last);
    high = fmin(fmax(ceil(high) + 1, 0), last);
    *first = (size_t)low;
    *count = (size_t)high - *first + 1;
}

murk_status murk_gdal_window_of(const murk_gdal_file *f, murk_gdal_window *out,
                                murk_error *err)
{
    const murk_geotiff_asked *asked = &f->request->asked;
    const double *box = asked->within_m;
    *out = (murk_gdal_window){.columns = f->columns, .rows = f->rows};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; asked->has_within && i < 4 * SIDE_POINTS; ++i) {
        /* Points along the sides of the box. */
        const double u = (double)(i % SIDE_POINTS) / (SIDE_POINTS - 1);
        const int side = i / SIDE_POINTS;
        const double at[2] = {
            side < 2 ? box[0] + u * (box[2] - box[0]) : box[side == 2 ? 0 : 2],
            side < 2 ? box[side == 0 ? 1 : 3] : box[1] + u * (box[3] - box[1])};
        double c, r;
        if (!to_pixel(f, at, &c, &r)) {
            return murk_fail(err, MURK_BAD_VALUE, f->request->where,
                             "within_m has the place %.9g %.9g m, which the "
                             "system of the file does not have",
                             at[0], at[1]);
        }
        low[0] = fmin(low[0], c);
        high[0] = fmax(high[0], c);
        low[1] = fmin(low[1], r);
        high[1] = fmax(high[1], r);
    }
    if (asked->has_within) {
        clip(low[0], high[0], f->columns, &out->column, &out->columns);
        clip(low[1], high[1], f->rows, &out->row, &out->rows);
        if (high[0] < 0 || low[0] > (double)f->columns - 1 || high[1] < 0 ||
            low[1] > (double)f->rows - 1 || out->columns < 2 || out->rows < 2) {
            return bad(f, err, "has no heights inside of within_m");
        }
    }
    return out->columns <= MURK_HEIGHTS_MAX / out->rows
               ? MURK_OK
               : murk_fail(
                     err, MURK_BAD_FILE, f->request->where,
                     "has %zu by %zu heights, must be at most %zu in all: "
                     "within_m must cut out a part",
                     out->columns, out->rows, MURK_HEIGHTS_MAX);
}

/* ---- heights ---- */

typedef struct rows_read {
    double *value;       /* [ROWS][columns] */
    unsigned char *mask; /* the same; 0: missing */
    double *alpha;       /* the same */
} rows_read;

/* Reads rows. All have values unless the file has a mask or an alpha band. */
static bool read_rows(const murk_gdal_file *f, const murk_gdal_window *w,
                      size_t row, size_t rows, const rows_read *to)
{
    const int x = (int)w->column, y = (int)(w->row + row), nx = (int)w->columns,
              ny = (int)rows;
    bool is_read = GDALRasterIO(f->band, GF_Read, x, y, nx, ny, to->value, nx,
                                ny, GDT_Float64, 0, 0) == CE_None;
    if (is_read && f->has_mask) {
        is_read = GDALRasterIO(GDALGetMaskBand(f->band), GF_Read, x, y, nx, ny,
                               to->mask, nx, ny, GDT_Byte, 0, 0) == CE_None;
    }
    const size_t n = rows * w->columns;
    if (!f->has_mask) {
        memset(to->mask, 1, n);
    }
    if (is_read && f->alpha) {
        is_read = GDALRasterIO(f->alpha, GF_Read, x, y, nx, ny, to->alpha, nx,
                               ny, GDT_Float64, 0, 0) == CE_None;
        for (size_t i = 0; i < n; ++i) {
            to->mask[i] = to->mask[i] && to->alpha[i] > 0;
        }
    }
    return is_read;
}

/* Converts a row to heights; *lowest: the lowest number so far. */
static murk_status convert_row(const murk_gdal_file *f,
                               const murk_gdal_window *w, size_t row,
                               const double *value, const unsigned char *mask,
                               double *height_m, murk_terrain_facts *facts,
                               double *lowest, murk_error *err)
{
    const murk_geotiff_asked *asked = &f->request->asked;
    for (size_t i = 0; i < w->columns; ++i) {
        const double v = value[i];
        /* A value in single precision is compared with one, too. */
        const bool is_missing =
            isnan(v) || mask[i] == 0 ||
            (asked->has_nodata &&
             (v == asked->nodata || v == (double)(float)asked->nodata));
        if (is_missing) {
            height_m[i] = NAN;
            continue;
        }
        const double up = (v * f->scale + f->offset) * f->unit_m,
                     h = f->is_depth ? -up : up;
        if (!(h >= LOWEST_M && h <= HIGHEST_M)) {
            return murk_fail(err, MURK_BAD_FILE, f->request->where,
                             "has the height %g m in column %zu, row %zu, must "
                             "be %d..%d m; nodata: %.9g if that stands for "
                             "none",
                             h, w->column + i, w->row + row, LOWEST_M,
                             HIGHEST_M, v);
        }
        *lowest = fmin(*lowest, v);
        height_m[i] = h - asked->altitude_m;
        facts->low_m = fmin(facts->low_m, height_m[i]);
        facts->high_m = fmax(facts->high_m, height_m[i]);
        ++facts->known;
    }
    return MURK_OK;
}

/* Blocks that a file leaves out are read as zeros, unless it says which value
 * stands for no height. */
static murk_status check_blocks(const murk_gdal_file *f,
                                const murk_gdal_window *w, murk_error *err)
{
    const int coverage = GDALGetDataCoverageStatus(
        f->band, (int)w->column, (int)w->row, (int)w->columns, (int)w->rows,
        GDAL_DATA_COVERAGE_STATUS_EMPTY, NULL);
    return coverage & GDAL_DATA_COVERAGE_STATUS_EMPTY && !f->has_nodata
               ? bad(f, err,
                     "leaves out blocks of pixels and does not say "
                     "which value they have: nodata must be given")
               : MURK_OK;
}

/* Lowest heights that nearly always stand for none are refused, if nothing says
 * what does. */
static murk_status check_lowest(const murk_gdal_file *f, double lowest,
                                murk_error *err)
{
    static const double usual[] = {-999, -9999, -32767, -32768};
    for (size_t i = 0; i < sizeof usual / sizeof *usual && !f->has_nodata;
         ++i) {
        if (lowest == usual[i]) {
            return murk_fail(err, MURK_BAD_FILE, f->request->where,
                             "has %g as its lowest number and does not say "
                             "which one stands for no height: nodata must be "
                             "given (%g, or another if that is a height)",
                             lowest, lowest);
        }
    }
    return MURK_OK;
}

murk_status murk_gdal_heights(const murk_gdal_file *f,
                              const murk_gdal_window *w, double *height_m,
                              murk_terrain_facts *facts, murk_error *err)
{
    const rows_read some = {malloc(ROWS * w->columns * sizeof *some.value),
                            malloc(ROWS * w->columns),
                            malloc(ROWS * w->columns * sizeof *some.alpha)};
    murk_status status = some.value && some.mask && some.alpha
                             ? check_blocks(f, w, err)
                             : murk_no_memory(err, f->request->where,
                                              "for %zu heights", w->columns);
    facts->known = 0;
    facts->low_m = INFINITY;
    facts->high_m = -INFINITY;
    double lowest = INFINITY; /* number of the file */
    /* Some rows at a time. */
    for (size_t row = 0; row < w->rows && !status; row += ROWS) {
        const size_t rows = w->rows - row < ROWS ? w->rows - row : ROWS;
        CPLErrorReset();
        if (!read_rows(f, w, row, rows, &some)) {
            status = bad_by(f, err, "has pixels that cannot be read");
        }
        for (size_t k = 0; k < rows && !status; ++k) {
            status = convert_row(f, w, row + k, some.value + k * w->columns,
                                 some.mask + k * w->columns,
                                 height_m + (row + k) * w->columns, facts,
                                 &lowest, err);
        }
    }
    free(some.value);
    free(some.mask);
    free(some.alpha);
    if (!status && facts->known == 0) {
        status = bad(f, err, "has no heights there: all are missing");
    }
    return status ? status : check_lowest(f, lowest, err);
}
