/* Sightlines: straight paths from one point, a sensor, to many others, through
 * the media. Surfaces are not considered here (path/segment.h does so), because
 * shadow rays to one point are traced in batches. */
#ifndef MURK_PATH_VIEWPOINT_H
#define MURK_PATH_VIEWPOINT_H

#include "path/path.h"
#include "path/segment.h"

typedef struct murk_path_viewpoint {
    const murk_path_space *space;
    murk_vec3 position;
    murk_inside meshes; /* the regions bounded by a mesh that contain the
                           position */
    double index;       /* index of refraction at the position */
} murk_path_viewpoint;

murk_path_viewpoint murk_path_viewpoint_at(const murk_path_space *space,
                                           murk_vec3 position);

/* The index of refraction at a point. */
double murk_path_index_at(const murk_path_space *space, murk_vec3 point);

/* The paths from the viewpoint to the nearest image of a point, one after the
 * other, each in the domain. Returns the number of paths, 1..3. */
int murk_path_to(const murk_path_viewpoint *viewpoint, murk_vec3 point,
                 murk_path path[MURK_PATH_SEGMENTS_MAX]);

/* Optical depth, and exp(-optical depth), of the straight line from the
 * viewpoint to the nearest image of a point. */
double murk_path_depth_to(const murk_path_viewpoint *viewpoint, int band,
                          murk_vec3 point);
double murk_path_transmittance_to(const murk_path_viewpoint *viewpoint,
                                  int band, murk_vec3 point);

/* True if the index of refraction changes on the straight path to the nearest
 * image of a point: light bends there, so the point does not appear in the
 * direction of this path. */
bool murk_path_bends_to(const murk_path_viewpoint *viewpoint, murk_vec3 point);

#endif
