/* Delta tracking through grids (Woodcock tracking): free flights are sampled
 * with a majorant of the extinction that is constant in each brick. A collision
 * is real with the probability extinction / majorant; otherwise it is a null
 * collision and the flight continues. The distribution is exact for any valid
 * majorant; a tight one only saves time.
 *
 * For use inside src/medium only; other folders call murk_media_fly_delta().
 *
 * Sources: Woodcock et al., ANL-7050 (1965) 557; Szirmay-Kalos, Toth and
 * Magdics, Comput. Graph. Forum 30 (2011) 85,
 * doi:10.1111/j.1467-8659.2010.01841.x (majorants on a coarse grid). */
#ifndef MURK_MEDIUM_DELTA_H
#define MURK_MEDIUM_DELTA_H

#include "medium/flight.h"

/* After more null collisions than this a flight continues by marching. A free
 * flight has no memory, so the distribution is unchanged, and majorants far
 * above almost all densities cannot hang a run. */
#define MURK_NULLS_MAX 1000

/* murk_media_prepare_delta() with a given edge of bricks and all majorants
 * times a factor, for tests. A factor above 1 costs time; with a factor below 1
 * a majorant may be less than the extinction, and results are then wrong. */
murk_status murk_delta_prepare(murk_media *media, int32_t edge, double factor,
                               murk_error *err);

/* murk_media_fly_delta() with a stream of random numbers that the caller has
 * set up and may inspect afterwards; without a stream (NULL) the flight
 * marches. */
bool murk_delta_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_flight_randoms *stream,
                    murk_collision *collision);

/* Crosses an interval [*from, to] with n >= 1 grids and a further constant
 * extinction even_per_m. Returns true at a real collision: then
 * flight->collision_m and density[n] are set, and flight->u is a fresh uniform
 * number. Returns false either at the end of the interval (*from = to), or if
 * the flight must continue by marching at *from: then flight->stream is NULL,
 * and flight->depth and flight->limit are set for the march. */
bool murk_delta_cross(murk_flight *flight, double *from, double to,
                      const murk_place *const *grids, size_t n,
                      double even_per_m, double *density);

#endif
