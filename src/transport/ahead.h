/* The boundary of a region that a photon meets next: of a half space, box or
 * sphere (medium/interfaces.h), of a mesh (geometry/boundary_meshes.h), or of
 * several at once. Private to this room.
 *
 * Boundaries of meshes are known in single precision only. So what lies within
 * their tolerance is met together, a mesh's face in a side of the domain is no
 * boundary, and on its next leg a photon does not look for the mesh it has
 * just passed: `skip_m` keeps that count. */
#ifndef MURK_TRANSPORT_AHEAD_H
#define MURK_TRANSPORT_AHEAD_H

#include "medium/interfaces.h"
#include "transport/trace.h"

typedef struct murk_ahead {
    murk_boundary boundary;
    bool is_mesh; /* one of those crossed is */
} murk_ahead;

/* The nearest, as murk_media_boundary(). What the photon is believed to be
 * inside of is put right by the meshes ahead. These are looked for between
 * skip_m and most_m along the ray. */
bool murk_look_ahead(const murk_transport_world *world, murk_inside *inside,
                     murk_vec3 origin, murk_vec3 direction, double skip_m,
                     double max_m, murk_ahead *ahead);

/* The regions that light is in which sets out from a point along `direction`:
 * on a boundary, those that lie ahead. */
murk_inside murk_inside_at(const murk_transport_world *world, murk_vec3 point,
                           murk_vec3 direction);

/* The set of a ray that goes on at `point` of the opposite side of a periodic
 * domain: as murk_media_wrapped(). */
murk_inside murk_inside_wrapped(const murk_transport_world *world,
                                murk_inside inside, murk_vec3 point, int axis);

#endif
