/* The straight way from a sensor to a photon through regions: what the media
 * let through, and whether the index of refraction changes on it. Internal to
 * the room. */
#ifndef MURK_SENSING_PASSAGE_H
#define MURK_SENSING_PASSAGE_H

#include "geometry/hulls.h"
#include "medium/media.h"

typedef struct murk_passages {
    const murk_media *media;
    const murk_hulls *hulls; /* NULL: no region is a mesh */
    const murk_domain *domain;
    murk_vec3 sensor;
    murk_inside around; /* the meshes that the sensor is in */
} murk_passages;

/* All borrowed. */
murk_passages murk_passages_from(const murk_media *media,
                                 const murk_hulls *hulls,
                                 const murk_domain *domain, murk_vec3 sensor);

/* exp(-optical depth) to a photon's place, by the nearest image. */
double murk_passage_transmittance(const murk_passages *passages, int band,
                                  murk_vec3 photon);

/* Whether the index changes on the way: light bends there, so what is seen
 * beyond is elsewhere. A mesh within its tolerance of the photon does not
 * count: the floor of a tank lies in the water's face. */
bool murk_passage_bends(const murk_passages *passages, murk_vec3 photon);

#endif
