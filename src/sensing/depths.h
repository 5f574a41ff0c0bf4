/* What a seen sightline passes, unrounded: optical depths in any media that lie
 * where the sight's do, and what sheets let through. For whoever must know how
 * clear a photon is at other extinctions; a look's clarity is their product
 * rounded to 1/65535. Not for sightlines that bend. */
#ifndef MURK_SENSING_DEPTHS_H
#define MURK_SENSING_DEPTHS_H

#include "sensing/sight.h"

/* photon[n], numbers as a look has them, seen from pose: depth[n][count] in
 * media[count], each in the photon's band, and sheets[n], 0..1 (1 where the
 * sight does not look through them). */
void murk_sight_depths(double *depth, double *sheets, const murk_sight *sight,
                       const murk_pose *pose, const uint32_t *photon, size_t n,
                       const murk_media *const *media, size_t count);

#endif
