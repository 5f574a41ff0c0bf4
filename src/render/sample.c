/* Follows one ray of a picture backwards through the world and sums the
 * radiance that it finds: lights that it meets, direct light by shadow rays,
 * and light from the photon maps, according to the method. */
#include "render/sample.h"

#include <stdlib.h>

#include "source/shine.h"
#include "transport/outside.h"

/* The tolerance of the distance to a lamp is margin_m divided by the cosine at
 * which the ray meets the face of the lamp; this is the least cosine that is
 * used. */
#define GRAZING 1e-3

/* The density [1/sr] above which the forward peak of a phase function begins:
 * some six times isotropic. With a lower value, rays continue for longer and
 * add noise; with a higher one, few records carry most of the light. */
#define PEAK_PER_SR 0.5

/* The number of equal steps from 0 to 180 degrees in which the edge of the peak
 * is searched. */
#define PEAK_STEPS 360

typedef enum part { SURFACE, VOLUME, PARTS } part;

struct murk_sampler {
    const murk_scenery *scenery;
    murk_render_method method;
    const murk_gather *gather;
    murk_follower *follower;
    uint32_t seed, purpose;
    uint64_t lost;
    double *cone; /* [media * bands] */
    /* The current ray. */
    uint64_t number;
    int band;
    double own_index;        /* index at the start; 0: not known yet */
    bool is_connected;       /* shadow rays were sent from `last`, and may have
                                found the light that the ray hits */
    murk_shading_point last; /* the last point at which the ray was scattered or
                                reflected diffusely */
    murk_vec3 wrapped;       /* displacement at periodic sides since that
                                point */
    murk_vec3 left;   /* the last point at which the ray left the domain through
                         a periodic side */
    bool has_wrapped; /* `wrapped` lacks the displacement at `left` until the
                         next segment begins */
    bool is_settled;  /* the ray was scattered or reflected diffusely, so all
                         further light belongs to the class `settled` */
    part settled;
    bool is_stopped, meets_light;
    murk_trace_segment segment; /* the last segment */
    double radiance[PARTS];     /* radiance / index^2 */
    double *group;              /* contributions of the maps */
};

/* Adds light that the ray has hit. */
static void add_met(murk_sampler *s, double radiance)
{
    s->meets_light = s->meets_light || !s->is_settled;
    s->radiance[s->is_settled ? s->settled : SURFACE] += radiance;
}

static void add(murk_sampler *s, part of, double radiance)
{
    s->radiance[s->is_settled ? s->settled : of] += radiance;
}

/* ---- lights that the ray meets ---- */

static double slack_at(const murk_scenery *scenery, const murk_source *light,
                       murk_vec3 sight)
{
    const murk_vec3 face = murk_source_face(light, sight);
    return scenery->margin_m / fmax(GRAZING, fabs(murk_dot(face, sight)));
}

/* The weight of a light that is hit on a segment: murk_direct_rest() if shadow
 * rays from the last point may have found the light; otherwise 1, but by maps 0
 * after the ray was scattered. */
static double share_met(const murk_sampler *s, size_t light, murk_vec3 sight)
{
    if (!s->is_connected) {
        /* by maps, the rest was counted at the point where the ray continued */
        return s->is_settled && s->method != MURK_BY_PATHS ? 0 : 1;
    }
    const murk_source *l = murk_sources_get(s->scenery->world->lights, light);
    const murk_vec3 from = murk_source_is_distant(l)
                               ? s->last.position
                               : murk_sub(s->last.position, s->wrapped);
    const murk_glare glare = murk_sources_glare(s->scenery->world->lights,
                                                light, s->band, from, sight);
    return murk_direct_rest(s->scenery, &s->last, light, murk_scale(-1, sight),
                            glare.per_sr, s->wrapped);
}

/* Adds the lights that the ray meets on the last segment: the lamps on it; or
 * the sun and the sky behind the end of it. */
static void meet_lights(murk_sampler *s, bool is_distant, murk_vec3 from,
                        murk_vec3 sight, double weight)
{
    const murk_sources *lights = s->scenery->world->lights;
    const double square = s->segment.index * s->segment.index;
    for (size_t i = 0; i < s->scenery->n_lit[s->band]; ++i) {
        const size_t light = s->scenery->lit[s->band][i];
        const murk_source *l = murk_sources_get(lights, light);
        if (murk_source_is_distant(l) != is_distant) {
            continue;
        }
        const murk_glare glare =
            murk_sources_glare(lights, light, s->band, from, sight);
        if (!(glare.radiance > 0) ||
            (!is_distant &&
             !(glare.distance_m <=
               s->segment.length_m + slack_at(s->scenery, l, sight)))) {
            continue;
        }
        /* Light from the sun or sky has passed the media outside. */
        const double outside =
            is_distant ? murk_outside_straight(s->scenery->world, s->band, from,
                                               murk_scale(-1, sight))
                       : 1;
        add_met(s, weight * glare.radiance * outside / square *
                       share_met(s, light, sight));
    }
}

static void receive_segment(void *context, uint64_t batch,
                            const murk_trace_segment *segment)
{
    murk_sampler *s = context;
    (void)batch;
    s->segment = *segment;
    if (!(s->own_index > 0)) {
        s->own_index = segment->index;
    }
    if (s->has_wrapped) {
        s->wrapped = murk_add(s->wrapped, murk_sub(s->left, segment->from));
        s->has_wrapped = false;
    }
    meet_lights(s, false, segment->from, segment->direction, segment->weight);
}

/* ---- events ---- */

/* Adds the light that leaves the point against the direction of the ray: direct
 * light by shadow rays, except in solids and by maps alone; and by maps the
 * light that the maps give. */
static void add_light(murk_sampler *s, const murk_event *event,
                      const murk_shading_point *place)
{
    const part of = place->phase ? VOLUME : SURFACE;
    const bool by_paths = s->method == MURK_BY_PATHS;
    if (!place->is_in_solid && s->method != MURK_BY_MAPS_ONLY) {
        const murk_address address = {s->seed, s->purpose, s->number,
                                      event->number};
        add(s, of,
            event->weight *
                murk_direct_light(
                    s->scenery, place, &address,
                    (murk_balance){.goes_on = by_paths || place->phase != NULL,
                                   .sheets = by_paths}));
    }
    if (!by_paths) {
        const double square = s->own_index * s->own_index;
        const double scale =
            event->weight * (place->phase ? place->albedo : 1) * square;
        add(s, of,
            murk_gather_light(s->gather, place, scale, s->group) / square);
    }
}

/* Records that the ray was scattered or reflected diffusely: this point is the
 * last event of all further light. */
static void settle(murk_sampler *s, part of, const murk_shading_point *place)
{
    s->last = *place;
    s->wrapped = murk_vec(0, 0, 0);
    s->settled = s->is_settled ? s->settled : of;
    s->is_settled = true;
    s->is_connected = !place->is_in_solid && s->method != MURK_BY_MAPS_ONLY;
}

/* Ends the ray, because the maps give all further light. */
static void stop(murk_sampler *s)
{
    s->is_stopped = true;
    murk_follower_stop(s->follower);
}

static void meet_surface(murk_sampler *s, const murk_event *event)
{
    const murk_shading_point place = {.band = s->band,
                                      .position = event->position,
                                      .sight = event->direction_in,
                                      .index = s->segment.index,
                                      .is_in_solid = s->segment.is_in_solid,
                                      .normal = event->normal,
                                      .diffuse = event->reflectance};
    if (event->reflectance > 0) {
        add_light(s, event, &place);
    }
    if (event->outcome == MURK_DIFFUSE) {
        settle(s, SURFACE, &place);
        if (s->method != MURK_BY_PATHS) {
            stop(s);
        }
    } else if (event->outcome == MURK_MIRRORED) {
        s->is_connected = false;
    } else if (event->outcome == MURK_TRANSMITTED) {
        /* A thin sheet does not bend; by paths, shadow rays pass it. */
        const murk_vec3 a = event->direction_in, b = event->direction_out;
        s->is_connected = s->is_connected && s->method == MURK_BY_PATHS &&
                          a.x == b.x && a.y == b.y && a.z == b.z;
    }
}

static void meet_medium(murk_sampler *s, const murk_event *event)
{
    const murk_shading_point place = {
        .band = s->band,
        .position = event->position,
        .sight = event->direction_in,
        .index = s->segment.index,
        .phase = murk_media_phase(s->scenery->world->media,
                                  event->material_or_medium, s->band),
        .albedo = event->reflectance,
        .cone =
            s->method == MURK_BY_PATHS
                ? -1
                : s->cone[event->material_or_medium * s->scenery->world->bands +
                          s->band]};
    add_light(s, event, &place);
    settle(s, VOLUME, &place);
    if (s->method != MURK_BY_PATHS &&
        !(murk_dot(event->direction_in, event->direction_out) > place.cone)) {
        stop(s);
    }
}

static void receive_event(void *context, uint64_t batch,
                          const murk_event *event)
{
    murk_sampler *s = context;
    (void)batch;
    /* Surfaces, media and the sky bring light; interfaces bend the ray, so
     * that no shadow ray could have found the light beyond; a periodic side
     * moves the ray. */
    switch (event->kind) {
    case MURK_EVENT_SURFACE:
        meet_surface(s, event);
        break;
    case MURK_EVENT_MEDIUM:
        meet_medium(s, event);
        break;
    case MURK_EVENT_INTERFACE:
        s->is_connected = false;
        break;
    case MURK_EVENT_ESCAPED:
        meet_lights(s, true, event->position, event->direction_out,
                    event->weight);
        break;
    case MURK_EVENT_LOST:
        s->lost += !s->is_stopped;
        break;
    case MURK_EVENT_WRAPPED:
        s->left = event->position;
        s->has_wrapped = true;
        break;
    case MURK_EVENT_EMITTED:
        break;
    }
}

/* ---- rays ---- */

/* The cosine of the angle at the edge of the forward peak, within which the
 * density is above PEAK_PER_SR; 1 if there is no peak. */
static double cone_of(const murk_phase *phase)
{
    double cone = 1;
    for (int i = 0; i <= PEAK_STEPS; ++i) {
        const double mu = cos(MURK_PI * i / PEAK_STEPS);
        if (murk_phase_density(phase, mu) <= PEAK_PER_SR) {
            break;
        }
        cone = mu;
    }
    return cone;
}

static double *cones_of(const murk_transport_world *world)
{
    const size_t bands = (size_t)world->bands;
    const size_t n = murk_media_count(world->media);
    double *cone = malloc((n * bands + 1) * sizeof *cone);
    for (size_t i = 0; cone && i < n * bands; ++i) {
        cone[i] = cone_of(
            murk_media_phase(world->media, i / bands, (int)(i % bands)));
    }
    return cone;
}

murk_status murk_sampler_create(murk_sampler **out, const murk_scenery *scenery,
                                murk_render_method method,
                                const murk_gather *gather,
                                const murk_trace *trace, murk_error *err)
{
    murk_sampler *s = calloc(1, sizeof *s);
    double *cone = cones_of(scenery->world);
    if (!s || !cone) {
        free(s);
        free(cone);
        return murk_no_memory(err, "render", "for a ray");
    }
    /* The ray is followed as a photon is, with sinks of its own. */
    s->cone = cone;
    s->scenery = scenery;
    s->method = method;
    s->gather = gather;
    s->seed = trace->seed;
    s->purpose = MURK_SHINE + MURK_STREAM * trace->stream;
    murk_trace own = *trace;
    own.world = scenery->world;
    own.sink = receive_event;
    own.segment_sink = receive_segment;
    own.context = s;
    const murk_status status = murk_follower_create(&s->follower, &own, err);
    if (status) {
        free(cone);
        free(s);
        return status;
    }
    *out = s;
    return MURK_OK;
}

void murk_sampler_destroy(murk_sampler *sampler)
{
    if (sampler) {
        murk_follower_destroy(sampler->follower);
        free(sampler->cone);
        free(sampler);
    }
}

murk_found murk_sampler_trace(murk_sampler *s, uint64_t number, int band,
                              murk_vec3 from, murk_vec3 sight,
                              double group[MURK_GATHER_GROUPS])
{
    s->number = number;
    s->group = group;
    s->band = band;
    s->own_index = 0;
    s->is_connected = s->is_settled = s->is_stopped = s->has_wrapped = false;
    s->meets_light = false;
    s->radiance[SURFACE] = s->radiance[VOLUME] = 0;
    murk_follow_photon(s->follower, number, band, from, sight);
    const double square = s->own_index * s->own_index;
    return (murk_found){.surface = square * s->radiance[SURFACE],
                        .volume = square * s->radiance[VOLUME],
                        .meets_light = s->meets_light};
}

uint64_t murk_sampler_lost(const murk_sampler *sampler)
{
    return sampler->lost;
}
