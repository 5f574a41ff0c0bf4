/* Chlorophyll in the sea, in mg/m3: a background and a deep maximum of Gaussian
 * shape, in which there are so many mg under a square metre. Means over voxels
 * are exact, so a column holds what is said. Patches, where asked for, are
 * lognormal of mean 1 and of one size in all directions.
 *
 * Source: Lewis, Cullen and Platt, J. Geophys. Res. 88 (1983) 2565,
 * doi:10.1029/JC088iC04p02565 (at second hand). */
#include "kinds.h"

#include <math.h>

enum { BACKGROUND, PEAK, PEAK_DEPTH_M, PEAK_WIDTH_M, PATCH, PATCH_M, CURRENT };

static double chlorophyll(const media_frame *f, murk_vec3 p)
{
    const double *w = f->word;
    const double half = f->voxel_m / 2, over = p.z + w[PEAK_DEPTH_M];
    const double mean =
        w[BACKGROUND] +
        w[PEAK] / f->voxel_m *
            normal_share(w[PEAK_WIDTH_M], over - half, over + half);
    if (!(w[PATCH] > 0)) {
        return mean;
    }
    const murk_vec3 moved =
        murk_vec((p.x - w[CURRENT] * f->time_s) / w[PATCH_M], p.y / w[PATCH_M],
                 p.z / w[PATCH_M]);
    return mean * noise_patches(w[PATCH], noise_normal(f->seed, 3, 4, moved));
}

const media_kind kind_chlorophyll = {
    .name = "chlorophyll",
    .about = "chlorophyll with a deep maximum, below z = 0",
    .unit = "mg/m3",
    .is_water = true,
    .size = {16, 16, 100},
    .voxel_m = 2,
    .words = {{"background_mg_per_m3", 0.1, 0, 100, "at all depths"},
              {"peak_mg_per_m2", 20, 0, 1e5, "in the maximum, over depth"},
              {"peak_depth_m", 70, 0, 1e4, "its depth [m]"},
              {"peak_width_m", 15, 0.01, 1e4, "its standard deviation [m]"},
              {"patch", 0, 0, 2, "standard deviation of the logarithm"},
              {"patch_m", 20, 0.01, 1e5, "size of patches [m]"},
              {"current_m_per_s", 0.1, 0, 10, "carries them [m/s]"}},
    .value = chlorophyll};
