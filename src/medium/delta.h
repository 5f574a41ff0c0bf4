/* Delta tracking through grids: the flight is thrown against bounds of the
 * extinction that are even brick by brick, and a collision found so is real
 * with the probability that extinction and bound have to each other; else the
 * flight goes on. Unbiased for any bound that holds; only a bound's tightness
 * costs time.
 *
 * Inside this room only; the way in is murk_media_fly_delta().
 *
 * Source: Woodcock et al., ANL-7050 (1965) 557; Szirmay-Kalos, Toth and
 * Magdics, Comput. Graph. Forum 30 (2011) 85,
 * doi:10.1111/j.1467-8659.2010.01841.x (bounds on a coarse grid). */
#ifndef MURK_MEDIUM_DELTA_H
#define MURK_MEDIUM_DELTA_H

#include "medium/flight.h"

/* A flight with more null collisions than this marches on from where it is. It
 * has no memory, so that changes nothing in distribution; and bounds far above
 * nearly all of what they bound cannot hang a run. */
#define MURK_NULLS_MAX 1000

/* As murk_media_prepare_delta(), with bricks of that edge and all bounds times
 * a factor, for tests: above 1 costs time, below 1 is wrong. */
murk_status murk_delta_prepare(murk_media *media, int32_t edge, double factor,
                               murk_error *err);

/* murk_media_fly_delta() with dice that the caller has set out and may look at
 * afterwards. */
bool murk_delta_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_dice *dice,
                    murk_collision *collision);

/* Crosses a piece [*from, to] in which n >= 1 grids lie and even_per_m more is
 * spread evenly. True when the flight stops: then stop_m and density[n] are
 * set, and u is fresh. False when it is across, *from then being `to`, or when
 * it must march on at *from: then dice is NULL and depth and limit are made
 * for that. */
bool murk_delta_cross(murk_flight *flight, double *from, double to,
                      const murk_place *const *grids, size_t n,
                      double even_per_m, double *density);

#endif
