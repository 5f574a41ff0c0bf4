/* Pictures against laws, and both methods against each other.
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
#include "study/light.h"

#include <stdlib.h>

#define ZTESTS 4
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

static const char ROOM[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [2, 1, 0], max_m: [3, 2, 1]}, material: crate}\n"
    "materials:\n"
    "  wall: {diffuse: [0.5, 0.7]}\n"
    "  crate: {diffuse: 0.3, specular: 0.4}\n"
    "media: {fog: {extinction_per_m: 0, albedo: 0.9, phase: {hg: 0.3}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: sphere, center_m: [1, 3, 2.5], radius_m: 0.2, power_w: 50}\n"
    "photons: {emit: 1000000}\n";

typedef struct taking {
    murk_vec3 from, to;
    double vfov_rad;
    size_t width, height, samples;
    murk_render_method method;
} taking;

static murk_stage *made(const char *yaml, const char *const *overrides)
{
    murk_stage *stage = stage_text_create(yaml, overrides);
    if (!stage) {
        exit(1);
    }
    return stage;
}

static murk_picture *taken(const murk_stage *stage, const taking *t)
{
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_picture *picture = NULL;
    const murk_trace trace = murk_stage_trace(stage);
    murk_render render = {
        .trace = &trace,
        .camera = murk_camera_look(t->from, t->to, murk_vec(0, 0, 1),
                                   t->vfov_rad, t->width, t->height),
        .samples = t->samples,
        .method = t->method,
        .nearest = MURK_RENDER_NEAREST,
        .from_nm = {450, 650},
        .to_nm = {450, 650},
        .threads = 2};
    murk_status status = MURK_OK;
    if (t->method == MURK_BY_MAPS) {
        status = murk_light_trace(&traced, stage, 0, 2, &err);
    }
    if (!status) {
        render.surface = traced ? traced->surface : NULL;
        render.volume = traced ? traced->volume : NULL;
        status = murk_render_run(&picture, &render, &err);
    }
    if (status) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    murk_traced_destroy(traced);
    return picture;
}

static const double FURNACE = 1 / (MURK_PI * (1 - 0.6));

static void test_even_light_stays_even_in_fog(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_stage *stage = made(FOG_BOX, NULL);
    const taking t = {{1, 2, 2}, {4, 2.2, 1.8}, 1.5, 40, 30, 32, MURK_BY_PATHS};
    murk_picture *p = taken(stage, &t);
    CHECK_WITHIN(limit, p->mean[0], FURNACE, p->mean_error[0]);
    CHECK(sigmas_off(p->mean[0], 1 / (MURK_PI * (1 - 0.62)), p->mean_error[0]) >
          limit);
    murk_picture_destroy(p);
    stage_text_destroy(stage);
}

/* The target dims the light right before it: by its width at most, in share of
 * a free flight. */
static void test_contrast_falls_as_koschmieder_says(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_stage *stage = made(FOG_BOX, NULL);
    for (int k = 1; k <= 3; ++k) {
        const double d = k;
        const taking t = {.from = {3.5 - d, 2, 2},
                          .to = {3.5, 2, 2},
                          .vfov_rad = 0.002 / d,
                          .width = 16,
                          .height = 16,
                          .samples = 200,
                          .method = MURK_BY_PATHS};
        murk_picture *p = taken(stage, &t);
        const double contrast = 1 - p->mean[0] / FURNACE;
        const double error = p->mean_error[0] / FURNACE + 0.5 * 0.004;
        CHECK_WITHIN(limit, contrast, exp(-0.5 * d), error);
        CHECK(k != 2 ||
              sigmas_off(contrast, exp(-0.65 * d), error) > 2 * limit);
        murk_picture_destroy(p);
    }
    stage_text_destroy(stage);
}

/* Mean over the picture of maps less paths, in shares of the mean: less than
 * two in a hundred, which the errors of both resolve; a wall that reflects a
 * tenth less does not pass. */
static void test_maps_and_paths_agree(const char *const *overrides)
{
    const char *darker[4] = {overrides[0],
                             "materials.wall.diffuse=[0.45, 0.63]", NULL};
    murk_stage *stage = made(ROOM, overrides), *dark = made(ROOM, darker);
    taking t = {{0.3, 0.4, 1.5}, {3, 2, 0.8}, 1.0, 48, 36, 256, MURK_BY_PATHS};
    murk_picture *path = taken(stage, &t);
    t.method = MURK_BY_MAPS;
    t.samples = 16;
    murk_picture *map = taken(stage, &t);
    t.method = MURK_BY_PATHS;
    murk_picture *wrong = taken(dark, &t);
    for (int b = 0; b < 2; ++b) {
        const double mean = path->mean[b];
        const double off = (map->mean[b] - mean) / mean;
        const double error = sqrt(path->mean_error[b] * path->mean_error[b] +
                                  map->mean_error[b] * map->mean_error[b]) /
                             mean;
        printf("band %d, %s: maps less paths %.4f +- %.4f\n", b,
               overrides[0] ? overrides[0] : "clear air", off, error);
        CHECK(fabs(off) < 0.02);
        CHECK(error < 0.006);
        CHECK(fabs(wrong->mean[b] - mean) > 0.02 * mean);
    }
    murk_picture_destroy(path);
    murk_picture_destroy(map);
    murk_picture_destroy(wrong);
    stage_text_destroy(stage);
    stage_text_destroy(dark);
}

int main(void)
{
    const char *const clear[] = {"media.fog.extinction_per_m=0", NULL};
    const char *const foggy[] = {"media.fog.extinction_per_m=0.2", NULL};
    test_even_light_stays_even_in_fog();
    test_contrast_falls_as_koschmieder_says();
    test_maps_and_paths_agree(clear);
    test_maps_and_paths_agree(foggy);
    return check_done();
}
