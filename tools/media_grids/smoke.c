/* Smoke of a fire, in g/m3 of soot: a buoyant plume in still air of one
 * temperature, which entrains air as it rises, and below a ceiling a layer that
 * spreads to all sides.
 *
 * The plume has Gaussian profiles of velocity and of smoke, exp(-r^2 / b^2), of
 * one radius b, and air flows in at `entrainment` times the velocity on the
 * axis. With z from the virtual source, a point, conservation of volume,
 * momentum and buoyancy gives
 *
 *     b = 6/5 entrainment z,    u = k z^(-1/3),
 *     k^3 = 25/12 B / entrainment^2,    pi B = g heat / (density c_p T),
 *
 * in the approximation of Boussinesq, with the heat that the plume carries, not
 * that which the fire radiates. The virtual source lies so far below the fire
 * that b is the radius of the fire at z = 0. The smoke of a cross-section
 * moves at half of the velocity on the axis, the mean weighted by smoke; a
 * cross-section therefore contains rate / (u/2) of smoke for each metre of
 * height. Smoke that left the fire at one time fills a bowl: its middle is
 * ahead of the mean by front_s, the smoke at radius r behind it by
 * front_s (r^2 / b^2 - 1), so that no smoke is lost or made. The front of the
 * plume is the smoke of the begin of the fire. (Turner measured 0.61 of the
 * velocity on the axis for the cap of a starting plume; it is half here, as for
 * the smoke behind it.)
 *
 * At the ceiling the volume flux of the plume, pi b^2 u, turns into a layer of
 * the depth layer_m, and each later part pushes the earlier ones outwards; the
 * layer takes in no more air.
 *
 * Eddies and puffs are lognormal factors of mean 1, and the axis sways. All
 * three depend on r / b and on the time at which the smoke left the fire alone,
 * so they are carried along with the smoke and grow with the plume: two frames
 * differ by advection.
 *
 * Sources: Morton, Taylor and Turner, Proc. R. Soc. A 234 (1956) 1,
 * doi:10.1098/rspa.1956.0011; Turner, J. Fluid Mech. 13 (1962) 356,
 * doi:10.1017/S0022112062000762 (the starting plume, at second hand). Layer,
 * bowl, sway and eddies are not theirs. */
#include "kinds.h"

#include <math.h>

/* Air of 20 degrees C at sea level: g / (density c_p T) for a watt, in
 * m4/s3. */
#define BUOYANCY_PER_W (9.81 / (1.204 * 1005 * 293.15))

/* Smoke farther from the axis than this many radii is left out, 1e-4 of it. */
#define RADII_MAX 3

enum {
    HEAT,
    SOOT,
    RADIUS_M,
    ENTRAINMENT,
    SOURCE_X,
    SOURCE_Y,
    CEILING_M,
    LAYER_M,
    FRONT_S,
    PUFF_S,
    PATCH,
    SWAY,
    BURNED_S
};

/* The plume at a height over the fire. */
typedef struct plume_level {
    double b_m, u_m_per_s, age_s; /* age: time since the smoke left the fire */
} plume_level;

static plume_level plume_at(const media_frame *f, double z_m)
{
    const double *w = f->word;
    const double growth = 1.2 * w[ENTRAINMENT];
    const double below_m = w[RADIUS_M] / growth, z = z_m + below_m;
    const double flux = BUOYANCY_PER_W * 1e3 * w[HEAT] / MURK_PI;
    const double k = cbrt(25. / 12 * flux / (w[ENTRAINMENT] * w[ENTRAINMENT]));
    return (plume_level){growth * z, k / cbrt(z),
                         1.5 / k * (z * cbrt(z) - below_m * cbrt(below_m))};
}

/* The time since the fire began. */
static double burned_s(const media_frame *f)
{
    return f->word[BURNED_S] + f->time_s;
}

/* The factor of eddies and puffs at a place in radii, for smoke that left the
 * fire at a time. */
static double eddies(const media_frame *f, double x, double y, double left_s)
{
    const double *w = f->word;
    return w[PATCH] > 0
               ? noise_patches(
                     w[PATCH],
                     noise_normal(f->seed, 4, 3,
                                  murk_vec(2 * x, 2 * y, left_s / w[PUFF_S])))
               : 1;
}

static double in_plume(const media_frame *f, murk_vec3 from_axis)
{
    const double *w = f->word;
    const plume_level at = plume_at(f, from_axis.z);
    const double passed_s = burned_s(f) - at.age_s;
    double x = from_axis.x / at.b_m, y = from_axis.y / at.b_m;
    /* The axis sways with the smoke that passes, not at the fire. */
    if (w[SWAY] > 0) {
        const double sway = w[SWAY] * (1 - w[RADIUS_M] / at.b_m);
        const murk_vec3 time = murk_vec(passed_s / (2 * w[PUFF_S]), 0, 0);
        x -= sway * noise_normal(f->seed, 5, 1, time);
        y -= sway * noise_normal(f->seed, 6, 1, time);
    }
    const double r2 = x * x + y * y;
    const double left_s = passed_s - w[FRONT_S] * (r2 - 1);
    if (r2 > RADII_MAX * RADII_MAX || left_s < 0) {
        return 0;
    }
    const double mean =
        2 * w[SOOT] * exp(-r2) / (MURK_PI * at.b_m * at.b_m * at.u_m_per_s);
    return mean * eddies(f, x, y, left_s);
}

/* Smoke in the layer below the ceiling; its lower edge is smooth. */
static double in_layer(const media_frame *f, murk_vec3 from_axis)
{
    const double *w = f->word;
    const plume_level top = plume_at(f, w[CEILING_M]);
    const double r_m = hypot(from_axis.x, from_axis.y);
    const double depth = (w[CEILING_M] - from_axis.z) / w[LAYER_M];
    const double flux = MURK_PI * top.b_m * top.b_m * top.u_m_per_s;
    /* The time in the layer is the volume within r over the flux. */
    const double inside_s =
        MURK_PI * w[LAYER_M] * (r_m * r_m - top.b_m * top.b_m) / flux;
    const double left_s = burned_s(f) - top.age_s - inside_s;
    if (depth > 1 || inside_s < 0 || left_s < 0) {
        return 0;
    }
    const double edge = 2 * (1 - depth * depth * (3 - 2 * depth));
    return w[SOOT] / flux * edge *
           eddies(f, from_axis.x / r_m, from_axis.y / r_m, left_s);
}

static double smoke(const media_frame *f, murk_vec3 p)
{
    const double *w = f->word;
    const murk_vec3 from_axis =
        murk_vec(p.x - w[SOURCE_X] * (double)f->size[0] * f->voxel_m,
                 p.y - w[SOURCE_Y] * (double)f->size[1] * f->voxel_m, p.z);
    if (!(w[CEILING_M] > 0)) {
        return in_plume(f, from_axis);
    }
    return p.z < w[CEILING_M] ? in_plume(f, from_axis) + in_layer(f, from_axis)
                              : 0;
}

const media_kind kind_smoke = {
    .name = "smoke",
    .about = "smoke that rises from a fire and spreads below a ceiling, from "
             "z = 0 up",
    .unit = "g/m3",
    .size = {64, 64, 72},
    .voxel_m = 0.125,
    .words = {{"heat_kw", 50, 1e-3, 1e6, "convective heat of the fire [kW]"},
              {"soot_g_per_s", 0.2, 0, 1e6, "smoke that the fire gives [g/s]"},
              {"radius_m", 0.3, 0.01, 100, "radius of the fire [m]"},
              {"entrainment", 0.1, 0.01, 1,
               "speed of air flowing in over that on the axis"},
              {"source_x", 0.5, 0, 1, "place of the fire along x, a share"},
              {"source_y", 0.5, 0, 1, "place of the fire along y, a share"},
              {"ceiling_m", 0, 0, 1e4, "height of the ceiling [m]; 0: none"},
              {"layer_m", 1, 0.01, 1e3, "depth of the layer below it [m]"},
              {"front_s", 0.2, 0, 100,
               "time by which the middle of the front is ahead [s]"},
              {"puff_s", 0.5, 0.01, 100, "time from puff to puff [s]"},
              {"patch", 0.5, 0, 2, "standard deviation of the logarithm"},
              {"sway", 0.3, 0, 2,
               "standard deviation of the axis, a share of the radius"},
              {"burned_s", 10, 0, 1e6,
               "time of the first frame in the fire [s]"}},
    .value = smoke};
