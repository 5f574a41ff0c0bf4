/* The straight way from a sensor to a photon through regions: what the media
 * let through, and whether the index of refraction changes on it. */
#ifndef MURK_SENSING_PASSAGE_H
#define MURK_SENSING_PASSAGE_H

#include "geometry/boundary_meshes.h"
#include "medium/media.h"
#include "sensing/segment.h"

typedef struct murk_passages {
    const murk_media *media;
    const murk_boundary_meshes *boundary_meshes; /* NULL: no region is a mesh */
    const murk_domain *domain;
    murk_vec3 sensor;
    murk_inside around; /* the meshes that the sensor is in */
    double index;       /* of refraction, where the sensor is */
} murk_passages;

/* All borrowed. */
murk_passages murk_passages_from(const murk_media *media,
                                 const murk_boundary_meshes *boundary_meshes,
                                 const murk_domain *domain, murk_vec3 sensor);

/* The index of refraction at a place. */
double murk_passage_index(const murk_passages *passages, murk_vec3 place);

/* A straight piece of a way. */
typedef struct murk_leg {
    murk_vec3 from, direction; /* unit */
    double length_m;
    double look_from_m; /* a mesh's face before this is no boundary: where a
                           leg begins in one, or in a side of the domain */
    murk_inside inside; /* the regions with a boundary that it begins in */
} murk_leg;

/* Where the index of refraction changes. */
typedef struct murk_index_change {
    double distance_m;
    murk_vec3 normal; /* unit, faces where the leg came from */
    bool is_mesh;     /* of a mesh alone */
    double before, beyond;
    murk_inside inside; /* beyond */
} murk_index_change;

/* The first change on a leg within the domain. Meshes within their tolerance of
 * its end do not count. Follows boundaries of both kinds, each as the set says;
 * those of meshes and others within the tolerance are passed at once. */
bool murk_passage_change(const murk_passages *passages, const murk_leg *leg,
                         murk_index_change *change);

/* The pieces of the straight way from the sensor to the nearest image of a
 * point, in their order, each in the domain. Returns how many. */
int murk_passage_legs(const murk_passages *passages, murk_vec3 point,
                      murk_leg leg[MURK_SEGMENT_PIECES]);

/* Optical depth, and exp(-optical depth), to a photon's place, by the nearest
 * image. */
double murk_passage_depth(const murk_passages *passages, int band,
                          murk_vec3 photon);
double murk_passage_transmittance(const murk_passages *passages, int band,
                                  murk_vec3 photon);

/* Whether the index changes on the way: light bends there, so what is seen
 * beyond is elsewhere. A mesh within its tolerance of the photon does not
 * count: the floor of a tank lies in the water's face. */
bool murk_passage_bends(const murk_passages *passages, murk_vec3 photon);

#endif
