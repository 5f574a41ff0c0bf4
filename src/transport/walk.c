/* One photon at a time, leg by leg: find the nearest surface up to the side of
 * the domain, let the media stop the flight before it, deal with what was met.
 *
 * A surface that lies in a side of the domain is part of the world, though
 * rounding may put it a little outside: surfaces are looked for in a slightly
 * grown box. `probe` is the place that the next surface is looked for from; it
 * differs from `position` where a photon starts: light that enters through a
 * side must not miss a surface lying in it, and a lamp's own ceiling must not
 * stop its light.
 *
 * `inside`, not the position, says on which side of the boundaries of
 * refractive regions and of meshes the photon is; see path/path.h. */
#include "transport/walk.h"

#include "medium/phase.h"
#include "transport/jump.h"
#include "transport/meet.h"
#include "transport/outside.h"
#include "transport/turn.h"

/* A plane nearer than this share of the domain's largest coordinate to a place
 * that was computed in double precision contains the place: some hundred times
 * the rounding. */
#define IN_PLANE_TOLERANCE 1e-13

/* A jump that leads to a boundary ends at this share of the way, and the
 * boundary is met from near. */
#define BEFORE_BOUNDARY 0.999

/* u: two numbers in (0, 1). Given that it scatters, what the roulette leaves of
 * its number is again uniform, and serves as the azimuth: so one collision
 * takes one draw of four. (A split rounds by the number that turns it: its
 * quantum in a billion may go with the azimuth.) False when the photon ends
 * there. */
static bool scatter(murk_walker *w, const murk_collision *c, const double u[2])
{
    /* Split the packet, or put the photon to roulette. */
    const int64_t before = w->quanta;
    w->absorber = w->sums->materials + c->medium;
    const bool is_split =
        murk_walker_splits(w, c->albedo, u[0], MURK_FATE_MEDIA, w->absorber);
    const bool scatters = is_split ? w->quanta > 0 : u[0] < c->albedo;
    const double azimuth = is_split ? u[0] : u[0] / c->albedo;
    const murk_vec3 arriving = w->path.direction;
    const murk_vec3 from = w->path.position;
    /* Move to the collision. */
    ++w->sums->collisions;
    w->path.position = w->probe = murk_path_sides_hold(
        &w->setup->space.sides,
        murk_along(from, c->distance_m, w->path.direction));
    if (w->sums->are_segments_wanted) {
        murk_walker_score(w, from, c->distance_m, before, w->path.position, 0);
    }
    /* Turn, and tell the event. */
    if (scatters) {
        w->path.direction = murk_turned_direction(
            arriving, murk_phase_sample(c->phase, u[1]), azimuth);
    }
    if (murk_walker_is_heard(w)) {
        murk_event event = murk_walker_event(w, MURK_EVENT_MEDIUM);
        event.outcome = scatters ? MURK_SCATTERED : MURK_ABSORBED;
        event.material_or_medium = (uint8_t)c->medium;
        event.direction_in = arriving;
        event.direction_out = scatters ? w->path.direction : murk_vec(0, 0, 0);
        event.weight = murk_packet_share(before);
        event.leaving = scatters ? murk_packet_share(w->quanta) : 0;
        event.reflectance = c->albedo;
        event.path_m = c->distance_m;
        event.scattering_per_m = c->scattering_per_m;
        murk_walker_tell(w, &event);
    }
    w->event_class = MURK_CLASS_LATER;
    w->wraps = 0;
    return scatters;
}

/* Whether a flight of at most length_m ends in a medium; rest: two numbers left
 * over for what happens there. */
static inline bool collides(const murk_walker *w, double length_m,
                            murk_collision *c, double rest[2])
{
    const murk_random4 random = murk_walker_draw(w, MURK_FLIGHT);
    rest[0] = random.u[2];
    rest[1] = random.u[3];
    const murk_media *media = w->setup->world->media;
    const double tau = -log(random.u[0]);
    if (w->setup->trace->by_delta) {
        const murk_address address = murk_walker_address(w, MURK_FLIGHT);
        return murk_media_fly_delta(media, w->band, w->path.inside,
                                    w->path.position, w->path.direction,
                                    length_m, tau, random.u[1], &address, c);
    }
    return murk_media_fly(media, w->band, w->path.inside, w->path.position,
                          w->path.direction, length_m, tau, random.u[1], c);
}

/* How far this leg can lead at most. Meshes are looked for only so far, which
 * in dense media saves more than flying twice costs. */
static inline double as_far_as_media_let(const murk_walker *w)
{
    murk_collision collision;
    double rest[2];
    return w->setup->space.boundary_meshes && w->setup->any_media &&
                   w->solids.n == 0 && collides(w, INFINITY, &collision, rest)
               ? collision.distance_m
               : INFINITY;
}

static murk_fate follow(murk_walker *w)
{
    const murk_walk_setup *r = w->setup;
    const murk_path_space *space = &r->space;
    const bool only_media = r->any_media && !space->any_surfaces;
    const bool media_too = r->any_media && space->any_surfaces;
    for (;;) {
        ++w->number;
        if (w->number > r->trace->events_max) {
            return murk_walker_lose(w, MURK_LOSS_EVENTS);
        }
        murk_collision collision;
        double rest[2];
        murk_path_boundary ahead;
        const bool bends =
            space->any_boundaries &&
            murk_path_next_boundary(&w->path, as_far_as_media_let(w), &ahead);
        const double boundary_m = bends ? ahead.met.distance_m : INFINITY;
        w->path.skip_m = 0;
        double run = r->jumps ? murk_jump_ahead(w) : 0;
        run = bends ? fmin(run, BEFORE_BOUNDARY * boundary_m) : run;
        if (run > 0) {
            const bool met_medium =
                r->any_media && collides(w, run, &collision, rest);
            murk_jump(w, met_medium ? collision.distance_m : run);
            collision.distance_m = 0; /* the flight is behind it */
            if (met_medium && !scatter(w, &collision, rest)) {
                return MURK_FATE_MEDIA;
            }
            continue;
        }
        /* With no surfaces most legs end in a medium: the others alone look
         * for the side. */
        if (only_media && collides(w, boundary_m, &collision, rest) &&
            murk_path_sides_contain(&space->sides,
                                    murk_along(w->path.position,
                                               collision.distance_m,
                                               w->path.direction))) {
            if (!scatter(w, &collision, rest)) {
                return MURK_FATE_MEDIA;
            }
            continue;
        }
        murk_path_event event;
        if (!murk_path_first_event(&w->path, w->probe, bends ? &ahead : NULL,
                                   &event)) {
            return murk_walker_lose(w, MURK_LOSS_NUMERICAL);
        }
        if (media_too && w->solids.n == 0 &&
            collides(w, event.distance_m, &collision, rest)) {
            if (!scatter(w, &collision, rest)) {
                return MURK_FATE_MEDIA;
            }
            continue;
        }
        murk_fate ended;
        if (event.kind == MURK_PATH_BOUNDARY) {
            if (!murk_meet_boundary(w, &ahead, &ended)) {
                return ended;
            }
            continue;
        }
        if (event.kind == MURK_PATH_SURFACE
                ? !murk_meet_surface(w, &event.hit, event.distance_m,
                                     event.crossed, &ended)
                : !murk_meet_side(w, event.distance_m, &ended)) {
            return ended;
        }
        if (event.crossed && ahead.has_mesh && w->is_beyond &&
            !murk_meet_mesh_beyond(w, &event.hit, &ahead, &ended)) {
            return ended;
        }
    }
}

static void start(murk_walker *w, murk_ray ray)
{
    const murk_walk_setup *r = w->setup;
    const murk_source *light = murk_sources_get(r->world->lights, w->light);
    w->path.position = w->probe = ray.origin;
    w->path.direction = ray.direction;
    if (r->space.any_boundaries) {
        w->path.inside =
            murk_path_inside_ahead(&r->space, ray.origin, ray.direction);
    }
    if (!r->space.any_surfaces) {
        return;
    }
    if (murk_source_is_distant(light)) {
        murk_walker_enter(w);
        return;
    }
    const murk_vec3 off = murk_source_face(light, ray.direction);
    w->probe = murk_surfaces_leave(r->world->surfaces, ray.origin, off);
    if (r->space.any_solids) {
        w->solids = murk_path_solids_around(r->world->surfaces, w->probe,
                                            w->path.direction);
    }
}

/* Media, meshes and solids around a place in the open. */
static void start_inside(murk_walker *w)
{
    const murk_walk_setup *r = w->setup;
    if (r->space.any_boundaries) {
        w->path.inside = murk_path_inside_ahead(&r->space, w->path.position,
                                                w->path.direction);
    }
    if (r->space.any_solids) {
        w->solids = murk_path_solids_around(r->world->surfaces, w->probe,
                                            w->path.direction);
    }
}

/* What another portal lets in escapes before it has done anything. */
static murk_fate spend(murk_walker *w)
{
    ++w->number;
    if (murk_walker_is_heard(w)) {
        murk_event event = murk_walker_event(w, MURK_EVENT_ESCAPED);
        event.direction_out = w->path.direction;
        murk_walker_tell(w, &event);
    }
    return MURK_FATE_ESCAPED;
}

/* Light of the sun or sky through a domain whose media go on outside: what they
 * take of it escapes before it has done anything, by roulette. Light that a
 * boundary outside has refracted is of class specular. */
static void come_from_outside(murk_walker *w, murk_ray *ray)
{
    const murk_transport_world *world = w->setup->world;
    const murk_trace *trace = w->setup->trace;
    bool is_bent;
    const double share = murk_outside_share(world, w->band, ray->origin,
                                            &ray->direction, &is_bent);
    if (share < 1) {
        /* slots 0 and 1 are the emission's own (source/sources.c) */
        const murk_random4 random =
            murk_random(trace->seed, MURK_EMIT + MURK_STREAM * trace->stream,
                        w->photon, 0, 2);
        ray->is_spent = ray->is_spent || random.u[0] >= share;
    }
    if (is_bent) {
        w->event_class = MURK_CLASS_SPECULAR;
    }
}

/* Where the chain of the tallies' planes begins: before the side that distant
 * light enters by. */
static murk_station first_station(const murk_walker *w)
{
    const murk_source *light =
        murk_sources_get(w->setup->world->lights, w->light);
    return murk_source_is_distant(light)
               ? (murk_station){murk_along(w->path.position,
                                           -w->setup->space.margin_m,
                                           w->path.direction),
                                0}
               : (murk_station){w->path.position, w->setup->in_plane_m};
}

murk_walk_setup murk_walk_setup_of(const murk_trace *trace)
{
    const murk_transport_world *world = trace->world;
    const double size = murk_box_largest_coordinate(&world->domain.box);
    const double step = murk_surfaces_leave_step_m(world->surfaces);
    return (murk_walk_setup){
        .trace = trace,
        .world = world,
        .space = murk_path_space_of(world->surfaces, world->media,
                                    world->boundary_meshes, &world->domain),
        .in_plane_m = fmax(step / 2, IN_PLANE_TOLERANCE * size),
        .any_media = murk_media_any(world->media),
        .purpose_shift = MURK_STREAM * trace->stream,
        .min_quanta = llround(trace->least_weight * (double)MURK_PACKET)};
}

void murk_walk_photon(const murk_walk_setup *r, murk_sums *s, uint64_t batch,
                      uint64_t photon)
{
    const murk_transport_world *world = r->world;
    const size_t channel = murk_sources_channel_of(world->lights, photon);
    murk_walker w = {.setup = r,
                     .sums = s,
                     .batch = batch,
                     .photon = photon,
                     .quanta = MURK_PACKET,
                     .channel = channel,
                     .light = channel / (size_t)world->bands,
                     .band = (int)(channel % (size_t)world->bands),
                     .event_class = MURK_CLASS_FIRST,
                     .path = {.space = &r->space, .length_m = INFINITY}};
    ++s->emitted[channel];
    /* Draw the start of the photon. */
    murk_ray ray = murk_sources_emit(world->lights, r->trace->seed,
                                     r->trace->stream, photon);
    if (world->continues &&
        murk_source_is_distant(murk_sources_get(world->lights, w.light))) {
        come_from_outside(&w, &ray);
    }
    /* Tell the emission. */
    start(&w, ray);
    if (murk_walker_is_heard(&w)) {
        murk_event event = murk_walker_event(&w, MURK_EVENT_EMITTED);
        event.direction_in = murk_vec(0, 0, 0);
        event.direction_out = w.path.direction;
        murk_walker_tell(&w, &event);
    }
    if (s->scorer) {
        murk_score_start(s->scorer, channel, first_station(&w));
    }
    /* Follow the photon to its end, and enter its fate into the sums. */
    const murk_fate fate = ray.is_spent ? spend(&w) : follow(&w);
    s->ended[channel][fate] += w.quanta;
    if (fate == MURK_FATE_SURFACES || fate == MURK_FATE_MEDIA) {
        murk_walker_keep(&w, w.absorber, w.quanta);
    }
    if (s->scorer) {
        murk_score_end(s->scorer, r->trace->takes_back);
    }
}

void murk_walk_from(const murk_walk_setup *r, murk_sums *s, uint64_t photon,
                    int band, murk_ray ray)
{
    murk_walker w = {.setup = r,
                     .sums = s,
                     .photon = photon,
                     .quanta = MURK_PACKET,
                     .band = band,
                     .event_class = MURK_CLASS_FIRST,
                     .path = {.space = &r->space,
                              .position = ray.origin,
                              .direction = ray.direction,
                              .length_m = INFINITY},
                     .probe = ray.origin};
    start_inside(&w);
    const murk_fate fate = follow(&w);
    s->ended[0][fate] += w.quanta;
}
