/* Ground from GeoTIFF files: heights and places against those that GDAL reads.
 *
 * Files that are written here: projected, geographic, rotated, with points in
 * place of areas, with scale, unit, vertical system, mask and missing heights.
 * Their truth are longitudes and latitudes of PROJ, and the heights written.
 * Files of ../shared/data/frontier/terrain: against their reference, by GDAL
 * 3.6.2. Everything is exact but for rounding, so there is no false alarm: 1 mm
 * is 1000 steps of single precision at 8 m, and a wrong axis, half a pixel or a
 * scale of UTM is a metre. Only built where libgdal is. */
#include "base/rng.h"
#include "check.h"
#include "geometry/mesh.h"
#include "scene/table.h"

#include <cpl_conv.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#include <stdlib.h>
#include <unistd.h>

#define DATA "../shared/data/frontier/terrain/"

#define MILLIMETRE 1e-3

/* Of the slope of the ground in the files, at most 1 here, times the places. */
#define HEIGHT_ROUNDING_M 2e-3

static char path[] = "/tmp/murk-terrain-XXXXXX";

/* ---- meshes ---- */

static murk_mesh *read_mesh(const char *file, const murk_geotiff_asked *asked,
                            murk_error *err)
{
    murk_mesh *mesh = NULL;
    const murk_mesh_import import = {.is_geotiff = true, .geotiff = *asked};
    const murk_status status =
        murk_mesh_read(&mesh, file, &import, "terrain.yaml:1:1", err);
    CHECK(!status == (mesh != NULL));
    return mesh;
}

static void corner_of(const murk_mesh *mesh, size_t triangle, size_t k,
                      double at[3])
{
    const float *v = mesh->vertex_m + 3 * mesh->corner[3 * triangle + k];
    at[0] = (double)v[0] + mesh->origin_m.x;
    at[1] = (double)v[1] + mesh->origin_m.y;
    at[2] = (double)v[2] + mesh->origin_m.z;
}

static double area_of(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/* The height of the mesh at a place; NAN: no triangle is there. Weights may be
 * negative by SHIFT_MAX of gdal/ground.c: at the border of a file, whose lines
 * are curves, a point may lie beside the straight edge of its triangle. */
static double height_of(const murk_mesh *mesh, const double at[2])
{
    double best = NAN, best_weight = -0.1;
    for (size_t i = 0; i < mesh->triangles; ++i) {
        double p[3][3];
        for (size_t k = 0; k < 3; ++k) {
            corner_of(mesh, i, k, p[k]);
        }
        const double whole = area_of(p[0], p[1], p[2]);
        CHECK(whole > 0); /* upward */
        const double w[3] = {area_of(at, p[1], p[2]) / whole,
                             area_of(p[0], at, p[2]) / whole,
                             area_of(p[0], p[1], at) / whole};
        const double smallest = fmin(w[0], fmin(w[1], w[2]));
        if (smallest > best_weight) {
            best_weight = smallest;
            best = w[0] * p[0][2] + w[1] * p[1][2] + w[2] * p[2][2];
        }
    }
    return best;
}

/* The distance of the nearest vertex. */
static double distance_of(const murk_mesh *mesh, const double at[2])
{
    double nearest = INFINITY;
    for (size_t i = 0; i < mesh->vertices; ++i) {
        const float *v = mesh->vertex_m + 3 * i;
        nearest = fmin(nearest, hypot((double)v[0] + mesh->origin_m.x - at[0],
                                      (double)v[1] + mesh->origin_m.y - at[1]));
    }
    return nearest;
}

/* ---- files that are written here ---- */

#define COLUMNS 40
#define ROWS    30

typedef struct sample {
    const char *name;
    const char *system; /* of GDAL */
    double transform[6];
    GDALDataType type;
    double scale, offset; /* 0: none */
    const char *unit;     /* of the band; NULL: none */
    const char *options[4];
    double unit_m; /* that murk must find */
    bool is_point;
    bool has_hole; /* a value for missing heights */
    bool has_mask;
    bool is_depth;
    bool has_alpha; /* a second band, which is 0 where there is no height */
} sample;

static const sample samples[] = {
    {"UTM", "EPSG:32631", {5e5, 3, 0, 5.75e6, 0, -3}, GDT_Float32, .unit_m = 1},
    {"UTM south, far from the meridian",
     "EPSG:32756",
     {7.2e5, 10, 0, 6.2e6, 0, -10},
     GDT_Float64,
     .unit_m = 1},
    {"geographic",
     "EPSG:4326",
     {5.2, 1. / 3600, 0, 52.1, 0, -1. / 3600},
     GDT_Float32,
     .unit_m = 1},
    {"geographic, coarse",
     "EPSG:4326",
     {5.2, 0.01, 0, 62.1, 0, -0.01},
     GDT_Float32,
     .unit_m = 1},
    {"rotated",
     "EPSG:32631",
     {5e5, 2.6, 1.5, 5.75e6, 1.5, -2.6},
     GDT_Float32,
     .unit_m = 1},
    {"south up",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, 3},
     GDT_Float32,
     .unit_m = 1},
    {"points",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Float32,
     .unit_m = 1,
     .is_point = true},
    {"scale and offset",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Int16,
     .scale = 0.01,
     .offset = 20,
     .unit_m = 1},
    {"feet of the band",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Float32,
     .unit = "ft",
     .unit_m = 0.3048},
    {"feet of the system", /* UTM and NAVD88 height (ftUS) */
     "EPSG:26915+6360",
     {4.25e5, 3, 0, 4.6e6, 0, -3},
     GDT_Float32,
     .unit_m = 1200. / 3937},
    {"depths", /* UTM and mean sea level depth */
     "EPSG:32631+5715",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Float32,
     .unit_m = 1,
     .is_depth = true},
    {"missing heights",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Float32,
     .options = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16",
                 "COMPRESS=DEFLATE"},
     .unit_m = 1,
     .has_hole = true},
    {"mask",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_UInt16,
     .options = {"COMPRESS=LZW", "PREDICTOR=2"},
     .unit_m = 1,
     .has_mask = true},
    {"alpha band", /* as gdalwarp -dstalpha writes it */
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Float32,
     .options = {"ALPHA=YES"},
     .unit_m = 1,
     .has_alpha = true},
    {"alpha band of 16 bits",
     "EPSG:32631",
     {5e5, 3, 0, 5.75e6, 0, -3},
     GDT_Int16,
     .options = {"ALPHA=YES"},
     .unit_m = 1,
     .has_alpha = true}};

/* The number in the file at a pixel; NAN: none. */
static double value_at(const sample *s, int column, int row)
{
    if ((s->has_hole || s->has_mask || s->has_alpha) &&
        hypot(column - 12, row - 14) < 5) {
        return NAN;
    }
    const double h = 100 + 10 * sin(column / 5.) * cos(row / 7.);
    return s->type == GDT_Float32   ? (double)(float)h
           : s->type == GDT_Float64 ? h
                                    : nearbyint(h);
}

/* The height that murk must find. */
static double height_at(const sample *s, int column, int row)
{
    const double scale = s->scale > 0 ? s->scale : 1;
    return (value_at(s, column, row) * scale + s->offset) * s->unit_m *
           (s->is_depth ? -1 : 1);
}

static void write_sample(const sample *s)
{
    char *options[5] = {NULL};
    for (int i = 0; i < 4 && s->options[i]; ++i) {
        options[i] = strdup(s->options[i]);
    }
    GDALDatasetH data =
        GDALCreate(GDALGetDriverByName("GTiff"), path, COLUMNS, ROWS,
                   s->has_alpha ? 2 : 1, s->type, options);
    OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
    CHECK(data && OSRSetFromUserInput(system, s->system) == OGRERR_NONE);
    double transform[6];
    memcpy(transform, s->transform, sizeof transform);
    CHECK(GDALSetGeoTransform(data, transform) == CE_None);
    CHECK(GDALSetSpatialRef(data, system) == CE_None);
    if (s->is_point) {
        GDALSetMetadataItem(data, "AREA_OR_POINT", "Point", NULL);
    }
    GDALRasterBandH band = GDALGetRasterBand(data, 1);
    if (s->scale > 0) {
        GDALSetRasterScale(band, s->scale);
        GDALSetRasterOffset(band, s->offset);
    }
    if (s->unit) {
        GDALSetRasterUnitType(band, s->unit);
    }
    if (s->has_hole) {
        GDALSetRasterNoDataValue(band, -9999);
    }
    if (s->has_mask) {
        CHECK(GDALCreateMaskBand(band, GMF_PER_DATASET) == CE_None);
    }
    /* Values row by row. */
    for (int row = 0; row < ROWS; ++row) {
        double value[COLUMNS];
        unsigned char mask[COLUMNS];
        for (int i = 0; i < COLUMNS; ++i) {
            value[i] = value_at(s, i, row);
            mask[i] = isnan(value[i]) ? 0 : 255;
            value[i] = mask[i] ? value[i] : s->has_hole ? -9999 : 0;
        }
        CHECK(GDALRasterIO(band, GF_Write, 0, row, COLUMNS, 1, value, COLUMNS,
                           1, GDT_Float64, 0, 0) == CE_None);
        if (s->has_mask || s->has_alpha) {
            GDALRasterBandH to = s->has_mask ? GDALGetMaskBand(band)
                                             : GDALGetRasterBand(data, 2);
            CHECK(GDALRasterIO(to, GF_Write, 0, row, COLUMNS, 1, mask, COLUMNS,
                               1, GDT_Byte, 0, 0) == CE_None);
        }
    }
    GDALClose(data);
    OSRDestroySpatialReference(system);
    for (int i = 0; i < 4; ++i) {
        free(options[i]);
    }
}

/* Longitude and latitude of the middle of a pixel by PROJ. */
static void earth_of(const sample *s, double column, double row, double *x,
                     double *y)
{
    OGRSpatialReferenceH own = OSRNewSpatialReference(NULL),
                         earth = OSRNewSpatialReference(NULL);
    char name[32];
    /* The horizontal part alone. */
    snprintf(name, sizeof name, "%.*s", (int)strcspn(s->system, "+"),
             s->system);
    OSRSetFromUserInput(own, name);
    OSRSetFromUserInput(earth, "EPSG:4326");
    OSRSetAxisMappingStrategy(own, OAMS_TRADITIONAL_GIS_ORDER);
    OSRSetAxisMappingStrategy(earth, OAMS_TRADITIONAL_GIS_ORDER);
    OGRCoordinateTransformationH t = OCTNewCoordinateTransformation(own, earth);
    const double *g = s->transform, c = column + 0.5, r = row + 0.5;
    *x = g[0] + c * g[1] + r * g[2];
    *y = g[3] + c * g[4] + r * g[5];
    CHECK(OCTTransform(t, 1, x, y, NULL));
    OCTDestroyCoordinateTransformation(t);
    OSRDestroySpatialReference(own);
    OSRDestroySpatialReference(earth);
}

/* The place of a pixel in the frame of a request. */
static void place_of(const sample *s, const murk_geotiff_asked *asked,
                     double column, double row, double at[2])
{
    double longitude, latitude, back[2];
    earth_of(s, column, row, &longitude, &latitude);
    CHECK(murk_local_from_geographic(&asked->frame, latitude, longitude, at));
    /* There and back, 1e-8 degrees are 1 mm. */
    murk_geographic_from_local(&asked->frame, at, &back[1], &back[0]);
    CHECK_NEAR(back[0], longitude, 1e-8);
    CHECK_NEAR(back[1], latitude, 1e-8);
}

static void check_sample(const sample *s, double error_m)
{
    double longitude, latitude;
    murk_error err = {0};
    earth_of(s, COLUMNS / 2., ROWS / 2., &longitude, &latitude);
    const murk_geotiff_asked asked = {
        .error_m = error_m,
        .band = 1,
        .altitude_m = 12.5,
        .has_frame = true,
        .frame = murk_local_frame_at(latitude + 0.01, longitude, 3, 4)};
    murk_mesh *mesh = read_mesh(path, &asked, &err);
    if (!mesh) {
        printf("%s: %s %s\n", s->name, err.where, err.text);
        return;
    }
    CHECK_NEAR(mesh->terrain.unit_m, s->unit_m, 1e-12);
    CHECK(mesh->terrain.is_depth == s->is_depth);
    CHECK(mesh->terrain.error_m <= fmax(error_m, 2e-5));
    for (int row = 0; row < ROWS; ++row) {
        for (int column = 0; column < COLUMNS; ++column) {
            double at[2];
            place_of(s, &asked, column, row, at);
            const double got = height_of(mesh, at),
                         want = height_at(s, column, row) - 12.5;
            if (isnan(want)) {
                CHECK(isnan(got));
                continue;
            }
            CHECK_NEAR(got, want, error_m + HEIGHT_ROUNDING_M);
            /* Whole numbers make flat places, which need no vertices. */
            if (error_m == 0 &&
                (s->type == GDT_Float32 || s->type == GDT_Float64)) {
                CHECK(distance_of(mesh, at) < MILLIMETRE);
            }
        }
    }
    murk_mesh_destroy(mesh);
}

static void test_samples(void)
{
    for (size_t i = 0; i < sizeof samples / sizeof *samples; ++i) {
        const int before = check_failures;
        write_sample(&samples[i]);
        check_sample(&samples[i], 0);
        check_sample(&samples[i], 1);
        check_sample(&samples[i], 5);
        if (check_failures > before) {
            printf("of file: %s\n", samples[i].name);
        }
    }
}

/* A part of a file: heights of all of the part, and few beyond. */
static void test_within(void)
{
    const sample *s = &samples[0];
    double longitude, latitude;
    murk_error err = {0};
    write_sample(s);
    earth_of(s, 20, 15, &longitude, &latitude);
    murk_geotiff_asked asked = {
        .band = 1,
        .has_within = true,
        .within_m = {-10, -20, 15, 5},
        .has_frame = true,
        .frame = murk_local_frame_at(latitude, longitude, 0, 1)};
    murk_mesh *mesh = read_mesh(path, &asked, &err);
    CHECK(mesh != NULL);
    /* All of the box has ground. */
    if (mesh) {
        CHECK(mesh->terrain.columns < 16 && mesh->terrain.rows < 16);
        for (double x = -10; x <= 15; x += 5) {
            for (double y = -20; y <= 5; y += 5) {
                CHECK(!isnan(height_of(mesh, (double[]){x, y})));
            }
        }
    }
    murk_mesh_destroy(mesh);
    asked.within_m[0] = 5000;
    asked.within_m[2] = 6000;
    CHECK(!read_mesh(path, &asked, &err));
    CHECK(strstr(err.text, "no heights inside of within_m") != NULL);
}

/* Files across 180 degrees, and with longitudes from 0 to 360: within_m finds
 * both sides. */
static void test_turns(void)
{
    static const double west_deg[] = {179.98, -180.02, 200, 359.98, -0.02};
    for (size_t i = 0; i < sizeof west_deg / sizeof *west_deg; ++i) {
        const sample s = {"turns",
                          "EPSG:4326",
                          {west_deg[i], 1e-3, 0, 10, 0, -1e-3},
                          GDT_Float32,
                          .unit_m = 1};
        murk_error err = {0};
        write_sample(&s);
        /* A site in the middle; 25 columns of 109.6 m, and one more at each
         * border. */
        const murk_geotiff_asked asked = {
            .band = 1,
            .has_within = true,
            .within_m = {-12.4 * 109.6, -500, 12.4 * 109.6, 500},
            .has_frame = true,
            .frame = murk_local_frame_at(
                9.985, remainder(west_deg[i] + 0.0205, 360), 0, 1)};
        murk_mesh *mesh = read_mesh(path, &asked, &err);
        CHECK(mesh != NULL);
        if (mesh) {
            CHECK(mesh->terrain.columns >= 27 && mesh->terrain.columns <= 29);
            CHECK(!isnan(height_of(mesh, (double[]){-12 * 109.6, 0})));
            CHECK(!isnan(height_of(mesh, (double[]){12 * 109.6, 0})));
        }
        murk_mesh_destroy(mesh);
    }
}

/* What is refused: the line names the file. */
static void test_refused(void)
{
    static const struct {
        const char *system;
        double scale, value;
        const char *unit, *text;
        uint64_t band;
    } cases[] = {
        {NULL, 1, 5, NULL, "no coordinate reference system", 1},
        {"LOCAL_CS[\"grid\",UNIT[\"metre\",1]]", 1, 5, NULL,
         "no coordinate reference system", 1},
        {"EPSG:32631", 1, 5, "furlong", "height_unit must be given", 1},
        {"EPSG:2263", 1, 5, NULL, "in units of 0.3048006 m and states no", 1},
        {"EPSG:32631", 1, 5, NULL, "band is 2, must be 1..1", 2},
        {"EPSG:32631", 1, -3.4e38, NULL, "nodata: -3.39999995e+38", 1},
        {"EPSG:32631", 1, 9001, NULL, "-12000..9000 m; nodata: 9001", 1},
        {"EPSG:32631", 1, -12001, NULL, "-12000..9000 m; nodata: -12001", 1},
        {"EPSG:32631", 1, -999, NULL, "nodata must be given (-999,", 1},
        {"EPSG:32631", 1, -9999, NULL, "nodata must be given (-9999,", 1},
        {"EPSG:32631", 1, -32767, "cm", "nodata must be given (-32767,", 1},
        {"EPSG:32631", 1, -32768, "cm", "nodata must be given (-32768,", 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        /* A small file with one thing wrong. */
        GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), path, 3, 3,
                                       1, GDT_Float32, NULL);
        double transform[] = {5e5, 3, 0, 5.75e6, 0, -3};
        GDALSetGeoTransform(data, transform);
        OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
        if (cases[i].system) {
            CHECK(OSRSetFromUserInput(system, cases[i].system) == OGRERR_NONE);
            GDALSetSpatialRef(data, system);
        }
        GDALRasterBandH band = GDALGetRasterBand(data, 1);
        if (cases[i].unit) {
            GDALSetRasterUnitType(band, cases[i].unit);
        }
        GDALFillRaster(band, cases[i].value, 0);
        GDALClose(data);
        OSRDestroySpatialReference(system);
        /* Read it. */
        murk_geotiff_asked asked = {.band = cases[i].band,
                                    .has_frame = true,
                                    .frame =
                                        murk_local_frame_at(51.9, 3, 0, 1)};
        murk_error err = {0};
        CHECK(!read_mesh(path, &asked, &err));
        CHECK(strstr(err.where, path) != NULL);
        if (!strstr(err.text, cases[i].text)) {
            printf("%s: %s, want %s\n", err.where, err.text, cases[i].text);
            CHECK(false);
        }
        /* A low number is a height if another stands for none. */
        if (strstr(cases[i].text, "must be given (")) {
            asked.has_nodata = true;
            asked.nodata = 5;
            murk_mesh *mesh = read_mesh(path, &asked, &err);
            CHECK(mesh && mesh->terrain.low_m < -300);
            murk_mesh_destroy(mesh);
        }
    }
}

/* The bands of a picture are heights only if the request names one. */
static void test_picture(void)
{
    char colour[] = "PHOTOMETRIC=RGB", *options[] = {colour, NULL};
    GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), path, 9, 9, 3,
                                   GDT_Byte, options);
    double transform[] = {5e5, 3, 0, 5.75e6, 0, -3};
    OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
    OSRSetFromUserInput(system, "EPSG:32631");
    GDALSetGeoTransform(data, transform);
    GDALSetSpatialRef(data, system);
    GDALClose(data);
    OSRDestroySpatialReference(system);
    for (uint64_t band = 0; band < 4; ++band) {
        const murk_geotiff_asked asked = {
            .band = band,
            .has_frame = true,
            .frame = murk_local_frame_at(51.9, 3, 0, 1)};
        murk_error err = {0};
        murk_mesh *mesh = read_mesh(path, &asked, &err);
        CHECK(!mesh == (band == 0));
        CHECK(mesh || strstr(err.text, "first band is \"Red\"; band must"));
        murk_mesh_destroy(mesh);
    }
}

/* Blocks that a file leaves out are heights of 0 to the library. Without a
 * value for missing heights such a file is refused. */
static void test_left_out(void)
{
    for (int has_nodata = 0; has_nodata < 2; ++has_nodata) {
        char sparse[] = "SPARSE_OK=TRUE", tiled[] = "TILED=YES";
        char *options[] = {sparse, tiled, NULL};
        GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), path, 512,
                                       256, 1, GDT_Float32, options);
        double transform[] = {5e5, 3, 0, 5.75e6, 0, -3};
        OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
        OSRSetFromUserInput(system, "EPSG:32631");
        GDALSetGeoTransform(data, transform);
        GDALSetSpatialRef(data, system);
        GDALRasterBandH band = GDALGetRasterBand(data, 1);
        if (has_nodata) {
            GDALSetRasterNoDataValue(band, -9999);
        }
        /* The first of two blocks. */
        static float h[256][256];
        h[100][100] = 5;
        CHECK(GDALRasterIO(band, GF_Write, 0, 0, 256, 256, h, 256, 256,
                           GDT_Float32, 0, 0) == CE_None);
        GDALClose(data);
        OSRDestroySpatialReference(system);
        const murk_geotiff_asked asked = {
            .band = 1,
            .has_frame = true,
            .frame = murk_local_frame_at(51.9, 3, 0, 1)};
        murk_error err = {0};
        murk_mesh *mesh = read_mesh(path, &asked, &err);
        CHECK(!mesh == !has_nodata);
        CHECK(mesh ? mesh->terrain.known == 256 * 256
                   : strstr(err.text, "leaves out blocks of pixels") != NULL);
        murk_mesh_destroy(mesh);
    }
}

/* ---- the reference ---- */

static double cell(const murk_table *t, size_t row, const char *name)
{
    double value = NAN;
    CHECK(!murk_table_number(t, row, murk_table_column(t, name), NAN, &value,
                             NULL));
    return value;
}

/* Heights at the points of a reference. In files of unit_m: nodata -> none. */
static void check_reference(const char *name, double unit_m, double nodata,
                            uint64_t columns, uint64_t known)
{
    static const double errors[] = {0, 0.05, 0.25, 1};
    char file[200], reference[240];
    snprintf(file, sizeof file, DATA "%s", name);
    snprintf(reference, sizeof reference, "%s.reference.csv", file);
    murk_table *t = NULL;
    CHECK(!murk_table_read(&t, reference, NULL));
    size_t triangles = SIZE_MAX;
    for (size_t e = 0; e < sizeof errors / sizeof *errors; ++e) {
        murk_error err = {0};
        const murk_geotiff_asked asked = {
            .error_m = errors[e],
            .band = 1,
            .unit_m = unit_m,
            .has_frame = true,
            .frame = murk_local_frame_at(41.687, -93.89, 0, 1)};
        murk_mesh *mesh = read_mesh(file, &asked, &err);
        if (!mesh) {
            printf("%s %s\n", err.where, err.text);
            break;
        }
        CHECK(mesh->terrain.columns == columns && mesh->terrain.known == known);
        CHECK(mesh->terrain.error_m <= fmax(errors[e], 2e-5));
        printf("%s: error %g m: %zu triangles, off by %g m\n", name, errors[e],
               mesh->triangles, mesh->terrain.error_m);
        CHECK(mesh->triangles < triangles);
        triangles = mesh->triangles;
        /* Points of the reference. */
        size_t heights = 0;
        for (size_t i = 0; i < t->rows; ++i) {
            if (strcmp(t->cell[i * t->columns], "pixel") != 0) {
                continue;
            }
            double at[2];
            CHECK(murk_local_from_geographic(&asked.frame, cell(t, i, "lat"),
                                             cell(t, i, "lon"), at));
            const double value = cell(t, i, "value"), got = height_of(mesh, at);
            if (value == nodata) {
                CHECK(isnan(got));
                continue;
            }
            CHECK_NEAR(got, value * (unit_m > 0 ? unit_m : 1),
                       errors[e] + HEIGHT_ROUNDING_M);
            heights += 1;
            if (errors[e] == 0) {
                CHECK(distance_of(mesh, at) < MILLIMETRE);
            }
        }
        CHECK(heights > 15);
        murk_mesh_destroy(mesh);
    }
    murk_table_destroy(t);
}

int main(void)
{
    const int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    CPLSetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
    GDALRegister_GTiff();
    test_samples();
    test_within();
    test_turns();
    test_refused();
    test_picture();
    test_left_out();
    unlink(path);
    if (access(DATA "small_dem_3m_merged.tif", R_OK) == 0) {
        check_reference("derived_crop_f32_deflate.tif", 0, -9999, 200, 24322);
        check_reference("small_dem_3m_merged.tif", 0.01, 0, 574, 88511);
    } else {
        puts("without " DATA);
    }
    GDALDestroyDriverManager();
    return check_done();
}
