/* The shapes of a scene in world coordinates, in double precision and in the
 * order of their descriptions. An intermediate result: geometry/soup.h
 * stores them for ray queries. */
#ifndef MURK_GEOMETRY_PLACED_SHAPES_H
#define MURK_GEOMETRY_PLACED_SHAPES_H

#include "base/status.h"
#include "geometry/surfaces.h"

/* How a ray interacts with a face. A murk_soup stores triangles and spheres in
 * this order. */
typedef enum murk_face {
    MURK_FACE_OPAQUE, /* no light passes */
    MURK_FACE_SOLID,  /* boundary of a solid: refracts */
    MURK_FACE_SHEET,  /* thin sheet: transmits in some band, does not refract */
    MURK_FACES
} murk_face;

typedef struct murk_stored_sphere {
    murk_vec3 center; /* in world coordinates in murk_placed_shapes, relative to
                       * the anchor in murk_soup */
    double radius;
    uint8_t material;
    uint16_t solid;
    murk_face face;
} murk_stored_sphere;

typedef struct murk_placed_triangle {
    uint32_t corner[3];
    uint32_t item; /* index of the description that the triangle comes from */
    uint16_t solid;
    uint8_t material, face;
} murk_placed_triangle;

typedef struct murk_placed_shapes {
    murk_vec3 *vertex;
    murk_placed_triangle *triangle;
    murk_stored_sphere *sphere;
    size_t vertices, triangles, spheres, degenerate;
} murk_placed_shapes;

static inline const char *murk_place_of(const murk_surface_desc *d)
{
    return d->where ? d->where : "geometry";
}

/* Index of the material with the name that a mesh file uses: an exact match,
 * else a match that ignores case, else one that also ignores blanks
 * (importers strip some of them). Without a match the result is 0, the
 * material `default`, and *is_named is false. */
size_t murk_material_named(const char *name, const murk_material *materials,
                           size_t n, bool *is_named);

/* Places all shapes. Fails with MURK_BAD_VALUE at the `where` of a shape that
 * has no extent or no mesh, is out of range or, for a sphere, is not placed by
 * a similarity; with MURK_BAD_VALUE if there are more vertices or triangles
 * than an index of 32 bits can name; or with MURK_NO_MEMORY. The caller calls
 * murk_placed_shapes_release() in either case. The members solid and face are
 * set to 0. */
murk_status murk_placed_shapes_build(murk_placed_shapes *out,
                                     const murk_surface_desc *surfaces,
                                     size_t n_surfaces,
                                     const murk_material *materials,
                                     size_t n_materials, murk_error *err);
void murk_placed_shapes_release(murk_placed_shapes *gathering);

#endif
