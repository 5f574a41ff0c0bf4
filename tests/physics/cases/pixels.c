/* Whether the errors that pictures by paths state are true, pixel by pixel:
 * where the radiance is known and the same in all pixels, the mean square of
 * what pixels are off by is the mean of their squared errors, and the mean over
 * a picture is off by its own error.
 *
 * A lamp of P watts in the middle of a sphere of radius R and reflectance d
 * lights the wall evenly: radiance d / (1 - d) P / (4 pi^2 R^2). Between walls
 * that shine by a watt a square metre and reflect d, with fog that only
 * scatters, it is 1 / (pi (1 - d)) everywhere.
 *
 * Each seed is a picture at the default 16 samples, and gives one ratio of
 * squares for its pixels, whose spread is the standard error of their mean, and
 * one square for its mean, where few digits are noise: the spread of a mean of
 * S squares of normal numbers is sqrt(2 / S). */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "cases/groups.h"
#include "pictures.h"
#include "render/render.h"
#include "stage_text.h"

#define WIDTH       24
#define HEIGHT      16
#define PIXELS      (WIDTH * HEIGHT)
#define SAMPLES     16
#define SEEDS       400
#define SEEDS_QUICK 60

static const char BALL[] =
    "murk: 1\n"
    "domain: {min_m: [-2, -2, -2], max_m: [2, 2, 2]}\n"
    "geometry: [{sphere: {center_m: [0, 0, 0], radius_m: 1}, material: wall}]\n"
    "materials: {wall: {diffuse: 0.7}}\n"
    "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n";
#define OF_BALL (.7 / (1 - .7) / (4 * MURK_PI * MURK_PI))

#define SHINING(corner, edge1, edge2)                                 \
    "  - {type: rect, corner_m: [" corner "], edge1_m: [" edge1 "], " \
    "edge2_m: [" edge2 "], power_w: 4}\n"
static const char FOG[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [2, 2, 2]}\n"
    "geometry: [{box: {min_m: [0, 0, 0], max_m: [2, 2, 2]}, material: wall}]\n"
    "materials: {wall: {diffuse: 0.6}}\n"
    "media: {fog: {extinction_per_m: 0.5, albedo: 1, phase: {hg: 0.5}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n" SHINING("0, 0, 0", "2, 0, 0", "0, 2, 0")
        SHINING("0, 0, 2", "0, 2, 0", "2, 0, 0")
            SHINING("0, 0, 0", "0, 2, 0", "0, 0, 2")
                SHINING("2, 0, 0", "0, 0, 2", "0, 2, 0")
                    SHINING("0, 0, 0", "0, 0, 2", "2, 0, 0")
                        SHINING("0, 2, 0", "2, 0, 0", "0, 0, 2");
#define OF_FOG (1 / (MURK_PI * (1 - .6)))

typedef struct view {
    const char *name, *yaml;
    double radiance;
    murk_vec3 from, to;
} view;

static const view pictures[] = {
    {"hollow ball", BALL, OF_BALL, {.5, .1, 0}, {0, 1, .3}},
    {"fog between shining walls", FOG, OF_FOG, {.5, 1, 1}, {2, 1.1, .9}}};

static murk_image *taken(const validation *v, const view *of,
                         const murk_stage *stage, uint32_t seed)
{
    murk_trace trace = murk_stage_trace(stage);
    trace.seed = seed;
    return picture_of_trace(
        (murk_render){.camera =
                          murk_camera_aimed(of->from, of->to, murk_vec(0, 0, 1),
                                            1, WIDTH, HEIGHT),
                      .samples = SAMPLES,
                      .method = MURK_BY_PATHS,
                      .threads = validation_threads(v)},
        &trace);
}

/* Of one seed's picture: squares of what is off, over those of the errors. */
static void take_ratios(double *of_pixels, double *of_mean, const murk_image *p,
                        double radiance, double larger)
{
    double off = 0, stated = 0;
    for (size_t i = 0; i < PIXELS; ++i) {
        const double error = larger * (double)p->error[0][i];
        off += pow((double)p->radiance[0][i] - radiance, 2);
        stated += error * error;
    }
    *of_pixels = off / stated;
    *of_mean = pow((p->mean[0] - radiance) / (larger * p->mean_error[0]), 2);
}

static double mean_of(const double *ratio, int n)
{
    double sum = 0;
    for (int k = 0; k < n; ++k) {
        sum += ratio[k] / n;
    }
    return sum;
}

/* Standard error of a mean of so many ratios, by their spread. */
static double error_of(const double *ratio, int n)
{
    const double mean = mean_of(ratio, n);
    double squares = 0;
    for (int k = 0; k < n; ++k) {
        squares += pow(ratio[k] - mean, 2);
    }
    return sqrt(squares / (n - 1) / n);
}

static void compare(validation *v, const view *of, const char *is_wrong,
                    double larger)
{
    if (!validation_wants(v, of->name)) {
        return;
    }
    /* Pictures of one view from many seeds. */
    const int seeds = validation_is_quick(v) ? SEEDS_QUICK : SEEDS;
    double of_pixels[SEEDS] = {NAN}, of_mean[SEEDS] = {NAN};
    murk_stage *stage = stage_text_create(of->yaml, NULL);
    for (int k = 0; stage && k < seeds; ++k) {
        murk_image *p =
            taken(v, of, stage, validation_seed(v) + 500 + (uint32_t)k);
        take_ratios(&of_pixels[k], &of_mean[k], p, of->radiance, larger);
        murk_image_destroy(p);
    }
    stage_text_destroy(stage);
    /* The mean square of error over stated error is 1 if errors are stated
     * rightly. */
    const uint64_t rays = (uint64_t)seeds * PIXELS * SAMPLES;
    const char *why = "a mean over as many pictures as seeds";
    validation_check(
        v, of->name, "closed form", is_wrong,
        &(validation_reference){"pixels, mean square in errors over seeds", 1,
                                0},
        (murk_estimate){mean_of(of_pixels, seeds), error_of(of_pixels, seeds)},
        rays);
    validation_mark_short(v, why);
    validation_check(v, of->name, "closed form", is_wrong,
                     &(validation_reference){
                         "mean of a picture, mean square in errors", 1, 0},
                     (murk_estimate){mean_of(of_mean, seeds), sqrt(2. / seeds)},
                     rays);
    validation_mark_short(v, why);
}

void cases_pixels(validation *v)
{
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; ++i) {
        compare(v, &pictures[i], NULL, 1);
    }
    compare(v, &pictures[0], "errors a tenth larger", 1.1);
}
