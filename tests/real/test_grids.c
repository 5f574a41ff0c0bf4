/* Real density grids against figures from an independent reader: counts,
 * extremes, sums, and the largest line integral along each axis; and files
 * that hold no density are refused by name. Deterministic. */
#include "base/log.h"
#include "check.h"
#include "grid_line.h"
#include "medium/grid.h"

#include <stdlib.h>
#include <unistd.h>

#define FOLDER "../shared/data/vdb/"
#define GRIDS  64

/* One grid of vdb_stats.json. */
typedef struct figures {
    char file[64], grid[64];
    int index;
    double active, bbox[6], minimum, maximum, sum, line[3];
} figures;

/* The text behind the next "key": after `from`. */
static const char *value_of(const char *from, const char *key)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    const char *at = strstr(from, quoted);
    return at ? at + strlen(quoted) : "";
}

static void read_text(const char *from, const char *key, char *to, size_t size)
{
    const char *at = strchr(value_of(from, key), '"');
    const size_t n = at ? strcspn(at + 1, "\"") : 0;
    snprintf(to, size, "%.*s", (int)n, at ? at + 1 : "");
}

static double read_number(const char *from, const char *key)
{
    return strtod(value_of(from, key), NULL);
}

/* Reads the figures of each grid. The file is regular enough for a search:
 * the keys of a grid follow its key "file". */
static size_t read_figures(figures *all, size_t max)
{
    /* Read the file. */
    static char text[65536];
    FILE *file = fopen(FOLDER "vdb_stats.json", "r");
    if (!file) {
        check_skip("../shared/data/vdb is not here");
    }
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    /* Read each key behind the next "file". */
    size_t n = 0;
    const char *at = text;
    while (n < max && (at = strstr(at, "\"file\"")) != NULL) {
        figures *f = &all[n++];
        read_text(at, "file", f->file, sizeof f->file);
        read_text(at, "grid", f->grid, sizeof f->grid);
        f->index = (int)read_number(at, "index");
        f->active = read_number(at, "active");
        f->minimum = read_number(at, "min");
        f->maximum = read_number(at, "max");
        f->sum = read_number(at, "sum");
        f->line[0] = read_number(at, "max_line_x");
        f->line[1] = read_number(at, "max_line_y");
        f->line[2] = read_number(at, "max_line_z");
        /* The bounding box is an array of six numbers. */
        const char *number = value_of(at, "bbox");
        for (int i = 0; i < 6; ++i) {
            char *end = NULL;
            number += strcspn(number, "-0123456789");
            f->bbox[i] = strtod(number, &end);
            number = end;
        }
        ++at;
    }
    return n;
}

/* The largest integral along an axis over all columns of voxels, in world
 * units: density times metres. */
static double largest_line(const murk_grid *grid, int axis)
{
    const murk_grid_facts *facts = murk_grid_describe(grid);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double length =
        (double)(facts->index_max[axis] - facts->index_min[axis]) + 3;
    double direction[3] = {0}, origin[3], largest = 0;
    direction[axis] = 1;
    origin[axis] = (double)facts->index_min[axis] - 1.5;
    for (int64_t i = facts->index_min[u]; i <= facts->index_max[u]; ++i) {
        for (int64_t j = facts->index_min[v]; j <= facts->index_max[v]; ++j) {
            origin[u] = (double)i;
            origin[v] = (double)j;
            largest = fmax(
                largest, grid_line_integral(
                             grid, murk_vec(origin[0], origin[1], origin[2]),
                             murk_vec(direction[0], direction[1], direction[2]),
                             length));
        }
    }
    return largest * facts->voxel_m[axis];
}

static void check_grid(const figures *want, bool has_namesakes)
{
    /* Read the grid; grids of the same name in a file are told apart by
     * index. */
    char path[160], name[96];
    snprintf(path, sizeof path, FOLDER "%s", want->file);
    snprintf(name, sizeof name, has_namesakes ? "%s[%d]" : "%s", want->grid,
             want->index);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, name, "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (!grid) {
        return;
    }
    /* Facts and line integrals agree with the figures. */
    const murk_grid_facts *got = murk_grid_describe(grid);
    CHECK((double)got->active == want->active);
    CHECK_TEXT(got->name, name);
    CHECK(got->minimum == want->minimum);
    CHECK(got->maximum == want->maximum);
    CHECK_NEAR(got->sum, want->sum, 1e-9 * want->sum);
    for (int axis = 0; axis < 3; ++axis) {
        CHECK((double)got->index_min[axis] == want->bbox[axis]);
        CHECK((double)got->index_max[axis] == want->bbox[axis + 3]);
        CHECK_NEAR(largest_line(grid, axis), want->line[axis],
                   1e-5 * want->line[axis]);
    }
    murk_grid_destroy(grid);
}

static void refuses(const char *file, const char *name, murk_status status,
                    const char *part)
{
    char path[160];
    snprintf(path, sizeof path, FOLDER "%s", file);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, name, "test", &err) == status);
    CHECK(grid == NULL);
    CHECK_MENTIONS(err.where, file);
    CHECK_MENTIONS(err.text, part);
}

static void test_what_is_no_density_is_refused(void)
{
    refuses("zeno_res.vdb", NULL, MURK_BAD_VALUE, "[0] is a level set");
    refuses("zeno_vel.vdb", NULL, MURK_BAD_VALUE, "vel holds vec3s");
    refuses("smoke_r64_f50.vdb", "velocity", MURK_BAD_VALUE,
            "velocity holds vec3s");
    refuses("smoke_r64_f50.vdb", "shadow", MURK_BAD_VALUE,
            "65536 of 65536 values are negative or not finite, the first is "
            "-1 at voxel (0, 0, 0)");
    refuses("usd_smoke_000001.vdb", "obstacles", MURK_BAD_VALUE,
            "obstacles holds int32");
    refuses("fvdb_smoke-blosc.nvdb", NULL, MURK_BAD_FILE, "NanoVDB");
    refuses("arnold_grids.vdb", NULL, MURK_BAD_VALUE,
            "density[0] (float), density[1] (float), density[2] (float)");
    refuses("arnold_grids.vdb", "density", MURK_BAD_VALUE, "several grids");
    refuses("usd_densityAndHeat.vdb", "smoke", MURK_BAD_VALUE,
            "no grid named smoke; there are density (float), heat (float)");
}

static char warned[640];

static void keep_warning(const char *where, const char *text)
{
    snprintf(warned, sizeof warned, "%s: %s", where, text);
}

static const murk_grid_facts *facts_of(murk_grid **grid, const char *file,
                                       const char *name)
{
    murk_error err = {0};
    warned[0] = '\0';
    CHECK(murk_grid_read(grid, file, name, "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return *grid ? murk_grid_describe(*grid) : NULL;
}

static void test_nothing_is_allowed_with_a_warning(void)
{
    murk_grid *grid = NULL;
    const murk_grid_facts *facts =
        facts_of(&grid, FOLDER "usd_smoke_000001.vdb", NULL);
    CHECK(facts && facts->active == 0);
    CHECK_MENTIONS(warned, "grid density is empty");
    CHECK(grid && grid_line_integral(grid, murk_vec(0, 0, 0), murk_vec(1, 0, 0),
                                     100) == 0);
    CHECK(grid && murk_grid_value(grid, 0, 0, 0) == 0);
    murk_grid_destroy(grid);

    /* Its one level has a `flame` grid without a voxel. */
    grid = NULL;
    facts = facts_of(&grid, FOLDER "smoke_r64_f50.vdb", "flame");
    CHECK(facts && facts->active == 0);
    CHECK_MENTIONS(warned, "grid flame is empty");
    murk_grid_destroy(grid);

    grid = NULL;
    facts = facts_of(&grid, FOLDER "tinyvdbio_sphere-div1.vdb", NULL);
    CHECK(facts && facts->active == 19);
    CHECK_MENTIONS(warned, "grid density is 0 everywhere");
    murk_grid_destroy(grid);
}

/* Without a name: the only float grid, or `density` among several. */
static void test_the_obvious_grid_needs_no_name(void)
{
    const char *file[] = {FOLDER "arnold_torus01.vdb",
                          FOLDER "smoke_r64_f50.vdb",
                          FOLDER "usd_densityAndHeat.vdb"};
    const char *want[] = {"voxel_fog_density", "density", "density"};
    for (int i = 0; i < 3; ++i) {
        murk_grid *grid = NULL;
        const murk_grid_facts *facts = facts_of(&grid, file[i], NULL);
        CHECK_TEXT(facts ? facts->name : "", want[i]);
        CHECK_TEXT(warned, "");
        murk_grid_destroy(grid);
    }
}

int main(void)
{
    static figures all[GRIDS];
    const size_t n = read_figures(all, GRIDS);
    CHECK(n >= 11);
    murk_warn_to(keep_warning);
    for (size_t i = 0; i < n; ++i) {
        bool has_namesakes = false;
        for (size_t j = 0; j < n; ++j) {
            has_namesakes |= j != i && strcmp(all[i].file, all[j].file) == 0 &&
                             strcmp(all[i].grid, all[j].grid) == 0;
        }
        check_grid(&all[i], has_namesakes);
    }
    test_what_is_no_density_is_refused();
    test_nothing_is_allowed_with_a_warning();
    test_the_obvious_grid_needs_no_name();
    return check_done();
}
