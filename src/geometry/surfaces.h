/* All surfaces of a scene: the nearest intersection of a ray, and whether a
 * sightline is blocked.
 *
 * Immutable after creation, so any number of threads may use it. Every answer
 * depends on the ray alone: not on other rays traced with it, nor on threads.
 *
 * A material divides incident light per band: diffuse + specular + transmit <=
 * 1, the rest is absorbed. Open geometry that transmits is a thin sheet and
 * does not refract. A closed mesh (or box, or sphere) whose material has an
 * index of refraction is a solid: Snell's law and Fresnel's equations apply at
 * its boundary (specular + transmit is then the share of the light that
 * Fresnel's equations divide into reflected and refracted light), and no medium
 * is inside. Closed means that every edge of a connected part, made of the
 * triangles of one description and one material, belongs to an even number of
 * them after vertices at equal places are merged. All closed parts together are
 * one solid, so a hollow shape of two closed surfaces is one solid. Open
 * surfaces of such a material do not refract, and a warning says so. The
 * winding of triangles is ignored: a normal faces the side from which the ray
 * came. */
#ifndef MURK_GEOMETRY_SURFACES_H
#define MURK_GEOMETRY_SURFACES_H

#include "base/bands.h"
#include "base/shape.h"
#include "base/status.h"
#include "base/vector.h"
#include "geometry/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Material numbers have 8 bits. */
#define MURK_MATERIALS_MAX 256

typedef struct murk_material {
    char name[MURK_NAME_SIZE];
    murk_spectrum diffuse, specular, transmit;
    double ior; /* 0: none */
} murk_material;

typedef struct murk_surface_desc {
    murk_shape shape;
    const murk_mesh *mesh;          /* borrowed until creation returns */
    murk_box box;                   /* box */
    murk_vec3 corner, edge1, edge2; /* rect */
    murk_vec3 center;               /* sphere */
    double radius_m;
    murk_affine to_world; /* meshes: applied after the conversion of unit and up
                             axis; spheres: a similarity only */
    int material; /* index; -1: by the names in the mesh file, `default` (index
                   * 0) for names that the scene does not define and for shapes
                   * other than meshes */
    const char *where;
} murk_surface_desc;

typedef struct murk_surfaces murk_surfaces;

/* Builds the surfaces. materials[0] is `default`; n_materials >= 1; n_surfaces
 * may be 0. Geometry outside of the domain is built, too; no ray gets there.
 * The caller owns *out and releases it with murk_surfaces_destroy() (NULL is
 * fine). Fails with MURK_BAD_VALUE for a wrong description or too many
 * materials, with MURK_NO_MEMORY, or with MURK_RUN_FAILED or MURK_UNSUPPORTED
 * if Embree cannot prepare the rays. */
murk_status murk_surfaces_create(murk_surfaces **out,
                                 const murk_surface_desc *surfaces,
                                 size_t n_surfaces,
                                 const murk_material *materials,
                                 size_t n_materials, murk_error *err);

/* The same for geometry that moves within a box: what rounding needs, and so
 * every bit of a hit, is as if the geometry reached up to this box, wherever it
 * is now. */
murk_status murk_surfaces_create_within(
    murk_surfaces **out, const murk_surface_desc *surfaces, size_t n_surfaces,
    const murk_material *materials, size_t n_materials, const murk_box *within,
    murk_error *err);
void murk_surfaces_destroy(murk_surfaces *surfaces);

const murk_material *murk_surfaces_material(const murk_surfaces *surfaces,
                                            size_t material);
size_t murk_surfaces_materials(
    const murk_surfaces *surfaces); /* the number of materials */

typedef struct murk_hit {
    double distance_m;
    murk_vec3
        normal; /* unit geometric normal, on the side from which the ray came */
    uint32_t triangle; /* number of the triangle, or of the sphere plus the
                        * number of triangles */
    uint8_t material;
    uint16_t solid; /* number of the solid from 1 for the boundary of a solid,
                       else 0 */
} murk_hit;

/* The nearest intersection strictly ahead and within max_m (may be INFINITY). A
 * ray that leaves a surface must start at murk_surfaces_leave(). In a corner of
 * opaque surfaces, within 1e-6 of the largest coordinate, distance_m is
 * shortened by 8e-6 of that coordinate (at most by half), so that the next ray
 * starts on the open side of all of them. False if there is none; *hit is then
 * unchanged. */
bool murk_surfaces_hit(const murk_surfaces *surfaces, murk_vec3 origin,
                       murk_vec3 direction, double max_m, murk_hit *hit);

/* The same for a caller to whom an intersection farther than near_m is as good
 * as none: such an intersection may be left out, which is faster. */
bool murk_surfaces_hit_near(const murk_surfaces *surfaces, murk_vec3 origin,
                            murk_vec3 direction, double max_m, double near_m,
                            murk_hit *hit);

/* A point slightly off the surface at `point`, on the side to which `normal`
 * points, so that rounding cannot make a ray from that point hit the surface
 * again. The distance is 9.5e-7 of the largest coordinate (relative to the
 * middle of a scene that is far from the origin). Surfaces closer to each other
 * than this are not told apart. */
murk_vec3 murk_surfaces_leave(const murk_surfaces *surfaces, murk_vec3 point,
                              murk_vec3 normal);

/* The length [m] of the step of murk_surfaces_leave(). */
double murk_surfaces_leave_step_m(const murk_surfaces *surfaces);

/* The number (from 1) of the innermost solid that encloses a point, or 0. The
 * number tells in which solid a light source is. */
uint16_t murk_surfaces_solid_at(const murk_surfaces *surfaces, murk_vec3 point);

/* True if a surface blocks the segment between two points. Thin transmitting
 * sheets do not block if through_sheets is set. A caller whose point lies on a
 * surface first moves the point off by murk_surfaces_leave(), so that this
 * surface does not block. The function also shortens the segment by
 * murk_surfaces_leave_step_m() at either end, so surfaces nearer to an end
 * along the segment do not block. */
bool murk_surfaces_blocked(const murk_surfaces *surfaces, murk_vec3 from,
                           murk_vec3 to, bool through_sheets);

/* Sets blocked[i] = murk_surfaces_blocked(from[i], to, ...), bit for bit,
 * but faster: the rays share one end. Neighbours in the array should be
 * neighbours in space. */
void murk_surfaces_blocked_many(const murk_surfaces *surfaces,
                                const murk_vec3 *from, size_t n, murk_vec3 to,
                                bool through_sheets, bool *blocked);

/* Product of the transmittances of the thin sheets between two points; 1 if
 * there are none. The material's transmit applies at any angle. Sheets closer
 * to each other than murk_surfaces_leave_step_m() count once; sheets closer
 * than that to one of the two points do not count. */
double murk_surfaces_sheet_transmittance(const murk_surfaces *surfaces,
                                         murk_vec3 from, murk_vec3 to,
                                         int band);

/* True if any surface, sheets included, is closer than radius_m. */
bool murk_surfaces_near(const murk_surfaces *surfaces, murk_vec3 point,
                        double radius_m);

typedef struct murk_surfaces_facts {
    size_t triangles, spheres, degenerate, solids, sheets;
    double area_m2;
    murk_box bounds_m; /* empty if there are no surfaces */
    size_t memory_bytes;
} murk_surfaces_facts;

murk_surfaces_facts murk_surfaces_describe(const murk_surfaces *surfaces);

/* The corners [m] in world coordinates of triangle i, less than
 * murk_surfaces_describe().triangles; and centre and radius of sphere i, less
 * than .spheres. The order is that of geometry/soup.h, by kind of face, not
 * that of the descriptions. */
void murk_surfaces_triangle(const murk_surfaces *surfaces, size_t i,
                            murk_vec3 corner[3]);
void murk_surfaces_sphere(const murk_surfaces *surfaces, size_t i,
                          murk_vec3 *center, double *radius_m);

/* The material of triangle i, or of sphere i - triangles; the numbers are
 * those of murk_hit. */
uint8_t murk_surfaces_material_of(const murk_surfaces *surfaces, size_t i);

/* The material that a name in a mesh file refers to: an exact match, or else
 * one that ignores case, or case and blanks. If the scene has no such name,
 * *is_named is false and the result is 0, `default`. */
size_t murk_surfaces_material_named(const murk_surfaces *surfaces,
                                    const char *name, bool *is_named);

/* Area [m2] of all surfaces of one material. */
double murk_surfaces_material_area(const murk_surfaces *surfaces,
                                   size_t material);

#endif
