/* Free flight and optical depth through all media.
 *
 * Every region contributes the segment of the ray inside the region. The ends
 * of all segments divide the ray into intervals with the same regions present.
 * An interval with constant extinction is crossed in one step. An interval with
 * grids or profiles is crossed by walks (medium/density_walk.h) that integrate
 * the density exactly, several walks side by side; or, if the flight has a
 * stream of random numbers and no profile is present, by delta tracking
 * (medium/delta.h), which leaves the rest to walks after too many null
 * collisions. Optical depth and free flight are the same crossing, without and
 * with a limit. */
#include "medium/media.h"

#include "medium/albedo.h"
#include "medium/delta.h"
#include "medium/density_walk.h"
#include "medium/flight.h"
#include "medium/lane_regions.h"

#include <assert.h>
#include <math.h>

typedef murk_flight ray;

/* The segment of a ray in one region. */
typedef struct span {
    double from, to;
    const murk_place *place;
    bool hides, fills; /* hides: removes the regions listed before; fills: adds
                          a density of its own */
} span;

/* A region may hide others along its whole shape and fill only a part of it:
 * two segments. */
#define SPANS_MAX (2 * MURK_REGIONS_MAX)

/* Records a medium present at the collision. */
static void add_contributor(ray *r, const murk_place *place,
                            double extinction_per_m)
{
    r->contributor[r->n_contributors++] =
        (murk_flight_contributor){place, extinction_per_m};
}

/* Crosses an interval of constant extinction; true if the collision is in
 * it. */
static inline bool cross_even(ray *r, double from, double to,
                              double extinction_per_m)
{
    if (!(extinction_per_m > 0)) {
        return false;
    }
    const double more = r->depth + extinction_per_m * (to - from);
    if (!(more >= r->limit)) {
        r->depth = more;
        return false;
    }
    const double collision_t = from + (r->limit - r->depth) / extinction_per_m;
    r->collision_m = collision_t < to ? collision_t : to;
    r->depth = r->limit;
    return true;
}

/* Crosses an interval with one grid or profile and a further constant
 * extinction even_per_m; true if the collision is in the interval. */
static bool cross_walk(ray *r, double from, double to, const murk_place *place,
                       double even_per_m, double *density)
{
    murk_density_walk walk;
    double collision_t = to;
    murk_density_walk_begin(&walk, place, r->band, r->origin, r->direction,
                            from, to);
    const bool collides = murk_density_walk_integrate(
        &walk, murk_flight_extinction(r, place), even_per_m, r->limit,
        &r->depth, &collision_t, density);
    r->collision_m = collision_t;
    return collides;
}

/* Crosses an interval in which the extinction is a cubic; true if the
 * collision is in it. */
static bool cross_cubic(ray *r, double from, double to, const murk_cubic *total)
{
    const double mean = murk_cubic_integral(total, 1);
    if (!(mean > 0)) {
        return false;
    }
    const double depth = mean * (to - from), more = r->depth + depth;
    if (!(more >= r->limit)) {
        r->depth = more;
        return false;
    }
    const double s = murk_cubic_reach(total, (r->limit - r->depth) / depth);
    r->collision_m = fmin(to, from + s * (to - from));
    r->depth = r->limit;
    return true;
}

/* Crosses an interval with several grids or profiles, always to the nearest end
 * of any of their segments. A part in which the sum of the extinctions is
 * constant is crossed by cross_even(). */
static bool cross_walks(ray *r, double from, double to,
                        const murk_place *const *places, size_t n,
                        double even_per_m, double *density)
{
    murk_density_walk walk[MURK_REGIONS_MAX];
    murk_cubic cubic[MURK_REGIONS_MAX];
    /* Start each walk at the beginning of the interval. */
    for (size_t i = 0; i < n; ++i) {
        murk_density_walk_begin(&walk[i], places[i], r->band, r->origin,
                                r->direction, from, to);
    }
    while (from < to) {
        /* Advance the walks whose segment has ended, and find the nearest end
         * of a segment. */
        double min = to;
        for (size_t i = 0; i < n; ++i) {
            while (murk_density_walk_to(&walk[i]) <= from &&
                   murk_density_walk_next(&walk[i])) {
            }
            min = fmin(min, murk_density_walk_to(&walk[i]));
        }
        /* Add the extinctions of all walks on this part. */
        murk_cubic total = {{even_per_m, 0, 0, 0}};
        for (size_t i = 0; i < n; ++i) {
            cubic[i] = murk_density_walk_cubic(&walk[i], from, min);
            murk_cubic_add(&total, murk_flight_extinction(r, places[i]),
                           &cubic[i]);
        }
        /* Cross the part; at a collision report the density of each walk. */
        const bool is_even =
            total.c[1] == 0 && total.c[2] == 0 && total.c[3] == 0;
        const double length = min - from;
        if (is_even ? cross_even(r, from, min, total.c[0])
                    : cross_cubic(r, from, min, &total)) {
            const double s = length > 0 ? (r->collision_m - from) / length : 0;
            for (size_t i = 0; i < n; ++i) {
                density[i] = murk_cubic_value(&cubic[i], s);
            }
            return true;
        }
        from = min;
    }
    return false;
}

static bool are_grids(const murk_place *const *places, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        if (!places[i]->tree) {
            return false;
        }
    }
    return true;
}

/* Crosses an interval with grids or profiles; true, with density[n] set, if the
 * collision is in the interval. Delta tracking needs a stream of random numbers
 * and is used only if no profile is among them, because a profile is crossed
 * faster than a majorant of the profile could be found. */
static bool cross_with_walks(ray *r, double from, double to,
                             const murk_place *const *places, size_t n,
                             double even_per_m, double *density)
{
    if (r->stream && are_grids(places, n)) {
        if (murk_delta_cross(r, &from, to, places, n, even_per_m, density)) {
            return true;
        }
        if (!(from < to)) {
            return false;
        }
    }
    return n == 1 ? cross_walk(r, from, to, places[0], even_per_m, density)
                  : cross_walks(r, from, to, places, n, even_per_m, density);
}

/* Crosses an interval in which exactly these regions are present. */
static bool cross_piece(ray *r, double from, double to,
                        const murk_place *const *present, size_t n)
{
    const murk_place *varying[MURK_REGIONS_MAX];
    double density[MURK_REGIONS_MAX];
    size_t n_varying = 0;
    double even = 0;
    /* Separate regions with a constant density from those with a grid or
     * profile. */
    for (size_t i = 0; i < n; ++i) {
        if (present[i]->filling != MURK_FILLED_EVENLY) {
            varying[n_varying++] = present[i];
        } else {
            even += murk_flight_extinction(r, present[i]);
        }
    }
    const bool collides =
        n_varying == 0
            ? cross_even(r, from, to, even)
            : cross_with_walks(r, from, to, varying, n_varying, even, density);
    if (collides) {
        /* At a collision, record the extinction of every medium present. */
        size_t next = 0;
        for (size_t i = 0; i < n; ++i) {
            const double value =
                present[i]->filling != MURK_FILLED_EVENLY ? density[next++] : 1;
            add_contributor(r, present[i],
                            value * murk_flight_extinction(r, present[i]));
        }
    }
    return collides;
}

/* Lists the regions that fill the whole interval from `from` to `to`, without
 * those before the last one that hides others there. Returns their number. */
static size_t list_present(const span *spans, size_t n, double from, double to,
                           const murk_place **present)
{
    size_t n_present = 0;
    for (size_t i = 0; i < n; ++i) {
        if (spans[i].from <= from && spans[i].to >= to) {
            if (spans[i].hides) {
                n_present = 0;
            }
            if (spans[i].fills) {
                present[n_present++] = spans[i].place;
            }
        }
    }
    return n_present;
}

/* The nearest end of a segment beyond `from`; false if there is none. */
static bool next_end(const span *spans, size_t n, double from, double *next)
{
    bool any = false;
    double nearest = INFINITY; /* a segment may end there, too */
    for (size_t i = 0; i < n; ++i) {
        const double begin = spans[i].from, end = spans[i].to;
        const double ahead = begin > from ? begin : end;
        any = any || ahead > from;
        nearest = ahead > from && ahead < nearest ? ahead : nearest;
    }
    *next = nearest;
    return any;
}

/* Crosses overlapping segments from end to end. Most flights collide in the
 * first interval, so the ends are not sorted in advance. */
static bool cross_overlapping(ray *r, const span *spans, size_t n)
{
    const murk_place *present[MURK_REGIONS_MAX];
    double from = spans[0].from, to;
    for (size_t i = 1; i < n; ++i) {
        from = spans[i].from < from ? spans[i].from : from;
    }
    for (; next_end(spans, n, from, &to); from = to) {
        const size_t n_present = list_present(spans, n, from, to, present);
        if (cross_piece(r, from, to, present, n_present)) {
            return true;
        }
    }
    return false;
}

static bool cross_alone(ray *r, const span *only)
{
    const murk_place *place = only->place;
    const double extinction = murk_flight_extinction(r, place);
    double density = 1;
    const bool collides =
        only->fills &&
        (place->filling != MURK_FILLED_EVENLY
             ? cross_with_walks(r, only->from, only->to, &place, 1, 0, &density)
             : cross_even(r, only->from, only->to, extinction));
    if (collides) {
        add_contributor(r, place, density * extinction);
    }
    return collides;
}

/* Adds the segments of a region whose shape the ray is inside of from `from` to
 * `to`: none if the region neither hides others nor fills any of this part, two
 * if it hides others and fills only a part of it, otherwise one. Returns the
 * number of all segments in the list, of which n were there before. */
static size_t add_spans(const ray *r, const murk_place *place, double from,
                        double to, span *spans, size_t n)
{
    double first = from, last = to;
    const bool fills = murk_place_clip_filling(place, &r->origin, &r->direction,
                                               &first, &last);
    const bool is_whole = fills && first == from && last == to;
    if (place->replaces && !is_whole) {
        spans[n++] = (span){from, to, place, true, false};
    }
    if (fills) {
        spans[n++] =
            (span){first, last, place, place->replaces && is_whole, true};
    }
    return n;
}

/* Follows the ray until the optical depth reaches the limit (true) or the
 * length is used up (false). A region that neither has extinction nor hides
 * others is left out, and so is a mesh that the ray is outside of. */
static bool cross_media(ray *r, double length_m)
{
    span spans[SPANS_MAX];
    size_t n = 0;
    /* cppcheck-suppress ctuuninitvar ; the callers fill all that is read */
    const murk_vec3 o = r->origin, d = r->direction;
    if (isnan(o.x + o.y + o.z + d.x + d.y + d.z + length_m)) {
        return false; /* a NaN collides with nothing; no clipping needs to
                         handle it */
    }
    for (size_t i = 0; i < r->media->n_places; ++i) {
        const murk_place *place = &r->media->places[i];
        if (!place->replaces && !(murk_flight_extinction(r, place) > 0)) {
            continue;
        }
        if (!murk_place_may_hold(place, i, r->inside)) {
            continue;
        }
        /* A flight that goes on beyond the domain does not count (walk.c of
         * transport), so it need not be clipped to a box around the domain. */
        double from = 0, to = length_m;
        const bool is_whole =
            place->is_around && r->limit < INFINITY && length_m > 0;
        if (is_whole ||
            murk_place_clip(place, &r->origin, &r->direction, &from, &to)) {
            n = add_spans(r, place, from, to, spans, n);
        }
    }
    return n == 0   ? false
           : n == 1 ? cross_alone(r, &spans[0])
                    : cross_overlapping(r, spans, n);
}

static double albedo_of(const ray *r, const murk_place *place, murk_vec3 at)
{
    return murk_albedo_at(&r->media->media[place->medium], place, r->band, at);
}

bool murk_media_even(const murk_media *media, int band,
                     double *extinction_per_m, murk_collision *collision)
{
    if (!media->is_even) {
        return false;
    }
    *collision = murk_media_even_collision(media, media->places[0].medium, band,
                                           extinction_per_m);
    return true;
}

/* fly() for a scene that is one homogeneous medium: a short cut, since fly()
 * would spend most of its time on finding out that there is no other region. */
static bool fly_evenly(const ray *r, double length_m, murk_collision *collision)
{
    const murk_vec3 o = r->origin, d = r->direction;
    double extinction;
    murk_media_even(r->media, r->band, &extinction, collision);
    if (!(extinction > 0 && length_m > 0 &&
          extinction * length_m >= r->limit) ||
        isnan(o.x + o.y + o.z + d.x + d.y + d.z)) {
        return false;
    }
    const double distance = r->limit / extinction;
    collision->distance_m = distance < length_m ? distance : length_m;
    return true;
}

static bool fly(ray *r, double length_m, murk_collision *collision)
{
    /* cppcheck-suppress ctuuninitvar ; the callers fill all that is read */
    const murk_media *media = r->media;
    const int band = r->band;
    assert(band >= 0 && band < MURK_BANDS_MAX);
    if (media->is_even) {
        return fly_evenly(r, length_m, collision);
    }
    /* Follow the ray to the collision. */
    r->depth = 0;
    r->n_contributors = 0;
    if (!media->in_band[band] || !cross_media(r, length_m)) {
        return false;
    }
    const murk_vec3 at = murk_along(r->origin, r->collision_m, r->direction);
    /* Sum extinction and scattering over the media present at the collision. */
    double total = 0, scattering = 0;
    for (size_t i = 0; i < r->n_contributors; ++i) {
        const murk_flight_contributor *contributor = &r->contributor[i];
        total += contributor->extinction_per_m;
        scattering += contributor->extinction_per_m *
                      albedo_of(r, contributor->place, at);
    }
    /* Select the medium in proportion to extinction. If rounding puts u past
     * the end, the last medium with an extinction remains. */
    const murk_place *partner = r->contributor[0].place;
    double left = r->u * total;
    for (size_t i = 0; i < r->n_contributors && left >= 0; ++i) {
        if (r->contributor[i].extinction_per_m > 0) {
            partner = r->contributor[i].place;
            left -= r->contributor[i].extinction_per_m;
        }
    }
    *collision =
        (murk_collision){.distance_m = r->collision_m,
                         .medium = partner->medium,
                         .albedo = albedo_of(r, partner, at),
                         .phase = &media->media[partner->medium].phase[band],
                         .scattering_per_m = scattering};
    return true;
}

bool murk_delta_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_flight_randoms *stream,
                    murk_collision *collision)
{
    assert(!stream || media->bound_factor > 0);
    ray r; /* not initialised as a whole: the list of media is long */
    r.media = media;
    r.band = band;
    r.inside = inside;
    r.origin = origin;
    r.direction = direction;
    r.limit = tau;
    r.u = u;
    r.stream = stream;
    return fly(&r, length_m, collision);
}

bool murk_media_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_collision *collision)
{
    return murk_delta_fly(media, band, inside, origin, direction, length_m, tau,
                          u, NULL, collision);
}

bool murk_media_fly_delta(const murk_media *media, int band, murk_inside inside,
                          murk_vec3 origin, murk_vec3 direction,
                          double length_m, double tau, double u,
                          const murk_address *address,
                          murk_collision *collision)
{
    murk_flight_randoms stream = {.address = address};
    return murk_delta_fly(media, band, inside, origin, direction, length_m, tau,
                          u, &stream, collision);
}

double murk_media_optical_depth(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 origin,
                                murk_vec3 direction, double length_m)
{
    assert(band >= 0 && band < MURK_BANDS_MAX);
    ray r;
    r.media = media;
    r.band = band;
    r.inside = inside;
    r.origin = origin;
    r.direction = direction;
    r.depth = 0;
    r.limit = INFINITY;
    r.stream = NULL;
    r.n_contributors = 0;
    if (media->in_band[band]) {
        cross_media(&r, length_m);
    }
    return r.depth;
}

double murk_media_transmittance(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 from,
                                murk_vec3 to)
{
    const murk_vec3 offset = murk_sub(to, from);
    const double length = murk_length(offset);
    if (!(length > 0) || !media->in_band[band]) {
        return 1;
    }
    return exp(-murk_media_optical_depth(
        media, band, inside, from, murk_scale(1 / length, offset), length));
}
