/* Writes the step cloud of I3RC phase 1, case 1, as a .vdb, or checks that a
 * file holds it:
 *
 *   make_step_cloud FILE
 *   make_step_cloud --check FILE
 *
 * 32 x 32 x 16 cubes of 15.625 m from the origin on; density 1 in the western
 * 16 columns and 9 in the others. The check is of contents, since the
 * library's version is in the bytes.
 *
 * Source: Cahalan et al., Bull. Am. Meteorol. Soc. 86 (2005) 1275,
 * doi:10.1175/BAMS-86-9-1275. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "medium/grid.h"
#include "medium/grid_write.h"
#include "medium/media.h"

#define COLUMNS 32
#define LAYERS  16
#define CUBE_M  15.625
#define THIN    1.0
#define THICK   9.0

static const size_t SIZE[3] = {COLUMNS, COLUMNS, LAYERS};

static double density_of(size_t column)
{
    return column < COLUMNS / 2 ? THIN : THICK;
}

static murk_status write_cloud(const char *path, murk_error *err)
{
    static float value[COLUMNS * COLUMNS * LAYERS];
    for (size_t i = 0; i < sizeof value / sizeof *value; ++i) {
        value[i] = (float)density_of(i % COLUMNS);
    }
    const murk_grid_field field = {.name = "density", .value = value};
    const murk_vec3 middle = {CUBE_M / 2, CUBE_M / 2, CUBE_M / 2};
    const murk_affine place =
        murk_affine_place(murk_vec(0, 0, 0), CUBE_M, middle);
    return murk_grid_write(path, &field, 1, SIZE, &place, err);
}

/* The number of voxels whose density, at the middle, is not the cloud's; those
 * around the cloud must be empty. */
static size_t wrong_voxels(const murk_media *media)
{
    size_t wrong = 0;
    for (int i = -1; i <= COLUMNS; ++i) {
        for (int j = -1; j <= COLUMNS; ++j) {
            for (int k = -1; k <= LAYERS; ++k) {
                const bool inside = i >= 0 && i < COLUMNS && j >= 0 &&
                                    j < COLUMNS && k >= 0 && k < LAYERS;
                const double want = inside ? density_of((size_t)i) : 0;
                const murk_vec3 p = {(i + .5) * CUBE_M, (j + .5) * CUBE_M,
                                     (k + .5) * CUBE_M};
                wrong += murk_media_extinction(media, 0, 0, p) != want;
            }
        }
    }
    return wrong;
}

static murk_status check_cloud(const char *path, murk_error *err)
{
    murk_grid *grid = NULL;
    murk_media *media = NULL;
    murk_status status = murk_grid_read(&grid, path, "density", path, err);
    if (status) {
        return status;
    }
    const murk_medium medium = {
        .extinction_per_m = {{1}}, .grid = grid, .where = path};
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity(),
                                .where = path};
    const murk_box around = {{-100, -100, -100}, {600, 600, 350}};
    status = murk_media_create(&media, &medium, 1, &region, 1, &around, err);
    if (!status && wrong_voxels(media) > 0) {
        status = murk_fail(err, MURK_BAD_FILE, path,
                           "%zu voxels are not the step cloud's",
                           wrong_voxels(media));
    }
    murk_media_destroy(media);
    murk_grid_destroy(grid);
    return status;
}

int main(int argc, char **argv)
{
    const bool checks = argc == 3 && strcmp(argv[1], "--check") == 0;
    if (argc != 2 && !checks) {
        fprintf(stderr, "usage: make_step_cloud [--check] FILE\n");
        return 2;
    }
    murk_error err = {0};
    const murk_status status =
        checks ? check_cloud(argv[2], &err) : write_cloud(argv[1], &err);
    if (status) {
        fprintf(stderr, "make_step_cloud: %s: %s\n", err.where, err.text);
    }
    return status ? 1 : 0;
}
