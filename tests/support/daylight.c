/* Traces sunlight into a half space of water, with planes at a series of
 * depths, and interpolates the logarithm of downward irradiance between the
 * planes to find the depths of two given shares. */
#include "daylight.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lightmap/lightmap.h"
#include "stage_text.h"

#define PLANES  60
#define TEXT    20000
#define PI      3.14159265358979324
#define SHALLOW 1e-6 /* of the deepest plane: just below the surface */

/* The planes' depths: the first just below the surface, the others by equal
 * ratios. */
static void lay(double depth[PLANES], size_t n, const double *about_per_m)
{
    double min = INFINITY, max = 0;
    for (size_t i = 0; i < n; ++i) {
        min = fmin(min, about_per_m[i]);
        max = fmax(max, about_per_m[i]);
    }
    const double first = 1 / max, last = 6.5 / min;
    depth[0] = SHALLOW * last;
    for (int k = 1; k < PLANES; ++k) {
        depth[k] = first * pow(last / first, (k - 1) / (PLANES - 2.));
    }
}

static void write_scene(char *text, const char *water, double sun_zenith_deg,
                        size_t n, const int *line_nm, const double *depth,
                        uint64_t photons_a_band, uint32_t seed)
{
    const double sun = sun_zenith_deg * PI / 180;
    /* Header and bands. */
    size_t at =
        (size_t)snprintf(text, TEXT, "murk: 1\nseed: %u\nbands_nm: [", seed);
    for (size_t i = 0; i < n; ++i) {
        /* Water below a level surface, sunlight from one direction. */
        at += (size_t)snprintf(text + at, TEXT - at, "%s%d", i ? ", " : "",
                               line_nm[i]);
    }
    at += (size_t)snprintf(
        text + at, TEXT - at,
        "]\ndomain: {min_m: [-1e4, -1e4, %.9g], max_m: [1e4, 1e4, 1], sides: "
        "periodic}\nmedia: {sea: {%s}}\n"
        "regions: [{medium: sea, below_z_m: 0, ior: 1.34}]\n"
        "lights: [{type: directional, direction: [%.17g, 0, %.17g], "
        "irradiance_w_per_m2: %zu}]\n"
        "photons: {emit: %llu, maps: none, least_weight: 0.01}\ntallies:\n",
        -1.5 * depth[PLANES - 1], water, sin(sun), -cos(sun), n,
        (unsigned long long)photons_a_band * n);
    /* A plane tally at each depth. */
    for (int k = 0; k < PLANES; ++k) {
        at += (size_t)snprintf(text + at, TEXT - at,
                               "  - {name: d%d, type: plane, point_m: [0, 0, "
                               "%.17g], normal: [0, 0, -1]}\n",
                               k, -depth[k]);
    }
}

/* Downward power through a plane; its error. */
static murk_estimate power(const murk_traced *traced, int band, int plane)
{
    return murk_tallies_read(traced->tallies, (size_t)plane, band, 0,
                             traced->ledger->emitted, traced->packet_w);
}

/* Where so much of what passes the first plane is left: log of power straight
 * between planes. */
static double depth_of(const murk_traced *traced, int band, const double *depth,
                       double share, double *relative_error)
{
    murk_estimate above = power(traced, band, 0);
    const double wanted = share * above.value;
    if (!(share < 1)) {
        *relative_error = above.standard_error / above.value;
        return depth[0];
    }
    for (int k = 1; k < PLANES; ++k) {
        const murk_estimate below = power(traced, band, k);
        if (below.value < wanted && below.value > 0) {
            *relative_error = below.standard_error / below.value;
            return depth[k - 1] + (depth[k] - depth[k - 1]) *
                                      log(above.value / wanted) /
                                      log(above.value / below.value);
        }
        above = below;
    }
    return NAN;
}

void daylight_attenuation(murk_estimate *out, const char *water,
                          double sun_zenith_deg, const double share[2],
                          size_t n, const int *line_nm,
                          const double *about_per_m, uint64_t photons_a_band,
                          uint32_t seed)
{
    double depth[PLANES];
    char *text = malloc(TEXT);
    murk_traced *traced = NULL;
    murk_error err = {0};
    murk_stage *stage = NULL;
    /* Build and trace the scene. */
    lay(depth, n, about_per_m);
    if (text) {
        write_scene(text, water, sun_zenith_deg, n, line_nm, depth,
                    photons_a_band, seed);
        stage = stage_text_create(text, NULL);
    }
    if (stage && murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    /* The attenuation coefficient between the depths of the two shares. */
    for (size_t i = 0; i < n; ++i) {
        out[i] = (murk_estimate){NAN, NAN};
        if (traced) {
            double upper = 0, lower = 0;
            const double from =
                depth_of(traced, (int)i, depth, share[0], &upper);
            const double to = depth_of(traced, (int)i, depth, share[1], &lower);
            const double fall = log(share[0] / share[1]);
            out[i].value = fall / (to - from);
            out[i].standard_error = out[i].value * hypot(upper, lower) / fall;
        }
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    free(text);
}
