/* The cameras of a scene as murk check reports them, with the memory that a
 * picture by maps takes. */
#include "overview/parts.h"

#include "base/log.h"
#include "base/machine.h"
#include "render/render.h"
#include "results/summary.h"

/* The memory of a render by maps [bytes]: the picture, the maps that were
 * traced, and the kernels that the render makes of them. */
static double bytes_of(const murk_scene_desc *scene,
                       const murk_forecast *forecast, size_t camera)
{
    const murk_scene_camera *c = &scene->cameras[camera];
    return murk_render_bytes(c->pixels[0], c->pixels[1], scene->bands,
                             MURK_BY_MAPS) +
           murk_photon_map_memory_for(forecast->surface) +
           murk_photon_map_memory_for(forecast->volume) +
           murk_gather_memory_for(forecast->surface, forecast->volume);
}

static murk_projection projection_of(const murk_scene_desc *scene,
                                     size_t camera)
{
    static const murk_projection projections[] = {
        [MURK_SCENE_PERSPECTIVE] = MURK_PERSPECTIVE,
        [MURK_SCENE_EQUIRECTANGULAR] = MURK_EQUIRECTANGULAR,
        [MURK_SCENE_ORTHOGRAPHIC] = MURK_ORTHOGRAPHIC};
    return projections[scene->cameras[camera].projection];
}

void murk_overview_json_cameras(cJSON *root, const murk_scene_desc *scene,
                                const murk_forecast *forecast)
{
    cJSON *list = cJSON_AddArrayToObject(root, "cameras");
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        const murk_scene_camera *c = &scene->cameras[i];
        cJSON *item = murk_json_item(list);
        cJSON_AddStringToObject(item, "name", c->name);
        cJSON_AddStringToObject(item, "type",
                                murk_projection_name(projection_of(scene, i)));
        const double pixels[] = {(double)c->pixels[0], (double)c->pixels[1]};
        murk_json_numbers(item, "pixels", pixels, 2);
        murk_json_number(item, "samples", (double)c->samples);
        murk_json_number(item, "memory_bytes", bytes_of(scene, forecast, i));
    }
}

void murk_overview_print_cameras(const murk_scene_desc *scene,
                                 const murk_forecast *forecast)
{
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        const murk_scene_camera *c = &scene->cameras[i];
        murk_print(
            "camera      %-12s %zu x %zu pixels%s, %zu sample%s; by maps "
            "about %.2g GB\n",
            c->name, c->pixels[0], c->pixels[1],
            projection_of(scene, i) == MURK_EQUIRECTANGULAR ? " all round"
            : projection_of(scene, i) == MURK_ORTHOGRAPHIC  ? ", orthographic"
                                                            : "",
            c->samples, c->samples == 1 ? "" : "s",
            bytes_of(scene, forecast, i) / 1e9);
    }
}

void murk_overview_warn_of_cameras(const murk_scene_desc *scene,
                                   const murk_forecast *forecast)
{
    const double have = murk_machine_memory_bytes();
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        const murk_scene_camera *c = &scene->cameras[i];
        const double bytes = bytes_of(scene, forecast, i);
        if (!(bytes <= have)) {
            murk_warn(c->where,
                      "a picture of %zu x %zu pixels by maps takes about %.3g "
                      "GB, and %.3g GB are free: fewer pixels or photons",
                      c->pixels[0], c->pixels[1], bytes / 1e9, have / 1e9);
        }
    }
}
