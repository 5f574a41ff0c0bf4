/* Surfaces on the rays of photons side by side (transport/lanes.h). A lane asks
 * for the first event on its ray once. Diffuse reflection and absorption are
 * treated here, so that the new directions of all lanes are computed at once;
 * all other events are handed to the walker, together with the surface that was
 * found. For use inside src/transport only. */
#ifndef MURK_TRANSPORT_LANES_SURFACES_H
#define MURK_TRANSPORT_LANES_SURFACES_H

#include "transport/lanes_step.h"
#include "transport/walker.h"

typedef enum murk_lane_next {
    MURK_LANE_UNKNOWN,  /* the walker finds the event */
    MURK_LANE_COLLIDES, /* the flight may end in a medium, as the lanes say */
    MURK_LANE_MEETS,    /* the walker meets the event `ahead` */
    MURK_LANE_REFLECTS  /* the surface `ahead` reflects diffusely or absorbs */
} murk_lane_next;

/* The next event of a lane. */
typedef struct murk_lane_ahead {
    murk_lane_next next;
    murk_path_event ahead;
    int64_t before; /* quanta before the surface */
} murk_lane_ahead;

/* Finds the next event of lane i, whose free flight is known. If the flight
 * does not end in a medium, the lane no longer meets one. `extinction_per_m` is
 * that of the medium at the end of the flight. */
void murk_lane_find(murk_lane_ahead *a, murk_walker *w, murk_photon_lanes *l,
                    size_t i, double extinction_per_m);

/* For a lane with MURK_LANE_REFLECTS: splits the packet, moves the lane clear
 * of the surface and puts the normal in place of the direction, which the next
 * step turns; an absorbed photon does not scatter. The walker stays in the
 * surface. */
void murk_lane_reflect(murk_lane_ahead *a, murk_walker *w, murk_photon_lanes *l,
                       size_t i);

/* Scores and reports the reflection or absorption, after the direction has been
 * turned. `from` is the start of the segment. */
void murk_lane_reflected(const murk_lane_ahead *a, murk_walker *w,
                         const murk_photon_lanes *l, size_t i, murk_vec3 from);

/* Meets the event of a lane with MURK_LANE_MEETS. The walker is up to date. */
murk_fate murk_lane_meet(const murk_lane_ahead *a, murk_walker *w);

#endif
