/* Broken GeoTIFF files: cut off anywhere, with flipped bits and hostile words.
 * Each is read as murk-gdal reads it, in a subprocess with its limits: a mesh
 * that is sane or one line of error, within bounded time. Only built where
 * libgdal is. Deterministic. usage: geotiff_input [FILES [large]], 200 if left
 * out; large: also the largest grids, which take some 20 s. */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "check.h"
#include "gdal/ground.h"
#include "gdal/read.h"
#include "geometry/import.h"
#include "written.h"

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_srs_api.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* Of a reader. The largest grid may wait for other programs: its bound is of
 * processor time. */
static double wall_max_s = BROKEN_SLOWEST_S;

#define WHERE "bad.yaml:1:1"

/* Readers that crashed. PROJ 9.1 does so for a few of 100,000 damaged systems,
 * which the subprocess is there for; none of the first 1000 files does. */
static uint32_t crashed;

#define CRASHES_MAX 1e-4 /* of the files */

static char path[] = "/tmp/murk-geotiff-XXXXXX";

#define COLUMNS 48
#define ROWS    40

/* Writes a file of one of the kinds. */
static void write_whole(uint32_t kind)
{
    static const struct {
        const char *system;
        double transform[6];
        GDALDataType type;
        char *options[6];
    } kinds[] = {
        {"EPSG:32631", {5e5, 3, 0, 5.75e6, 0, -3}, GDT_Float32, {NULL}},
        {"EPSG:4326",
         {5.2, 1e-4, 0, 52, 0, -1e-4},
         GDT_Int16,
         {(char *)(uintptr_t) "TILED=YES", (char *)(uintptr_t) "BLOCKXSIZE=16",
          (char *)(uintptr_t) "BLOCKYSIZE=16",
          (char *)(uintptr_t) "COMPRESS=DEFLATE",
          (char *)(uintptr_t) "PREDICTOR=2", NULL}},
        {"EPSG:26915+6360",
         {4.2e5, 3, 0, 4.6e6, 0, -3},
         GDT_UInt16,
         {(char *)(uintptr_t) "COMPRESS=LZW",
          (char *)(uintptr_t) "BLOCKYSIZE=8", NULL}}};
    /* The library's options are not const. */
    char *options[6];
    memcpy(options, kinds[kind].options, sizeof options);
    GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), path, COLUMNS,
                                   ROWS, 1, kinds[kind].type, options);
    OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
    CHECK(data &&
          OSRSetFromUserInput(system, kinds[kind].system) == OGRERR_NONE);
    double transform[6];
    memcpy(transform, kinds[kind].transform, sizeof transform);
    GDALSetGeoTransform(data, transform);
    GDALSetSpatialRef(data, system);
    GDALRasterBandH band = GDALGetRasterBand(data, 1);
    GDALSetRasterNoDataValue(band, kind == 0 ? -9999 : 0);
    /* Heights with a corner that has none. */
    float h[ROWS][COLUMNS];
    for (int row = 0; row < ROWS; ++row) {
        for (int i = 0; i < COLUMNS; ++i) {
            h[row][i] = i > 40 && row < 5
                            ? (kind == 0 ? -9999 : 0)
                            : (float)(100 + (i * 7 + row * row) % 90);
        }
    }
    CHECK(GDALRasterIO(band, GF_Write, 0, 0, COLUMNS, ROWS, h, COLUMNS, ROWS,
                       GDT_Float32, 0, 0) == CE_None);
    GDALClose(data);
    OSRDestroySpatialReference(system);
}

/* Writes a file in a process of its own. Otherwise PROJ has the database of
 * systems open in this one, and each reader closes it first, which takes longer
 * than all the rest. */
static void in_child(void write(uint32_t), uint32_t kind)
{
    const pid_t pid = fork();
    if (pid == 0) {
        write(kind);
        _exit(check_done());
    }
    int ended = -1;
    CHECK(pid > 0 && waitpid(pid, &ended, 0) == pid && ended == 0);
}

/* A murk_subprocess_work. */
static murk_status read_ground(murk_subprocess *to, void *context,
                               murk_error *err)
{
    return murk_gdal_answer(to, context, err);
}

/* True if the file gives a mesh. The frame is near some of the files, and far
 * from those of which the place is broken. */
static bool survives(uint32_t kind, bool has_frame)
{
    static const double places[][2] = {{51.9, 3}, {52, 5.2}, {41.5, -94}};
    const double start_s = murk_clock_s();
    const murk_subprocess_limits limits = murk_geotiff_limits(100000);
    murk_geotiff_request request = {
        .path = path,
        .where = WHERE,
        .asked = {.error_m = 1,
                  .band = 1,
                  .has_frame = has_frame,
                  .frame = murk_local_frame_at(places[kind][0], places[kind][1],
                                               0, 1)}};
    unsigned char *sent = NULL;
    size_t size = 0;
    murk_mesh *mesh = NULL;
    murk_error err = {0};
    murk_status status = murk_subprocess_run(&sent, &size, read_ground,
                                             &request, &limits, WHERE, &err);
    if (!status && has_frame) {
        status = murk_import_open(&mesh, sent, size, true, path, WHERE, &err);
    } else if (!status) {
        murk_terrain_facts facts;
        const unsigned char *from = sent;
        CHECK(murk_terrain_facts_take(&facts, &from, &size) && size == 0);
    }
    free(sent);
    if (status) {
        CHECK(strncmp(err.where, WHERE, strlen(WHERE)) == 0);
        CHECK(err.text[0] != '\0' && !strchr(err.text, '\n'));
        crashed += strstr(err.text, "its reader") != NULL;
        if (strstr(err.text, "its reader")) {
            printf("%s\n", err.text);
        }
        /* A subprocess that was slow says so. */
        CHECK(!strstr(err.text, "malformed, or too large"));
    }
    if (mesh) {
        CHECK(mesh->triangles > 0 && mesh->terrain.error_m <= 1);
        CHECK(mesh->bounds_m.min.z >= -12000 && mesh->bounds_m.max.z <= 9000);
    }
    murk_mesh_destroy(mesh);
    CHECK(murk_clock_s() - start_s < wall_max_s);
    return !status;
}

static unsigned char whole[65536];

/* Reads `files` broken copies of a file of a kind. */
static void test_kind(uint32_t kind, uint32_t files)
{
    in_child(write_whole, kind);
    FILE *from = fopen(path, "rb");
    CHECK(from != NULL);
    const size_t size = from ? fread(whole, 1, sizeof whole, from) : 0;
    fclose(from);
    CHECK(size > 500 && size < sizeof whole);
    CHECK(survives(kind, true) && survives(kind, false));
    uint32_t refused = 0;
    for (uint32_t i = 0; i < files; ++i) {
        static unsigned char copy[sizeof whole];
        const murk_random4 r = murk_random(18 + kind, MURK_TEST, i, 0, 0);
        uint32_t word[4];
        memcpy(copy, whole, size);
        /* Two thirds of the changes are in the first part, the header. */
        const uint32_t among =
            (uint32_t)(r.u[1] < 0.67 && size > 1200 ? 600 : size);
        size_t n = size;
        for (uint32_t k = 0; k <= i % 4; ++k) {
            murk_random_words(18 + kind, MURK_TEST, i, 1 + k, 0, word);
            const size_t at = murk_random_below(word[0], among - 4);
            const uint32_t worst[] = {0xffffffff, 0x7fffffff, 0x80000000, 0};
            if (r.u[0] < 0.1) {
                n = at;
            } else if (r.u[0] < 0.6) {
                copy[at] ^= (unsigned char)(1u << (word[1] & 7));
            } else {
                memcpy(copy + at, &worst[word[1] & 3], 4);
            }
        }
        write_bytes(path, copy, n);
        refused += !survives(kind, i % 4 != 0);
    }
    printf("kind %u: %u of %u refused, %u readers crashed so far\n", kind,
           refused, files, crashed);
    CHECK(refused > files / 8);
}

/* Processor time of the readers that have ended. */
static double used_s(void)
{
    struct rusage of;
    CHECK(getrusage(RUSAGE_CHILDREN, &of) == 0);
    return (double)(of.ru_utime.tv_sec + of.ru_stime.tv_sec) +
           1e-6 * (double)(of.ru_utime.tv_usec + of.ru_stime.tv_usec);
}

/* The largest grids: of one height, in a small file, where each height is
 * looked at on all levels; with a column more, which is refused; and of noise,
 * which needs too many triangles. */
static const struct {
    int columns;
    bool is_noise;
    bool is_read;
} large[] = {{4096, false, true}, {4097, false, false}, {4096, true, false}};

static void write_large(uint32_t kind)
{
    const int columns = large[kind].columns;
    char deflate[] = "COMPRESS=DEFLATE", tiled[] = "TILED=YES";
    char *options[] = {deflate, tiled, NULL};
    double transform[] = {5e5, 3, 0, 5.75e6, 0, -3};
    GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), path, columns,
                                   4096, 1, GDT_Float32, options);
    OGRSpatialReferenceH system = OSRNewSpatialReference(NULL);
    CHECK(data && OSRSetFromUserInput(system, "EPSG:32631") == OGRERR_NONE);
    GDALSetGeoTransform(data, transform);
    GDALSetSpatialRef(data, system);
    GDALRasterBandH band = GDALGetRasterBand(data, 1);
    /* Heights row by row, if they differ. */
    GDALFillRaster(band, 100, 0);
    for (int row = 0; row < 4096 && large[kind].is_noise; ++row) {
        static float h[4096];
        for (int i = 0; i < columns; ++i) {
            h[i] = 100 * (float)murk_random(19, MURK_TEST, (uint64_t)i,
                                            (uint32_t)row, 0)
                             .u[0];
        }
        CHECK(GDALRasterIO(band, GF_Write, 0, row, columns, 1, h, columns, 1,
                           GDT_Float32, 0, 0) == CE_None);
    }
    GDALClose(data);
    OSRDestroySpatialReference(system);
}

/* By processor time, because other programs may take the rest. */
static void test_large(void)
{
    wall_max_s = 6 * BROKEN_SLOWEST_S;
    for (uint32_t i = 0; i < sizeof large / sizeof *large; ++i) {
        in_child(write_large, i);
        const double before_s = used_s();
        CHECK(survives(0, true) == large[i].is_read);
        const double own_s = used_s() - before_s;
        printf("%d by 4096 heights%s: %.1f s\n", large[i].columns,
               large[i].is_noise ? " of noise" : "", own_s);
        CHECK(own_s < BROKEN_SLOWEST_S);
    }
}

int main(int argc, char **argv)
{
    const uint32_t files = argc > 1 ? (uint32_t)atol(argv[1]) : 200;
    const int file = mkstemp(path);
    CHECK(file >= 0);
    close(file);
    (void)murk_warn_quiet(true);
    murk_gdal_begin();
    for (uint32_t kind = 0; kind < 3; ++kind) {
        test_kind(kind, files / 3 + (kind < files % 3));
    }
    CHECK(crashed <= CRASHES_MAX * files);
    if (argc > 2) {
        test_large();
    }
    unlink(path);
    return check_done();
}
