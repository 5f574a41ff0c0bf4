/* All surfaces of a world: what a ray meets, and whether one is in the way.
 *
 * Immutable after creation, so any number of threads may ask. Every answer
 * depends on the ray alone: not on other rays asked with it, nor on threads.
 *
 * A material splits light that meets it, per band: diffuse + specular +
 * transmit <= 1, the rest is absorbed. Open geometry that transmits is a thin
 * sheet and does not bend. A closed mesh (or box, or sphere) whose material
 * has an index of refraction is a solid: Snell and Fresnel act at its boundary
 * (there specular + transmit is the share not absorbed, split by Fresnel), and
 * no medium is inside. Closed: each edge of a connected part of the triangles
 * of one description and one material belongs to an even number of them, once
 * vertices of equal place are one; all closed parts together are one solid, so
 * a hollow shape of two shells is one. Where such a material's surface is open
 * it does not bend, and a warning says so. Winding means nothing: a normal
 * faces the side that the ray came from. */
#ifndef MURK_GEOMETRY_SURFACES_H
#define MURK_GEOMETRY_SURFACES_H

#include "base/bands.h"
#include "base/status.h"
#include "base/vector.h"
#include "geometry/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_MATERIALS_MAX 256

typedef struct murk_material {
    char name[MURK_NAME_SIZE];
    murk_spectrum diffuse, specular, transmit;
    double ior; /* 0: none */
} murk_material;

typedef enum murk_shape {
    MURK_SHAPE_MESH,
    MURK_SHAPE_BOX,
    MURK_SHAPE_RECT,
    MURK_SHAPE_SPHERE
} murk_shape;

typedef struct murk_surface_desc {
    murk_shape shape;
    const murk_mesh *mesh;          /* borrowed during creation */
    murk_box box;                   /* box */
    murk_vec3 corner, edge1, edge2; /* rect */
    murk_vec3 center;               /* sphere */
    double radius_m;
    murk_affine to_world; /* meshes: after unit and up axis; others too, spheres
                             by similarity only */
    int material; /* index; -1: by the mesh's own names, `default` (index
                     0) where the scene does not name them */
    const char *where;
} murk_surface_desc;

typedef struct murk_surfaces murk_surfaces;

/* materials[0] is `default`; n_materials >= 1. n_surfaces may be 0. Geometry
 * outside the domain is kept: rays do not get there. *out is the caller's:
 * murk_surfaces_destroy(). */
murk_status murk_surfaces_create(murk_surfaces **out,
                                 const murk_surface_desc *surfaces,
                                 size_t n_surfaces,
                                 const murk_material *materials,
                                 size_t n_materials, murk_error *err);
void murk_surfaces_destroy(murk_surfaces *surfaces);

const murk_material *murk_surfaces_material(const murk_surfaces *surfaces,
                                            size_t material);
size_t murk_surfaces_materials(const murk_surfaces *surfaces); /* how many */

typedef struct murk_hit {
    double distance_m;
    murk_vec3 normal;  /* unit, geometric, faces the side the ray came from */
    uint32_t triangle; /* a number of the triangle or sphere, for replay */
    uint8_t material;
    uint16_t solid; /* 1.. for the boundary of a solid, else 0 */
} murk_hit;

/* The nearest surface strictly ahead within max_m (may be INFINITY). For a ray
 * that leaves a surface, start from murk_surfaces_leave(). In a corner of
 * opaque surfaces, within 1e-6 of the largest coordinate, distance_m is short
 * by 8e-6 of it, so that the next ray starts in the room. */
bool murk_surfaces_hit(const murk_surfaces *surfaces, murk_vec3 origin,
                       murk_vec3 direction, double max_m, murk_hit *hit);

/* A point just off the surface at `point`, on the side that `normal` points
 * to: far enough that no ray from it meets that surface again through
 * rounding: 9.5e-7 of the largest coordinate (counted from the middle of a
 * scene that is far from the origin). Surfaces nearer to each other than this
 * are not told apart. */
murk_vec3 murk_surfaces_leave(const murk_surfaces *surfaces, murk_vec3 point,
                              murk_vec3 normal);

/* The solid that encloses a point, the innermost of several: 1.., or 0. For
 * where a lamp stands. */
uint16_t murk_surfaces_solid_at(const murk_surfaces *surfaces, murk_vec3 point);

/* Whether anything but a thin transmitting sheet (or, if !through_sheets,
 * anything) stands between two points. Both may lie on surfaces: the ends
 * themselves do not block when moved off as murk_surfaces_leave() does. */
bool murk_surfaces_blocked(const murk_surfaces *surfaces, murk_vec3 from,
                           murk_vec3 to, bool through_sheets);

/* blocked[i] = murk_surfaces_blocked(from[i], to, ...), faster: the rays share
 * one end, and neighbours in the array should be neighbours in space. Equal to
 * the single call bit for bit. */
void murk_surfaces_blocked_many(const murk_surfaces *surfaces,
                                const murk_vec3 *from, size_t n, murk_vec3 to,
                                bool through_sheets, bool *blocked);

/* Product of the transmittances of the thin sheets between two points: 1 where
 * there are none. The material's transmit holds at any angle; sheets nearer to
 * each other than murk_surfaces_leave() moves count once. */
double murk_surfaces_sheet_transmittance(const murk_surfaces *surfaces,
                                         murk_vec3 from, murk_vec3 to,
                                         int band);

/* True when any surface, sheets too, is nearer than radius_m. */
bool murk_surfaces_near(const murk_surfaces *surfaces, murk_vec3 point,
                        double radius_m);

typedef struct murk_surfaces_facts {
    size_t triangles, spheres, degenerate, solids, sheets;
    double area_m2;
    murk_box bounds_m; /* empty when there are none */
    size_t memory_bytes;
} murk_surfaces_facts;

murk_surfaces_facts murk_surfaces_describe(const murk_surfaces *surfaces);

/* The i-th of murk_surfaces_describe().triangles, in no order that means
 * anything: its corners in the world [m]; and of the spheres. */
void murk_surfaces_triangle(const murk_surfaces *surfaces, size_t i,
                            murk_vec3 corner[3]);
void murk_surfaces_sphere(const murk_surfaces *surfaces, size_t i,
                          murk_vec3 *center, double *radius_m);

/* The material of triangle i, or of sphere i - triangles: numbers as in
 * murk_hit. */
uint8_t murk_surfaces_material_of(const murk_surfaces *surfaces, size_t i);

/* The material that triangles get by a mesh's own name for theirs; where the
 * scene has none of that name (whatever its case and blanks), *is_named is
 * false and it is 0, `default`. */
size_t murk_surfaces_material_named(const murk_surfaces *surfaces,
                                    const char *name, bool *is_named);

/* Area [m2] of one material. */
double murk_surfaces_material_area(const murk_surfaces *surfaces,
                                   size_t material);

#endif
