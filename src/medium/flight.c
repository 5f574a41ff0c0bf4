/* How rays and media meet: every region gives the stretch of the ray inside
 * it; the ends of all stretches cut the ray into pieces on each of which the
 * same regions are present; a piece is crossed in closed form, by one course
 * through one grid or profile, or by several courses side by side; or, where
 * the flight throws dice, by delta tracking (delta.h). Optical depth and free
 * flight are one and the same crossing, with and without a limit. */
#include "medium/media.h"

#include "medium/albedo.h"
#include "medium/course.h"
#include "medium/delta.h"
#include "medium/flight.h"

#include <assert.h>
#include <math.h>

typedef murk_flight ray;

/* The part of a ray in one place. */
typedef struct stretch {
    double from, to;
    const murk_place *place;
    bool hides, fills; /* takes the place of what is listed before; adds its
                          own density */
} stretch;

/* A place may hide along its shape and fill a part of that. */
#define STRETCHES_MAX (2 * MURK_REGIONS_MAX)

static double extinction_of(const ray *r, const murk_place *place)
{
    return murk_flight_extinction(r, place);
}

static void meet(ray *r, const murk_place *place, double extinction_per_m)
{
    r->met[r->n_met++] = (murk_meeting){place, extinction_per_m};
}

/* Crosses a piece of even extinction; true when the ray stops in it. */
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
    const double stop = from + (r->limit - r->depth) / extinction_per_m;
    r->stop_m = stop < to ? stop : to;
    r->depth = r->limit;
    return true;
}

/* Crosses a piece with one course, in which `even` more is spread evenly. */
static bool cross_course(ray *r, double from, double to,
                         const murk_place *place, double even_per_m,
                         double *density)
{
    murk_flight_state course;
    double stop = to;
    murk_course_begin(&course, place, r->band, r->origin, r->direction, from,
                      to);
    const bool stops =
        murk_course_integrate(&course, extinction_of(r, place), even_per_m,
                              r->limit, &r->depth, &stop, density);
    r->stop_m = stop;
    return stops;
}

/* Crosses a part in which the extinction is a cubic; true when the ray stops
 * in it. */
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
    r->stop_m = fmin(to, from + s * (to - from));
    r->depth = r->limit;
    return true;
}

/* Crosses a piece with several courses: to the nearest end of their segments,
 * over and over. A part of even extinction is crossed as everywhere else. */
static bool cross_courses(ray *r, double from, double to,
                          const murk_place *const *places, size_t n,
                          double even_per_m, double *density)
{
    murk_flight_state course[MURK_REGIONS_MAX];
    murk_cubic cubic[MURK_REGIONS_MAX];
    for (size_t i = 0; i < n; ++i) {
        murk_course_begin(&course[i], places[i], r->band, r->origin,
                          r->direction, from, to);
    }
    while (from < to) {
        double min = to;
        for (size_t i = 0; i < n; ++i) {
            while (murk_course_to(&course[i]) <= from &&
                   murk_course_next(&course[i])) {
            }
            min = fmin(min, murk_course_to(&course[i]));
        }
        murk_cubic total = {{even_per_m, 0, 0, 0}};
        for (size_t i = 0; i < n; ++i) {
            cubic[i] = murk_course_cubic(&course[i], from, min);
            murk_cubic_add(&total, extinction_of(r, places[i]), &cubic[i]);
        }
        const bool is_even =
            total.c[1] == 0 && total.c[2] == 0 && total.c[3] == 0;
        const double length = min - from;
        if (is_even ? cross_even(r, from, min, total.c[0])
                    : cross_cubic(r, from, min, &total)) {
            const double s = length > 0 ? (r->stop_m - from) / length : 0;
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

/* Crosses a piece with courses; density[n] is theirs where the ray stops.
 * Delta tracking is for grids: a profile is crossed faster than bounded. */
static bool cross_with_courses(ray *r, double from, double to,
                               const murk_place *const *places, size_t n,
                               double even_per_m, double *density)
{
    if (r->dice && are_grids(places, n)) {
        if (murk_delta_cross(r, &from, to, places, n, even_per_m, density)) {
            return true;
        }
        if (!(from < to)) {
            return false;
        }
    }
    return n == 1 ? cross_course(r, from, to, places[0], even_per_m, density)
                  : cross_courses(r, from, to, places, n, even_per_m, density);
}

/* Crosses a piece in which exactly these places are present. */
static bool cross_piece(ray *r, double from, double to,
                        const murk_place *const *present, size_t n)
{
    const murk_place *courses[MURK_REGIONS_MAX];
    double density[MURK_REGIONS_MAX];
    size_t n_courses = 0;
    double even = 0;
    for (size_t i = 0; i < n; ++i) {
        if (present[i]->filling != MURK_FILLED_EVENLY) {
            courses[n_courses++] = present[i];
        } else {
            even += extinction_of(r, present[i]);
        }
    }
    const bool stops = n_courses == 0
                           ? cross_even(r, from, to, even)
                           : cross_with_courses(r, from, to, courses, n_courses,
                                                even, density);
    if (stops) {
        size_t course = 0;
        for (size_t i = 0; i < n; ++i) {
            const double value = present[i]->filling != MURK_FILLED_EVENLY
                                     ? density[course++]
                                     : 1;
            meet(r, present[i], value * extinction_of(r, present[i]));
        }
    }
    return stops;
}

/* The places that count between two neighbouring ends: those present, from
 * the last that replaces on. */
static size_t list_present(const stretch *stretches, size_t n, double from,
                           double to, const murk_place **present)
{
    size_t n_present = 0;
    for (size_t i = 0; i < n; ++i) {
        if (stretches[i].from <= from && stretches[i].to >= to) {
            if (stretches[i].hides) {
                n_present = 0;
            }
            if (stretches[i].fills) {
                present[n_present++] = stretches[i].place;
            }
        }
    }
    return n_present;
}

/* All ends of the stretches, in order: n of them twice. */
static void sort_ends(const stretch *stretches, size_t n, double *ends)
{
    size_t n_ends = 0;
    for (size_t i = 0; i < 2 * n; ++i) {
        const double end = i & 1 ? stretches[i / 2].to : stretches[i / 2].from;
        size_t at = n_ends++;
        /* cppcheck-suppress uninitvar ; the first n_ends are filled */
        for (; at > 0 && ends[at - 1] > end; --at) {
            ends[at] = ends[at - 1];
        }
        ends[at] = end;
    }
}

static bool cross_overlapping(ray *r, const stretch *stretches, size_t n)
{
    double ends[2 * STRETCHES_MAX];
    const murk_place *present[MURK_REGIONS_MAX];
    sort_ends(stretches, n, ends);
    for (size_t i = 0; i + 1 < 2 * n; ++i) {
        if (ends[i] < ends[i + 1]) {
            const size_t n_present =
                list_present(stretches, n, ends[i], ends[i + 1], present);
            if (cross_piece(r, ends[i], ends[i + 1], present, n_present)) {
                return true;
            }
        }
    }
    return false;
}

static bool cross_alone(ray *r, const stretch *only)
{
    const murk_place *place = only->place;
    const double extinction = extinction_of(r, place);
    double density = 1;
    const bool stops =
        only->fills && (place->filling != MURK_FILLED_EVENLY
                            ? cross_with_courses(r, only->from, only->to,
                                                 &place, 1, 0, &density)
                            : cross_even(r, only->from, only->to, extinction));
    if (stops) {
        meet(r, place, density * extinction);
    }
    return stops;
}

/* Adds the stretches of a place that the ray is in from one end to the other:
 * one, or, where it fills only a part of what it hides, two. Returns how many
 * there are now. */
static size_t add_stretches(const ray *r, const murk_place *place, double from,
                            double to, stretch *stretches, size_t n)
{
    double first = from, last = to;
    const bool fills = murk_place_clip_filling(place, &r->origin, &r->direction,
                                               &first, &last);
    const bool is_whole = fills && first == from && last == to;
    if (place->replaces && !is_whole) {
        stretches[n++] = (stretch){from, to, place, true, false};
    }
    if (fills) {
        stretches[n++] =
            (stretch){first, last, place, place->replaces && is_whole, true};
    }
    return n;
}

/* Follows the ray until its depth reaches the limit (true) or its length is
 * used up. A place that neither extinguishes nor hides others is left out. */
static bool follow(ray *r, double length_m)
{
    stretch stretches[STRETCHES_MAX];
    size_t n = 0;
    /* cppcheck-suppress ctuuninitvar ; the callers fill all that is read */
    const murk_vec3 o = r->origin, d = r->direction;
    if (isnan(o.x + o.y + o.z + d.x + d.y + d.z + length_m)) {
        return false; /* meets nothing; no clipping has to think of it */
    }
    for (size_t i = 0; i < r->media->n_places; ++i) {
        const murk_place *place = &r->media->places[i];
        if (!place->replaces && !(extinction_of(r, place) > 0)) {
            continue;
        }
        if (!murk_place_may_hold(place, i, r->inside)) {
            continue;
        }
        double from = 0, to = length_m;
        if (murk_place_clip(place, &r->origin, &r->direction, &from, &to)) {
            n = add_stretches(r, place, from, to, stretches, n);
        }
    }
    return n == 0   ? false
           : n == 1 ? cross_alone(r, &stretches[0])
                    : cross_overlapping(r, stretches, n);
}

static double albedo_of(const ray *r, const murk_place *place, murk_vec3 at)
{
    return murk_albedo_at(&r->media->media[place->medium], place, r->band, at);
}

/* What fly() comes to in a world of one even medium, which most of a photon's
 * time would else go into finding out. */
static bool fly_evenly(const ray *r, double length_m, murk_collision *collision)
{
    const murk_vec3 o = r->origin, d = r->direction;
    const size_t number = r->media->places[0].medium;
    const murk_medium *medium = &r->media->media[number];
    const double extinction = medium->extinction_per_m.band[r->band];
    if (!(extinction > 0 && length_m > 0 &&
          extinction * length_m >= r->limit) ||
        isnan(o.x + o.y + o.z + d.x + d.y + d.z)) {
        return false;
    }
    const double distance = r->limit / extinction;
    const double albedo = medium->albedo.band[r->band];
    *collision = (murk_collision){.distance_m =
                                      distance < length_m ? distance : length_m,
                                  .medium = number,
                                  .albedo = albedo,
                                  .phase = &medium->phase[r->band],
                                  .scattering_per_m = extinction * albedo};
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
    r->depth = 0;
    r->n_met = 0;
    if (!media->in_band[band] || !follow(r, length_m)) {
        return false;
    }
    const murk_vec3 at = murk_along(r->origin, r->stop_m, r->direction);
    double total = 0, scattering = 0;
    for (size_t i = 0; i < r->n_met; ++i) {
        const murk_meeting *met = &r->met[i];
        total += met->extinction_per_m;
        scattering += met->extinction_per_m * albedo_of(r, met->place, at);
    }
    /* The last with any extinction is left for a u that rounding puts past
     * the end. */
    const murk_place *partner = r->met[0].place;
    double left = r->u * total;
    for (size_t i = 0; i < r->n_met && left >= 0; ++i) {
        if (r->met[i].extinction_per_m > 0) {
            partner = r->met[i].place;
            left -= r->met[i].extinction_per_m;
        }
    }
    *collision =
        (murk_collision){.distance_m = r->stop_m,
                         .medium = partner->medium,
                         .albedo = albedo_of(r, partner, at),
                         .phase = &media->media[partner->medium].phase[band],
                         .scattering_per_m = scattering};
    return true;
}

bool murk_media_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_collision *collision)
{
    ray r;
    r.media = media;
    r.band = band;
    r.inside = inside;
    r.origin = origin;
    r.direction = direction;
    r.limit = tau;
    r.u = u;
    r.dice = NULL;
    return fly(&r, length_m, collision);
}

bool murk_delta_fly(const murk_media *media, int band, murk_inside inside,
                    murk_vec3 origin, murk_vec3 direction, double length_m,
                    double tau, double u, murk_dice *dice,
                    murk_collision *collision)
{
    assert(media->bound_factor > 0);
    ray r;
    r.media = media;
    r.band = band;
    r.inside = inside;
    r.origin = origin;
    r.direction = direction;
    r.limit = tau;
    r.u = u;
    r.dice = dice;
    return fly(&r, length_m, collision);
}

bool murk_media_fly_delta(const murk_media *media, int band, murk_inside inside,
                          murk_vec3 origin, murk_vec3 direction,
                          double length_m, double tau, double u,
                          const murk_address *address,
                          murk_collision *collision)
{
    murk_dice dice = {.address = address};
    return murk_delta_fly(media, band, inside, origin, direction, length_m, tau,
                          u, &dice, collision);
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
    r.dice = NULL;
    r.n_met = 0;
    if (media->in_band[band]) {
        follow(&r, length_m);
    }
    return r.depth;
}

double murk_media_transmittance(const murk_media *media, int band,
                                murk_inside inside, murk_vec3 from,
                                murk_vec3 to)
{
    const murk_vec3 way = murk_sub(to, from);
    const double length = murk_length(way);
    if (!(length > 0) || !media->in_band[band]) {
        return 1;
    }
    return exp(-murk_media_optical_depth(media, band, inside, from,
                                         murk_scale(1 / length, way), length));
}
