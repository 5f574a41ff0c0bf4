/* Turns a camera of a scene into a camera of src/render, and a world with
 * traced light into the input of a rendering. */
#include "pictures/scene_picture.h"

murk_camera murk_camera_of_scene(const murk_scene_camera *c,
                                 const murk_scene_desc *scene,
                                 const size_t asked[2])
{
    const size_t *pixels = asked[0] ? asked : c->pixels;
    /* The projection, then the clip plane. */
    murk_camera camera;
    switch (c->projection) {
    case MURK_SCENE_EQUIRECTANGULAR:
        camera = murk_camera_around(
            c->from, c->has_to ? murk_sub(c->to, c->from) : scene->north,
            pixels[0], pixels[1]);
        break;
    case MURK_SCENE_ORTHOGRAPHIC:
        camera = murk_camera_parallel(c->from, c->to, c->up, c->width_m,
                                      pixels[0], pixels[1]);
        break;
    case MURK_SCENE_PERSPECTIVE:
    default:
        camera = murk_camera_aimed(c->from, c->to, c->up, c->vfov_rad,
                                   pixels[0], pixels[1]);
    }
    if (c->has_clip) {
        camera.clip =
            (murk_clip){true, c->clip_point, murk_unit(c->clip_normal)};
    }
    return camera;
}

murk_render murk_render_of_stage(const murk_stage *stage,
                                 const murk_trace *trace, murk_camera camera,
                                 const murk_traced *traced, unsigned threads)
{
    const murk_scene_desc *scene = stage->scene;
    murk_render render = {.trace = trace,
                          .camera = camera,
                          .surface = traced ? traced->surface : NULL,
                          .volume = traced ? traced->volume : NULL,
                          .threads = threads};
    /* The edges of each band, for the colours; of a band without edges, the
     * wavelength twice. */
    for (int b = 0; b < scene->bands; ++b) {
        const bool edges = scene->has_edges;
        render.from_nm[b] = edges ? scene->band_edge_nm[b] : scene->band_nm[b];
        render.to_nm[b] =
            edges ? scene->band_edge_nm[b + 1] : scene->band_nm[b];
    }
    return render;
}
