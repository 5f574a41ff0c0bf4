/* Surfaces on the rays of photons side by side (transport/lanes_surfaces.h).
 *
 * The order of events is that of the walker (transport/walk.c): the nearest
 * surface or side of the domain, and a collision before it. The walker ends the
 * flight there, and the lanes compute the flight without end and compare. Both
 * find the same collision, because an end beyond the collision enters no sum of
 * optical depths before it: the operations up to there are the same. Only if
 * the two lie within NEAR of each other may rounding decide, and then the
 * walker finds the event. */
#include "transport/lanes_surfaces.h"

#include "base/philox.h"
#include "transport/meet.h"

/* Two events nearer to each other than this share of their distance, or of the
 * optical depth to the collision, count as near: thousands of times the
 * rounding of the last step of a flight. Cost: some two in 10^9 events are
 * found twice. */
#define NEAR 1e-9

/* True if a surface of the material, met outside of all solids, either reflects
 * light of this band diffusely or absorbs it. */
static bool is_plain(const murk_walker *w, const murk_hit *hit)
{
    const murk_material *m =
        murk_surfaces_material(w->setup->world->surfaces, hit->material);
    return m->specular.band[w->band] == 0 && m->transmit.band[w->band] == 0;
}

void murk_lane_find(murk_lane_ahead *a, murk_walker *w, murk_photon_lanes *l,
                    size_t i, double extinction_per_m)
{
    const bool flies = l->meets[i] != 0;
    a->next = MURK_LANE_UNKNOWN;
    l->meets[i] = 0;
    /* A photon with too many events or in a solid is the walker's. */
    if (l->number[i] > w->setup->trace->events_max || w->solids.n > 0) {
        return;
    }
    /* The ray; the walker of a new photon knows where the search begins. */
    const murk_vec3 position = {l->ray.x[i], l->ray.y[i], l->ray.z[i]};
    w->path.position = position;
    w->path.direction = murk_vec(l->ray.dx[i], l->ray.dy[i], l->ray.dz[i]);
    if (l->is_new[i] == 0) {
        w->probe = position;
        w->event_class = MURK_CLASS_LATER;
        w->wraps = 0;
    }
    /* The event, up to the end of the flight. A flight beyond the side of the
     * domain may still end before a surface that lies just outside. */
    const double flight_m = l->distance_m[i];
    const double near_m =
        flies ? NEAR * (flight_m + l->tau[i] / extinction_per_m) : 0;
    if (!murk_path_first_event(&w->path, w->probe, NULL,
                               flies ? flight_m + near_m : INFINITY,
                               &a->ahead) ||
        (flies && a->ahead.kind == MURK_PATH_SIDE &&
         a->ahead.distance_m < flight_m &&
         !murk_path_first_event(&w->path, w->probe, NULL, INFINITY,
                                &a->ahead))) {
        return;
    }
    /* The nearer of the two. */
    const double event_m = a->ahead.distance_m;
    if (flies && fabs(flight_m - event_m) <= near_m) {
        return;
    }
    if (flies && flight_m < event_m) {
        l->meets[i] = 1;
        a->next = MURK_LANE_COLLIDES;
        return;
    }
    a->next = a->ahead.kind == MURK_PATH_SURFACE && is_plain(w, &a->ahead.hit)
                  ? MURK_LANE_REFLECTS
                  : MURK_LANE_MEETS;
}

void murk_lane_reflect(murk_lane_ahead *a, murk_walker *w, murk_photon_lanes *l,
                       size_t i)
{
    const murk_surfaces *surfaces = w->setup->world->surfaces;
    const murk_hit *hit = &a->ahead.hit;
    const double diffuse =
        murk_surfaces_material(surfaces, hit->material)->diffuse.band[w->band];
    /* Move to the surface. */
    w->path.position = murk_along(w->probe, hit->distance_m, w->path.direction);
    /* Split the packet, or leave the absorbed share to roulette, as
     * murk_meet_surface() does. */
    double u = murk_uniform((uint32_t)l->surface_word[0][i]);
    w->quanta = a->before = (int64_t)l->ray.quanta[i];
    if (diffuse < 1 &&
        murk_walker_splits(w, diffuse,
                           murk_uniform((uint32_t)l->surface_word[2][i]),
                           MURK_FATE_SURFACES, hit->material)) {
        u = w->quanta > 0 ? u * diffuse : 1;
        l->ray.quanta[i] = (double)w->quanta;
    }
    if (!(u <= diffuse)) {
        return; /* absorbed */
    }
    /* Continue clear of the surface, by the cosine law. */
    const murk_vec3 clear =
        murk_surfaces_leave(surfaces, w->path.position, hit->normal);
    l->ray.x[i] = clear.x;
    l->ray.y[i] = clear.y;
    l->ray.z[i] = clear.z;
    l->ray.dx[i] = hit->normal.x;
    l->ray.dy[i] = hit->normal.y;
    l->ray.dz[i] = hit->normal.z;
    l->cosine[i] = sqrt(murk_uniform((uint32_t)l->surface_word[1][i]));
    l->azimuth[i] = murk_uniform((uint32_t)l->surface_word[2][i]);
    l->scatters[i] = 1;
    l->is_new[i] = 0;
}

void murk_lane_reflected(const murk_lane_ahead *a, murk_walker *w,
                         const murk_photon_lanes *l, size_t i, murk_vec3 from)
{
    const bool leaves = l->scatters[i] != 0;
    w->number = (uint32_t)l->number[i];
    murk_walker_score(w, from, a->ahead.distance_m, a->before, w->path.position,
                      w->setup->in_plane_m);
    if (murk_walker_is_heard(w) && (leaves || !w->setup->trace->skips_ends)) {
        const murk_bounce bounce = {
            leaves ? MURK_DIFFUSE : MURK_ABSORBED,
            leaves ? murk_vec(l->ray.dx[i], l->ray.dy[i], l->ray.dz[i])
                   : murk_vec(0, 0, 0)};
        murk_meet_tell_surface(w, &a->ahead.hit, a->ahead.distance_m, a->before,
                               &bounce);
        w->event_class = MURK_CLASS_LATER;
    }
}

murk_fate murk_lane_meet(const murk_lane_ahead *a, murk_walker *w)
{
    const double distance_m = a->ahead.distance_m;
    return a->ahead.kind == MURK_PATH_SURFACE
               ? murk_meet_surface(w, &a->ahead.hit, distance_m, 0)
               : murk_meet_side(w, distance_m);
}
