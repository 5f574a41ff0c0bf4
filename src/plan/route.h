/* The shortest way between two places over others, in straight open steps.
 *
 * The graph joins any two places that a straight way is open between; a step is
 * tried only when the shortest way may need it.
 *
 * Source: Hart, Nilsson, Raphael, IEEE Trans. Syst. Sci. Cybern. 4 (1968) 100,
 * doi:10.1109/TSSC.1968.300136 (A*); Cohen, Phillips, Likhachev, Robotics:
 * Science and Systems X (2014), doi:10.15607/RSS.2014.X.056 (steps tried
 * late). */
#ifndef MURK_PLAN_ROUTE_H
#define MURK_PLAN_ROUTE_H

#include "sensing/outlook.h"

/* stop[0 .. *stops): from, what is passed, to; room for n. *stops is 0 where
 * there is no way. Places whose step may be left out are. Memory follows n^2
 * at worst. */
murk_status murk_route_find(size_t *stop, size_t *stops, double *length_m,
                            murk_outlook *outlook, const murk_vec3 *place,
                            size_t n, size_t from, size_t to, murk_error *err);

#endif
