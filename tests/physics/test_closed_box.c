/* The closed diffuse box by maps: walls that shine and reflect, filled with fog
 * that absorbs nothing, have one radiance everywhere, E / (pi (1 - d)). By
 * maps and by maps alone pictures' means are that, and what pixels and means
 * are off by over lights of many seeds is what they say of their errors, no
 * more and no less.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "render/render.h"
#include "stage_text.h"

#include <stdlib.h>

#define ZTESTS 6
#define SEEDS  40
#define WIDTH  12
#define HEIGHT 9
#define PIXELS (WIDTH * HEIGHT)

static const char BOX[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 4]}, material: wall}\n"
    "materials: {wall: {diffuse: 0.6}}\n"
    "media: {fog: {extinction_per_m: 0.3, albedo: 1, phase: {hg: 0.5}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [4, 0, 0],\n"
    "     edge2_m: [0, 4, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 0, 4], edge1_m: [0, 4, 0],\n"
    "     edge2_m: [4, 0, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [0, 4, 0],\n"
    "     edge2_m: [0, 0, 4], power_w: 16}\n"
    "  - {type: rect, corner_m: [4, 0, 0], edge1_m: [0, 0, 4],\n"
    "     edge2_m: [0, 4, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [0, 0, 4],\n"
    "     edge2_m: [4, 0, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 4, 0], edge1_m: [4, 0, 0],\n"
    "     edge2_m: [0, 0, 4], power_w: 16}\n"
    "photons: {emit: 6000}\n";

static const double TRUTH = 1 / (MURK_PI * (1 - 0.6));

/* Over seeds. */
typedef struct sums {
    double sum, squares;
} sums;

static void take(sums *s, double value)
{
    s->sum += value;
    s->squares += value * value;
}

static double mean_of(const sums *s)
{
    return s->sum / SEEDS;
}

static double error_of(const sums *s)
{
    const double mean = mean_of(s);
    return sqrt((s->squares / SEEDS - mean * mean) / (SEEDS - 1));
}

static murk_image *taken(uint32_t seed, murk_render_method method)
{
    /* Trace the photon maps of the box. */
    char own[32];
    snprintf(own, sizeof own, "seed=%lu", (unsigned long)seed);
    const char *const overrides[] = {own, NULL};
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_image *picture = NULL;
    murk_stage *stage = stage_text_create(BOX, overrides);
    if (!stage || murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    /* Render the same view from inside by the method. */
    const murk_trace trace = murk_stage_trace(stage);
    const murk_render render = {
        .trace = &trace,
        .camera = murk_camera_aimed(murk_vec(1, 2, 2), murk_vec(4, 2.2, 1.8),
                                    murk_vec(0, 0, 1), 1.5, WIDTH, HEIGHT),
        .samples = 16,
        .method = method,
        .surface = traced->surface,
        .volume = traced->volume,
        .from_nm = {550},
        .to_nm = {550},
        .threads = 2};
    if (murk_render_run(&picture, &render, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return picture;
}

/* Squares of what pixels are off by, in those of what they say: 1 in the mean.
 * Whole pictures are one number, since their pixels share records. */
static double squares_over_stated(const murk_image *p)
{
    double off = 0, stated = 0;
    for (size_t i = 0; i < PIXELS; ++i) {
        off += pow((double)p->radiance[0][i] - TRUTH, 2);
        stated += pow((double)p->error[0][i], 2);
    }
    return off / stated;
}

static void test_radiance_and_errors(murk_render_method method,
                                     const char *name)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    sums mean = {0, 0}, pixels = {0, 0}, whole = {0, 0};
    for (uint32_t seed = 1; seed <= SEEDS; ++seed) {
        murk_image *p = taken(seed, method);
        take(&mean, p->mean[0]);
        take(&pixels, squares_over_stated(p));
        take(&whole, pow((p->mean[0] - TRUTH) / p->mean_error[0], 2));
        murk_image_destroy(p);
    }
    printf("%s: %.5f +- %.5f, truth %.5f; squares over those told: pixels "
           "%.3f +- %.3f, means %.3f +- %.3f\n",
           name, mean_of(&mean), error_of(&mean), TRUTH, mean_of(&pixels),
           error_of(&pixels), mean_of(&whole), error_of(&whole));
    CHECK_WITHIN(limit, mean_of(&mean), TRUTH, error_of(&mean));
    CHECK_WITHIN(limit, mean_of(&pixels), 1, error_of(&pixels));
    CHECK_WITHIN(limit, mean_of(&whole), 1, error_of(&whole));
    /* teeth: walls of .62, errors of pixels half and twice as large */
    CHECK(sigmas_off(mean_of(&mean), 1 / (MURK_PI * (1 - 0.62)),
                     error_of(&mean)) > limit);
    CHECK(sigmas_off(4 * mean_of(&pixels), 1, 4 * error_of(&pixels)) > limit);
    CHECK(sigmas_off(mean_of(&pixels) / 4, 1, error_of(&pixels) / 4) > limit);
}

int main(void)
{
    test_radiance_and_errors(MURK_BY_MAPS, "maps");
    test_radiance_and_errors(MURK_BY_MAPS_ONLY, "maps alone");
    return check_done();
}
