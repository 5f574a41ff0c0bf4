/* Where a picture is taken from: one of the scene's cameras, or a sensor of a
 * given list; and the sensors whose coverage the picture shows. */
#ifndef MURK_PICTURES_VIEWPOINT_H
#define MURK_PICTURES_VIEWPOINT_H

#include "render/camera.h"
#include "sensing/sensor.h"
#include "world/stage.h"

/* The largest number of pixels along a side: that of the key cameras.N.pixels
 * of a scene. */
#define MURK_PICTURE_SIDE_MAX 65536

/* What the caller asks for; zeros: the first camera of the scene as it is. */
typedef struct murk_viewpoint_request {
    const char *camera;      /* name of a camera of the scene; NULL: the first,
                                or none with from_sensor */
    const murk_pose *sensor; /* [sensors]; the picture shows their coverage */
    size_t sensors;
    const char *sensors_file; /* the file that the sensors are from, for
                                 messages; NULL: none */
    uint64_t from_sensor;     /* the picture is the view of this sensor, from 1
                                 on; 0: of the camera */
    size_t pixels[2];         /* width and height; 0: those of the camera */
    uint64_t samples;         /* of each pixel; 0: those of the camera */
} murk_viewpoint_request;

typedef struct murk_viewpoint {
    const murk_scene_camera *named; /* borrowed from the scene; NULL: the
                                       picture is of a sensor, and no camera is
                                       named */
    char name[128];    /* the name of the camera, or "sensor 3 (node)" */
    const char *where; /* the place of the camera, for messages */
    murk_camera camera;
    double heading_deg, tilt_deg; /* of the middle of the picture; heading
                                     clockwise from north, 0..360 */
    size_t samples;
    const murk_pose *sensor; /* [sensors] of the request, borrowed */
    size_t sensors;
} murk_viewpoint;

/* Sets out->named to the camera of the scene that the request names. Fails with
 * MURK_BAD_VALUE if the scene has no such camera, or, unless the picture is of
 * a sensor, no camera at all. */
murk_status murk_viewpoint_choose(murk_viewpoint *out,
                                  const murk_scene_desc *scene,
                                  const murk_viewpoint_request *request,
                                  murk_error *err);

/* Fills all other members of a viewpoint that murk_viewpoint_choose() has
 * chosen. Fails with MURK_BAD_VALUE if the list has no sensor of that number,
 * or if a camera that is not orthographic is outside of the domain. */
murk_status murk_viewpoint_stand(murk_viewpoint *viewpoint,
                                 const murk_stage *stage,
                                 const murk_viewpoint_request *request,
                                 murk_error *err);

/* Warns if the viewpoint is inside a solid of transmitting material, or if no
 * open way leads from it to any light. Does nothing for orthographic and
 * clipped cameras, whose rays begin elsewhere. Fails as
 * murk_stage_free_space(). */
murk_status murk_viewpoint_judge(const murk_viewpoint *viewpoint,
                                 const murk_stage *stage, unsigned threads,
                                 murk_error *err);

#endif
