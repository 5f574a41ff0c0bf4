/* The standard errors that pictures by paths state, pixel by pixel.
 *
 * At the default 16 samples a pixel's value is far from normal: most of its
 * light may come by few paths, so the pixels that have missed such a path are
 * too low and, by their own samples alone, would claim a small error. The test
 * takes pictures by many seeds, and one of many samples, which stands for the
 * truth, and asks of z = (value - truth) / error over all pixels and seeds:
 * rms of z .85 to 1.2; at least 92 % within two errors; at most 4 % more than
 * two errors too low; and the mean of the squared errors within 15 % of the
 * variance between seeds. Teeth: errors a quarter smaller or larger are
 * refused.
 *
 * Quick: a room with few seeds. Nightly (`test_physics_pixel_errors nightly`,
 * some 3 minutes of one processor): 40 seeds against 8000 samples, in the
 * smoke hall and the room. All is by fixed seeds, so there is no chance of a
 * false alarm. */
#include "check.h"
#include "pictures.h"
#include "render/render.h"
#include "stage_text.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH     32
#define HEIGHT    24
#define PIXELS    (WIDTH * HEIGHT)
#define SAMPLES   16
#define SEEDS_MAX 40

/* A room that is lit mostly by light that a wall sends back: the lamp shines at
 * the ceiling, a second one stands behind a screen, haze lies in the room, and
 * one wall is a mirror. */
static const char INDIRECT_LIGHT[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [5, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [5, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [2, 1, 0], max_m: [3, 2, 0.8]}, material: crate}\n"
    "  - {rect: {corner_m: [3.5, 1.5, 0], edge1_m: [0, 2, 0],\n"
    "            edge2_m: [0, 0, 2]}, material: screen}\n"
    "  - {sphere: {center_m: [1.2, 0.8, 0.5], radius_m: 0.4},\n"
    "     material: metal}\n"
    "materials:\n"
    "  wall: {diffuse: 0.6}\n"
    "  crate: {diffuse: 0.3}\n"
    "  screen: {diffuse: 0.5}\n"
    "  metal: {diffuse: 0.2, specular: 0.6}\n"
    "media: {haze: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.6}}}\n"
    "regions: [{medium: haze}]\n"
    "lights:\n"
    "  - {type: rect, corner_m: [1, 2.5, 2], edge1_m: [0.6, 0, 0],\n"
    "     edge2_m: [0, 0.6, 0], power_w: 40}\n"
    "  - {type: sphere, center_m: [4.4, 2.6, 0.6], radius_m: 0.1,\n"
    "     power_w: 40}\n";

typedef struct view {
    const char *name, *yaml, *path; /* yaml or path */
    murk_vec3 from, to;
} view;

static const view pictures[] = {{.name = "room",
                                 .yaml = INDIRECT_LIGHT,
                                 .from = {0.3, 0.4, 1.6},
                                 .to = {4, 2.5, 0.8}},
                                {.name = "hall",
                                 .path = "scenes/smoke-hall.yaml",
                                 .from = {28.6, 3, 2.2},
                                 .to = {15, 10, 3.4}}};

static murk_stage *made(const view *v)
{
    if (v->yaml) {
        return stage_text_create(v->yaml, NULL);
    }
    murk_error err = {0};
    murk_scene_desc *scene = NULL;
    murk_stage *stage = NULL;
    if (murk_scene_desc_read(&scene, v->path, NULL, 0, &err) ||
        murk_stage_create(&stage, scene, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    return stage;
}

static murk_image *taken(const view *v, const murk_stage *stage, size_t samples,
                         uint32_t seed)
{
    murk_trace trace = murk_stage_trace(stage);
    trace.seed = seed;
    return picture_of_trace(
        (murk_render){.camera = murk_camera_aimed(
                          v->from, v->to, murk_vec(0, 0, 1), 1, WIDTH, HEIGHT),
                      .samples = samples,
                      .method = MURK_BY_PATHS,
                      .threads = 2},
        &trace);
}

/* Over all pixels and seeds. */
typedef struct judged {
    double rms, within_one, within_two, too_low; /* of z; shares */
    double stated; /* mean squared error over the variance between seeds */
} judged;

static judged judge(const murk_image *truth, murk_image *const *picture,
                    size_t seeds, double larger)
{
    /* Deviation z of each pixel from the truth in units of the stated
     * error, which a twin multiplies by `larger`. */
    judged j = {0};
    double stated = 0, spread = 0;
    const double count = (double)(PIXELS * seeds);
    for (size_t i = 0; i < PIXELS; ++i) {
        double sum = 0, squares = 0;
        for (size_t k = 0; k < seeds; ++k) {
            const double off = (double)picture[k]->radiance[0][i] -
                               (double)truth->radiance[0][i];
            const double error = larger * (double)picture[k]->error[0][i];
            const double z = off == 0 ? 0 : off / error;
            j.rms += z * z / count;
            j.within_one += (fabs(z) <= 1) / count;
            j.within_two += (fabs(z) <= 2) / count;
            j.too_low += (z < -2) / count;
            /* Sums for the variance of a pixel between seeds. */
            stated += error * error / (double)seeds;
            sum += off;
            squares += off * off;
        }
        /* Unbiased variance between seeds. */
        spread += (squares - sum * sum / (double)seeds) / (double)(seeds - 1);
    }
    /* Stated variance over the variance between seeds. */
    j.rms = sqrt(j.rms);
    j.stated = stated / spread;
    return j;
}

static bool is_honest(judged j)
{
    return j.rms > 0.85 && j.rms < 1.2 && j.within_two >= 0.92 &&
           j.too_low <= 0.04 && fabs(j.stated - 1) < 0.15;
}

static void test_errors_are_honest(const view *v, size_t seeds,
                                   size_t truth_samples)
{
    /* One picture of many samples is the truth; the pictures to be judged
     * have a seed each. */
    murk_stage *stage = made(v);
    if (!stage) {
        exit(1);
    }
    murk_image *truth = taken(v, stage, truth_samples, 1000);
    murk_image *picture[SEEDS_MAX];
    double unsure = 0;
    for (size_t k = 0; k < seeds; ++k) {
        picture[k] = taken(v, stage, SAMPLES, (uint32_t)k + 1);
        unsure += (double)picture[k]->unsure / PIXELS / (double)seeds;
    }
    /* Judge the stated errors. */
    const judged j = judge(truth, picture, seeds, 1);
    printf("%s: rms of z %.3f; within one error %.3f, within two %.3f, more "
           "than two too low %.4f; stated variance %.3f of that between seeds; "
           "unsure %.3f\n",
           v->name, j.rms, j.within_one, j.within_two, j.too_low, j.stated,
           unsure);
    /* The check can fail: errors that are 25 % smaller or larger are
     * refused. */
    CHECK(is_honest(j));
    CHECK(!is_honest(judge(truth, picture, seeds, 0.75)));
    CHECK(!is_honest(judge(truth, picture, seeds, 1.25)));
    for (size_t k = 0; k < seeds; ++k) {
        murk_image_destroy(picture[k]);
    }
    murk_image_destroy(truth);
    stage_text_destroy(stage);
}

int main(int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "nightly") == 0) {
        test_errors_are_honest(&pictures[0], SEEDS_MAX, 8000);
        test_errors_are_honest(&pictures[1], SEEDS_MAX, 8000);
    } else {
        test_errors_are_honest(&pictures[0], 16, 1000);
    }
    return check_done();
}
