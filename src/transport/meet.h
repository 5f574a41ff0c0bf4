/* The end of a segment at a surface, at the boundary of a region, or at a side
 * of the domain. murk_meet_boundary(), murk_meet_surface() and murk_meet_side()
 * move the photon there, score the segment, report the event and prepare the
 * next segment. The result is MURK_FATE_NONE if the photon continues. A photon
 * that cannot be followed further is reported as lost instead. For use inside
 * src/transport only. */
#ifndef MURK_TRANSPORT_MEET_H
#define MURK_TRANSPORT_MEET_H

#include "transport/bounce.h"
#include "transport/walker.h"

/* Reflects the photon at the boundary or refracts it. A boundary at which the
 * index does not change is passed without an event. A photon that is given up
 * among waves (transport/facets.h) is lost. */
murk_fate murk_meet_boundary(murk_walker *w, const murk_path_boundary *ahead);

/* Absorbs, reflects or transmits the photon at the surface that it hits.
 * path_m: length of the segment; `crossed`: the set of regions with a boundary
 * that lies in this surface. */
murk_fate murk_meet_surface(murk_walker *w, const murk_hit *hit, double path_m,
                            murk_inside crossed);

/* Reports the event at a surface, at the walker's position. `before`: quanta of
 * the packet that arrives; path_m as above. */
static inline void murk_meet_tell_surface(murk_walker *w, const murk_hit *hit,
                                          double path_m, int64_t before,
                                          const murk_bounce *bounce)
{
    const murk_material *material =
        murk_surfaces_material(w->setup->world->surfaces, hit->material);
    murk_event event;
    murk_walker_event(&event, w, MURK_EVENT_SURFACE);
    event.outcome = bounce->outcome;
    event.material_or_medium = hit->material;
    event.direction_out = bounce->direction;
    event.normal = hit->normal;
    event.weight = murk_packet_share(before);
    event.leaving =
        bounce->outcome == MURK_ABSORBED ? 0 : murk_packet_share(w->quanta);
    event.reflectance = material->diffuse.band[w->band];
    event.path_m = path_m;
    murk_walker_tell(w, &event);
}

/* Called after murk_meet_surface() if the surface transmitted the photon and a
 * face of a boundary mesh lies in the surface. If the surface bounds a solid,
 * murk_meet_surface() has already taken the photon through the face. If the
 * surface is a thin sheet, the photon now meets the face, at the present
 * position. In both cases the next search for boundaries skips the first part
 * of the ray, so that the photon does not meet the same face again. */
murk_fate murk_meet_mesh_beyond(murk_walker *w, const murk_hit *hit,
                                murk_path_boundary *ahead);

/* The photon escapes, enters a periodic domain through the opposite side, or is
 * lost after too many wraps. */
murk_fate murk_meet_side(murk_walker *w, double path_m);

#endif
