/* The camera and the input of a rendering (render/render.h), made of a scene, a
 * world and traced light. */
#ifndef MURK_PICTURES_SCENE_PICTURE_H
#define MURK_PICTURES_SCENE_PICTURE_H

#include "lightmap/lightmap.h"
#include "render/render.h"

/* A camera of a scene, with pixels[0] x pixels[1] pixels; pixels[0] 0: with the
 * numbers of pixels that the scene gives the camera. */
murk_camera murk_camera_of_scene(const murk_scene_camera *camera,
                                 const murk_scene_desc *scene,
                                 const size_t pixels[2]);

/* The input of a rendering of the world of a stage; traced NULL: without maps.
 * The caller sets samples and method. Borrows stage, trace and traced. */
murk_render murk_render_of_stage(const murk_stage *stage,
                                 const murk_trace *trace, murk_camera camera,
                                 const murk_traced *traced, unsigned threads);

#endif
