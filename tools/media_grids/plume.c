/* A plume of sediment in a current, in g/m3: a steady source at one place,
 * carried along x, spreading across by eddies of constant diffusivity, sinking,
 * thrown back by surface and bed. Between the voxel's sides across the current
 * the Gaussian is integrated, so the flux through each section of the current
 * is the source's rate but for what is beyond the sides of the grid. Patches
 * are lognormal of mean 1 and move with the current.
 *
 * Source: the Gaussian plume with images, Sutton, Proc. R. Soc. A 135 (1932)
 * 143, doi:10.1098/rspa.1932.0025, and Csanady, Turbulent Diffusion in the
 * Environment (1973), ch. 3 (at second hand). */
#include "kinds.h"

#include <math.h>

#define IMAGES 8 /* of the source, over and under, on either side */

enum {
    RATE,
    CURRENT,
    MIX_ACROSS,
    MIX_UP,
    SINK,
    SOURCE_M,
    SOURCE_X,
    SOURCE_Z,
    PATCH,
    PATCH_M
};

/* Share of what lies about z, thrown back by surface and bed, between two
 * heights. From a spread of twice the depth on it is even to 1e-8. */
static double share_of_layer(double z, double spread, double deep, double from,
                             double to)
{
    if (spread > 2 * deep) {
        return (to - from) / deep;
    }
    double share = 0;
    for (int i = -IMAGES; i <= IMAGES; ++i) {
        const double image = 2 * i * deep; /* thrown back by both, i times */
        share += normal_share(spread, from - (image + z), to - (image + z));
        share += normal_share(spread, from - (image - z), to - (image - z));
    }
    return share;
}

static double sediment(const media_frame *f, murk_vec3 p)
{
    const double *w = f->word;
    const double x = p.x - w[SOURCE_X] * (double)f->size[0] * f->voxel_m;
    if (x < 0) {
        return 0;
    }
    const double deep = (double)f->size[2] * f->voxel_m;
    const double half = f->voxel_m / 2, age_s = x / w[CURRENT];
    const double r2 = w[SOURCE_M] * w[SOURCE_M];
    const double across = sqrt(r2 + 2 * w[MIX_ACROSS] * age_s);
    const double up = sqrt(r2 + 2 * w[MIX_UP] * age_s);
    const double y = p.y - (double)f->size[1] * f->voxel_m / 2;
    const double z = fmax(-deep, -w[SOURCE_Z] * deep - w[SINK] * age_s);
    const double share = share_of_layer(z, up, deep, p.z - half, p.z + half);
    const double per_m2 = share * normal_share(across, y - half, y + half) /
                          (f->voxel_m * f->voxel_m);
    const murk_vec3 moved =
        murk_vec((p.x - w[CURRENT] * f->time_s) / w[PATCH_M], p.y / w[PATCH_M],
                 p.z / w[PATCH_M]);
    return w[RATE] / w[CURRENT] * per_m2 *
           (w[PATCH] > 0
                ? noise_patches(w[PATCH], noise_normal(f->seed, 2, 4, moved))
                : 1);
}

const media_kind kind_plume = {
    .name = "plume",
    .about = "a plume of sediment in a current, below z = 0",
    .unit = "g/m3",
    .is_water = true,
    .size = {160, 64, 24},
    .voxel_m = 0.5,
    .words = {{"rate_g_per_s", 100, 0, 1e9, "what the source gives [g/s]"},
              {"current_m_per_s", 0.2, 1e-3, 10, "carries it [m/s]"},
              {"mixing_across_m2_per_s", 0.05, 0, 100, "diffusivity [m2/s]"},
              {"mixing_up_m2_per_s", 0.005, 0, 100, "diffusivity [m2/s]"},
              {"sinking_m_per_s", 5e-4, 0, 1, "speed of sinking [m/s]"},
              {"source_m", 0.5, 0.01, 100,
               "standard deviation of the source [m]"},
              {"source_x", 0.05, 0, 1, "its place along the grid, a share"},
              {"source_depth", 0.5, 0, 1, "its depth, a share of the grid's"},
              {"patch", 0.5, 0, 2, "standard deviation of the logarithm"},
              {"patch_m", 3, 0.01, 1e5, "size of patches [m]"}},
    .value = sediment};
