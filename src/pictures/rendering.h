/* A picture of the world of a stage: the method, the viewpoint and the image,
 * with the checks before and the warnings after the rendering. */
#ifndef MURK_PICTURES_RENDERING_H
#define MURK_PICTURES_RENDERING_H

#include "lightmap/lightmap.h"
#include "pictures/images.h"
#include "pictures/viewpoint.h"
#include "render/render.h"

typedef struct murk_rendering_method {
    murk_render_method kind;
    const char *name, *text; /* "path"; "path: path tracing with shadow rays" */
} murk_rendering_method;

/* The methods, in the order of murk_method of murk.h. */
#define MURK_RENDERING_METHODS 3
extern const murk_rendering_method
    murk_rendering_methods[MURK_RENDERING_METHODS];

typedef struct murk_rendering {
    const murk_rendering_method *method;
    murk_viewpoint viewpoint;
    murk_image *image; /* owned; NULL before murk_rendering_run() */
    double render_s;   /* the time of murk_rendering_run() */
} murk_rendering;

/* Chooses the camera. Fails as murk_viewpoint_choose(), and with MURK_BAD_VALUE
 * if the scene does not store the maps that the method needs. */
murk_status murk_rendering_choose(murk_rendering *out,
                                  const murk_rendering_method *method,
                                  const murk_scene_desc *scene,
                                  const murk_viewpoint_request *request,
                                  murk_error *err);

/* Fails with MURK_NO_MEMORY if less memory is free than the picture, the files
 * of `images` (NULL: none) and, with light, the kernels of the maps take. */
murk_status murk_rendering_check_memory(const murk_rendering *rendering,
                                        const murk_scene_desc *scene,
                                        const murk_image_options *images,
                                        const murk_traced *light,
                                        murk_error *err);

/* Renders the image and adds the coverage by the sensors of the viewpoint.
 * Warns of maps with few records and of standard errors that rest on few bright
 * paths. light NULL: the method uses no maps. Fails with MURK_NO_MEMORY or
 * MURK_INTERRUPTED. */
murk_status murk_rendering_run(murk_rendering *rendering,
                               const murk_stage *stage,
                               const murk_traced *light, unsigned threads,
                               murk_error *err);
void murk_rendering_release(murk_rendering *rendering);

#endif
