/* A straight ray through surfaces and through regions with a boundary. The
 * functions that follow photons, sightlines and rays of cameras are all made of
 * the functions of this file.
 *
 * Regions with a boundary are those with an index of refraction
 * (medium/interfaces.h) and those bounded by a closed mesh
 * (geometry/boundary_meshes.h). Each ray carries the set of the regions with a
 * boundary that contain the ray. The set, and not the position, tells on which
 * side of a boundary the ray is: no position is shifted, and the ray may begin
 * on the boundary that it has just crossed.
 *
 * Surfaces and boundary meshes are known in single precision only, boundaries
 * of other shapes in double. So boundaries that lie within the tolerance of a
 * mesh are crossed together with it, and a face of a mesh in a side of the
 * domain is no boundary. */
#ifndef MURK_PATH_PATH_H
#define MURK_PATH_PATH_H

#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"
#include "medium/interfaces.h"
#include "path/sides.h"

/* Everything that a ray can meet, and the tolerances that follow from it. The
 * pointers are borrowed; immutable, so any number of threads may read it. */
typedef struct murk_path_space {
    const murk_surfaces *surfaces; /* NULL: none */
    const murk_media *media;
    const murk_boundary_meshes *boundary_meshes; /* NULL: no region is a mesh */
    const murk_domain *domain;
    murk_path_sides sides;   /* of the domain */
    murk_path_sides grown;   /* of the larger box in which surfaces are looked
                              * for: rounding may put a surface outside of the
                              * domain */
    double margin_m;         /* from `sides` to `grown` */
    double near_m;           /* a boundary nearer than this to a surface that is
                              * almost parallel lies in the surface */
    double mesh_tolerance_m; /* of boundary meshes; 0 without */
    bool any_surfaces, any_solids;
    bool any_boundaries; /* some region has an index or is a mesh */
} murk_path_space;

/* Surfaces that lie outside of the domain by at most this length [m] count as
 * lying in a side of the domain. */
double murk_path_margin_m(const murk_domain *domain);

murk_path_space murk_path_space_of(const murk_surfaces *surfaces,
                                   const murk_media *media,
                                   const murk_boundary_meshes *boundary_meshes,
                                   const murk_domain *domain);

/* The regions with a boundary that contain a point. For a point on a boundary,
 * to rounding, either answer is possible. */
murk_inside murk_path_inside(const murk_path_space *space, murk_vec3 point);

/* The regions with a boundary that contain a ray just beyond its start at a
 * point: regions are looked up a little ahead along `direction`, so that of a
 * boundary through the point the far side counts. */
murk_inside murk_path_inside_ahead(const murk_path_space *space,
                                   murk_vec3 point, murk_vec3 direction);

/* The regions with a boundary that contain a ray that has left a periodic
 * domain across an axis (0 x, 1 y) with the set `inside` and continues at
 * `point` on the opposite side. */
murk_inside murk_path_inside_wrapped(const murk_path_space *space,
                                     murk_inside inside, murk_vec3 point,
                                     int axis);

/* A ray, and how far it has been followed. */
typedef struct murk_path {
    const murk_path_space *space;
    murk_vec3 position, direction; /* where the ray begins; unit vector */
    double length_m;               /* may be INFINITY */
    double gone_m;      /* from `position` to the last boundary passed */
    double skip_m;      /* faces of meshes nearer than this to `position` do not
                         * count: the ray begins in such a face, or has just
                         * passed it */
    murk_inside inside; /* regions with a boundary that contain the ray
                           beyond gone_m */
} murk_path;

/* The whole ray between two points of the domain. If the points are equal,
 * length and direction are 0. */
murk_path murk_path_between(const murk_path_space *space, murk_vec3 from,
                            murk_vec3 to);

typedef struct murk_path_boundary {
    murk_boundary met; /* distance_m counts from the ray's position */
    bool has_mesh;     /* some of the crossed boundaries are faces of meshes */
    bool has_shape;    /* some are boundaries of other shapes */
    double mesh_m;     /* if has_mesh: distance from the ray's position to the
                        * faces of meshes */
} murk_path_boundary;

/* The next boundary on the ray beyond gone_m. Faces of meshes are looked for up
 * to mesh_max_m from the ray's position, boundaries of other shapes up to
 * length_m. The function corrects path->inside if the faces of meshes ahead
 * prove it wrong (geometry/boundary_meshes.h). False if there is no boundary;
 * *boundary then has no meaning. */
bool murk_path_next_boundary(murk_path *path, double mesh_max_m,
                             murk_path_boundary *boundary);

/* Moves the state of the ray beyond the boundary: gone_m, inside and, if a
 * face of a mesh is crossed, skip_m. */
void murk_path_pass(murk_path *path, const murk_path_boundary *boundary);

/* A place on the ray at which the index of refraction changes. */
typedef struct murk_path_change {
    double distance_m;
    murk_vec3 normal;      /* unit, on the side from which the ray came */
    bool is_mesh;          /* of a mesh alone */
    double before, beyond; /* indices of refraction */
    murk_inside inside;    /* regions with a boundary that contain the ray
                            * beyond */
} murk_path_change;

/* Follows the ray to the first change of the index of refraction beyond gone_m
 * and passes the boundary there. False if there is none, or none among the next
 * 100,000 boundaries. Faces of meshes within mesh_tolerance_m of the end of the
 * ray do not count, because a ray often ends on a surface, such as the floor of
 * a tank, that lies in the face of a mesh of water. */
bool murk_path_next_change(murk_path *path, murk_path_change *change);

/* Optical depth in a band over the whole length of a ray that has not been
 * followed yet. */
double murk_path_depth(const murk_path *path, int band);

typedef enum murk_path_event_kind {
    MURK_PATH_SURFACE,
    MURK_PATH_BOUNDARY,
    MURK_PATH_SIDE /* of the domain */
} murk_path_event_kind;

typedef struct murk_path_event {
    murk_path_event_kind kind;
    double distance_m;   /* from the ray's position */
    murk_hit hit;        /* surface: as seen from `probe` */
    murk_inside crossed; /* surface: regions whose boundary lies in the surface;
                          * else 0 */
} murk_path_event;

/* The first event on the ray: the nearest surface ahead of `probe`, a point on
 * the line of the ray; or `boundary`, the next boundary (NULL: none); or the
 * side of the domain. A surface comes before a boundary that lies in the
 * surface, and a surface outside of the domain by at most margin_m comes before
 * the side. False if the position is not finite or is outside of the domain by
 * more than margin_m, or, for a position in the domain, if each component of
 * the direction is 0 or NaN. Surfaces farther than near_m from the position
 * may be left out; INFINITY: none is. */
bool murk_path_first_event(const murk_path *path, murk_vec3 probe,
                           const murk_path_boundary *boundary, double near_m,
                           murk_path_event *event);

#endif
