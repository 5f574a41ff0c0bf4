/* Optical depths along sightlines of a sensor, unrounded: in any media that
 * occupy the regions of the sight's media, and the transmittance of sheets. For
 * callers that need the clarity of photons at other extinctions; a clarity is
 * the product of both rounded to 1/65535. Not for sightlines that bend. */
#ifndef MURK_SENSING_DEPTHS_H
#define MURK_SENSING_DEPTHS_H

#include "sensing/sight.h"

/* For photon[n], indices of a row seen from pose: depth[n][count] in
 * media[count], in the band of the photon, and sheets[n], 0..1 (1 if the sight
 * does not look through sheets). */
void murk_sight_depths(double *depth, double *sheets, const murk_sight *sight,
                       const murk_pose *pose, const uint32_t *photon, size_t n,
                       const murk_media *const *media, size_t count);

#endif
