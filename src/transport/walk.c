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
 * refractive regions and of meshes the photon is; see transport/ahead.h. */
#include "transport/walk.h"

#include "base/rng.h"
#include "medium/interfaces.h"
#include "medium/phase.h"
#include "transport/ahead.h"
#include "transport/bounce.h"
#include "transport/solids.h"
#include "transport/turn.h"

/* Share of the domain's largest coordinate by which the box for surfaces is
 * grown: some times what rays in single precision are off by, and what
 * murk_surfaces_leave() moves by. */
#define GROWN_BY 4e-6

/* Likewise, how near to a place that was worked out in double a plane has it in
 * it: some hundred times what it is off by. */
#define IN_PLANE_BY 1e-13

/* Reflected at a mesh, a photon stands on it to double precision: this share of
 * what meshes are told apart by keeps it from meeting it again. */
#define REFLECTED_SKIP 0x1p-20

/* A photon under way. */
typedef struct walk {
    const murk_course *course;
    murk_sums *sums;
    uint64_t batch, photon;
    int64_t quanta; /* what is left of its packet */
    size_t channel, light;
    size_t absorber; /* that took it, where it ended so */
    int band;
    uint32_t number, wraps;
    murk_event_class event_class;
    murk_vec3 position, direction, probe;
    murk_solids solids;
    murk_inside inside; /* regions with a boundary that it is in */
    double silent_m;    /* flown to boundaries that were no event, since one */
    double skip_m;      /* no mesh is looked for nearer on the next leg */
    bool is_beyond;     /* the surface met last let it through */
} walk;

static murk_address address_of(const walk *w, murk_purpose purpose)
{
    return (murk_address){w->course->trace->seed,
                          (uint32_t)purpose + w->course->purpose_shift,
                          w->photon, w->number};
}

static murk_random4 draw(const walk *w, murk_purpose purpose)
{
    const murk_address address = address_of(w, purpose);
    return murk_random_at(&address, 0);
}

static double share_of_packet(int64_t quanta)
{
    return (double)quanta / (double)MURK_PACKET;
}

/* Quanta that a material or, counted on from the last of them, a medium keeps.
 */
static void keep(const walk *w, size_t absorber, int64_t quanta)
{
    murk_tally_add(
        &w->sums->absorber[w->channel * w->sums->absorbers + absorber],
        w->course->trace->takes_back ? -quanta : quanta);
}

/* Leaves behind all but the share `kept` of the photon's quanta, where it has
 * enough of them to be split; u in (0, 1) rounds without bias. False where the
 * roulette must decide instead. */
static bool splits(walk *w, double kept, double u, murk_fate fate,
                   size_t absorber)
{
    if (w->quanta <= w->course->least_quanta) {
        return false;
    }
    const int64_t left = (int64_t)floor((double)w->quanta * kept + u);
    const int64_t quanta = left < w->quanta ? left : w->quanta;
    w->sums->ended[w->channel][fate] += w->quanta - quanta;
    keep(w, absorber, w->quanta - quanta);
    w->quanta = quanta;
    return true;
}

/* What all events tell. */
static murk_event event_of(const walk *w, murk_event_kind kind)
{
    return (murk_event){.kind = kind,
                        .event_class = w->event_class,
                        .photon = w->photon,
                        .number = w->number,
                        .light = (uint16_t)w->light,
                        .band = (uint8_t)w->band,
                        .weight = share_of_packet(w->quanta),
                        .leaving = share_of_packet(w->quanta),
                        .position = w->position,
                        .direction_in = w->direction};
}

static void tell(walk *w, murk_event *event)
{
    event->path_m += w->silent_m;
    w->silent_m = 0;
    w->course->trace->sink(w->course->trace->context, w->batch, event);
}

static bool is_heard(const walk *w)
{
    return w->course->trace->sink != NULL;
}

/* A leg for the tallies, which ends for planes at `end`; reach_m: murk_station.
 */
static void score(const walk *w, murk_vec3 from, double length_m,
                  int64_t quanta, murk_vec3 end, double reach_m)
{
    murk_score_leg(w->sums->scorer, from, w->direction, length_m,
                   (double)quanta, (murk_station){end, reach_m});
}

static murk_fate lose(walk *w, murk_loss loss)
{
    ++w->sums->lost[loss];
    if (is_heard(w)) {
        murk_event event = event_of(w, MURK_EVENT_LOST);
        event.loss = loss;
        event.leaving = 0;
        tell(w, &event);
    }
    return MURK_FATE_LOST;
}

/* Distance to the wall ahead along one axis; INFINITY or NaN where there is no
 * motion along it (+ 0.0 makes -0 a 0). Free of branches: which way a photon
 * flies cannot be foretold. */
static inline double wall_ahead(double p, double d, const double wall[2])
{
    return (wall[!(d < 0)] - p) / (d + 0.0);
}

static inline double nearer(double a, double b)
{
    return a < b ? a : b; /* b where a is NaN */
}

/* Distance [m] to the side ahead, not below 0; INFINITY where the direction
 * has no length. */
static inline double side_ahead(const murk_walls *walls, murk_vec3 p,
                                murk_vec3 d)
{
    const double x = wall_ahead(p.x, d.x, walls->x);
    const double y = wall_ahead(p.y, d.y, walls->y);
    const double z = wall_ahead(p.z, d.z, walls->z);
    const double distance = nearer(x, nearer(y, nearer(z, INFINITY)));
    return distance > 0 ? distance : 0;
}

/* The axis that the side ahead lies across. */
static int axis_ahead(const murk_walls *walls, murk_vec3 p, murk_vec3 d)
{
    const double x = wall_ahead(p.x, d.x, walls->x);
    const double y = wall_ahead(p.y, d.y, walls->y);
    const double z = wall_ahead(p.z, d.z, walls->z);
    const double distance = nearer(x, nearer(y, nearer(z, INFINITY)));
    return z == distance ? 2 : y == distance ? 1 : 0;
}

static inline double held(double x, const double wall[2])
{
    return x < wall[0] ? wall[0] : x > wall[1] ? wall[1] : x;
}

static inline murk_vec3 held_inside(const murk_walls *walls, murk_vec3 p)
{
    return murk_vec(held(p.x, walls->x), held(p.y, walls->y),
                    held(p.z, walls->z));
}

static bool is_between(const murk_walls *walls, murk_vec3 p)
{
    return p.x >= walls->x[0] && p.x <= walls->x[1] && p.y >= walls->y[0] &&
           p.y <= walls->y[1] && p.z >= walls->z[0] && p.z <= walls->z[1];
}

/* The nearest surface; *distance_m is along the leg from w->position. */
static bool meets_surface(const walk *w, murk_hit *hit, double *distance_m)
{
    const double most = side_ahead(&w->course->grown, w->probe, w->direction);
    if (!murk_surfaces_hit(w->course->world->surfaces, w->probe, w->direction,
                           most, hit)) {
        return false;
    }
    const double ahead =
        murk_dot(murk_sub(w->probe, w->position), w->direction);
    *distance_m = fmax(0, hit->distance_m + ahead);
    return true;
}

/* u: two numbers in (0, 1). Given that it scatters, what the roulette leaves of
 * its number is again uniform, and serves as the azimuth: so one collision
 * takes one draw of four. (A split rounds by the number that turns it: its
 * quantum in a billion may go with the azimuth.) False when the photon ends
 * there. */
static bool scatter(walk *w, const murk_collision *c, const double u[2])
{
    const int64_t before = w->quanta;
    w->absorber = w->sums->materials + c->medium;
    const bool is_split =
        splits(w, c->albedo, u[0], MURK_FATE_MEDIA, w->absorber);
    const bool scatters = is_split ? w->quanta > 0 : u[0] < c->albedo;
    const double azimuth = is_split ? u[0] : u[0] / c->albedo;
    const murk_vec3 arriving = w->direction;
    const murk_vec3 from = w->position;
    ++w->sums->collisions;
    w->position = w->probe = held_inside(
        &w->course->walls, murk_along(from, c->distance_m, w->direction));
    if (w->sums->scorer) {
        score(w, from, c->distance_m, before, w->position, 0);
    }
    if (scatters) {
        w->direction =
            murk_turned(arriving, murk_phase_sample(c->phase, u[1]), azimuth);
    }
    if (is_heard(w)) {
        murk_event event = event_of(w, MURK_EVENT_MEDIUM);
        event.outcome = scatters ? MURK_SCATTERED : MURK_ABSORBED;
        event.material_or_medium = (uint8_t)c->medium;
        event.direction_in = arriving;
        event.direction_out = scatters ? w->direction : murk_vec(0, 0, 0);
        event.weight = share_of_packet(before);
        event.leaving = scatters ? share_of_packet(w->quanta) : 0;
        event.reflectance = c->albedo;
        event.path_m = c->distance_m;
        event.scattering_per_m = c->scattering_per_m;
        tell(w, &event);
    }
    w->event_class = MURK_CLASS_LATER;
    w->wraps = 0;
    return scatters;
}

/* The index of refraction in these solids and regions. */
static double index_in(const walk *w, const murk_solids *solids,
                       murk_inside inside)
{
    return solids->n > 0 ? murk_solids_ior(solids)
                         : murk_media_index(w->course->world->media, inside);
}

/* At a mirror or a boundary. */
static void note_specular(walk *w)
{
    if (w->event_class == MURK_CLASS_FIRST) {
        w->event_class = MURK_CLASS_SPECULAR;
    }
    w->wraps = 0;
}

/* Flies to the boundary of regions ahead, and is reflected or goes on beyond
 * it. A boundary that does not change the index is no event. */
static void meet_boundary(walk *w, const murk_ahead *ahead)
{
    const murk_boundary *b = &ahead->boundary;
    const murk_vec3 arriving = w->direction;
    const double lead = murk_dot(murk_sub(w->probe, w->position), arriving);
    const murk_vec3 from = w->position;
    w->position = held_inside(&w->course->walls,
                              murk_along(from, b->distance_m, arriving));
    if (w->sums->scorer) {
        score(w, from, b->distance_m, w->quanta, w->position,
              w->course->in_plane_m);
    }
    if (!(lead > b->distance_m)) {
        w->probe = w->position;
    }
    const murk_inside beyond = w->inside ^ b->crossed;
    w->skip_m = ahead->is_mesh ? w->course->near_m : 0;
    const double n_from = index_in(w, &w->solids, w->inside);
    const double n_to = index_in(w, &w->solids, beyond);
    if (n_from == n_to) {
        w->inside = beyond;
        w->silent_m += b->distance_m;
        return;
    }
    const murk_bounce bent = murk_refract(n_from, n_to, arriving, b->normal,
                                          draw(w, MURK_SURFACE).u[3]);
    if (is_heard(w)) {
        murk_event event = event_of(w, MURK_EVENT_INTERFACE);
        event.outcome = bent.outcome;
        event.material_or_medium = (uint8_t)b->region;
        event.direction_out = bent.direction;
        event.normal = b->normal;
        event.path_m = b->distance_m;
        tell(w, &event);
    }
    w->direction = bent.direction;
    if (bent.outcome == MURK_TRANSMITTED) {
        w->inside = beyond;
    } else if (ahead->is_mesh) {
        w->skip_m = REFLECTED_SKIP * w->course->near_m;
    }
    note_specular(w);
}

/* Steps over to where the photon goes on; `crossed` are regions whose boundary
 * lies in this surface. False when it ends there, *ended telling how. */
static bool bounce(walk *w, const murk_hit *hit, double path_m,
                   murk_inside crossed, murk_fate *ended)
{
    const murk_surfaces *surfaces = w->course->world->surfaces;
    const murk_material *material =
        murk_surfaces_material(surfaces, hit->material);
    murk_solids beyond = w->solids;
    murk_inside inside = w->inside;
    double n_from = 0, n_to = 0;
    if (hit->solid && material->ior > 0) {
        if (!murk_solids_cross(&beyond, hit->solid, material->ior)) {
            *ended = lose(w, MURK_LOSS_NUMERICAL);
            return false;
        }
        inside ^= crossed;
        n_from = index_in(w, &w->solids, w->inside);
        n_to = index_in(w, &beyond, inside);
    }
    const murk_vec3 place = murk_along(w->probe, hit->distance_m, w->direction);
    if (w->sums->scorer) {
        score(w, w->position, path_m, w->quanta, place, w->course->in_plane_m);
    }
    w->position = place;
    w->absorber = hit->material;
    murk_random4 random = draw(w, MURK_SURFACE);
    const int64_t before = w->quanta;
    const double kept = material->diffuse.band[w->band] +
                        material->specular.band[w->band] +
                        material->transmit.band[w->band];
    if (kept < 1 &&
        splits(w, kept, random.u[2], MURK_FATE_SURFACES, w->absorber)) {
        random.u[0] = w->quanta > 0 ? random.u[0] * kept : 1;
    }
    const murk_bounce b = murk_surface_bounce(
        material, w->band, n_from, n_to, w->direction, hit->normal, random.u);
    if (is_heard(w)) {
        murk_event event = event_of(w, MURK_EVENT_SURFACE);
        event.outcome = b.outcome;
        event.material_or_medium = hit->material;
        event.direction_out = b.direction;
        event.normal = hit->normal;
        event.weight = share_of_packet(before);
        event.leaving =
            b.outcome == MURK_ABSORBED ? 0 : share_of_packet(w->quanta);
        event.reflectance = material->diffuse.band[w->band];
        event.path_m = path_m;
        tell(w, &event);
    }
    *ended = MURK_FATE_SURFACES;
    if (b.outcome == MURK_ABSORBED) {
        return false;
    }
    const bool through = b.outcome == MURK_TRANSMITTED;
    w->is_beyond = through;
    if (through) {
        w->solids = beyond;
        w->inside = inside;
    }
    w->direction = b.direction;
    w->position = w->probe = murk_surfaces_leave(
        surfaces, w->position,
        through ? murk_scale(-1, hit->normal) : hit->normal);
    note_specular(w);
    if (b.outcome == MURK_DIFFUSE) {
        w->event_class = MURK_CLASS_LATER;
    }
    return true;
}

/* Enters at w->position, through a side of the domain. */
static void enter(walk *w)
{
    w->probe = murk_along(w->position, -w->course->margin_m, w->direction);
    if (w->course->any_solids) {
        w->solids = murk_solids_around(w->course->world->surfaces, w->probe,
                                       w->direction);
    }
}

/* Puts p onto the lower or the upper wall across the axis. */
static void put_on_wall(const murk_walls *walls, int axis, bool upper,
                        murk_vec3 *p)
{
    if (axis == 0) {
        p->x = walls->x[upper];
    } else if (axis == 1) {
        p->y = walls->y[upper];
    } else {
        p->z = walls->z[upper];
    }
}

/* Just out of a side of the domain, so that planes in it count what passes. */
static murk_vec3 beyond_side(const walk *w, int axis, bool upper)
{
    const double step = upper ? w->course->margin_m : -w->course->margin_m;
    return murk_add(w->position,
                    murk_vec(axis == 0 ? step : 0, axis == 1 ? step : 0,
                             axis == 2 ? step : 0));
}

/* False when the photon has left the world, *ended telling how. */
static bool pass_side(walk *w, double path_m, murk_fate *ended)
{
    const murk_walls *walls = &w->course->walls;
    const murk_vec3 d = w->direction;
    const int axis = axis_ahead(walls, w->position, d);
    const bool upper = (axis == 0 ? d.x : axis == 1 ? d.y : d.z) > 0;
    const bool wraps = w->course->world->domain.is_periodic && axis != 2;
    const murk_vec3 from = w->position;
    w->position = held_inside(walls, murk_along(from, path_m, d));
    put_on_wall(walls, axis, upper, &w->position);
    if (w->sums->scorer) {
        score(w, from, path_m, w->quanta, beyond_side(w, axis, upper), 0);
    }
    if (wraps && w->wraps >= w->course->trace->wraps_max) {
        *ended = lose(w, MURK_LOSS_WRAPS);
        return false;
    }
    if (is_heard(w)) {
        murk_event event =
            event_of(w, wraps ? MURK_EVENT_WRAPPED : MURK_EVENT_ESCAPED);
        event.direction_out = d;
        event.path_m = path_m;
        tell(w, &event);
    }
    *ended = MURK_FATE_ESCAPED;
    if (!wraps) {
        return false;
    }
    ++w->wraps;
    put_on_wall(walls, axis, !upper, &w->position);
    if (w->sums->scorer) {
        murk_score_jump(w->sums->scorer,
                        (murk_station){beyond_side(w, axis, !upper), 0});
    }
    w->inside =
        murk_inside_wrapped(w->course->world, w->inside, w->position, axis);
    enter(w);
    return true;
}

/* Whether a flight of at most length_m ends in a medium; rest: two numbers left
 * over for what happens there. */
static inline bool collides(const walk *w, double length_m, murk_collision *c,
                            double rest[2])
{
    const murk_random4 random = draw(w, MURK_FLIGHT);
    rest[0] = random.u[2];
    rest[1] = random.u[3];
    const murk_media *media = w->course->world->media;
    const double tau = -log(random.u[0]);
    if (w->course->trace->by_delta) {
        const murk_address address = address_of(w, MURK_FLIGHT);
        return murk_media_fly_delta(media, w->band, w->inside, w->position,
                                    w->direction, length_m, tau, random.u[1],
                                    &address, c);
    }
    return murk_media_fly(media, w->band, w->inside, w->position, w->direction,
                          length_m, tau, random.u[1], c);
}

/* Which comes first: the boundary, the surface at path_m, or both at once?
 * Surfaces are known in single precision only, so within what they are moved
 * off by a boundary counts as lying in them: the floor of a tank is wet, and
 * glass that holds water lets light straight through from one to the other. */
typedef enum order { BOUNDARY_FIRST, TOGETHER, SURFACE_FIRST } order;

static order order_of(const walk *w, const murk_boundary *b, double path_m)
{
    const double gap =
        (path_m - b->distance_m) * fabs(murk_dot(b->normal, w->direction));
    return gap > w->course->near_m    ? BOUNDARY_FIRST
           : gap < -w->course->near_m ? SURFACE_FIRST
                                      : TOGETHER;
}

/* Beyond a surface in which the boundary of a mesh lies. A solid has taken it
 * into account; after a sheet it is met in its turn, where the photon is now.
 * Then the photon goes on as far as it takes to leave the mesh behind. */
static void pass_mesh_in_surface(walk *w, const murk_hit *hit,
                                 murk_ahead *ahead)
{
    if (!hit->solid) {
        ++w->number;
        ahead->boundary.distance_m = 0;
        meet_boundary(w, ahead);
    }
    w->skip_m = w->course->near_m / fabs(murk_dot(w->direction, hit->normal));
}

static murk_fate follow(walk *w)
{
    const murk_course *r = w->course;
    const bool only_media = r->any_media && !r->any_surfaces;
    const bool media_too = r->any_media && r->any_surfaces;
    for (;;) {
        ++w->number;
        if (w->number > r->trace->events_max) {
            return lose(w, MURK_LOSS_EVENTS);
        }
        murk_collision collision;
        double rest[2];
        murk_ahead ahead;
        const murk_boundary *boundary = &ahead.boundary;
        bool bends = r->any_boundaries &&
                     murk_look_ahead(r->world, &w->inside, w->position,
                                     w->direction, w->skip_m, &ahead);
        w->skip_m = 0;
        /* With no surfaces most legs end in a medium: the others alone look
         * for the side. */
        if (only_media &&
            collides(w, bends ? boundary->distance_m : INFINITY, &collision,
                     rest) &&
            is_between(&r->walls, murk_along(w->position, collision.distance_m,
                                             w->direction))) {
            if (!scatter(w, &collision, rest)) {
                return MURK_FATE_MEDIA;
            }
            continue;
        }
        double length_m = side_ahead(&r->walls, w->position, w->direction);
        /* Also false for what is not a number. */
        if (!(is_between(&r->grown, w->position) && length_m < INFINITY)) {
            return lose(w, MURK_LOSS_NUMERICAL);
        }
        murk_hit hit;
        const bool met = r->any_surfaces && meets_surface(w, &hit, &length_m);
        murk_inside crossed = 0;
        if (bends && met) {
            const order o = order_of(w, boundary, length_m);
            bends = o == BOUNDARY_FIRST;
            crossed = o == TOGETHER ? boundary->crossed : 0;
        }
        bends = bends && boundary->distance_m < length_m;
        if (bends) {
            length_m = boundary->distance_m;
        }
        if (media_too && w->solids.n == 0 &&
            collides(w, length_m, &collision, rest)) {
            if (!scatter(w, &collision, rest)) {
                return MURK_FATE_MEDIA;
            }
            continue;
        }
        if (bends) {
            meet_boundary(w, &ahead);
            continue;
        }
        murk_fate ended;
        if (met ? !bounce(w, &hit, length_m, crossed, &ended)
                : !pass_side(w, length_m, &ended)) {
            return ended;
        }
        if (crossed && ahead.is_mesh && w->is_beyond) {
            pass_mesh_in_surface(w, &hit, &ahead);
        }
    }
}

static void start(walk *w, murk_ray ray)
{
    const murk_course *r = w->course;
    const murk_light *light = murk_lights_get(r->world->lights, w->light);
    w->position = w->probe = ray.origin;
    w->direction = ray.direction;
    w->inside = murk_inside_at(r->world, ray.origin, ray.direction);
    if (!r->any_surfaces) {
        return;
    }
    if (light->type == MURK_LIGHT_DIRECTIONAL) {
        enter(w);
        return;
    }
    const murk_vec3 off =
        light->type == MURK_LIGHT_RECT
            ? murk_unit(murk_cross(light->edge1, light->edge2))
            : ray.direction;
    w->probe = murk_surfaces_leave(r->world->surfaces, ray.origin, off);
    if (r->any_solids) {
        w->solids =
            murk_solids_around(r->world->surfaces, w->probe, w->direction);
    }
}

/* Where the chain of the tallies' planes begins: before the side that distant
 * light enters by. */
static murk_station first_station(const walk *w)
{
    const murk_light *light =
        murk_lights_get(w->course->world->lights, w->light);
    return light->type == MURK_LIGHT_DIRECTIONAL
               ? (murk_station){murk_along(w->position, -w->course->margin_m,
                                           w->direction),
                                0}
               : (murk_station){w->position, w->course->in_plane_m};
}

static murk_walls walls_of(const murk_box *box, double grow)
{
    return (murk_walls){{box->min.x - grow, box->max.x + grow},
                        {box->min.y - grow, box->max.y + grow},
                        {box->min.z - grow, box->max.z + grow}};
}

murk_course murk_course_of(const murk_trace *trace)
{
    const murk_world *world = trace->world;
    const murk_surfaces_facts facts = murk_surfaces_describe(world->surfaces);
    const murk_box box = world->domain.box;
    const double size =
        fmax(fmax(fmax(fabs(box.min.x), fabs(box.min.y)), fabs(box.min.z)),
             fmax(fmax(fabs(box.max.x), fabs(box.max.y)), fabs(box.max.z)));
    const double grow = GROWN_BY * size;
    const murk_vec3 zero = {0, 0, 0}, up = {0, 0, 1};
    const double step =
        murk_length(murk_surfaces_leave(world->surfaces, zero, up));
    return (murk_course){
        .trace = trace,
        .world = world,
        .walls = walls_of(&box, 0),
        .grown = walls_of(&box, grow),
        .margin_m = grow,
        .near_m = fmax(2 * step,
                       world->hulls ? murk_hulls_tolerance_m(world->hulls) : 0),
        .in_plane_m = fmax(step / 2, IN_PLANE_BY * size),
        .any_surfaces = facts.triangles + facts.spheres > 0,
        .any_solids = facts.solids > 0,
        .any_media = murk_media_any(world->media),
        .any_boundaries = murk_media_bends(world->media) || world->hulls,
        .purpose_shift = MURK_STREAM * trace->stream,
        .least_quanta = llround(trace->least_weight * (double)MURK_PACKET)};
}

void murk_walk_photon(const murk_course *r, murk_sums *s, uint64_t batch,
                      uint64_t photon)
{
    const murk_world *world = r->world;
    const size_t channel = murk_lights_channel_of(world->lights, photon);
    walk w = {.course = r,
              .sums = s,
              .batch = batch,
              .photon = photon,
              .quanta = MURK_PACKET,
              .channel = channel,
              .light = channel / (size_t)world->bands,
              .band = (int)(channel % (size_t)world->bands),
              .event_class = MURK_CLASS_FIRST};
    ++s->emitted[channel];
    start(&w, murk_lights_emit(world->lights, r->trace->seed, r->trace->stream,
                               photon));
    if (is_heard(&w)) {
        murk_event event = event_of(&w, MURK_EVENT_EMITTED);
        event.direction_in = murk_vec(0, 0, 0);
        event.direction_out = w.direction;
        tell(&w, &event);
    }
    if (s->scorer) {
        murk_score_start(s->scorer, channel, first_station(&w));
    }
    const murk_fate fate = follow(&w);
    s->ended[channel][fate] += w.quanta;
    if (fate == MURK_FATE_SURFACES || fate == MURK_FATE_MEDIA) {
        keep(&w, w.absorber, w.quanta);
    }
    if (s->scorer) {
        murk_score_end(s->scorer, r->trace->takes_back);
    }
}
