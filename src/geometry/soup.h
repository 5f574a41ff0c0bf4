/* The triangles and spheres of a scene as they are stored for rays: placed,
 * with materials resolved, sorted by kind of face.
 *
 * Coordinates are relative to an anchor, so that a room far from the origin
 * keeps its millimetres in single precision. */
#ifndef MURK_GEOMETRY_SOUP_H
#define MURK_GEOMETRY_SOUP_H

#include "geometry/placed_shapes.h"
#include "geometry/triangle.h"

/* A triangle as a hit needs it, computed once: its plane, and what is told of
 * the triangle. */
typedef struct murk_plane {
    murk_vec3 point;       /* the first corner */
    murk_vec3 normal;      /* murk_triangle_normal() */
    double inverse_length; /* 1 / the length of the normal */
    uint16_t solid;        /* number of the solid, 0: none */
    uint8_t material;
} murk_plane;

_Static_assert(sizeof(murk_plane) == 64, "a hit reads one cache line");

typedef struct murk_soup {
    murk_vec3 anchor;
    double extent; /* largest magnitude of a stored coordinate [m] */
    murk_box box;  /* relative to the anchor */
    size_t vertices, triangles, spheres;
    float *vertex; /* 3 * vertices, and three more floats because Embree reads
                      16 bytes */
    uint32_t *corner;           /* 3 * triangles, sorted by face */
    murk_plane *plane;          /* triangles */
    murk_stored_sphere *sphere; /* sorted by face */
    size_t first_triangle[MURK_FACES + 1], first_sphere[MURK_FACES + 1];
    size_t solids, degenerate;
} murk_soup;

/* Builds the soup. Fails as murk_placed_shapes_build() does, with
 * MURK_BAD_VALUE if there are too many solids, or with MURK_NO_MEMORY. The
 * caller calls murk_soup_release() in either case. */
murk_status murk_soup_build(murk_soup *soup, const murk_surface_desc *surfaces,
                            size_t n_surfaces, const murk_material *materials,
                            size_t n_materials, murk_error *err);
void murk_soup_release(murk_soup *soup);

static inline murk_triangle murk_soup_triangle(const murk_soup *soup, size_t i)
{
    return murk_triangle_at(soup->vertex, soup->corner + 3 * i);
}

/* The triangle in world coordinates. */
static inline murk_triangle murk_soup_placed_triangle(const murk_soup *soup,
                                                      size_t i)
{
    const murk_triangle t = murk_soup_triangle(soup, i);
    return (murk_triangle){murk_add(t.a, soup->anchor),
                           murk_add(t.b, soup->anchor),
                           murk_add(t.c, soup->anchor)};
}

/* Material, and solid, of triangle i or of sphere i - triangles. */
static inline uint8_t murk_soup_material(const murk_soup *soup, size_t i)
{
    return i < soup->triangles ? soup->plane[i].material
                               : soup->sphere[i - soup->triangles].material;
}

static inline uint16_t murk_soup_solid(const murk_soup *soup, size_t i)
{
    return i < soup->triangles ? soup->plane[i].solid
                               : soup->sphere[i - soup->triangles].solid;
}

size_t murk_soup_bytes(const murk_soup *soup);

#endif
