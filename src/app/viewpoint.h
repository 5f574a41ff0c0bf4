/* Where murk render looks from: one of the scene's cameras, or a sensor of a
 * given placement; and the sensors whose coverage the picture shows. */
#ifndef MURK_APP_VIEWPOINT_H
#define MURK_APP_VIEWPOINT_H

#include "app/options.h"
#include "render/camera.h"
#include "world/stage.h"

#include "sensing/sensor.h"

typedef struct murk_viewpoint {
    const murk_scene_camera *named; /* the scene's; NULL: a sensor alone */
    char name[128];    /* of who looks: the camera's, "sensor 3 (node)" */
    char mark[80];     /* for the image's name: "gate", "sensor3"; empty if
                          neither --camera nor --from-sensor is given */
    const char *where; /* for messages */
    murk_camera camera;
    double heading_deg, tilt_deg; /* of the picture's middle; heading clockwise
                                     from north, 0..360 */
    size_t samples;
    murk_pose *sensor; /* [sensors] of --sensors, owned */
    size_t sensors;
} murk_viewpoint;

/* Chooses the camera of the scene by the options, before the world is built.
 * Fails with MURK_BAD_VALUE if there is none. Release the viewpoint also after
 * a failure. */
murk_status murk_viewpoint_choose(murk_viewpoint *out,
                                  const murk_scene_desc *scene,
                                  const murk_options *options, murk_error *err);

/* Reads the sensors and fills the camera, once the world is built. Fails if a
 * camera that is not orthographic is outside of the domain. */
murk_status murk_viewpoint_stand(murk_viewpoint *viewpoint,
                                 const murk_stage *stage,
                                 const murk_options *options, murk_error *err);

/* Warns if the viewpoint is inside a solid, or if no open way leads from it to
 * any light, because it is inside of something closed or behind a wall. */
murk_status murk_viewpoint_judge(const murk_viewpoint *viewpoint,
                                 const murk_stage *stage, unsigned threads,
                                 murk_error *err);
void murk_viewpoint_release(murk_viewpoint *viewpoint);

#endif
