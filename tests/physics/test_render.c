/* Pictures against laws.
 *
 * Fog lit evenly from all sides (walls that shine and reflect, nothing absorbed
 * in between) has one radiance everywhere, E / (pi (1 - d)). A black target at
 * a distance then stands out by Koschmieder's law, contrast exp(-sigma d)
 * (Beitr. Phys. freien Atm. 12 (1924) 33).
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "render/render.h"
#include "stage_text.h"

#include <stdlib.h>

#define ZTESTS 4

/* Of FOG_BOX's fog [1/m] and its phase function, and the target's side. */
#define EXTINCTION 0.5
#define ASYMMETRY  0.5
#define SIDE_M     0.004

#define WALLS                                                                \
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [4, 0, 0], edge2_m: [0," \
    " 4, 0], power_w: 16}\n"                                                 \
    "  - {type: rect, corner_m: [0, 0, 4], edge1_m: [0, 4, 0], edge2_m: [4," \
    " 0, 0], power_w: 16}\n"                                                 \
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [0, 4, 0], edge2_m: [0," \
    " 0, 4], power_w: 16}\n"                                                 \
    "  - {type: rect, corner_m: [4, 0, 0], edge1_m: [0, 0, 4], edge2_m: [0," \
    " 4, 0], power_w: 16}\n"                                                 \
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [0, 0, 4], edge2_m: [4," \
    " 0, 0], power_w: 16}\n"                                                 \
    "  - {type: rect, corner_m: [0, 4, 0], edge1_m: [4, 0, 0], edge2_m: [0," \
    " 0, 4], power_w: 16}\n"

static const char FOG_BOX[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 4]}, material: wall}\n"
    "  - {rect: {corner_m: [3.5, 1.998, 1.998], edge1_m: [0, .004, 0],\n"
    "            edge2_m: [0, 0, .004]}, material: black}\n"
    "materials: {wall: {diffuse: 0.6}, black: {diffuse: 0}}\n"
    "media: {fog: {extinction_per_m: 0.5, albedo: 1, phase: {hg: 0.5}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n" WALLS;

typedef struct taking {
    murk_vec3 from, to;
    double vfov_rad;
    size_t width, height, samples;
} taking;

static murk_stage *made(const char *yaml)
{
    murk_stage *stage = stage_text_create(yaml, NULL);
    if (!stage) {
        exit(1);
    }
    return stage;
}

static murk_image *taken(const murk_stage *stage, const taking *t)
{
    murk_error err = {0};
    murk_image *picture = NULL;
    const murk_trace trace = murk_stage_trace(stage);
    const murk_render render = {
        .trace = &trace,
        .camera = murk_camera_aimed(t->from, t->to, murk_vec(0, 0, 1),
                                    t->vfov_rad, t->width, t->height),
        .samples = t->samples,
        .method = MURK_BY_PATHS,
        .from_nm = {550},
        .to_nm = {550},
        .threads = 2};
    if (murk_render_run(&picture, &render, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return picture;
}

static const double FURNACE = 1 / (MURK_PI * (1 - 0.6));

static void test_even_light_stays_even_in_fog(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_stage *stage = made(FOG_BOX);
    const taking t = {{1, 2, 2}, {4, 2.2, 1.8}, 1.5, 40, 30, 32};
    murk_image *p = taken(stage, &t);
    CHECK_WITHIN(limit, p->mean[0], FURNACE, p->mean_error[0]);
    CHECK(sigmas_off(p->mean[0], 1 / (MURK_PI * (1 - 0.62)), p->mean_error[0]) >
          limit);
    murk_image_destroy(p);
    stage_text_destroy(stage);
}

/* What the target adds to contrast at most: it hides light from fog right
 * before it, too. At s before it, that fog scatters less by the integral of the
 * phase function p over the angle that the target fills, and the camera sees
 * less by extinction times the integral of that over s. Summed over s first,
 * the target's part at r from the line of sight adds
 *   extinction * dA / r * integral of p(cos t) cos(t) dt, t = 0..pi/2,
 * so no target of its area adds more than a disc about the line, of radius
 * side / sqrt(pi): 2 pi * radius times the rest. Not taken off is what the fog
 * dims on the way to the camera, far more than what scattering twice adds, of
 * the order of (extinction * side)^2. */
static double max_added(void)
{
    const double g = ASYMMETRY;
    double integral = 0;
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) * MURK_PI / 2 / steps;
        const double p =
            (1 - g * g) / (4 * MURK_PI * pow(1 + g * g - 2 * g * cos(t), 1.5));
        integral += p * cos(t) * MURK_PI / 2 / steps;
    }
    return EXTINCTION * 2 * MURK_PI * SIDE_M / sqrt(MURK_PI) * integral;
}

/* In standard errors, beyond what the target adds. */
static double contrast_off(const murk_image *p, double want)
{
    const double contrast = 1 - p->mean[0] / FURNACE;
    const double off = fabs(contrast - want) - max_added();
    return off / (p->mean_error[0] / FURNACE);
}

/* Teeth: a tenth more or less extinction is not met. */
static void test_contrast_falls_as_koschmieder_says(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_stage *stage = made(FOG_BOX);
    for (int k = 1; k <= 3; ++k) {
        const double d = k;
        const taking t = {.from = {3.5 - d, 2, 2},
                          .to = {3.5, 2, 2},
                          .vfov_rad = 0.5 * SIDE_M / d,
                          .width = 16,
                          .height = 16,
                          .samples = 200};
        murk_image *p = taken(stage, &t);
        printf("%g m: contrast %.5f +- %.5f, law %.5f, at most %.5f added\n", d,
               1 - p->mean[0] / FURNACE, p->mean_error[0] / FURNACE,
               exp(-EXTINCTION * d), max_added());
        CHECK(contrast_off(p, exp(-EXTINCTION * d)) < limit);
        CHECK(contrast_off(p, exp(-EXTINCTION * 1.1 * d)) > limit);
        CHECK(contrast_off(p, exp(-EXTINCTION / 1.1 * d)) > limit);
        murk_image_destroy(p);
    }
    stage_text_destroy(stage);
}

int main(void)
{
    test_even_light_stays_even_in_fog();
    test_contrast_falls_as_koschmieder_says();
    return check_done();
}
