/* The world prepared for pictures, and straight rays through the world.
 *
 * A ray passes media and, if wanted, thin sheets. The ray ends at anything
 * else, and at a change of the index of refraction, since light bends there. In
 * a periodic domain the ray goes on at the opposite side. */
#ifndef MURK_RENDER_SCENERY_H
#define MURK_RENDER_SCENERY_H

#include "base/status.h"
#include "path/pieces.h"
#include "render/camera.h"
#include "transport/trace.h"

/* Immutable; any number of threads may use it. */
typedef struct murk_scenery {
    const murk_transport_world *world;
    murk_path_tiling tiling;
    bool any_surfaces, any_sheets, any_media, bends;
    double margin_m; /* upper bound of the error of surfaces in single precision
                        [m] */
    size_t *lit[MURK_BANDS_MAX];    /* [n_lit] lights with power in a band */
    double *chance[MURK_BANDS_MAX]; /* [n_lit] cumulative probabilities, half by
                                       power and half equal */
    size_t n_lit[MURK_BANDS_MAX];
} murk_scenery;

/* Borrows the world. Call murk_scenery_release() also after a failure. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_scenery_prepare(murk_scenery *scenery,
                                 const murk_transport_world *world,
                                 murk_error *err);
void murk_scenery_release(murk_scenery *scenery);

/* The transmittance of media, and of sheets with through_sheets, along a
 * straight ray in a band, for a ray of length_m from a point off all surfaces
 * (murk_surfaces_leave()); INFINITY: out of the domain, with the media outside.
 * 0 if the ray is blocked or the refractive index changes. */
double murk_scenery_through(const murk_scenery *scenery, int band,
                            murk_vec3 from, murk_vec3 direction,
                            double length_m, bool through_sheets);

/* The end of a viewing ray from a point off all surfaces: the first surface,
 * change of index or side of the domain. */
typedef struct murk_scenery_end {
    double distance_m;
    bool is_surface;
    murk_vec3 position; /* of a surface: in the domain, also if the ray crossed
                           periodic sides */
    murk_vec3 normal;   /* of a surface: unit normal towards the viewer */
} murk_scenery_end;

murk_scenery_end murk_scenery_find_end(const murk_scenery *scenery,
                                       murk_vec3 from, murk_vec3 direction);

/* murk_camera_begin() in this world. */
bool murk_scenery_begin(const murk_scenery *scenery, murk_camera_ray *out,
                        const murk_camera *camera, double x, double y,
                        murk_vec3 direction);

/* Optical depth of the media over a length, without surfaces. */
double murk_scenery_depth(const murk_scenery *scenery, int band, murk_vec3 from,
                          murk_vec3 direction, double length_m);

#endif
