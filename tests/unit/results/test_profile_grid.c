/* Measured profiles made into grids: the column's optical depth and that of
 * each voxel against the profile's integral, units, and what is refused.
 * Nothing here is random. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "check.h"
#include "medium/media.h"
#include "results/profile_grid.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_profile_XXXXXX";
static char csv[64], vdb[64];

static murk_status layers_of(murk_profile_layers *out, const char *text,
                             const char *column, const char *rows,
                             double voxel_m, murk_error *err)
{
    write_text(csv, text);
    *err = (murk_error){0};
    const murk_profile_settings settings = {
        .csv = csv, .column = column, .rows = rows, .voxel_m = voxel_m};
    return murk_profile_layers_read(out, &settings, err);
}

static double depth_of(const murk_profile_layers *l)
{
    double sum = 0;
    for (size_t i = 0; i < l->n; ++i) {
        sum += (double)l->per_m[i] * l->voxel_m;
    }
    return sum;
}

#define CAST                        \
    "# a cast\n"                    \
    "depth_m,c_per_m,note\n"        \
    "0,0.10,top\n2,0.30,\n5,0.3,\n" \
    "5,0.8,jump\n10,0.0,bottom\n"
#define CAST_DEPTH (0.2 * 2 + 0.3 * 3 + 0.4 * 5)

static void test_a_column_keeps_its_depth(void)
{
    const double voxel_m[] = {0.001, 0.3, 1, 2.5, 7, 10, 1000};
    for (int i = 0; i < 7; ++i) {
        murk_profile_layers l;
        murk_error err;
        CHECK(!layers_of(&l, CAST, NULL, NULL, voxel_m[i], &err));
        CHECK(l.n == (size_t)ceil(10 / voxel_m[i] - 1e-9) && l.top_m == 0);
        CHECK(l.rows == 5);
        CHECK_NEAR(l.depth, CAST_DEPTH, 1e-12);
        /* single precision of one voxel is all that is off */
        CHECK_NEAR(depth_of(&l), CAST_DEPTH, 1e-7 * fmax(1, voxel_m[i]));
        murk_profile_layers_release(&l);
    }
}

static void test_voxels_hold_means(void)
{
    murk_profile_layers l;
    murk_error err;
    CHECK(!layers_of(&l, CAST, "c_per_m", NULL, 2.5, &err));
    CHECK(l.n == 4);
    CHECK_NEAR(l.per_m[0], (0.4 + 0.15) / 2.5, 1e-7);
    CHECK_NEAR(l.per_m[1], 0.3, 1e-7);
    CHECK_NEAR(l.per_m[2], 0.6, 1e-7);
    CHECK_NEAR(l.per_m[3], 0.2, 1e-7);
    murk_profile_layers_release(&l);
}

/* The same cast upwards, in other units, and one of two in a file. */
static void test_units_and_directions(void)
{
    static const char *const same[] = {
        "height[km],b[1/km]\n-.01,0\n-.005,800\n-.005,300\n-.002,300\n0,100\n",
        "b_per_cm,depth_cm\n.001,0\n.003,200\n.003,500\n.008,500\n0,1000\n",
        ("z_m,s,q[1/m],c_per_m\n3,b,1,1\n0,a,1,.1\n-2,a,1,.3\n-5,a,1,.3\n"
         "-5,a,1,.8\n-10,a,1,0\n4,b,1,1\n")};
    for (int i = 0; i < 3; ++i) {
        murk_profile_layers l;
        murk_error err;
        CHECK(!layers_of(&l, same[i], i == 2 ? "c_per_m" : NULL,
                         i == 2 ? "s=a" : NULL, 2.5, &err));
        CHECK_TEXT(err.text, "");
        CHECK_NEAR(l.depth, CAST_DEPTH, 1e-12);
        CHECK(l.n == 4 && l.top_m == 0);
        CHECK_NEAR(l.per_m[2], 0.6, 1e-7);
        murk_profile_layers_release(&l);
    }
}

/* A profile through the written file, as a medium: optical depth straight
 * down, along a slant, and voxel by voxel. */
static void test_depth_through_the_grid(void)
{
    /* Write the layers of the profile as a grid, and read the grid as a
     * medium. */
    murk_profile_layers l;
    murk_error err;
    CHECK(!layers_of(&l, CAST, NULL, NULL, 0.7, &err));
    CHECK(!murk_profile_layers_write(&l, vdb, &err));
    murk_grid *grid = NULL;
    murk_media *media = NULL;
    CHECK(!murk_grid_read(&grid, vdb, NULL, "grid", &err));
    const murk_medium medium = {.extinction_per_m = {{1}}, .grid = grid};
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity()};
    const murk_box box = {{-400, -400, -20}, {400, 400, 20}};
    CHECK(!murk_media_create(&media, &medium, 1, &region, 1, &box, &err));
    /* Straight down and along a slant, the optical depth is the integral of
     * the profile. */
    const murk_vec3 down = {0, 0, -1}, slant = {.6, 0, -.8};
    CHECK_NEAR(
        murk_media_optical_depth(media, 0, 0, murk_vec(1, 2, 9), down, 30),
        CAST_DEPTH, 1e-6);
    CHECK_NEAR(
        murk_media_optical_depth(media, 0, 0, murk_vec(1, 2, 8), slant, 30),
        CAST_DEPTH / .8, 1e-6);
    /* Each voxel has the extinction of the layer. */
    for (size_t i = 0; i < l.n; ++i) {
        CHECK_NEAR(murk_media_optical_depth(
                       media, 0, 0, murk_vec(-3, 4, -.7 * (double)i), down, .7),
                   (double)l.per_m[i] * .7, 1e-6);
    }
    murk_media_destroy(media);
    murk_grid_destroy(grid);
    murk_profile_layers_release(&l);
}

typedef struct refusal {
    const char *text, *column, *rows;
    double voxel_m;
    const char *where, *what;
} refusal;

static void test_refusals(void)
{
    /* Files with too few rows, places out of order, cells that are no
     * numbers, values out of limits, and missing columns. */
    static const refusal bad[] = {
        {"", NULL, NULL, 0, "", ""},
        {"depth_m,c_per_m\n", NULL, NULL, 0, "cast.csv", "0 rows"},
        {"depth_m,c_per_m\n1,2\n", NULL, NULL, 0, "cast.csv", "1 rows"},
        {"depth_m,c_per_m\n1,2\n1,3\n", NULL, NULL, 0, "", "different places"},
        {"depth_m,c_per_m\n1,2\n1,3\n1,4\n", NULL, NULL, 0, "cast.csv:4",
         "each place twice at most"},
        {"depth_m,c_per_m\n1,2\n2,3\n1,4\n", NULL, NULL, 0,
         "cast.csv:4: depth_m", "1 after 2, must go one way"},
        {"depth_m,c_per_m\n1,2\n2,x\n", NULL, NULL, 0, "cast.csv:3",
         "must be a number"},
        {"depth_m,c_per_m\n1,2\n2,nan\n", NULL, NULL, 0, "cast.csv:3",
         "must be a number"},
        {"depth_m,c_per_m\n1,2\n2,\n", NULL, NULL, 0, "cast.csv:3", ""},
        {"depth_m,c_per_m\n1,2\n2,-1\n", NULL, NULL, 0, "cast.csv:3: c_per_m",
         "-1, must be 0 to"},
        {"depth_m,c_per_m\n1,2\n2,1e10\n", NULL, NULL, 0, "cast.csv:3: c_per_m",
         "1e+10, must be 0 to"},
        {"depth_m,c_per_m\n1,2\n1e300,1\n", NULL, NULL, 0,
         "cast.csv:3: depth_m", "1e+300, must be at most 1e+09 m"},
        {"depth_m,z_m,c_per_m\n1,2,3\n", NULL, NULL, 0, "cast.csv",
         "columns depth_m and z_m"},
        {"depth,c_per_m\n1,2\n", NULL, NULL, 0, "cast.csv",
         "no column of places"},
        {"depth_m,c\n1,2\n", NULL, NULL, 0, "cast.csv",
         "no column of a coefficient"},
        {"depth_m,c_per_m,b_per_m\n1,2,3\n", NULL, NULL, 0, "cast.csv",
         "c_per_m and b_per_m, must choose with options->column"},
        {"depth_m,c_per_m\n1,2\n", "d_per_m", NULL, 0, "cast.csv",
         "options->column d_per_m: not a column"},
        {"depth_m,c_per_m\n1,2\n", "depth_m", NULL, 0, "cast.csv",
         "no unit in its name"},
        {"depth_m,c_per_m\n1,2\n", NULL, "s=a", 0, "cast.csv",
         "options->rows s=a: must be COLUMN=VALUE"},
        {"depth_m,c_per_m\n1,2\n2,2\n", NULL, "c_per_m=7", 0, "cast.csv",
         "0 rows of a profile where c_per_m=7"},
        {CAST, NULL, NULL, 1e-9, "cast.csv", "1e+10 voxels of 1e-09 m"}};
    /* Each is refused with a message of one line and the place in the file. */
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        murk_profile_layers l;
        murk_error err;
        CHECK(layers_of(&l, bad[i].text, bad[i].column, bad[i].rows,
                        bad[i].voxel_m, &err) != MURK_OK);
        CHECK_MENTIONS(err.where, bad[i].where);
        CHECK_MENTIONS(err.text, bad[i].what);
        CHECK(!strchr(err.text, '\n'));
        murk_profile_layers_release(&l);
    }
}

int main(void)
{
    if (!mkdtemp(folder)) {
        return 1;
    }
    snprintf(csv, sizeof csv, "%s/cast.csv", folder);
    snprintf(vdb, sizeof vdb, "%s/cast.vdb", folder);
    test_a_column_keeps_its_depth();
    test_voxels_hold_means();
    test_units_and_directions();
    test_depth_through_the_grid();
    test_refusals();
    remove(csv);
    remove(vdb);
    rmdir(folder);
    return check_done();
}
