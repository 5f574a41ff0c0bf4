/* What the files of this room share about murk_surfaces.
 *
 * Embree works in float and names the primitive that a ray meets; where
 * exactly is then computed in double from that primitive, whose float vertices
 * are the truth.
 *
 * Lengths that rounding makes necessary derive from `unit`, the spacing of
 * floats at the largest stored coordinate. Rounding a ray's origin moves it by
 * at most 0.9 units, its direction by some 2 units at the far side, and
 * Embree's plane distance is off by a few. */
#ifndef MURK_GEOMETRY_WORLD_H
#define MURK_GEOMETRY_WORLD_H

#include "geometry/embree.h"
#include "geometry/soup.h"
#include "geometry/surfaces.h"

/* Off a surface, when a ray starts on it: 8 units are 1e-6 of the largest
 * coordinate. Costs: surfaces nearer to each other than this are not told
 * apart. */
#define MURK_LEAVE_UNITS 8

struct murk_surfaces {
    murk_soup soup;
    murk_material *material;
    size_t n_materials;
    double *material_area_m2; /* [n_materials] */
    double area_m2;
    double unit_m, leave_m;
    murk_box reach; /* the soup's box, larger by leave_m */
    RTCDevice device;
    RTCScene scene; /* NULL when there is nothing to meet */
    size_t embree_bytes;
};

/* Faces as Embree's ray masks. */
#define MURK_MASK(face) (1u << (unsigned)(face))
#define MURK_MASK_BLOCKS \
    (MURK_MASK(MURK_FACE_OPAQUE) | MURK_MASK(MURK_FACE_SOLID))
#define MURK_MASK_ALL (MURK_MASK_BLOCKS | MURK_MASK(MURK_FACE_SHEET))

/* Geometry numbers: triangles of each face, then balls of each face. */
#define MURK_GEOMETRY_OF_BALLS(face) ((unsigned)(face) + (unsigned)MURK_FACES)

/* A ray in double beside Embree's float one, so that balls are met exactly. */
typedef struct murk_ray_context {
    murk_embree_context embree; /* first: Embree hands its address back */
    murk_vec3 origin, direction;
} murk_ray_context;

/* Which primitive a hit means. */
typedef struct murk_primitive {
    bool is_ball;
    uint32_t index; /* into the soup's triangles or balls */
} murk_primitive;

static inline murk_primitive murk_primitive_of(const murk_soup *soup,
                                               const struct RTCHit *hit)
{
    const bool is_ball = hit->geomID >= MURK_FACES;
    const size_t first =
        is_ball ? soup->first_ball[hit->geomID - (unsigned)MURK_FACES]
                : soup->first_triangle[hit->geomID];
    return (murk_primitive){is_ball, (uint32_t)first + hit->primID};
}

/* Embree's own limit is 1.8e18; beyond it, and for what is not finite, some of
 * its builds stop the program. */
#define MURK_RAY_MAX_M 1e17

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

static inline void murk_ray_set(struct RTCRay *ray, murk_vec3 origin,
                                murk_vec3 direction, float tfar, unsigned mask)
{
    ray->org_x = (float)origin.x;
    ray->org_y = (float)origin.y;
    ray->org_z = (float)origin.z;
    ray->tnear = 0;
    ray->dir_x = (float)direction.x;
    ray->dir_y = (float)direction.y;
    ray->dir_z = (float)direction.z;
    ray->time = 0;
    ray->tfar = tfar;
    ray->mask = mask;
    ray->id = 0;
    ray->flags = 0;
}

/* Makes device and scene from the soup, which must have something in it.
 * murk_world_release() also after a failure. */
murk_status murk_world_commit(murk_surfaces *surfaces, murk_error *err);
void murk_world_release(murk_surfaces *surfaces);

#endif
