/* How rays and media meet: every region gives the stretch of the ray inside
 * it; the ends of all stretches cut the ray into pieces on each of which the
 * same regions are present; a piece is crossed in closed form, by one march
 * through one grid, or by several grids' marches side by side; or, where the
 * flight throws dice, by delta tracking (delta.h). Optical depth and free
 * flight are one and the same crossing, with and without a limit. */
#include "medium/media.h"

#include "medium/delta.h"
#include "medium/flight.h"

#include <assert.h>
#include <math.h>

typedef murk_flight ray;

/* The part of a ray in one place. */
typedef struct stretch {
    double from, to;
    const murk_place *place;
} stretch;

static double extinction_of(const ray *r, const murk_place *place)
{
    return murk_flight_extinction(r, place);
}

static void meet(ray *r, const murk_place *place, double extinction_per_m)
{
    r->met[r->n_met++] = (murk_meeting){place->medium, extinction_per_m};
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
    r->stop_m = fmin(to, from + (r->limit - r->depth) / extinction_per_m);
    r->depth = r->limit;
    return true;
}

/* Crosses a piece with one grid, in which `even` more is spread evenly. */
static bool cross_grid(ray *r, double from, double to, const murk_place *place,
                       double even_per_m, double *density)
{
    murk_march march;
    murk_place_march(place, r->origin, r->direction, from, to, &march);
    const bool stops = murk_march_integrate(&march, extinction_of(r, place),
                                            even_per_m, r->limit, &r->depth);
    r->stop_m = march.to;
    *density = march.value;
    return stops;
}

/* Crosses a piece with several grids: to the nearest end of their segments,
 * over and over. */
static bool cross_grids(ray *r, double from, double to,
                        const murk_place *const *places, size_t n,
                        double even_per_m, double *density)
{
    murk_march march[MURK_REGIONS_MAX];
    for (size_t i = 0; i < n; ++i) {
        murk_place_march(places[i], r->origin, r->direction, from, to,
                         &march[i]);
    }
    while (from < to) {
        double total = even_per_m, least = to;
        for (size_t i = 0; i < n; ++i) {
            while (march[i].to <= from && murk_march_next(&march[i])) {
            }
            density[i] = march[i].value;
            total += extinction_of(r, places[i]) * density[i];
            least = fmin(least, march[i].to);
        }
        if (cross_even(r, from, least, total)) {
            return true;
        }
        from = least;
    }
    return false;
}

/* Crosses a piece with grids; density[n] is theirs where the ray stops. */
static bool cross_with_grids(ray *r, double from, double to,
                             const murk_place *const *grids, size_t n,
                             double even_per_m, double *density)
{
    if (r->dice) {
        if (murk_delta_cross(r, &from, to, grids, n, even_per_m, density)) {
            return true;
        }
        if (!(from < to)) {
            return false;
        }
    }
    return n == 1 ? cross_grid(r, from, to, grids[0], even_per_m, density)
                  : cross_grids(r, from, to, grids, n, even_per_m, density);
}

/* Crosses a piece in which exactly these places are present. */
static bool cross_piece(ray *r, double from, double to,
                        const murk_place *const *present, size_t n)
{
    const murk_place *grids[MURK_REGIONS_MAX];
    double density[MURK_REGIONS_MAX];
    size_t n_grids = 0;
    double even = 0;
    for (size_t i = 0; i < n; ++i) {
        if (present[i]->tree) {
            grids[n_grids++] = present[i];
        } else {
            even += extinction_of(r, present[i]);
        }
    }
    const bool stops = n_grids == 0 ? cross_even(r, from, to, even)
                                    : cross_with_grids(r, from, to, grids,
                                                       n_grids, even, density);
    if (stops) {
        size_t grid = 0;
        for (size_t i = 0; i < n; ++i) {
            const double value = present[i]->tree ? density[grid++] : 1;
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
            if (stretches[i].place->replaces) {
                n_present = 0;
            }
            present[n_present++] = stretches[i].place;
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
    double ends[2 * MURK_REGIONS_MAX];
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
    const double extinction = extinction_of(r, only->place);
    double density = 1;
    const bool stops = only->place->tree
                           ? cross_with_grids(r, only->from, only->to,
                                              &only->place, 1, 0, &density)
                           : cross_even(r, only->from, only->to, extinction);
    if (stops) {
        meet(r, only->place, density * extinction);
    }
    return stops;
}

/* Follows the ray until its depth reaches the limit (true) or its length is
 * used up. A place that neither extinguishes nor hides others is left out. */
static bool follow(ray *r, double length_m)
{
    stretch stretches[MURK_REGIONS_MAX];
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
        double from = 0, to = length_m;
        if (murk_place_clip(place, &r->origin, &r->direction, &from, &to)) {
            stretches[n++] = (stretch){from, to, place};
        }
    }
    return n == 0   ? false
           : n == 1 ? cross_alone(r, &stretches[0])
                    : cross_overlapping(r, stretches, n);
}

static bool fly(ray *r, double length_m, murk_collision *collision)
{
    const murk_media *media = r->media;
    const int band = r->band;
    assert(band >= 0 && band < MURK_BANDS_MAX);
    r->depth = 0;
    r->n_met = 0;
    if (!media->in_band[band] || !follow(r, length_m)) {
        return false;
    }
    double total = 0, scattering = 0;
    for (size_t i = 0; i < r->n_met; ++i) {
        const murk_meeting *met = &r->met[i];
        total += met->extinction_per_m;
        scattering +=
            met->extinction_per_m * media->media[met->medium].albedo.band[band];
    }
    /* The last with any extinction is left for a u that rounding puts past
     * the end. */
    size_t partner = r->met[0].medium;
    double left = r->u * total;
    for (size_t i = 0; i < r->n_met && left >= 0; ++i) {
        if (r->met[i].extinction_per_m > 0) {
            partner = r->met[i].medium;
            left -= r->met[i].extinction_per_m;
        }
    }
    *collision =
        (murk_collision){.distance_m = r->stop_m,
                         .medium = partner,
                         .albedo = media->media[partner].albedo.band[band],
                         .phase = &media->media[partner].phase[band],
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
