/* A bank of fog. In well-mixed, optically thick fog the liquid water rises
 * linearly with height and falls off at the top, where dry air is mixed in; in
 * thin fog it is most at the ground. Extinction goes by the water to 2/3 where
 * the number of droplets is the same throughout. Value 1 is the mean at the
 * ground, where visibility is read.
 *
 * Sources: Toledo, Haeffelin, Waersted and Dupont, Atmos. Chem. Phys. 21 (2021)
 * 13099, doi:10.5194/acp-21-13099-2021 (linear with height); Costabloz and
 * others, Atmos. Chem. Phys. 25 (2025) 6539, doi:10.5194/acp-25-6539-2025 (thin
 * and thick fog). Patches and swell are not theirs: lognormal, of mean 1. */
#include "kinds.h"

#include <math.h>

enum { TOP_M, TOP_RATIO, EDGE_M, SWELL_M, PATCH, PATCH_M, WIND };

static double fog(const media_frame *f, murk_vec3 p)
{
    const double *w = f->word;
    const murk_vec3 moved = murk_vec((p.x - w[WIND] * f->time_s) / w[PATCH_M],
                                     p.y / w[PATCH_M], p.z / w[PATCH_M]);
    const double top =
        w[TOP_M] +
        w[SWELL_M] * noise_normal(f->seed, 0, 2, murk_vec(moved.x, moved.y, 0));
    if (p.z >= top) {
        return 0;
    }
    const double water = 1 + (w[TOP_RATIO] - 1) * p.z / w[TOP_M];
    const double below = fmin(1, (top - p.z) / w[EDGE_M]);
    const double cap = below * below * (3 - 2 * below);
    return cbrt(water * water) * cap *
           noise_patches(w[PATCH], noise_normal(f->seed, 1, 4, moved));
}

const media_kind kind_fog_bank = {
    .name = "fog-bank",
    .about = "fog over the ground with a stratified, swelling top, in patches; "
             "1 is the ground's mean",
    .unit = "1",
    .size = {80, 80, 32},
    .voxel_m = 2,
    .words = {{"top_m", 45, 1, 1e4, "mean height of the top [m]"},
              {"top_ratio", 3, 0, 100,
               "liquid water just below the top over that at the ground; thin "
               "fog has less than 1"},
              {"edge_m", 12, 0.01, 1e4, "depth over which it ends [m]"},
              {"swell_m", 4, 0, 1e3, "standard deviation of the top [m]"},
              {"patch", 0.4, 0, 2, "standard deviation of the logarithm"},
              {"patch_m", 30, 0.01, 1e5, "size of patches [m]"},
              {"wind_m_per_s", 1.5, 0, 100, "carries it [m/s]"}},
    .value = fog};
