/* Events at boundaries of regions, at surfaces and at sides of the domain
 * (transport/meet.h). Two kinds of places can have a change of refractive
 * index: boundaries, and surfaces of solids with an index. There the index on
 * each side is that of the innermost solid on that side or, outside of all
 * solids, that of the regions on that side (murk_walker_index()). */
#include "transport/meet.h"

#include "medium/interfaces.h"
#include "transport/facets.h"
#include "transport/turn.h"

/* After reflection at a mesh, the photon lies on the mesh to double precision.
 * This share of near_m (path/path.h) is skipped, so that the photon does not
 * meet the same face again. */
#define REFLECTED_SKIP 0x1p-20

/* Updates the event class as after a specular event, and sets the number of
 * wraps without an event to 0. */
static void note_specular(murk_walker *w)
{
    if (w->event_class == MURK_CLASS_FIRST) {
        w->event_class = MURK_CLASS_SPECULAR;
    }
    w->wraps = 0;
}

/* Draws the outcome at a boundary. False if the photon is given up among
 * waves. */
static bool bounce_at(const murk_walker *w, const murk_boundary *b,
                      double n_from, double n_to, murk_bounce *bounce)
{
    if (b->mean_square_slope > 0) {
        const murk_address address = murk_walker_address(w, MURK_SURFACE);
        return murk_meet_facets(&address, n_from, n_to, b->mean_square_slope,
                                w->path.direction, b->normal, bounce);
    }
    *bounce = murk_refract(n_from, n_to, w->path.direction, b->normal,
                           murk_walker_draw(w, MURK_SURFACE).u[3]);
    return true;
}

murk_fate murk_meet_boundary(murk_walker *w, const murk_path_boundary *ahead)
{
    const murk_boundary *b = &ahead->met;
    const murk_vec3 arriving = w->path.direction;
    /* Move to the boundary. */
    const double lead =
        murk_dot(murk_sub(w->probe, w->path.position), arriving);
    const murk_vec3 from = w->path.position;
    w->path.position = murk_path_sides_hold(
        &w->setup->space.sides, murk_along(from, b->distance_m, arriving));
    murk_walker_score(w, from, b->distance_m, w->quanta, w->path.position,
                      w->setup->in_plane_m);
    if (!(lead > b->distance_m)) {
        w->probe = w->path.position;
    }
    /* The index on either side; equal indices bend nothing. */
    const murk_inside beyond = w->path.inside ^ b->crossed;
    w->path.skip_m = ahead->has_mesh ? w->setup->space.near_m : 0;
    const double n_from = murk_walker_index(w, &w->solids, w->path.inside);
    const double n_to = murk_walker_index(w, &w->solids, beyond);
    if (n_from == n_to) {
        w->path.inside = beyond;
        w->silent_m += b->distance_m;
        return MURK_FATE_NONE;
    }
    /* Reflect or refract. */
    murk_bounce bent;
    if (!bounce_at(w, b, n_from, n_to, &bent)) {
        return murk_walker_lose(w, MURK_LOSS_EVENTS);
    }
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_INTERFACE);
        event.outcome = bent.outcome;
        event.material_or_medium = (uint8_t)b->region;
        event.direction_out = bent.direction;
        event.normal = b->normal;
        event.path_m = b->distance_m;
        murk_walker_tell(w, &event);
    }
    /* Continue on the side to which the photon leaves. */
    w->path.direction = bent.direction;
    if (bent.outcome == MURK_TRANSMITTED) {
        w->path.inside = beyond;
    } else if (ahead->has_mesh) {
        w->path.skip_m = REFLECTED_SKIP * w->setup->space.near_m;
    }
    note_specular(w);
    return MURK_FATE_NONE;
}

murk_fate murk_meet_surface(murk_walker *w, const murk_hit *hit, double path_m,
                            murk_inside crossed)
{
    const murk_surfaces *surfaces = w->setup->world->surfaces;
    const murk_material *material =
        murk_surfaces_material(surfaces, hit->material);
    murk_path_solids beyond = w->solids;
    murk_inside inside = w->path.inside;
    double n_from = 0, n_to = 0;
    /* At the boundary of a solid: the index on either side. */
    if (hit->solid && material->ior > 0) {
        if (!murk_path_solids_cross(&beyond, hit->solid, material->ior)) {
            /* The solids around the photon are unknown here, and so is the
             * medium of the segment: the ledger counts all quanta as lost, and
             * tallies do not score the segment. */
            return murk_walker_lose(w, MURK_LOSS_NUMERICAL);
        }
        inside ^= crossed;
        n_from = murk_walker_index(w, &w->solids, w->path.inside);
        n_to = murk_walker_index(w, &beyond, inside);
    }
    /* Move to the surface. */
    const murk_vec3 place =
        murk_along(w->probe, hit->distance_m, w->path.direction);
    murk_walker_score(w, w->path.position, path_m, w->quanta, place,
                      w->setup->in_plane_m);
    w->path.position = place;
    w->absorber = hit->material;
    /* Split the packet, or leave the absorbed share to the roulette of the
     * surface. */
    murk_random4 random = murk_walker_draw(w, MURK_SURFACE);
    const int64_t before = w->quanta;
    const double survival = material->diffuse.band[w->band] +
                            material->specular.band[w->band] +
                            material->transmit.band[w->band];
    if (survival < 1 && murk_walker_splits(w, survival, random.u[2],
                                           MURK_FATE_SURFACES, w->absorber)) {
        random.u[0] = w->quanta > 0 ? random.u[0] * survival : 1;
    }
    /* Draw the outcome, and report the event. */
    const murk_bounce b =
        murk_surface_bounce(material, w->band, n_from, n_to, w->path.direction,
                            hit->normal, random.u);
    if (murk_walker_is_heard(w)) {
        murk_meet_tell_surface(w, hit, path_m, before, &b);
    }
    if (b.outcome == MURK_ABSORBED) {
        return MURK_FATE_SURFACES;
    }
    /* Continue from a position clear of the surface. */
    const bool through = b.outcome == MURK_TRANSMITTED;
    w->is_beyond = through;
    if (through) {
        w->solids = beyond;
        w->path.inside = inside;
    }
    w->path.direction = b.direction;
    w->path.position = w->probe = murk_surfaces_leave(
        surfaces, w->path.position,
        through ? murk_scale(-1, hit->normal) : hit->normal);
    note_specular(w);
    if (b.outcome == MURK_DIFFUSE) {
        w->event_class = MURK_CLASS_LATER;
    }
    return MURK_FATE_NONE;
}

murk_fate murk_meet_mesh_beyond(murk_walker *w, const murk_hit *hit,
                                murk_path_boundary *ahead)
{
    murk_fate fate = MURK_FATE_NONE;
    if (!hit->solid) {
        ++w->number;
        ahead->met.distance_m = 0;
        fate = murk_meet_boundary(w, ahead);
    }
    w->path.skip_m =
        w->setup->space.near_m / fabs(murk_dot(w->path.direction, hit->normal));
    return fate;
}

/* Starts the search for surfaces a little before the position, because a
 * surface may lie in the side of the domain through which the photon enters.
 * Finds the solids that contain the start of the search. */
static void enter(murk_walker *w)
{
    w->probe = murk_along(w->path.position, -w->setup->space.margin_m,
                          w->path.direction);
    if (w->setup->space.any_solids) {
        w->solids = murk_path_solids_around(w->setup->world->surfaces, w->probe,
                                            w->path.direction);
    }
}

/* A position slightly outside of the side, so that plane tallies in the side
 * count the photon. */
static murk_vec3 beyond_side(const murk_walker *w, int axis, bool upper)
{
    const double step =
        upper ? w->setup->space.margin_m : -w->setup->space.margin_m;
    murk_vec3 place = w->path.position;
    murk_component_set(&place, axis, murk_component(place, axis) + step);
    return place;
}

murk_fate murk_meet_side(murk_walker *w, double path_m)
{
    const murk_path_sides *sides = &w->setup->space.sides;
    const murk_vec3 d = w->path.direction;
    const int axis = murk_path_sides_axis(sides, w->path.position, d);
    const bool upper = murk_component(d, axis) > 0;
    const bool wraps = w->setup->world->domain.is_periodic && axis != 2;
    /* Move to the side. */
    const murk_vec3 from = w->path.position;
    w->path.position = murk_path_sides_hold(sides, murk_along(from, path_m, d));
    murk_path_sides_put(sides, axis, upper, &w->path.position);
    murk_walker_score(w, from, path_m, w->quanta, beyond_side(w, axis, upper),
                      0);
    /* A photon wraps a limited number of times. */
    if (wraps && w->wraps >= w->setup->trace->wraps_max) {
        return murk_walker_lose(w, MURK_LOSS_WRAPS);
    }
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w,
                          wraps ? MURK_EVENT_WRAPPED : MURK_EVENT_ESCAPED);
        event.direction_out = d;
        event.path_m = path_m;
        murk_walker_tell(w, &event);
    }
    /* Escape, or enter through the opposite side. */
    if (!wraps) {
        return MURK_FATE_ESCAPED;
    }
    ++w->wraps;
    murk_path_sides_put(sides, axis, !upper, &w->path.position);
    if (w->score) {
        murk_score_jump(w->score,
                        (murk_station){beyond_side(w, axis, !upper), 0});
    }
    if (w->setup->space.any_boundaries) {
        w->path.inside = murk_path_inside_wrapped(
            &w->setup->space, w->path.inside, w->path.position, axis);
    }
    enter(w);
    return MURK_FATE_NONE;
}
