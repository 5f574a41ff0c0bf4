/* Regions of interest: what more or less depends on in a plan than its power.
 *
 * A region is what lies in a box, a sphere or a closed mesh, on a material or
 * in a medium, or several of these at once. Regions may overlap: weights are
 * factors and multiply, so that 0 leaves out whatever else a photon lies in.
 * What lies in none has the factor `elsewhere`.
 *
 * Shapes are closed: what lies on their boundary is in, and for surface photons
 * so is what storing may have moved off it. So the photons of a wall are in a
 * box that ends at the wall, and those of a crate in the crate's own mesh. */
#ifndef MURK_SENSING_INTEREST_H
#define MURK_SENSING_INTEREST_H

#include "base/shape.h"
#include "base/vector.h"
#include "geometry/boundary_meshes.h"
#include "photonmap/map.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_INTERESTS_MAX 64

typedef struct murk_interest_region {
    const char *name;
    double weight; /* 0 or more, finite */
    murk_region_shape shape;
    murk_box box;
    murk_vec3 center;
    double radius_m;
    int material; /* surface photons on it alone; -1: any */
    int medium;   /* volume photons in it alone; -1: any */
    const char *where;
} murk_interest_region;

typedef struct murk_interest {
    const murk_interest_region *region; /* [n] */
    size_t n;                           /* 0..MURK_INTERESTS_MAX */
    const murk_boundary_meshes
        *boundary_meshes; /* of those that are meshes, or NULL */
    double elsewhere;     /* 0 or more, finite */
} murk_interest;

/* The regions that a photon lies in, bit i for region i. slack_m: how far
 * storing may have moved it. */
uint64_t murk_interest_at(const murk_interest *interest,
                          const murk_photon *photon, double slack_m);

/* The same of all photons of a map: member[murk_photon_map_count(map)]. */
void murk_interest_members(uint64_t *member, const murk_interest *interest,
                           const murk_photon_map *map, double slack_m,
                           unsigned threads);

/* What a photon's power counts times, by the regions it lies in. */
double murk_interest_factor(const murk_interest *interest, uint64_t regions);

#endif
