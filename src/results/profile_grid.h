/* A measured profile as a grid, for murk_context_profile_grid().
 *
 * The CSV has a column of places and one of the coefficient, each with its unit
 * in its name: `depth_m` (down from z = 0), `z_m`, `height_m` or `altitude_m`
 * (up), and a name with `_per_m`; `_km`, `_per_km`, and the same in brackets,
 * `depth[m]`, `c532[1/m]`, are read, too. Rows go one way, up or down; a place
 * given twice is a jump. Between rows the coefficient is linear, beyond them
 * there is nothing, as for `profile` in a scene.
 *
 * A voxel holds the mean of the coefficient over its height. The error of
 * rounding to single precision is carried to the next voxel. So the optical
 * depth of each voxel, and to the last digit that of the whole column, is that
 * of the profile. The grid `density` is in 1/m (extinction_per_m: 1 in a
 * scene), one voxel wide, about x = y = 0, and its top is the highest place. */
#ifndef MURK_RESULTS_PROFILE_GRID_H
#define MURK_RESULTS_PROFILE_GRID_H

#include "base/status.h"

#include <stddef.h>

/* A layer is a voxel of a grid; lengths are those that a scene may have. */
#define MURK_PROFILE_LAYERS_MAX   1000000
#define MURK_PROFILE_LENGTH_MAX_M 1e9

typedef struct murk_profile_settings {
    const char *csv;
    const char *column; /* of the coefficient; NULL: the only one there is */
    const char *rows;   /* "COLUMN=VALUE": of these rows only; NULL: all */
    double voxel_m;     /* height of a voxel; 0: a hundredth of the profile */
    double width_m;     /* of the grid in x and y; 0: 1000 */
} murk_profile_settings;

/* Layers from the top down, all of one height. If the height of the profile is
 * no multiple of it, the lowest layer reaches below the lowest place. */
typedef struct murk_profile_layers {
    size_t n;
    float *per_m;           /* [n] */
    double top_m, bottom_m; /* of the profile */
    double voxel_m, width_m;
    double depth;    /* integral of the coefficient along the profile */
    size_t rows;     /* read */
    char column[64]; /* that was read */
} murk_profile_layers;

/* Lengths of the settings must be 0 or more. Fails with MURK_BAD_VALUE or
 * MURK_BAD_FILE at the line and column of the fault. Release *out in any case.
 */
murk_status murk_profile_layers_read(murk_profile_layers *out,
                                     const murk_profile_settings *settings,
                                     murk_error *err);
void murk_profile_layers_release(murk_profile_layers *layers);

/* Writes them as a .vdb; see medium/grid_write.h. */
murk_status murk_profile_layers_write(const murk_profile_layers *layers,
                                      const char *path, murk_error *err);

#endif
