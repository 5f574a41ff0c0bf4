/* Cameras against tallies: what arrives at a place from all round is its scalar
 * irradiance, 4 pi times the mean radiance over the sphere. Pictures all round,
 * by paths from the camera, from points drawn evenly in a ball, against the
 * track lengths of photons from the lamps in that ball: nothing is shared but
 * the world, and neither has any bias.
 *
 * Pictures have seeds of their own, so their spread over the points is their
 * error. The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "render/render.h"
#include "stage_text.h"

#include <stdlib.h>

#define ZTESTS 2
#define POINTS 4000
#define WIDTH  8
#define HEIGHT 4

/* Right below a lamp, so that light comes from above most; clear air in one
 * band, fog in the other. */
static const char SCENE[] =
    "murk: 1\n"
    "bands_nm: [450, 650]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [2.4, 1, 0], max_m: [3.4, 2, 1]}, material: crate}\n"
    "materials:\n"
    "  wall: {diffuse: 0.3}\n"
    "  crate: {diffuse: 0.3, specular: 0.4}\n"
    "media: {fog: {extinction_per_m: [0, 0.4], albedo: 0.9, phase: {hg: .6}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: rect, corner_m: [1, 1, 2.9], edge1_m: [0, 1, 0], edge2_m: [1,"
    " 0, 0], power_w: 50}\n"
    "tallies: [{name: ball, type: sphere, center_m: [1.5, 1.5, 1.6],"
    " radius_m: 0.6}]\n"
    "photons: {emit: 300000, maps: none}\n";

static const murk_vec3 CENTER = {1.5, 1.5, 1.6};
#define RADIUS 0.6

/* Evenly in the ball. */
static murk_vec3 point_in_ball(uint64_t i)
{
    for (uint32_t k = 0;; ++k) {
        const murk_random4 u =
            murk_random(1, MURK_LENS + MURK_STREAM * 7, i, k, 0);
        const murk_vec3 p = {2 * u.u[0] - 1, 2 * u.u[1] - 1, 2 * u.u[2] - 1};
        if (murk_length(p) <= 1) {
            return murk_along(CENTER, RADIUS, p);
        }
    }
}

typedef struct sums {
    double sum, squares;
} sums;

static void take(sums *s, double value)
{
    s->sum += value;
    s->squares += value * value;
}

static murk_estimate mean_of(const sums *s, double n)
{
    const double mean = s->sum / n;
    return (murk_estimate){mean,
                           sqrt((s->squares / n - mean * mean) / (n - 1))};
}

/* Scalar irradiance in each band: of[] by the means of the pictures, which
 * count each pixel by solid angle; by_pixels[] by the plain means of the
 * pixels. */
static void gather_around(const murk_stage *stage, murk_estimate of[2],
                          murk_estimate by_pixels[2])
{
    /* Render a picture of the whole sphere of directions at each point,
     * with a seed of its own. */
    sums whole[2] = {{0, 0}}, pixels[2] = {{0, 0}};
    for (uint64_t i = 0; i < POINTS; ++i) {
        murk_trace trace = murk_stage_trace(stage);
        trace.seed = (uint32_t)(1000 + i);
        const murk_render render = {
            .trace = &trace,
            .camera = murk_camera_around(point_in_ball(i), murk_vec(0, 1, 0),
                                         WIDTH, HEIGHT),
            .samples = 3,
            .method = MURK_BY_PATHS,
            .from_nm = {450, 650},
            .to_nm = {450, 650},
            .threads = 2};
        murk_image *p = NULL;
        murk_error err = {0};
        if (murk_render_run(&p, &render, &err)) {
            printf("%s: %s\n", err.where, err.text);
            exit(1);
        }
        /* Radiance averaged over the sphere is scalar irradiance over 4 pi. */
        for (int b = 0; b < 2; ++b) {
            double plain = 0;
            for (size_t k = 0; k < WIDTH * HEIGHT; ++k) {
                plain += (double)p->radiance[b][k] / (WIDTH * HEIGHT);
            }
            take(&whole[b], 4 * MURK_PI * p->mean[b]);
            take(&pixels[b], 4 * MURK_PI * plain);
        }
        murk_image_destroy(p);
    }
    for (int b = 0; b < 2; ++b) {
        of[b] = mean_of(&whole[b], POINTS);
        by_pixels[b] = mean_of(&pixels[b], POINTS);
    }
}

static double together(murk_estimate a, murk_estimate b)
{
    return sqrt(a.standard_error * a.standard_error +
                b.standard_error * b.standard_error);
}

int main(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_stage *stage = stage_text_create(SCENE, NULL);
    murk_traced *traced = NULL;
    murk_error err = {0};
    if (!stage || murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
        return 1;
    }
    murk_estimate seen[2], by_pixels[2];
    gather_around(stage, seen, by_pixels);
    for (int b = 0; b < 2; ++b) {
        const murk_estimate tally =
            murk_tallies_read(traced->tallies, 0, b, 0, traced->ledger->emitted,
                              traced->packet_w);
        const double error = together(seen[b], tally);
        printf("band %d: pictures %.4f +- %.4f, tally %.4f +- %.4f W/m2; by "
               "pixels %.4f\n",
               b, seen[b].value, seen[b].standard_error, tally.value,
               tally.standard_error, by_pixels[b].value);
        CHECK_WITHIN(limit, seen[b].value, tally.value, error);
        CHECK(error < 0.01 * tally.value);
        /* teeth: pixels have unlike solid angles */
        CHECK(sigmas_off(by_pixels[b].value, tally.value,
                         together(by_pixels[b], tally)) > 2 * limit);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
    return check_done();
}
