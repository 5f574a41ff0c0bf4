/* The density between two frames: (1 - w) a + w b in each voxel, over tiles,
 * leaves and voxels that one frame does not have; files that cannot be combined
 * are refused with both names. Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/log.h"
#include "check.h"
#include "grid_line.h"
#include "medium/grid.h"
#include "medium/grid_write.h"

#include <stdlib.h>
#include <unistd.h>

#define FOLDER "tests/unit/medium/grids/"
#define WHERE  "fog.yaml:7:3: media.fog"

static char folder[64], first[96], second[96], warned[960];

static void keep_warning(const char *where, const char *text)
{
    const size_t used = strlen(warned);
    snprintf(warned + used, sizeof warned - used, "%s: %s\n", where, text);
}

static murk_grid *reads(const char *path)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, NULL, WHERE, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return grid;
}

static murk_grid *between(const char *a, const char *b, double weight)
{
    const char *const path[] = {a, b};
    murk_grid *grid = NULL;
    murk_error err = {0};
    warned[0] = '\0';
    CHECK(murk_grid_read_between(&grid, path, weight, NULL, WHERE, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return grid;
}

/* Refused at the file `place`, in words that contain `text` and `other`. */
static void refuses(const char *a, const char *b, murk_status status,
                    const char *place, const char *text, const char *other)
{
    const char *const path[] = {a, b};
    char where[192];
    murk_grid *grid = NULL;
    murk_error err = {0};
    snprintf(where, sizeof where, WHERE ": %s", place);
    CHECK(murk_grid_read_between(&grid, path, .5, NULL, WHERE, &err) == status);
    CHECK(grid == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_MENTIONS(err.text, text);
    CHECK_MENTIONS(err.text, other);
}

/* Refused at the second file, or, if the process that reads them has died, at
 * one of both. */
static void refuses_one_of(const char *a, const char *b, const char *text)
{
    const char *const path[] = {a, b};
    char either[400], that[200];
    murk_grid *grid = NULL;
    murk_error err = {0};
    snprintf(either, sizeof either, WHERE ": %s or %s", a, b);
    snprintf(that, sizeof that, WHERE ": %s", b);
    CHECK(murk_grid_read_between(&grid, path, .5, NULL, WHERE, &err) ==
          MURK_BAD_FILE);
    CHECK(grid == NULL);
    CHECK(strcmp(err.where, either) == 0 || strcmp(err.where, that) == 0);
    CHECK_MENTIONS(err.text, text);
}

/* Writes a grid of value[] that begins with voxel (0, 0, 0). */
static void write_grid(const char *path, const size_t size[3],
                       const float *value, const murk_affine *place)
{
    const murk_grid_field field = {"density", value, NULL};
    murk_error err = {0};
    CHECK(murk_grid_write(path, &field, 1, size, place, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
}

/* Writes one voxel (i, 1, 1) that is not 0. */
static void write_voxel(const char *path, size_t i, float value)
{
    const size_t size[3] = {i + 1, 2, 2};
    float *all = calloc(4 * (i + 1), sizeof *all);
    const murk_affine place = murk_affine_identity();
    CHECK(all != NULL);
    if (all) {
        all[4 * (i + 1) - 1] = value;
        write_grid(path, size, all, &place);
    }
    free(all);
}

static void test_each_voxel_is_the_mean(double weight)
{
    /* Two grids that overlap in part; their zeros are not stored. */
    enum { N = 20 };
    const size_t size[3] = {N, N, N};
    static float a[N * N * N], b[N * N * N];
    for (int i = 0; i < N * N * N; ++i) {
        const int x = i % N, z = i / (N * N);
        a[i] = x < 13 ? .1F * (float)(i * 7 % 31) : 0;
        b[i] = z > 9 ? .3F * (float)(i * 11 % 17) : 0;
    }
    const murk_affine place = murk_affine_identity();
    write_grid(first, size, a, &place);
    write_grid(second, size, b, &place);
    murk_grid *grid = between(first, second, weight);
    if (!grid) {
        return;
    }
    /* Every value is the mean in double precision, rounded once. */
    size_t active = 0;
    double sum = 0;
    bool is_mean = true;
    for (int i = 0; i < N * N * N; ++i) {
        const float mean =
            (float)((1 - weight) * (double)a[i] + weight * (double)b[i]);
        is_mean =
            is_mean && (double)mean ==
                           murk_grid_value(grid, i % N, i / N % N, i / (N * N));
        active += a[i] > 0 || b[i] > 0;
        sum += (double)mean;
    }
    CHECK(is_mean);
    CHECK(murk_grid_describe(grid)->active == active);
    CHECK_NEAR(murk_grid_describe(grid)->sum, sum, 1e-9 * sum);
    CHECK_TEXT(warned, "");
    murk_grid_destroy(grid);
}

/* Tiles of 8, 128 and 4096 voxels, a leaf, and nothing, with a voxel of the
 * other frame inside; either frame may be the first. */
static void test_tiles(void)
{
    static const size_t at[] = {5, 20, 130, 300, 4500};
    static const double there[] = {0, 0, 2, 0, 1}; /* at (., 1, 1) */
    const char *tiles = FOLDER "tiles.vdb";
    for (size_t k = 0; k < sizeof at / sizeof *at; ++k) {
        write_voxel(first, at[k], 16);
        const int64_t i = (int64_t)at[k];
        murk_grid *one = between(tiles, first, .25),
                  *other = between(first, tiles, .75);
        for (int side = 0; side < 2; ++side) {
            const murk_grid *grid = side ? other : one;
            CHECK(grid &&
                  murk_grid_value(grid, i, 1, 1) == .75 * there[k] + .25 * 16);
            CHECK(grid && murk_grid_value(grid, i, 2, 1) == .75 * there[k]);
            CHECK(grid && murk_grid_value(grid, -1, -8, -5) == .75 * 3);
            CHECK(grid && murk_grid_value(grid, 5, 0, 0) == .75 * 5);
            CHECK(grid && murk_grid_value(grid, 255, 127, 127) == .75 * 2);
            CHECK(grid && murk_grid_value(grid, 256, 127, 127) == 0);
            CHECK(grid && murk_grid_value(grid, 8191, 4095, 0) == .75);
            CHECK(grid && murk_grid_value(grid, -9, -8, -5) == 0);
            CHECK_NEAR(grid ? grid_line_integral(grid, murk_vec(-100, 0, 0),
                                                 murk_vec(1, 0, 0), 1e4)
                            : 0,
                       .75 * (28 + 2 * 128 + 4096), 1e-9);
            CHECK(grid && murk_grid_describe(grid)->memory_bytes < 2000000);
        }
        murk_grid_destroy(one);
        murk_grid_destroy(other);
    }
}

/* Values in single precision whatever the precision of the files; the largest
 * float stays finite; inactive voxels are 0, with a warning at their file. */
static void test_other_values(void)
{
    murk_grid *fine = reads(FOLDER "fine.vdb");
    murk_grid *grid = between(FOLDER "fine.vdb", FOLDER "tiles.vdb", .25);
    CHECK(fine && grid &&
          murk_grid_value(grid, 1, 2, 3) ==
              (double)(float)(.75 * murk_grid_value(fine, 1, 2, 3)));
    murk_grid_destroy(fine);
    murk_grid_destroy(grid);
    const float largest = 3.40282347e38F;
    write_voxel(first, 3, largest);
    write_voxel(second, 3, largest);
    grid = between(first, second, .3);
    CHECK(grid && murk_grid_value(grid, 3, 1, 1) == (double)largest);
    murk_grid_destroy(grid);
    grid = between(FOLDER "tiles.vdb", FOLDER "inactive.vdb", .5);
    CHECK(grid && murk_grid_value(grid, 1, 0, 0) == .5);
    CHECK(grid && murk_grid_value(grid, 9, 1, 1) == 0);
    CHECK_MENTIONS(warned, WHERE ": " FOLDER "inactive.vdb: grid density: 513 "
                                 "voxels hold a value but are not active");
    murk_grid_destroy(grid);
    grid = between(FOLDER "inactive.vdb", FOLDER "inactive.vdb", .5);
    CHECK(grid && murk_grid_describe(grid)->sum == 1);
    murk_grid_destroy(grid);
}

static void test_refusals(void)
{
    /* Other transforms: a shift, a scale, and a turn. */
    const float value[1] = {1};
    const size_t size[3] = {1, 1, 1};
    murk_affine place = murk_affine_identity();
    write_grid(first, size, value, &place);
    place.shift.y = .1;
    write_grid(second, size, value, &place);
    refuses(first, second, MURK_BAD_VALUE, second,
            "has voxel (0, 0, 0) at y = 0.1 m, must be at 0 m, as in ", first);
    place = murk_affine_identity();
    place.matrix[2][2] = 1.5;
    write_grid(second, size, value, &place);
    refuses(first, second, MURK_BAD_VALUE, second,
            "axis k extends 1.5 m along z, must be 1 m, as in ", first);
    refuses(FOLDER "moved.vdb", first, MURK_BAD_VALUE, first, "axis i extends",
            "moved.vdb");
    /* A bad file is named, whichever it is. */
    const char *negative = FOLDER "negative.vdb", *none = FOLDER "none.vdb";
    refuses(first, negative, MURK_BAD_VALUE, negative, "negative", "-0.5");
    refuses(negative, first, MURK_BAD_VALUE, negative, "negative", "-0.5");
    refuses(first, FOLDER "background.vdb", MURK_BAD_VALUE,
            FOLDER "background.vdb", "has the value 0.25 everywhere outside",
            "must be 0");
    refuses(first, none, MURK_BAD_FILE, none, "holds no grids", "empty");
    refuses(first, "no-such.vdb", MURK_BAD_FILE, "no-such.vdb",
            "cannot be read", "No such file");
    refuses(first, FOLDER "make_grids.cpp", MURK_BAD_FILE,
            FOLDER "make_grids.cpp", "is not an OpenVDB file", "");
    /* The end of the second file is missing. */
    char text[4096];
    FILE *from = fopen(FOLDER "below.vdb", "rb"), *to = fopen(second, "wb");
    const size_t n = from ? fread(text, 1, sizeof text, from) : 0;
    CHECK(to && fwrite(text, 1, n, to) == n && n == sizeof text);
    fclose(from);
    fclose(to);
    refuses_one_of(first, second, "malformed");
}

int main(void)
{
    murk_warn_to(keep_warning);
    snprintf(folder, sizeof folder, "%s/murk_between_XXXXXX", P_tmpdir);
    if (!mkdtemp(folder)) {
        return 1;
    }
    snprintf(first, sizeof first, "%s/a.vdb", folder);
    snprintf(second, sizeof second, "%s/b.vdb", folder);
    test_each_voxel_is_the_mean(.25);
    test_each_voxel_is_the_mean(.1);
    test_tiles();
    test_other_values();
    test_refusals();
    remove(first);
    remove(second);
    rmdir(folder);
    return check_done();
}
