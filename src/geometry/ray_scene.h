/* The Embree scene behind murk_surfaces, shared by the files of src/geometry.
 *
 * Embree works in single precision and names the primitive that a ray hits. The
 * exact place is then computed in double precision from that primitive, whose
 * float vertices define the geometry.
 *
 * Lengths that rounding makes necessary are multiples of `unit_m`, the largest
 * stored coordinate times 2^-23, which is at least the spacing of floats there.
 * Comments call unit_m a float step. Rounding a ray's origin moves the ray by
 * at most 0.9 units, rounding its direction by some 2 units at the far side,
 * and Embree's distance to a plane is off by a few units. */
#ifndef MURK_GEOMETRY_RAY_SCENE_H
#define MURK_GEOMETRY_RAY_SCENE_H

#include "geometry/embree.h"
#include "geometry/soup.h"
#include "geometry/surfaces.h"

#include <string.h>

/* Distance by which a ray's start is moved off a surface. 8 units are 1e-6
 * of the largest coordinate and exceed the sum of the errors above. Cost:
 * surfaces closer to each other than this are not told apart. */
#define MURK_LEAVE_UNITS 8

/* Planes with thin sheets, at most (a choice: a hall has a plane for each side,
 * the roof and some partitions, and a test of all takes less time than a ray).
 */
#define MURK_SHEET_PLANES_MAX 16

/* The planes that contain the thin sheets of a scene, relative to the anchor: a
 * point p lies in plane k if (x, y, z) . p + offset is 0. */
typedef struct murk_sheet_planes {
    bool are_all; /* every sheet lies in one of the planes; false if there are
                     too many planes, or curved sheets */
    size_t n;
    double x[MURK_SHEET_PLANES_MAX], y[MURK_SHEET_PLANES_MAX],
        z[MURK_SHEET_PLANES_MAX], offset[MURK_SHEET_PLANES_MAX];
    murk_box box[MURK_SHEET_PLANES_MAX]; /* of the sheets in each plane */
} murk_sheet_planes;

/* unit_m: a float step. */
murk_sheet_planes murk_sheet_planes_of(const murk_soup *soup, double unit_m);

struct murk_surfaces {
    murk_soup soup;
    murk_material *material;
    size_t n_materials;
    double *material_area_m2; /* [n_materials] */
    double area_m2;
    double unit_m, leave_m;
    murk_box reach;      /* the bounding box of the soup, enlarged by leave_m */
    bool is_reach_sound; /* Embree can trace from any point of it to another */
    murk_sheet_planes sheet_planes;
    RTCDevice device;
    RTCScene scene; /* NULL if the scene is empty */
    size_t embree_bytes;
};

/* Kinds of faces as Embree's ray masks. */
#define MURK_MASK(face) (1u << (unsigned)(face))
#define MURK_MASK_BLOCKS \
    (MURK_MASK(MURK_FACE_OPAQUE) | MURK_MASK(MURK_FACE_SOLID))
#define MURK_MASK_ALL (MURK_MASK_BLOCKS | MURK_MASK(MURK_FACE_SHEET))

/* Numbers of Embree's geometries: triangles of each kind of face, then
 * spheres of each kind. */
#define MURK_GEOMETRY_OF_SPHERES(face) ((unsigned)(face) + (unsigned)MURK_FACES)

/* The ray in double precision beside Embree's, so that spheres are
 * intersected exactly. */
typedef struct murk_ray_context {
    murk_embree_context embree; /* must be first: Embree passes the address of
                                 * this member to callbacks */
    murk_vec3 origin, direction;
} murk_ray_context;

/* The primitive that Embree's hit names. */
typedef struct murk_primitive {
    bool is_sphere;
    uint32_t index; /* index into the triangles or spheres of the soup */
} murk_primitive;

static inline murk_primitive murk_primitive_of(const murk_soup *soup,
                                               const struct RTCHit *hit)
{
    const bool is_sphere = hit->geomID >= MURK_FACES;
    const size_t first =
        is_sphere ? soup->first_sphere[hit->geomID - (unsigned)MURK_FACES]
                  : soup->first_triangle[hit->geomID];
    return (murk_primitive){is_sphere, (uint32_t)first + hit->primID};
}

/* The number of a primitive: triangles come first, then spheres. */
static inline size_t murk_primitive_number(const murk_soup *soup,
                                           murk_primitive p)
{
    return p.is_sphere ? soup->triangles + p.index : p.index;
}

/* Largest coordinate of a ray. Embree's own limit is 1.8e18; beyond it, and
 * for values that are not finite, some builds of Embree stop the program. */
#define MURK_RAY_MAX_M 1e17

/* True if Embree can trace the ray: finite coordinates within the limit and
 * a direction other than 0. */
static inline bool murk_ray_is_sound(murk_vec3 origin, murk_vec3 direction)
{
    const murk_vec3 v[2] = {origin, direction};
    for (int i = 0; i < 2; ++i) {
        if (!(fabs(v[i].x) < MURK_RAY_MAX_M && fabs(v[i].y) < MURK_RAY_MAX_M &&
              fabs(v[i].z) < MURK_RAY_MAX_M)) {
            return false;
        }
    }
    return murk_dot(direction, direction) > 0;
}

/* Four floats that are written together, because Embree reads them together: a
 * processor forwards one store to one load at once, several stores only when
 * all are in the cache. */
typedef float murk_four_floats __attribute__((vector_size(16)));

/* Writes the ray; its id and flags are 0. */
static inline void murk_ray_set(struct RTCRay *ray, murk_vec3 origin,
                                murk_vec3 direction, float tfar, unsigned mask)
{
    const murk_four_floats start = {(float)origin.x, (float)origin.y,
                                    (float)origin.z, 0};
    const murk_four_floats along = {(float)direction.x, (float)direction.y,
                                    (float)direction.z, 0};
    _Static_assert(offsetof(struct RTCRay, tnear) == 3 * sizeof(float) &&
                       offsetof(struct RTCRay, dir_x) == sizeof start &&
                       offsetof(struct RTCRay, time) == 7 * sizeof(float),
                   "the order of the members of Embree's ray");
    memcpy(&ray->org_x, &start, sizeof start);
    memcpy(&ray->dir_x, &along, sizeof along);
    ray->tfar = tfar;
    ray->mask = mask;
    ray->id = 0;
    ray->flags = 0;
}

/* Creates Embree's device and scene from the soup, which must not be empty. The
 * caller calls murk_ray_scene_release() also after a failure. Fails with
 * MURK_NO_MEMORY (also if Embree does not start), with MURK_UNSUPPORTED if
 * Embree has no ray masks, or with MURK_RUN_FAILED for other errors of
 * Embree. */
murk_status murk_ray_scene_commit(murk_surfaces *surfaces, murk_error *err);
void murk_ray_scene_release(murk_surfaces *surfaces);

/* Calls visit() for the primitives within radius_m of a point, and possibly for
 * some slightly beyond, in no particular order, until visit() returns true. The
 * point is relative to the anchor, and the scene is not empty. */
typedef bool (*murk_visit)(void *context, murk_primitive p);
void murk_ray_scene_visit(const murk_surfaces *surfaces, murk_vec3 point,
                          double radius_m, murk_visit visit, void *context);

#endif
