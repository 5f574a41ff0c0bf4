/* The solids that a photon is in, one inside the other: whose index holds, and
 * whether a boundary is entered or left. Private to this room. */
#ifndef MURK_TRANSPORT_SOLIDS_H
#define MURK_TRANSPORT_SOLIDS_H

#include "geometry/surfaces.h"

#define MURK_SOLIDS_DEEP 8

/* The innermost, whose index holds, comes last. */
typedef struct murk_solids {
    int n;
    uint16_t solid[MURK_SOLIDS_DEEP];
    double ior[MURK_SOLIDS_DEEP];
} murk_solids;

/* Index of refraction where the photon is: 1 outside all. */
double murk_solids_ior(const murk_solids *solids);

/* Steps through the boundary of a solid: out where it was in, else in. False
 * (and nothing changed) when that would be too deep. */
bool murk_solids_cross(murk_solids *solids, uint16_t solid, double ior);

/* Those around a point, found along a ray from it. Where solids overlap, the
 * one left first counts as the innermost. */
murk_solids murk_solids_around(const murk_surfaces *surfaces, murk_vec3 point,
                               murk_vec3 direction);

#endif
