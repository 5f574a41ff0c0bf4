/* The triangles and spheres of a world before rays: placed, named materials
 * resolved, sorted into three classes.
 *
 * Coordinates are kept relative to an anchor, so that a room far from the
 * origin keeps its millimetres in float. */
#ifndef MURK_GEOMETRY_SOUP_H
#define MURK_GEOMETRY_SOUP_H

#include "base/status.h"
#include "geometry/surfaces.h"
#include "geometry/triangle.h"

/* What a face is to a ray. The order is that of storage. */
typedef enum murk_face {
    MURK_FACE_OPAQUE, /* nothing goes through */
    MURK_FACE_SOLID,  /* boundary of a solid: bends */
    MURK_FACE_SHEET,  /* transmits in some band, does not bend */
    MURK_FACES
} murk_face;

typedef struct murk_ball {
    murk_vec3 center; /* relative to the anchor */
    double radius;
    uint8_t material;
    uint16_t solid;
    murk_face face;
} murk_ball;

typedef struct murk_soup {
    murk_vec3 anchor;
    double extent; /* largest magnitude of a stored coordinate [m] */
    murk_box box;  /* relative to the anchor */
    size_t vertices, triangles, balls;
    float *vertex;     /* 3 * vertices, and one more that Embree may touch */
    uint32_t *corner;  /* 3 * triangles, sorted by face */
    uint8_t *material; /* triangles */
    uint16_t *solid;   /* triangles; 0: none */
    murk_ball *ball;   /* sorted by face */
    size_t first_triangle[MURK_FACES + 1], first_ball[MURK_FACES + 1];
    size_t solids, degenerate;
} murk_soup;

/* Fails with MURK_BAD_VALUE at the surface's `where`, or MURK_NO_MEMORY. In
 * either case murk_soup_release() afterwards. */
murk_status murk_soup_build(murk_soup *soup, const murk_surface_desc *surfaces,
                            size_t n_surfaces, const murk_material *materials,
                            size_t n_materials, murk_error *err);
void murk_soup_release(murk_soup *soup);

static inline murk_triangle murk_soup_triangle(const murk_soup *soup, size_t i)
{
    return murk_triangle_at(soup->vertex, soup->corner + 3 * i);
}

size_t murk_soup_bytes(const murk_soup *soup);

#endif
