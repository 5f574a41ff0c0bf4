/* The shortest path between two places over other places, in straight
 * unobstructed steps.
 *
 * The graph connects any two places with an unobstructed straight line between
 * them. The line of a step is tested only if the shortest path may need that
 * step.
 *
 * Source: P. E. Hart, N. J. Nilsson, B. Raphael, IEEE Trans. Syst. Sci. Cybern.
 * 4 (1968) 100, doi:10.1109/TSSC.1968.300136 (A*); B. Cohen, M. Phillips, M.
 * Likhachev, Robotics: Science and Systems X (2014),
 * doi:10.15607/RSS.2014.X.056 (lazy evaluation of steps). */
#ifndef MURK_PLAN_ROUTE_H
#define MURK_PLAN_ROUTE_H

#include "sensing/outlook.h"

/* Finds the path over place[n] from place `from` to place `to`. stop[0 ..
 * *stops) are the numbers of the places on the path, both ends included; the
 * array must hold n. *stops is 0 if there is no path. Places that a straight
 * step can bypass are left out. Memory grows as n^2 in the worst case. */
murk_status murk_route_find(size_t *stop, size_t *stops, double *length_m,
                            murk_outlook *outlook, const murk_vec3 *place,
                            size_t n, size_t from, size_t to, murk_error *err);

#endif
