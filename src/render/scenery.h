/* The world as pictures of it need it, and straight rays through it.
 *
 * A ray passes media and, if wanted, thin sheets. The ray ends at anything
 * else, and at a change of the index of refraction, since light bends there. In
 * a periodic domain the ray goes on at the opposite side. */
#ifndef MURK_RENDER_SCENERY_H
#define MURK_RENDER_SCENERY_H

#include "base/status.h"
#include "path/pieces.h"
#include "transport/trace.h"

/* Immutable; any number of threads may use it. */
typedef struct murk_scenery {
    const murk_transport_world *world;
    murk_path_tiling tiling;
    bool any_surfaces, any_sheets, any_media, bends;
    double margin_m; /* what surfaces in single precision are off by, at most */
    size_t *lit[MURK_BANDS_MAX];    /* [n_lit] lights with power in a band */
    double *chance[MURK_BANDS_MAX]; /* [n_lit] cumulative, of being drawn */
    size_t n_lit[MURK_BANDS_MAX];
} murk_scenery;

/* The world must outlive it. Release it also after a failure. */
murk_status murk_scenery_prepare(murk_scenery *scenery,
                                 const murk_transport_world *world,
                                 murk_error *err);
void murk_scenery_release(murk_scenery *scenery);

/* What is left of light in a band along a way from a point that lies on no
 * surface (murk_surfaces_leave()), over a length or, INFINITY, out of the
 * domain: 0 where it is blocked. */
double murk_scenery_through(const murk_scenery *scenery, int band,
                            murk_vec3 from, murk_vec3 direction,
                            double length_m, bool through_sheets);

/* What one looks at from a point in the open: the first surface, change of
 * index or side of the domain. */
typedef struct murk_scenery_end {
    double distance_m;
    bool is_surface;
    murk_vec3 position; /* of a surface: in the domain, whose copies repeat */
    murk_vec3 normal;   /* of a surface: unit, faces who looks */
} murk_scenery_end;

murk_scenery_end murk_scenery_find_end(const murk_scenery *scenery,
                                       murk_vec3 from, murk_vec3 direction);

/* Optical depth over that length. */
double murk_scenery_depth(const murk_scenery *scenery, int band, murk_vec3 from,
                          murk_vec3 direction, double length_m);

#endif
