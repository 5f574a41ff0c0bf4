/* Small OpenVDB files, each with one oddity (grids/make_grids.cpp): what is
 * read, what is refused and how it is told. Deterministic. */
#include "base/log.h"
#include "check.h"
#include "grid_line.h"
#include "medium/grid.h"
#include "medium/grid_choice.h"

#include <unistd.h>

#define FOLDER "tests/unit/medium/grids/"

static char warned[960];

static void keep_warning(const char *where, const char *text)
{
    snprintf(warned, sizeof warned, "%s: %s", where, text);
}

static murk_grid *reads(const char *file, const char *name)
{
    char path[128];
    snprintf(path, sizeof path, FOLDER "%s", file);
    murk_grid *grid = NULL;
    murk_error err = {0};
    warned[0] = '\0';
    CHECK(murk_grid_read(&grid, path, name, "fog.yaml:7:3: media.fog.vdb",
                         &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return grid;
}

static void refuses(const char *file, const char *name, murk_status status,
                    const char *text)
{
    char path[128], where[192];
    snprintf(path, sizeof path, FOLDER "%s", file);
    snprintf(where, sizeof where, "fog.yaml:7:3: media.fog.vdb: %s", path);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, name, "fog.yaml:7:3: media.fog.vdb",
                         &err) == status);
    CHECK(grid == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_TEXT(err.text, text);
}

/* Along +x through the middle of the voxels (., j, k). */
static double along_x(const murk_grid *grid, double from, double j, double k,
                      double length)
{
    return grid_line_integral(grid, murk_vec(from, j, k), murk_vec(1, 0, 0),
                              length);
}

static void test_tiles_of_every_size_are_density(void)
{
    murk_grid *grid = reads("tiles.vdb", NULL);
    if (!grid) {
        return;
    }
    const murk_grid_facts *facts = murk_grid_describe(grid);
    const double big = 4096.0 * 4096 * 4096, middle = 128.0 * 128 * 128;
    CHECK((double)facts->active == big + middle + 512 + 8);
    CHECK_NEAR(facts->sum, big + 2 * middle + 3 * 512 + 28, 1);
    CHECK(facts->maximum == 7 && facts->minimum == 0);
    CHECK(facts->index_min[0] == -8 && facts->index_max[0] == 8191);
    CHECK(facts->memory_bytes < 1000000);
    CHECK_TEXT(warned, "");

    CHECK(murk_grid_value(grid, -1, -8, -5) == 3);
    CHECK(murk_grid_value(grid, -9, -8, -5) == 0);
    CHECK(murk_grid_value(grid, 5, 0, 0) == 5);
    CHECK(murk_grid_value(grid, 255, 127, 127) == 2);
    CHECK(murk_grid_value(grid, 256, 0, 0) == 0);
    CHECK(murk_grid_value(grid, 8191, 4095, 0) == 1);
    CHECK(murk_grid_value(grid, 8192, 0, 0) == 0);

    CHECK_NEAR(along_x(grid, -100, -4, -4, 1e4), 3 * 8, 1e-9);
    CHECK_NEAR(along_x(grid, -100, 0, 0, 1e4), 28 + 2 * 128 + 4096, 1e-9);
    CHECK_NEAR(along_x(grid, 5000, 9, 9, 10), 10, 1e-9);
    /* Corner to corner of the largest tile, backwards. */
    const murk_vec3 from = {8191.5, 4095.5, 4095.5};
    CHECK_NEAR(
        grid_line_integral(grid, from, murk_unit(murk_vec(-1, -1, -1)), 1e5),
        4096 * sqrt(3), 1e-8);
    murk_grid_destroy(grid);
}

/* 2e9 voxels wide, two of them filled: nothing may cost by the width. */
static void test_a_sparse_box_is_never_filled(void)
{
    murk_grid *grid = reads("wide.vdb", NULL);
    if (!grid) {
        return;
    }
    CHECK(murk_grid_describe(grid)->active == 2);
    CHECK(murk_grid_describe(grid)->memory_bytes < 1000000);
    CHECK(murk_grid_value(grid, 1000000000, -7, 5) == 3);
    CHECK(murk_grid_value(grid, 0, -7, 5) == 0);
    for (int i = 0; i < 1000; ++i) {
        CHECK_NEAR(along_x(grid, -1000000009.0, -7, 5, 3e9), 5, 1e-6);
    }
    CHECK(along_x(grid, -999999999.0, -7, 5, 1.9e9) == 0);
    CHECK(along_x(grid, 1000000000, -7, 5, 9) == 1.5);
    murk_grid_destroy(grid);
}

/* Voxels of 0.5 x 2 x 4 m, turned by 90 degrees about z, moved. */
static void test_transforms_and_half_floats(void)
{
    murk_grid *grid = reads("moved.vdb", "density");
    if (!grid) {
        return;
    }
    const murk_grid_facts *facts = murk_grid_describe(grid);
    CHECK_NEAR(facts->voxel_m[0], 0.5, 1e-12);
    CHECK_NEAR(facts->voxel_m[1], 2, 1e-12);
    CHECK_NEAR(facts->voxel_m[2], 4, 1e-12);
    const murk_vec3 p =
        murk_affine_point(&facts->index_to_world, murk_vec(3, 1, 0));
    CHECK_NEAR(p.x, 10 - 2, 1e-12);
    CHECK_NEAR(p.y, 20 + 1.5, 1e-12);
    CHECK_NEAR(p.z, 30, 1e-12);
    CHECK_NEAR(facts->maximum, 0.3, 0.3 * 0x1p-11); /* a half's digits */
    murk_grid_destroy(grid);
}

static void test_what_is_not_active_counts_as_nothing(void)
{
    murk_grid *grid = reads("inactive.vdb", NULL);
    if (!grid) {
        return;
    }
    CHECK_MENTIONS(warned, "513 voxels hold a value but are not active");
    CHECK(murk_grid_describe(grid)->sum == 1);
    CHECK(along_x(grid, -5, 0, 0, 50) == 1);
    murk_grid_destroy(grid);
}

static void test_names(void)
{
    murk_grid *grid = reads("names.vdb", "smoke[1]");
    CHECK(grid && murk_grid_value(grid, 0, 0, 0) == 2);
    murk_grid_destroy(grid);
    grid = reads("names.vdb", "");
    CHECK(grid && murk_grid_value(grid, 0, 0, 0) == 3);
    murk_grid_destroy(grid);
    grid = reads("nameless.vdb", NULL);
    CHECK(grid && murk_grid_value(grid, 0, 0, 0) == 3);
    murk_grid_destroy(grid);

#define ALL                                                                \
    "[0] (float), fine (double), mask (bool), smoke[0] (float), smoke[1] " \
    "(float)"
    refuses("names.vdb", "smoke", MURK_BAD_VALUE,
            "several grids, choose one by name (such as smoke[0]) among " ALL);
    refuses("names.vdb", NULL, MURK_BAD_VALUE,
            "several grids, choose one by name (such as [0]) among " ALL);
    refuses("names.vdb", "smoke[2]", MURK_BAD_VALUE,
            "no grid named smoke[2]; there are " ALL);
    refuses("names.vdb", "mask", MURK_BAD_VALUE,
            "grid mask holds bool, must be float, half or double");
    grid = reads("names.vdb", "fine"); /* in double precision, but empty */
    CHECK(grid && murk_grid_describe(grid)->active == 0);
    murk_grid_destroy(grid);
}

static void test_double_precision_is_read_as_floats(void)
{
    murk_grid *grid = reads("fine.vdb", NULL);
    CHECK(grid && murk_grid_value(grid, 1, 2, 3) == (double)0.1F);
    CHECK(grid && murk_grid_value(grid, 9, 2, 3) == 0); /* 1e-300 */
    CHECK(grid && murk_grid_describe(grid)->active == 513);
    murk_grid_destroy(grid);
    refuses("fine_overflow.vdb", NULL, MURK_BAD_VALUE,
            "grid density holds 1e+39 at voxel (2, 2, 3), must be at most "
            "3.40282e+38, as floats hold");
}

static void refuses_albedo(const char *file, const char *text)
{
    char path[128];
    snprintf(path, sizeof path, FOLDER "%s", file);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read_albedo(&grid, path, "albedo", "test", &err) ==
          MURK_BAD_VALUE);
    CHECK(grid == NULL);
    CHECK_TEXT(err.text, text);
}

static void test_albedos_have_a_background(void)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    warned[0] = '\0';
    CHECK(murk_grid_read_albedo(&grid, FOLDER "albedo.vdb", NULL, "test",
                                &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    CHECK_TEXT(warned, "");
    CHECK(grid && murk_grid_describe(grid)->background == 0.5);
    CHECK(grid && murk_grid_describe(grid)->minimum == 0);
    CHECK(grid && murk_grid_describe(grid)->maximum == 0.75);
    murk_grid_destroy(grid);
    /* A large cell of albedo 0 is no cell without an albedo. */
    CHECK(murk_grid_read_albedo(&grid, FOLDER "albedo_tile.vdb", NULL, "test",
                                &err) == MURK_OK);
    CHECK(grid && murk_grid_value(grid, 9, 4000, 17) == 0);
    CHECK(grid && murk_grid_value(grid, -1, 0, 0) == 0.25);
    CHECK(grid && murk_grid_value(grid, -1, 1, 0) < 0);
    murk_grid_destroy(grid);
    refuses_albedo("albedo_above.vdb",
                   "grid albedo: 1 of 4 values are no share, the first is 1.5 "
                   "at voxel (2, 0, 0), (2, 0, 0) m; albedo must be 0..1");
    refuses_albedo("albedo_background.vdb",
                   "grid albedo has the value -1 everywhere outside (its "
                   "background), must be 0..1");
}

static void test_what_is_no_density_is_refused(void)
{
    /* Values that are negative or not finite, in the grid or as background. */
    refuses("negative.vdb", NULL, MURK_BAD_VALUE,
            "grid density: 2 of 3 values are negative or not finite, the "
            "first is -0.5 at voxel (2, 1, 1), (2, 1, 1) m; density must be 0 "
            "or more");
    refuses("nan.vdb", NULL, MURK_BAD_VALUE,
            "grid density: 1 of 2 values are negative or not finite, the "
            "first is nan at voxel (1, 2, 1), (1, 2, 1) m; density must be 0 "
            "or more");
    refuses("infinite.vdb", NULL, MURK_BAD_VALUE,
            "grid density: 512 of 512 values are negative or not finite, the "
            "first is inf at voxel (0, 0, 0), (0, 0, 0) m; density must be 0 "
            "or more");
    refuses("background.vdb", NULL, MURK_BAD_VALUE,
            "grid density has the value 0.25 everywhere outside (its "
            "background), must be 0");
    refuses("nan_background.vdb", NULL, MURK_BAD_VALUE,
            "grid density has the value nan everywhere outside (its "
            "background), must be 0");
    /* Grids of other types, or with transforms or extents that cannot be
     * used. */
    refuses("mask.vdb", NULL, MURK_BAD_VALUE,
            "grid mask holds bool, must be float, half or double");
    refuses("points.vdb", NULL, MURK_BAD_VALUE,
            "grid points holds ptdataidx32, must be float, half or double");
    refuses("frustum.vdb", NULL, MURK_BAD_VALUE,
            "grid density has a frustum transform, must be linear");
    refuses("overflow.vdb", NULL, MURK_BAD_FILE,
            "grid density has a transform that is singular or not finite");
    refuses("far.vdb", NULL, MURK_BAD_FILE,
            "grid density reaches from voxel 2000000000 to 2000000000 along "
            "z, must be within 2^30");
    /* Files without a grid or of another format, and paths that are no
     * file. */
    refuses("none.vdb", NULL, MURK_BAD_FILE,
            "holds no grids: empty, or cut off in its header");
    refuses("make_grids.cpp", NULL, MURK_BAD_FILE,
            "is not an OpenVDB file (its first bytes differ)");
    refuses("nowhere.vdb", NULL, MURK_BAD_FILE,
            "cannot be read: No such file or directory");
    refuses("", NULL, MURK_BAD_FILE, "is a folder, must be an OpenVDB file");
}

static void refuses_samples(size_t nx, size_t ny, float value, const char *part)
{
    const size_t size[3] = {nx, ny, 1};
    const float density[2] = {1, value};
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_from_samples(&grid, size, density, &identity, "tool",
                                 &err) == MURK_BAD_VALUE);
    CHECK(grid == NULL);
    CHECK_TEXT(err.where, "tool");
    CHECK_MENTIONS(err.text, part);
}

static void test_samples_are_checked_like_files(void)
{
    refuses_samples(2, 1, -1, "the first is -1 at voxel (1, 0, 0)");
    refuses_samples(2, 1, NAN, "not finite");
    refuses_samples(0, 1, 1, "0 x 1 x 1 samples");
    refuses_samples((size_t)-1, (size_t)-1, 1, "at most 2147483648 in all");

    const size_t size[3] = {2, 1, 1};
    const float zero[2] = {0, 0};
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    CHECK(murk_grid_from_samples(&grid, size, zero, &identity, "tool", NULL) ==
          MURK_OK);
    CHECK(grid && murk_grid_describe(grid)->active == 0);
    CHECK(grid && along_x(grid, -5, 0, 0, 50) == 0);
    murk_grid_destroy(grid);
    murk_grid_destroy(NULL);
}

/* Of some grids: the only density, or that called so; by name the only one of
 * that name, or of that unique name. */
static void test_the_grid_that_is_meant(void)
{
    const murk_grid_entry density[2] = {
        {"density[0]", "density", "float", false, true},
        {"density[1]", "density", "float", false, true}};
    const murk_grid_entry smoke = {"smoke", "smoke", "double", false, true};
    const murk_grid_entry shape = {"shape", "shape", "float", true, true};
    const murk_grid_entry wind = {"wind", "wind", "vec3s", false, true};
    const murk_grid_entry fan = {"fan", "fan", "float", false, false};
    const murk_grid_entry none = {0};
    const struct {
        murk_grid_entry entry[3];
        size_t n;
        const char *name;
        size_t chosen; /* 9: none */
        const char *why;
    } cases[] = {
        {{wind, shape, smoke}, 3, NULL, 2, NULL},
        {{smoke, wind, density[1]}, 3, NULL, 2, NULL},
        {{smoke, wind, density[1]}, 3, "smoke", 0, NULL},
        {{wind, density[0], density[1]}, 3, "density[1]", 2, NULL},
        {{none}, 0, NULL, 9, "holds no grids: empty, or cut off in its header"},
        {{wind, shape},
         2,
         NULL,
         9,
         "no float grid; there are wind (vec3s), shape (level set)"},
        {{smoke, fan},
         2,
         NULL,
         9,
         "several grids, choose one by name (such as smoke) among smoke "
         "(double), fan (float)"},
        {{smoke, density[0], density[1]},
         3,
         NULL,
         9,
         "several grids, choose one by name (such as density[0]) among smoke "
         "(double), density[0] (float), density[1] (float)"},
        {{smoke, density[0], density[1]},
         3,
         "density",
         9,
         "(such as density[0])"},
        {{smoke, wind},
         2,
         "fog",
         9,
         "no grid named fog; there are smoke (double), wind (vec3s)"},
        {{wind},
         1,
         NULL,
         9,
         "grid wind holds vec3s, must be float, half or double"},
        {{shape}, 1, NULL, 9, "grid shape is a level set"},
        {{fan}, 1, NULL, 9, "grid fan has a frustum transform"},
        {{smoke, shape}, 2, "shape", 9, "grid shape is a level set"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        size_t chosen = 9;
        murk_error err = {0};
        CHECK((murk_grid_choose(&chosen, cases[i].entry, cases[i].n,
                                cases[i].name, "here", &err) == MURK_OK) ==
              (cases[i].chosen != 9));
        if (cases[i].why) {
            CHECK_MENTIONS(err.text, cases[i].why);
        } else {
            CHECK(chosen == cases[i].chosen);
        }
    }
}

int main(void)
{
    murk_warn_to(keep_warning);
    test_tiles_of_every_size_are_density();
    test_a_sparse_box_is_never_filled();
    test_transforms_and_half_floats();
    test_what_is_not_active_counts_as_nothing();
    test_names();
    test_the_grid_that_is_meant();
    test_double_precision_is_read_as_floats();
    test_albedos_have_a_background();
    test_what_is_no_density_is_refused();
    test_samples_are_checked_like_files();
    return check_done();
}
