/* The shapes of a world, placed, in double, in the order described. */
#ifndef MURK_GEOMETRY_GATHER_H
#define MURK_GEOMETRY_GATHER_H

#include "geometry/soup.h"

typedef struct murk_gathering {
    murk_vec3 *vertex;
    uint32_t *corner, *item; /* item: index of the description */
    uint8_t *material;
    uint16_t *solid;
    uint8_t *face;
    size_t vertices, triangles, balls, degenerate;
    murk_ball *ball;
} murk_gathering;

static inline const char *murk_place_of(const murk_surface_desc *d)
{
    return d->where ? d->where : "geometry";
}

/* The material that has a mesh's name: exactly, else whatever the case of
 * letters, else also whatever the blanks (importers strip some of them); else
 * index 0, `default`, and *is_named is false. */
size_t murk_material_named(const char *name, const murk_material *materials,
                           size_t n, bool *is_named);

/* Fails as murk_soup_build(). In either case murk_gathering_release()
 * afterwards. solid and face are zero. */
murk_status murk_gather_triangles(murk_gathering *out,
                                  const murk_surface_desc *surfaces,
                                  size_t n_surfaces,
                                  const murk_material *materials,
                                  size_t n_materials, murk_error *err);
void murk_gathering_release(murk_gathering *gathering);

#endif
