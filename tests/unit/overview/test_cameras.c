/* The memory that `murk check` predicts for pictures equals the sizes of the
 * buffers that rendering allocates. Nothing here is random. */
#include "base/log.h"
#include "check.h"
#include "overview/parts.h"
#include "render/render.h"

static char noted[1000];

static void keep_note(const char *where, const char *text)
{
    const size_t used = strlen(noted);
    snprintf(noted + used, sizeof noted - used, "%s: %s\n", where, text);
}

static double predicted(const murk_scene_desc *scene,
                        const murk_forecast *forecast, int camera)
{
    cJSON *root = cJSON_CreateObject();
    murk_overview_json_cameras(root, scene, forecast);
    const cJSON *item =
        cJSON_GetArrayItem(cJSON_GetObjectItem(root, "cameras"), camera);
    const cJSON *bytes = cJSON_GetObjectItem(item, "memory_bytes");
    const double value = cJSON_IsNumber(bytes) ? bytes->valuedouble : -1;
    cJSON_Delete(root);
    return value;
}

static void test_pictures_and_maps_are_forecast(void)
{
    murk_scene_camera camera[2] = {
        {.name = "gate", .where = "yard.yaml:9:5: cameras.0", .samples = 1},
        {.name = "wide", .where = "yard.yaml:10:5: cameras.1", .samples = 1}};
    camera[0].pixels[0] = 64;
    camera[0].pixels[1] = 48;
    /* more than any machine has: 16 bands of 2^40 pixels */
    camera[1].pixels[0] = camera[1].pixels[1] = (size_t)1 << 20;
    const murk_scene_desc scene = {
        .cameras = camera, .n_cameras = 2, .bands = 16};
    const murk_forecast dark = {0}, lit = {.surface = 1e6, .volume = 1e5};
    const double maps = murk_photon_map_memory_for(1e6) +
                        murk_photon_map_memory_for(1e5) -
                        2 * murk_photon_map_memory_for(0);
    CHECK(predicted(&scene, &dark, 0) >=
          murk_render_bytes(64, 48, 16, MURK_BY_MAPS));
    const double kernels =
        murk_gather_memory_for(1e6, 1e5) - murk_gather_memory_for(0, 0);
    CHECK(predicted(&scene, &lit, 0) - predicted(&scene, &dark, 0) ==
          maps + kernels);
    /* copies of 32 bytes, kernels of at least 24, balls of 16 */
    CHECK(kernels > 1.1e6 * (32 + 24 + 16));
    const murk_warn_sink before = murk_warn_to(keep_note);
    murk_overview_warn_of_cameras(&scene, &dark);
    (void)murk_warn_to(before);
    static const char want[] = "yard.yaml:10:5: cameras.1: a picture of "
                               "1048576 x 1048576 pixels by maps takes about ";
    CHECK(strncmp(noted, want, sizeof want - 1) == 0);
    CHECK(strstr(noted, "GB are free: fewer pixels or photons\n"));
    CHECK(strchr(noted, '\n') == noted + strlen(noted) - 1);
}

int main(void)
{
    test_pictures_and_maps_are_forecast();
    return check_done();
}
