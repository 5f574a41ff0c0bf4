/* The optical depth at a time between two frames of a sequence of grids is the
 * weighted mean of the optical depths of both frames, along any path: an
 * optical depth is linear in the density, with nearest and with linear
 * interpolation in space.
 *
 * The density between two frames is rounded once to single precision, so it is
 * off by at most 2^-24 of itself, and depths of positive densities by as much:
 * 6e-8. The tolerance is 1e-6 of the depth. Deterministic. A weight that is off
 * by 1 %, and weights of the wrong frames, must be rejected. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/rng.h"
#include "check.h"
#include "medium/grid_write.h"
#include "stage_text.h"

#include <stdlib.h>
#include <unistd.h>

#define RAYS      200
#define TOLERANCE 1e-6

static char folder[64];

/* Frame `number` of a cloud of 40 x 32 x 24 voxels of 0.25 m: two frames share
 * some of their voxels. In the first half along z all voxels of a frame have
 * one value, so that tiles meet leaves. */
static void write_frame(int number)
{
    static const size_t size[3] = {40, 32, 24};
    float *value = calloc(size[0] * size[1] * size[2], sizeof *value);
    size_t n = 0;
    for (size_t k = 0; k < size[2]; ++k) {
        for (size_t j = 0; j < size[1]; ++j) {
            for (size_t i = 0; i < size[0]; ++i, ++n) {
                const murk_random4 r =
                    murk_random((uint32_t)number, MURK_EMIT, n, 0, 0);
                const bool is_there =
                    number % 2 ? i < 24 + j / 4 : i >= 12 + j / 8;
                const double random = r.u[1] < .5 ? 0 : r.u[0];
                value[n] =
                    is_there ? (float)(k < 12 ? (double)number : random) : 0;
            }
        }
    }
    /* Write it with voxels of a quarter of a metre. */
    char path[96];
    murk_error err = {0};
    const murk_grid_field field = {"density", value, NULL};
    const murk_affine place =
        murk_affine_place(murk_vec(0, 0, 0), .25, murk_vec(-5, -4, -3));
    snprintf(path, sizeof path, "%s/f.%d.vdb", folder, number);
    CHECK(murk_grid_write(path, &field, 1, size, &place, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    free(value);
}

/* The stage at a time, in a region that is turned and scaled. */
static murk_stage *stage_at(const char *frame, const char *interpolation)
{
    char text[1024];
    snprintf(text, sizeof text,
             "murk: 1\n"
             "domain: {min_m: [-30, -30, -30], max_m: [30, 30, 30]}\n"
             "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
             "media: {m: {vdb: %s/f.%%d.vdb, frame: %s, extinction_per_m: .7, "
             "albedo: .5, interpolation: %s}}\n"
             "regions: [{medium: m, scale: 1.5, rotate_deg: [10, 20, 30]}]\n",
             folder, frame, interpolation);
    return stage_text_create(text, NULL);
}

/* Optical depth along ray i, which passes near the middle of the cloud. */
static double depth(const murk_stage *stage, uint64_t i)
{
    const murk_random4 a = murk_random(7, MURK_EMIT, i, 0, 0),
                       b = murk_random(7, MURK_EMIT, i, 0, 1);
    const murk_vec3 middle =
        murk_vec(8 * a.u[0] - 4, 8 * a.u[1] - 4, 6 * a.u[2] - 3);
    const murk_vec3 direction =
        murk_unit(murk_vec(b.u[0] - .5, b.u[1] - .5, b.u[2] - .5));
    const murk_vec3 from = murk_along(middle, -12, direction);
    return murk_media_optical_depth(stage->media, 0, 0, from, direction, 24);
}

/* The largest difference between depths of `mean` and weighted means of depths
 * of two frames, relative to the latter. Rays that miss both frames must miss
 * `mean`; most rays hit. */
static double deviation(const murk_stage *mean, const murk_stage *a,
                        const murk_stage *b, double weight)
{
    double max = 0;
    int hits = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        const double want = (1 - weight) * depth(a, i) + weight * depth(b, i);
        const double found = depth(mean, i);
        if (!(want > 0)) {
            CHECK(found == 0);
            continue;
        }
        ++hits;
        max = fmax(max, fabs(found - want) / want);
    }
    CHECK(hits > RAYS / 2);
    return max;
}

static void test_depths(const char *interpolation)
{
    murk_stage *a = stage_at("12", interpolation),
               *b = stage_at("13", interpolation),
               *quarter = stage_at("12.25", interpolation),
               *tenth = stage_at("12.1", interpolation),
               *whole = stage_at("12.0", interpolation);
    if (!a || !b || !quarter || !tenth || !whole) {
        CHECK(false);
        return;
    }
    CHECK_NEAR(deviation(quarter, a, b, .25), 0, TOLERANCE);
    CHECK_NEAR(deviation(tenth, a, b, .1), 0, TOLERANCE);
    CHECK(deviation(whole, a, b, 0) == 0);
    /* A wrong weight, and the weights of the frames exchanged, are seen. */
    CHECK(deviation(quarter, a, b, .2525) > 1e3 * TOLERANCE);
    CHECK(deviation(quarter, b, a, .25) > 1e3 * TOLERANCE);
    murk_stage *const all[] = {a, b, quarter, tenth, whole};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        stage_text_destroy(all[i]);
    }
}

int main(void)
{
    snprintf(folder, sizeof folder, "%s/murk_frames_XXXXXX", P_tmpdir);
    if (!mkdtemp(folder)) {
        return 1;
    }
    write_frame(12);
    write_frame(13);
    test_depths("nearest");
    test_depths("linear");
    for (int i = 12; i <= 13; ++i) {
        char path[96];
        snprintf(path, sizeof path, "%s/f.%d.vdb", folder, i);
        remove(path);
    }
    rmdir(folder);
    return check_done();
}
