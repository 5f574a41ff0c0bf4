/* Media for a view: cells hold the extinction at their middles, by the root and
 * to half a step of 255, as many as are asked for at most, cubes as far as the
 * box allows. Nothing here is random. */
#include "check.h"
#include "report/view_media.h"
#include "stage_text.h"

#include <math.h>
#include <stdlib.h>

#define SCENE                                        \
    "murk: 1\nbands_nm: [550]\n"                     \
    "domain: {min_m: [0, 0, 0], max_m: [8, 4, 2]}\n" \
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]\n"
#define LAYERS                                                               \
    SCENE "media: {layer: {profile: {z_m: [0, 2], extinction_per_m: [0.01, " \
          "2.01]}, albedo: 0.5, phase: isotropic}}\n"                        \
          "regions: [{medium: layer}]\n"
#define EVEN                                                          \
    SCENE "media: {fog: {extinction_per_m: 0.3, albedo: 0.5, phase: " \
          "isotropic}}\nregions: [{medium: fog}]\n"

static const murk_box box = {{0, 0, 0}, {8, 4, 2}};

static void test_layers(void)
{
    murk_stage *made = stage_text_create(LAYERS, NULL);
    const size_t max[] = {300, 5000, 100000};
    for (size_t m = 0; m < 3; ++m) {
        murk_view_media media;
        CHECK(murk_view_media_make(&media, made->media, &box, max[m], NULL) ==
              MURK_OK);
        const size_t n = media.size[0] * media.size[1] * media.size[2];
        CHECK(n <= max[m] && n > max[m] / 4 && !media.is_even);
        CHECK(media.size[0] == 2 * media.size[1] &&
              media.size[0] == 4 * media.size[2]);
        for (size_t i = 0; i < n; ++i) {
            const size_t k = i / (media.size[0] * media.size[1]);
            const double z = 2 * ((double)k + 0.5) / (double)media.size[2];
            const double root = sqrt((0.01 + z) / media.max_per_m);
            CHECK(fabs(media.cell[i] - 255 * root) < 0.501);
        }
        murk_view_media_release(&media);
    }
    stage_text_destroy(made);
}

static void test_even_fog_is_reported(void)
{
    murk_stage *made = stage_text_create(EVEN, NULL);
    murk_view_media media;
    CHECK(murk_view_media_make(&media, made->media, &box, 1000, NULL) ==
          MURK_OK);
    CHECK(media.is_even && fabs(media.max_per_m - 0.3) < 1e-12);
    CHECK(media.cell && media.cell[0] == 255);
    murk_view_media_release(&media);
    stage_text_destroy(made);
}

/* A box without volume, no media and no world are no reason to fail. */
static void test_nothing(void)
{
    murk_stage *clear = stage_text_create(SCENE, NULL);
    murk_view_media media;
    CHECK(murk_view_media_make(&media, clear->media, &box, 1000, NULL) ==
          MURK_OK);
    CHECK(!media.cell);
    CHECK(murk_view_media_make(&media, NULL, &box, 1000, NULL) == MURK_OK);
    CHECK(!media.cell);
    stage_text_destroy(clear);
    murk_stage *made = stage_text_create(LAYERS, NULL);
    const murk_box flat = {{1, 1, 1}, {1, 1, 1}};
    CHECK(murk_view_media_make(&media, made->media, &flat, 1000, NULL) ==
          MURK_OK);
    CHECK(media.size[0] * media.size[1] * media.size[2] == 1);
    murk_view_media_release(&media);
    stage_text_destroy(made);
}

int main(void)
{
    test_layers();
    test_even_fog_is_reported();
    test_nothing();
    return check_done();
}
