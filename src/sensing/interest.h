/* Regions of interest: factors on the weight of photons.
 *
 * A region is the inside of a box, a sphere or a closed mesh, or all space. It
 * may be limited to the surface photons on one material or to the volume
 * photons in one medium. Regions may overlap: their weights are factors that
 * multiply, so weight 0 leaves out a photon whatever other regions contain it.
 * Photons in no region have the factor `elsewhere`.
 *
 * Shapes include their boundary. For surface photons they are wider by the
 * distance by which storage may have moved a photon. So the photons of a wall
 * are in a box that ends at the wall, and those of a crate are in the crate's
 * own mesh. */
#ifndef MURK_SENSING_INTEREST_H
#define MURK_SENSING_INTEREST_H

#include "base/shape.h"
#include "base/vector.h"
#include "geometry/boundary_meshes.h"
#include "photonmap/map.h"

#include <stddef.h>
#include <stdint.h>

/* One bit of a 64-bit mask for each region. */
#define MURK_INTERESTS_MAX 64

typedef struct murk_interest_region {
    const char *name;
    double weight; /* >= 0, finite */
    murk_region_shape shape;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    int material; /* only surface photons on this material; -1: any */
    int medium;   /* only volume photons in this medium; -1: any */
    const char *where;
} murk_interest_region;

typedef struct murk_interest {
    const murk_interest_region *region; /* [n] */
    size_t n;                           /* 0..MURK_INTERESTS_MAX */
    const murk_boundary_meshes
        *boundary_meshes; /* the meshes of the regions that are meshes: bit i of
                             the mask that murk_boundary_meshes_at() returns
                             stands for region i. NULL: no region is a mesh */
    double elsewhere;     /* >= 0, finite */
} murk_interest;

/* The regions that contain a photon, bit i for region i. slack_m is the
 * distance by which storage may have moved the photon; it is used for surface
 * photons only. */
uint64_t murk_interest_at(const murk_interest *interest,
                          const murk_photon *photon, double slack_m);

/* Sets member[k] to murk_interest_at() of photon k, for all photons of a map:
 * member[murk_photon_map_count(map)]. */
void murk_interest_members(uint64_t *member, const murk_interest *interest,
                           const murk_photon_map *map, double slack_m,
                           unsigned threads);

/* The factor on the power of a photon that these regions contain: the product
 * of their weights, or `elsewhere` if there is none. */
double murk_interest_factor(const murk_interest *interest, uint64_t regions);

#endif
