/* Shafts of rain below a cloud: round, thinning out as a Gaussian, slanting as
 * drops fall at one speed through one wind, carried along by it. They leave the
 * grid on one side and come back on the other. Value 1 is the middle of a shaft
 * of mean strength; strengths are lognormal.
 *
 * A sketch of rain's patchiness, not a model of it: the fall speed that is
 * usual here is that of drops of 2 mm, 6.5 m/s (Gunn and Kinzer, J. Meteor. 6
 * (1949) 243; at second hand). */
#include "kinds.h"

#include "base/rng.h"

#include <math.h>

enum { SHAFTS, RADIUS_M, BACKGROUND, SPREAD, BASE_M, FALL, WIND };

/* The nearest way from a to b on a circle. */
static double around(double from, double to, double length)
{
    return remainder(to - from, length);
}

static double rain(const media_frame *f, murk_vec3 p)
{
    const double *w = f->word;
    const double x_m = (double)f->size[0] * f->voxel_m;
    const double y_m = (double)f->size[1] * f->voxel_m;
    if (p.z >= w[BASE_M]) {
        return 0;
    }
    const double drift = w[WIND] * (f->time_s + (w[BASE_M] - p.z) / w[FALL]);
    double sum = w[BACKGROUND];
    for (uint32_t i = 0; i < (uint32_t)w[SHAFTS]; ++i) {
        const murk_random4 r = murk_random(f->seed, MURK_TEST, i, 0, 0);
        const double dx = around(r.u[0] * x_m + drift, p.x, x_m);
        const double dy = around(r.u[1] * y_m, p.y, y_m);
        const double normal =
            sqrt(-2 * log(r.u[2])) * cos(2 * MURK_PI * r.u[3]);
        sum += noise_patches(w[SPREAD], normal) *
               exp(-(dx * dx + dy * dy) / (2 * w[RADIUS_M] * w[RADIUS_M]));
    }
    return sum;
}

const media_kind kind_rain_shafts = {
    .name = "rain-shafts",
    .about = "slanting shafts of rain below a cloud; 1 is the middle of a mean "
             "shaft",
    .unit = "1",
    .size = {80, 80, 60},
    .voxel_m = 5,
    .words = {{"shafts", 6, 0, 1000, "how many"},
              {"radius_m", 30, 0.01, 1e5, "standard deviation of one [m]"},
              {"background", 0.05, 0, 10, "rain between them"},
              {"spread", 0.4, 0, 2,
               "standard deviation of the logarithm of strengths"},
              {"base_m", 290, 1, 1e5, "height of the cloud [m]"},
              {"fall_m_per_s", 6.5, 0.1, 20, "speed of falling [m/s]"},
              {"wind_m_per_s", 4, 0, 100, "carries them [m/s]"}},
    .value = rain};
