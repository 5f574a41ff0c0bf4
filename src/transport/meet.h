/* What becomes of a photon where its leg ends: at a surface, at the boundary of
 * a region, at a side of the domain. Each flies it there, tells the event, and
 * leaves it where it goes on. Private to this room. */
#ifndef MURK_TRANSPORT_MEET_H
#define MURK_TRANSPORT_MEET_H

#include "path/path.h"
#include "transport/walker.h"

/* Is reflected at the boundary or goes on beyond it. One that does not change
 * the index is no event. False when the photon ends there, *ended telling how:
 * given up among waves (transport/facets.h). */
bool murk_meet_boundary(murk_walker *w, const murk_path_boundary *ahead,
                        murk_fate *ended);

/* path_m is the leg's; `crossed` are regions whose boundary lies in this
 * surface. False when the photon ends there, *ended telling how. */
bool murk_meet_surface(murk_walker *w, const murk_hit *hit, double path_m,
                       murk_inside crossed, murk_fate *ended);

/* Beyond a surface in which the boundary of a mesh lies. A solid has taken it
 * into account; after a sheet it is met in its turn, where the photon is now.
 * Then the photon goes on as far as it takes to leave the mesh behind.
 * Otherwise as murk_meet_boundary(). */
bool murk_meet_mesh_beyond(murk_walker *w, const murk_hit *hit,
                           murk_path_boundary *ahead, murk_fate *ended);

/* False when the photon has left the world, *ended telling how. */
bool murk_meet_side(murk_walker *w, double path_m, murk_fate *ended);

/* Enters at w->path.position, through a side of the domain. */
void murk_walker_enter(murk_walker *w);

#endif
