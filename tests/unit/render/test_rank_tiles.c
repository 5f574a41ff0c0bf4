/* Ranks that divide the tiles of a picture have the picture of one rank
 * afterwards, in every bit: by paths, and by maps of random records. An
 * exchange that loses a rank's tiles is noticed. Seeds are fixed. */
#include "base/rng.h"
#include "check.h"
#include "render/render.h"
#include "thread_ranks.h"
#include "worlds.h"

#include <stdlib.h>
#include <string.h>

/* The last tiles are not whole. */
enum { WIDTH = 50, HEIGHT = 37, RECORDS = 3000, SAMPLES = 2 };

/* A lamp in fog over a floor of 4 m. */
static test_world lit_floor(void)
{
    const murk_source lamp = test_point(murk_vec(0, 0, 1.5));
    const murk_surface_desc floor =
        test_rect(murk_vec(-2, -2, 0), murk_vec(4, 0, 0), murk_vec(0, 4, 0), 0);
    const murk_material paint = test_material(0.5, 0, 0, 0);
    const murk_medium fog = test_medium(0.2, 0.8, 0);
    const murk_region all = test_everywhere(0);
    return test_world_made(
        &(test_setup){.domain = {{{-2, -2, -0.1}, {2, 2, 2}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &floor,
                      .n_surfaces = 1,
                      .materials = &paint,
                      .n_materials = 1,
                      .media = &fog,
                      .n_media = 1,
                      .regions = &all,
                      .n_regions = 1});
}

/* Random records on the floor, or in the fog. */
static murk_photon_map *records(bool in_fog)
{
    murk_photon *photon = calloc(RECORDS, sizeof *photon);
    murk_photon_map *map = NULL;
    murk_error err = {0};
    for (uint32_t i = 0; i < RECORDS; ++i) {
        uint32_t word[4];
        murk_random_words(5, MURK_TEST, i, in_fog, 0, word);
        const murk_vec3 down = {0, 0, -1}, up = {0, 0, 1}, none = {0, 0, 0};
        photon[i] = murk_photon_make(&(murk_photon_values){
            .position_m = {word[0] * 0x1p-30 - 2, word[1] * 0x1p-30 - 2,
                           in_fog ? word[2] * 0x1p-31 : 0},
            .direction = down,
            .normal = in_fog ? none : up,
            .power_w = 0.01,
            .emitted = i,
            .is_volume = in_fog,
            .event_class = 2});
    }
    CHECK(murk_photon_map_create(&map, photon, RECORDS, 1, &err) == MURK_OK);
    return map;
}

typedef struct job {
    murk_render render;
    murk_image *picture[THREAD_RANKS_MAX];
} job;

static murk_status render(void *context, unsigned number, murk_error *err)
{
    job *j = context;
    return murk_render_run(&j->picture[number], &j->render, err);
}

static bool same_picture(const murk_image *a, const murk_image *b)
{
    return memcmp(a->radiance[0], b->radiance[0],
                  (size_t)murk_image_bytes(WIDTH, HEIGHT, 1)) == 0 &&
           memcmp(a->mean, b->mean, sizeof a->mean) == 0 &&
           memcmp(a->mean_error, b->mean_error, sizeof a->mean_error) == 0 &&
           a->rays == b->rays && a->lost == b->lost && a->unsure == b->unsure;
}

/* True if all ranks have the picture of one. */
static bool ranks_have_the_picture_of_one(const murk_render *wanted,
                                          unsigned count,
                                          thread_ranks_defect defect)
{
    job one = {.render = *wanted}, all = {.render = *wanted};
    one.render.threads = 1;
    thread_ranks_end end =
        thread_ranks_run(1, THREAD_RANKS_SOUND, render, &one);
    CHECK(thread_ranks_succeeded(&end, 1));
    end = thread_ranks_run(count, defect, render, &all);
    bool is_same = thread_ranks_succeeded(&end, count);
    for (unsigned r = 0; r < count; ++r) {
        is_same = is_same && same_picture(one.picture[0], all.picture[r]);
        murk_image_destroy(all.picture[r]);
    }
    CHECK(one.picture[0] && one.picture[0]->mean[0] > 0);
    murk_image_destroy(one.picture[0]);
    return is_same;
}

int main(void)
{
    static const murk_render_method methods[] = {MURK_BY_PATHS, MURK_BY_MAPS,
                                                 MURK_BY_MAPS_ONLY};
    static const unsigned counts[] = {1, 2, 3, 5};
    /* The world, records, and the camera. */
    test_world world = lit_floor();
    murk_trace trace = murk_trace_defaults();
    trace.world = &world.world;
    trace.seed = 1;
    murk_photon_map *surface = records(false), *volume = records(true);
    murk_render wanted = {
        .trace = &trace,
        .camera = murk_camera_aimed(murk_vec(0.5, 0.1, 1), murk_vec(0, 0.4, 0),
                                    murk_vec(0, 0, 1), 1.5, WIDTH, HEIGHT),
        .samples = SAMPLES,
        .from_nm = {550},
        .to_nm = {550}};
    /* Each method, sound and with a defect. */
    for (size_t m = 0; m < sizeof methods / sizeof *methods; ++m) {
        const bool by_maps = methods[m] != MURK_BY_PATHS;
        wanted.method = methods[m];
        wanted.surface = by_maps ? surface : NULL;
        wanted.volume = by_maps ? volume : NULL;
        for (size_t c = 0; c < sizeof counts / sizeof *counts; ++c) {
            for (wanted.threads = 1; wanted.threads <= 2; ++wanted.threads) {
                CHECK(ranks_have_the_picture_of_one(&wanted, counts[c],
                                                    THREAD_RANKS_SOUND));
            }
        }
        wanted.threads = 1;
        CHECK(!ranks_have_the_picture_of_one(&wanted, 3,
                                             THREAD_RANKS_LOSE_WORDS));
    }
    murk_photon_map_destroy(surface);
    murk_photon_map_destroy(volume);
    test_world_unmade(&world);
    return check_done();
}
