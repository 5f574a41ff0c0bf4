/* A picture of a slab is the radiance that leaves it: van de Hulst's slab of
 * table 35 (albedo .9, g .75, optical depth 2; reference/
 * vdhulst_slab_angular.csv says where the values come from), lit along its
 * normal, seen from 200 m at several angles from above and from below, by paths
 * and by maps.
 *
 * A picture covers a period of the slab and .6 degrees to either side, over
 * which the values' curvature is at most a thousandth.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "render/render.h"
#include "scene/table.h"
#include "stage_text.h"

#include <stdlib.h>

#define AWAY_M 200.0
#define PERIOD 4.0
#define PIXELS 10
#define TILTS  3
#define ZTESTS (2 * 2 * TILTS)

static const char SLAB[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, -201], max_m: [4, 4, 203], sides: periodic}\n"
    "media: {slab: {extinction_per_m: 1, albedo: 0.9, phase: {hg: 0.75}}}\n"
    "regions:\n"
    "  - {medium: slab, box: {min_m: [0, 0, 0], max_m: [4, 4, 2]}}\n"
    "lights:\n"
    "  - {type: directional, direction: [0, 0, -1], irradiance_w_per_m2: 1}\n"
    "photons: {emit: 60000}\n";

static const double tilt_deg[TILTS] = {0, 30, 60};

typedef struct radiances {
    double mean[2][TILTS], error[2][TILTS]; /* reflected, transmitted */
} radiances;

static murk_table *reference(void)
{
    murk_table *table = NULL;
    murk_error err = {0};
    if (murk_table_read(
            &table, "tests/physics/reference/vdhulst_slab_angular.csv", &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return table;
}

static double tabulated(const murk_table *table, bool is_below,
                        double angle_deg)
{
    const long angle = murk_table_column(table, "angle_deg");
    const long column = murk_table_column(table, is_below ? "transmitted_per_sr"
                                                          : "reflected_per_sr");
    for (size_t row = 0; row < table->rows; ++row) {
        double a = 0, value = 0;
        if (!murk_table_number(table, row, angle, NAN, &a, NULL) &&
            a == angle_deg &&
            !murk_table_number(table, row, column, NAN, &value, NULL)) {
            return value;
        }
    }
    return NAN;
}

static murk_camera looking(bool is_below, double angle_deg)
{
    const double angle = angle_deg * MURK_PI / 180;
    const double side = is_below ? -1 : 1;
    const murk_vec3 out = {sin(angle), 0, side * cos(angle)};
    const murk_vec3 to = {1, 2, is_below ? 0 : 2};
    murk_vec3 from = murk_along(to, AWAY_M, out);
    const murk_vec3 ahead = murk_sub(from, out);
    /* the same picture, from within the domain */
    const double shift = -PERIOD * floor(from.x / PERIOD);
    from.x += shift;
    return murk_camera_aimed(from, murk_vec(ahead.x + shift, ahead.y, ahead.z),
                             murk_vec(0, 1, 0), PERIOD / AWAY_M, PIXELS,
                             PIXELS);
}

static radiances seen(murk_render_method method, const char *override,
                      size_t samples, int tilts)
{
    const char *const overrides[] = {override, NULL};
    murk_stage *stage = stage_text_create(SLAB, overrides);
    murk_traced *traced = NULL;
    murk_error err = {0};
    if (!stage || (method != MURK_BY_PATHS &&
                   murk_lightmap_trace(&traced, stage, 0, 2, &err))) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    const murk_trace trace = murk_stage_trace(stage);
    radiances r = {{{0}}, {{0}}};
    for (int k = 0; k < 2 * tilts; ++k) {
        const murk_render render = {.trace = &trace,
                                    .camera = looking(k % 2, tilt_deg[k / 2]),
                                    .samples = samples,
                                    .method = method,
                                    .surface = traced ? traced->surface : NULL,
                                    .volume = traced ? traced->volume : NULL,
                                    .from_nm = {550},
                                    .to_nm = {550},
                                    .threads = 2};
        murk_image *picture = NULL;
        if (murk_render_run(&picture, &render, &err)) {
            printf("%s: %s\n", err.where, err.text);
            exit(1);
        }
        r.mean[k % 2][k / 2] = picture->mean[0];
        r.error[k % 2][k / 2] = picture->mean_error[0];
        /* the nearly level ones, which wrap until they count as lost */
        CHECK((double)picture->lost < 0.01 * (double)picture->rays);
        murk_image_destroy(picture);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return r;
}

/* Largest distance from the reference, in errors. */
static double worst(const murk_table *table, const radiances *r, int tilts)
{
    double max = 0;
    for (int k = 0; k < 2 * tilts; ++k) {
        const double want = tabulated(table, k % 2, tilt_deg[k / 2]);
        const double z =
            sigmas_off(r->mean[k % 2][k / 2], want, r->error[k % 2][k / 2]);
        printf("%4.0f degrees, %s: %.5f +- %.5f, reference %.5f, z %.2f\n",
               tilt_deg[k / 2], k % 2 ? "below" : "above",
               r->mean[k % 2][k / 2], r->error[k % 2][k / 2], want, z);
        max = fmax(max, z);
    }
    return max;
}

int main(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_table *table = reference();
    radiances r = seen(MURK_BY_PATHS, NULL, 160, TILTS);
    CHECK(worst(table, &r, TILTS) < limit);
    /* teeth: g 2 % off, seen along the normal */
    r = seen(MURK_BY_PATHS, "media.slab.phase.hg=0.765", 160, 1);
    CHECK(worst(table, &r, 1) > limit);
    r = seen(MURK_BY_MAPS, NULL, 40, TILTS);
    CHECK(worst(table, &r, TILTS) < limit);
    /* teeth: albedo 5 % off */
    r = seen(MURK_BY_MAPS, "media.slab.albedo=0.855", 40, 1);
    CHECK(worst(table, &r, 1) > limit);
    murk_table_destroy(table);
    return check_done();
}
