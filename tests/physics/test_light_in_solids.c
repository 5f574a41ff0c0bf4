/* Pictures of what a solid holds together with its lamp: no shadow ray goes
 * there, so by maps direct light comes from the records, too. One radiance by
 * maps, by maps alone and by paths; also where water lies elsewhere, whose
 * index has no say in the glass.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "render/render.h"
#include "stage_text.h"

#include <stdlib.h>

#define ZTESTS 4

static const char AQUARIUM[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [1, 1, 0.5], max_m: [3, 3, 2.5]}, material: glass}\n"
    "  - {box: {min_m: [1.6, 1.6, 0.6], max_m: [2.4, 2.4, 1]},\n"
    "     material: crate}\n"
    "materials:\n"
    "  wall: {diffuse: 0.3}\n"
    "  crate: {diffuse: 0.5}\n"
    "  glass: {transmit: 1, ior: 1.33}\n"
    "lights:\n"
    "  - {type: sphere, center_m: [2, 2, 1.9], radius_m: 0.4, power_w: 50}\n"
    "photons: {emit: 60000}\n";

/* Beside the glass. */
static const char WATER[] =
    "regions=[{medium: water, box: {min_m: [0, 0, 0], max_m: [0.5, 4, 1]}, "
    "ior: 1.34}]";

static murk_image *taken(const murk_stage *stage, const murk_traced *traced,
                         murk_render_method method, size_t samples)
{
    const murk_trace trace = murk_stage_trace(stage);
    const murk_render render = {
        .trace = &trace,
        .camera = murk_camera_aimed(murk_vec(1.2, 1.2, 1.5), murk_vec(2, 2, 1),
                                    murk_vec(0, 0, 1), 0.5, 16, 12),
        .samples = samples,
        .method = method,
        .surface = traced->surface,
        .volume = traced->volume,
        .from_nm = {550},
        .to_nm = {550},
        .threads = 2};
    murk_error err = {0};
    murk_image *picture = NULL;
    if (murk_render_run(&picture, &render, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return picture;
}

static void test_three_methods_agree(const char *const *overrides)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    murk_error err = {0};
    murk_traced *traced = NULL;
    murk_stage *stage = stage_text_create(AQUARIUM, overrides);
    if (!stage || murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    murk_image *path = taken(stage, traced, MURK_BY_PATHS, 600);
    static const murk_render_method methods[] = {MURK_BY_MAPS,
                                                 MURK_BY_MAPS_ONLY};
    for (int i = 0; i < 2; ++i) {
        murk_image *map = taken(stage, traced, methods[i], 16);
        const double error = hypot(map->mean_error[0], path->mean_error[0]);
        printf("paths %.4f +- %.4f, maps %.4f +- %.4f\n", path->mean[0],
               path->mean_error[0], map->mean[0], map->mean_error[0]);
        CHECK_WITHIN(limit, map->mean[0], path->mean[0], error);
        /* teeth: a fifth less */
        CHECK(sigmas_off(map->mean[0], 0.8 * path->mean[0], error) > limit);
        murk_image_destroy(map);
    }
    murk_image_destroy(path);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

int main(void)
{
    static const char *const plain[] = {NULL};
    static const char *const by_water[] = {
        "media={water: {extinction_per_m: 0, albedo: 0}}", WATER, NULL};
    test_three_methods_agree(plain);
    test_three_methods_agree(by_water);
    return check_done();
}
