/* The photon loop: find the next event on the ray, let a medium end the flight
 * before that event, move, score and interact (transport/walk.h).
 *
 * Rounding may put a surface that lies in a side of the domain slightly outside
 * of the domain. Surfaces are therefore searched in a slightly larger box. The
 * search for surfaces begins at `probe`, which may differ from `position`:
 * light that enters through a side of the domain must meet a surface in that
 * side, and light of a lamp must not meet the ceiling that the lamp touches.
 *
 * The set `inside`, not the position, determines on which side of the
 * boundaries of refractive regions and of meshes the photon is
 * (path/path.h). */
#include "transport/walk.h"

#include "base/logarithm.h"
#include "medium/phase.h"
#include "transport/jump.h"
#include "transport/meet.h"
#include "transport/outside.h"
#include "transport/turn.h"

/* A plane nearer than this share of the domain's largest coordinate to a
 * position that was computed in double precision contains the position: some
 * hundred times the rounding. */
#define IN_PLANE_TOLERANCE 1e-13

/* A jump towards a boundary ends at this share of the distance, and an ordinary
 * segment meets the boundary. */
#define BEFORE_BOUNDARY 0.999

/* ---- collisions ---- */

/* A collision, and two numbers in (0, 1) for the interaction there. */
typedef struct hit_medium {
    murk_collision at;
    double u[2];
} hit_medium;

/* Draws a free flight. True if the flight ends in a medium within length_m. */
static inline bool collides(const murk_walker *w, double length_m,
                            hit_medium *hit)
{
    const murk_random4 random = murk_walker_draw(w, MURK_FLIGHT);
    hit->u[0] = random.u[2];
    hit->u[1] = random.u[3];
    const murk_media *media = w->setup->world->media;
    const double tau = -murk_log(random.u[0]);
    if (w->setup->trace->by_delta) {
        const murk_address address = murk_walker_address(w, MURK_FLIGHT);
        return murk_media_fly_delta(
            media, w->band, w->path.inside, w->path.position, w->path.direction,
            length_m, tau, random.u[1], &address, &hit->at);
    }
    return murk_media_fly(media, w->band, w->path.inside, w->path.position,
                          w->path.direction, length_m, tau, random.u[1],
                          &hit->at);
}

/* Moves to the collision; scatters or absorbs the photon. If the photon is
 * scattered, the rest of the number of the roulette is uniform again and gives
 * the azimuth, so that one collision takes one draw of four numbers (more with
 * delta tracking). (A split packet is rounded by the number that also gives the
 * azimuth: one quantum in a billion may depend on the azimuth.) */
static murk_fate scatter(murk_walker *w, const hit_medium *hit)
{
    const murk_collision *c = &hit->at;
    const double *u = hit->u;
    /* Split the packet, or decide by roulette. */
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
    murk_walker_score(w, from, c->distance_m, before, w->path.position, 0);
    /* Draw the new direction, and report the event. */
    if (scatters) {
        w->path.direction = murk_turned_direction(
            arriving, murk_phase_sample(c->phase, u[1]), azimuth);
    }
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_MEDIUM);
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
    return scatters ? MURK_FATE_NONE : MURK_FATE_MEDIA;
}

/* ---- the photon loop ---- */

/* Finds the next boundary on the ray; false if there is none. Meshes are
 * searched only up to the collision that a medium would give, which in dense
 * media saves more time than the second flight takes. */
static inline bool boundary_ahead(murk_walker *w, murk_path_boundary *ahead)
{
    const murk_path_space *space = &w->setup->space;
    if (!space->any_boundaries) {
        return false;
    }
    hit_medium hit;
    const bool is_cut = space->boundary_meshes && w->setup->any_media &&
                        w->solids.n == 0 && collides(w, INFINITY, &hit);
    return murk_path_next_boundary(
        &w->path, is_cut ? hit.at.distance_m : INFINITY, ahead);
}

/* Jumps `run` metres, or up to a collision on the way, at which the photon is
 * scattered or absorbed. */
static murk_fate jump(murk_walker *w, double run)
{
    hit_medium hit;
    const bool collided = w->setup->any_media && collides(w, run, &hit);
    murk_jump(w, collided ? hit.at.distance_m : run);
    hit.at.distance_m = 0; /* the jump has moved the photon there */
    return collided ? scatter(w, &hit) : MURK_FATE_NONE;
}

/* Follows the photon to the next event, or to the next boundary at which
 * nothing happens. Inlined, because a call for each event would cost 2 % of the
 * time. */
static inline __attribute__((always_inline)) murk_fate
next_event(murk_walker *w)
{
    const murk_walk_setup *r = w->setup;
    const murk_path_space *space = &r->space;
    if (++w->number > r->trace->events_max) {
        return murk_walker_lose(w, MURK_LOSS_EVENTS);
    }
    murk_path_boundary ahead;
    const bool bends = boundary_ahead(w, &ahead);
    const double boundary_m = bends ? ahead.met.distance_m : INFINITY;
    w->path.skip_m = 0;
    double run = r->jumps ? murk_jump_ahead(w) : 0;
    run = bends ? fmin(run, BEFORE_BOUNDARY * boundary_m) : run;
    if (run > 0) {
        return jump(w, run);
    }
    /* Without surfaces most segments end in a medium: only the others need the
     * side of the domain. */
    hit_medium hit;
    if (r->any_media && !space->any_surfaces && collides(w, boundary_m, &hit) &&
        murk_path_sides_contain(&space->sides,
                                murk_along(w->path.position, hit.at.distance_m,
                                           w->path.direction))) {
        return scatter(w, &hit);
    }
    /* The nearest surface, boundary or side; a collision before that event
     * comes first. */
    murk_path_event event;
    if (!murk_path_first_event(&w->path, w->probe, bends ? &ahead : NULL,
                               INFINITY, &event)) {
        return murk_walker_lose(w, MURK_LOSS_NUMERICAL);
    }
    if (r->any_media && space->any_surfaces && w->solids.n == 0 &&
        collides(w, event.distance_m, &hit)) {
        return scatter(w, &hit);
    }
    if (event.kind == MURK_PATH_BOUNDARY) {
        return murk_meet_boundary(w, &ahead);
    }
    const murk_fate fate =
        event.kind == MURK_PATH_SURFACE
            ? murk_meet_surface(w, &event.hit, event.distance_m, event.crossed)
            : murk_meet_side(w, event.distance_m);
    return fate == MURK_FATE_NONE && event.crossed && ahead.has_mesh &&
                   w->is_beyond
               ? murk_meet_mesh_beyond(w, &event.hit, &ahead)
               : fate;
}

/* Follows the photon to its end. */
static murk_fate follow(murk_walker *w)
{
    murk_fate fate;
    do {
        fate = next_event(w);
    } while (fate == MURK_FATE_NONE);
    return fate;
}

/* ---- starts ---- */

/* A photon before the start, of channel 0, with the whole packet. Member by
 * member, because compilers clear a whole walker with an instruction that takes
 * as long as to draw the start; of the solids only the number has a meaning. */
static void set_up(murk_walker *w, const murk_walk_setup *setup,
                   murk_sums *sums, uint64_t photon)
{
    w->setup = setup;
    w->sums = sums;
    w->batch = 0;
    w->photon = photon;
    w->quanta = MURK_PACKET;
    w->channel = w->light = w->absorber = 0;
    w->band = 0;
    w->number = w->wraps = 0;
    w->event_class = MURK_CLASS_FIRST;
    w->path.space = &setup->space;
    w->path.length_m = INFINITY;
    w->path.gone_m = w->path.skip_m = 0;
    w->path.inside = 0;
    w->solids.n = 0;
    w->silent_m = 0;
    w->is_beyond = false;
    w->score = NULL;
}

/* Puts the photon at the beginning of the ray, and finds the regions and solids
 * that contain the photon. `probe`: where the search for surfaces begins. */
static inline void set_out(murk_walker *w, const murk_ray *ray, murk_vec3 probe)
{
    const murk_path_space *space = &w->setup->space;
    w->path.position = ray->origin;
    w->path.direction = ray->direction;
    w->probe = probe;
    if (space->any_boundaries) {
        w->path.inside =
            murk_path_inside_ahead(space, ray->origin, ray->direction);
    }
    if (space->any_solids) {
        w->solids =
            murk_path_solids_around(space->surfaces, probe, ray->direction);
    }
}

/* The start of the search for surfaces: for distant light before the side of
 * the domain, for lamps clear of the surface that the lamp touches; without
 * surfaces, the start of the ray. */
static inline murk_vec3 first_probe(const murk_walker *w, const murk_ray *ray)
{
    const murk_walk_setup *r = w->setup;
    const murk_source *light = murk_sources_get(r->world->lights, w->light);
    if (!r->space.any_surfaces) {
        return ray->origin;
    }
    return murk_source_is_distant(light)
               ? murk_along(ray->origin, -r->space.margin_m, ray->direction)
               : murk_surfaces_leave(r->world->surfaces, ray->origin,
                                     murk_source_face(light, ray->direction));
}

/* Ends a photon at the start of the ray: the ray belongs to another portal
 * (source/entry_faces.h), or roulette has removed the photon
 * (come_from_outside()). */
static murk_fate spend(murk_walker *w)
{
    ++w->number;
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_ESCAPED);
        event.direction_out = w->path.direction;
        murk_walker_tell(w, &event);
    }
    return MURK_FATE_ESCAPED;
}

/* Attenuates light of sun and sky in the media that continue outside of the
 * domain, by roulette: a photon that is removed escapes at the start of the
 * ray. Light that a boundary outside has refracted is of class specular. */
static void come_from_outside(murk_walker *w, murk_ray *ray)
{
    const murk_transport_world *world = w->setup->world;
    const murk_trace *trace = w->setup->trace;
    bool is_bent;
    const double share = murk_outside_share(world, w->band, ray->origin,
                                            &ray->direction, &is_bent);
    if (share < 1) {
        /* slots 0 and 1 belong to the emission (source/sources.c) */
        const murk_random4 random =
            murk_random(trace->seed, MURK_EMIT + MURK_STREAM * trace->stream,
                        w->photon, 0, 2);
        ray->is_spent = ray->is_spent || random.u[0] >= share;
    }
    if (is_bent) {
        w->event_class = MURK_CLASS_SPECULAR;
    }
}

/* The first position of the chain of plane tallies: for distant light, before
 * the side through which the light enters. */
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

static bool is_lit(const murk_walk_setup *r, size_t channel)
{
    return murk_sources_channel_power_w(r->world->lights, channel) > 0;
}

void murk_walk_starts_draw(const murk_walk_setup *r, uint64_t place, size_t n,
                           murk_photon_start *start)
{
    const murk_sources *lights = r->world->lights;
    for (size_t i = 0; i < n; ++i) {
        murk_photon_start *s = &start[i];
        s->photon = murk_trace_photon(r->trace, place + i);
        s->channel = murk_sources_channel_of(lights, s->photon);
        if (is_lit(r, s->channel)) {
            s->ray = murk_sources_emit_in(lights, s->channel, r->trace->seed,
                                          r->trace->stream, s->photon);
        }
    }
}

murk_fate murk_walk_photon_begin(murk_walker *w, const murk_walk_setup *r,
                                 murk_sums *s, murk_score_path *score,
                                 uint64_t batch, const murk_photon_start *start)
{
    const murk_transport_world *world = r->world;
    const size_t channel = start->channel;
    set_up(w, r, s, start->photon);
    w->batch = batch;
    w->channel = channel;
    w->light = channel / (size_t)world->bands;
    w->band = (int)(channel % (size_t)world->bands);
    w->score = score;
    /* A photon of a light source that is off is not traced: it has no part in
     * ledger and tallies. */
    if (!is_lit(r, channel)) {
        w->score = NULL;
        w->quanta = 0;
        return MURK_FATE_ESCAPED;
    }
    ++s->emitted[channel];
    murk_ray ray = start->ray;
    if (world->continues &&
        murk_source_is_distant(murk_sources_get(world->lights, w->light))) {
        come_from_outside(w, &ray);
    }
    /* Report the emission. */
    set_out(w, &ray, first_probe(w, &ray));
    if (murk_walker_is_heard(w) && !r->trace->skips_ends) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_EMITTED);
        event.direction_in = murk_vec(0, 0, 0);
        event.direction_out = w->path.direction;
        murk_walker_tell(w, &event);
    }
    if (w->score) {
        murk_score_start(w->score, channel, first_station(w));
    }
    return ray.is_spent ? spend(w) : MURK_FATE_NONE;
}

murk_fate murk_walk_photon_event(murk_walker *w)
{
    return next_event(w);
}

murk_fate murk_walk_photon_on(murk_walker *w)
{
    return follow(w);
}

void murk_walk_photon_end(murk_walker *w, murk_fate fate)
{
    w->sums->ended[w->channel][fate] += w->quanta;
    if (fate == MURK_FATE_SURFACES || fate == MURK_FATE_MEDIA) {
        murk_walker_keep(w, w->absorber, w->quanta);
    }
    if (w->score) {
        murk_score_end(w->score, w->setup->trace->takes_back);
    }
}

void murk_walk_photon(const murk_walk_setup *r, murk_sums *s, uint64_t batch,
                      uint64_t place)
{
    murk_walker w;
    murk_photon_start start;
    murk_walk_starts_draw(r, place, 1, &start);
    const murk_fate fate = murk_walk_photon_begin(
        &w, r, s, s->scorer ? &s->scorer->path[0] : NULL, batch, &start);
    murk_walk_photon_end(&w, fate == MURK_FATE_NONE ? follow(&w) : fate);
}

void murk_walk_from(const murk_walk_setup *r, murk_sums *s, uint64_t photon,
                    int band, murk_ray ray)
{
    murk_walker w;
    set_up(&w, r, s, photon);
    w.band = band;
    set_out(&w, &ray, ray.origin);
    const murk_fate fate = follow(&w);
    s->ended[0][fate] += w.quanta;
}
