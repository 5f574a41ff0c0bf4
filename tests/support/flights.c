/* Draws rays through a box, samples one free flight along each, and converts
 * the distance into a number that is uniform if the flights follow the optical
 * depth. */
#include "flights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "medium/delta.h"

typedef struct line {
    murk_vec3 from, along;
    double length;
} line;

/* From a point in the box grown by half to a point in it, and as far again. */
static line line_through(const murk_box *box, uint32_t seed, uint64_t i)
{
    const murk_random4 a = murk_random(seed, MURK_TEST, i, 100, 0);
    const murk_random4 b = murk_random(seed, MURK_TEST, i, 100, 1);
    const murk_vec3 size = murk_sub(box->max, box->min);
    const murk_vec3 from = {box->min.x + (1.5 * a.u[0] - 0.25) * size.x,
                            box->min.y + (1.5 * a.u[1] - 0.25) * size.y,
                            box->min.z + (1.5 * a.u[2] - 0.25) * size.z};
    const murk_vec3 to = {box->min.x + b.u[0] * size.x,
                          box->min.y + b.u[1] * size.y,
                          box->min.z + b.u[2] * size.z};
    const murk_vec3 offset = murk_sub(to, from);
    return (line){from, murk_unit(offset), 2 * murk_length(offset)};
}

static bool fits(const murk_media *media, const line *l,
                 const murk_collision *c)
{
    /* A hair to either side, as rounding may put the place itself beyond a
     * face. */
    const double near = 1e-9 * l->length;
    const double before = murk_media_scattering(
        media, 0, 0, murk_along(l->from, c->distance_m - near, l->along));
    const double behind = murk_media_scattering(
        media, 0, 0, murk_along(l->from, c->distance_m + near, l->along));
    const double minimum = fmin(before, behind), maximum = fmax(before, behind);
    return c->distance_m >= 0 && c->distance_m <= l->length &&
           c->scattering_per_m >= minimum * (1 - 1e-6) &&
           c->scattering_per_m <= maximum * (1 + 1e-6);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

test_flights test_fly(const murk_media *media, const murk_box *box, size_t n,
                      uint32_t seed, bool by_delta)
{
    test_flights f = {.n = n,
                      .y = calloc(n, sizeof *f.y),
                      .partner = calloc(MURK_MEDIA_MAX, sizeof *f.partner)};
    if (!f.y || !f.partner) {
        printf("no memory for %zu flights\n", n);
        exit(1);
    }
    for (size_t i = 0; i < n; ++i) {
        /* One ray, with random numbers of its own. */
        const line l = line_through(box, seed, i);
        const murk_address address = {seed, MURK_TEST, i, 101 + by_delta};
        const murk_random4 r = murk_random_at(&address, 0);
        murk_flight_randoms dice = {.address = &address};
        murk_collision c;
        const double tau = -log(r.u[0]);
        /* One free flight, by delta tracking or by marching. */
        const bool hits = by_delta
                              ? murk_delta_fly(media, 0, 0, l.from, l.along,
                                               l.length, tau, r.u[1], &dice, &c)
                              : murk_media_fly(media, 0, 0, l.from, l.along,
                                               l.length, tau, r.u[1], &c);
        /* Convert the distance by the exact transmittance into a uniform
         * number. */
        const double length = hits ? c.distance_m : l.length;
        const double through = exp(
            -murk_media_optical_depth(media, 0, 0, l.from, l.along, length));
        f.y[i] = 1 - through * (hits ? 1 : r.u[2]);
        /* Count what the flight met. */
        if (hits) {
            ++f.collided;
            ++f.partner[c.medium];
            f.wrong += !fits(media, &l, &c);
        }
        const double tried = dice.nulls + (double)hits;
        f.tried += tried;
        f.tried_squared += tried * tried;
    }
    qsort(f.y, n, sizeof *f.y, ascending);
    return f;
}

void test_flights_free(test_flights *flights)
{
    free(flights->y);
    free(flights->partner);
    *flights = (test_flights){0};
}

double test_flights_off_law(const test_flights *flights)
{
    const double n = (double)flights->n;
    double maximum = 0;
    for (size_t i = 0; i < flights->n; ++i) {
        const double y = flights->y[i];
        maximum =
            fmax(maximum, fmax((double)(i + 1) / n - y, y - (double)i / n));
    }
    return maximum * sqrt(n);
}

double test_flights_distance(const test_flights *a, const test_flights *b)
{
    const double n = (double)a->n, m = (double)b->n;
    double maximum = 0;
    for (size_t i = 0, j = 0; i < a->n && j < b->n;) {
        if (a->y[i] <= b->y[j]) {
            ++i;
        } else {
            ++j;
        }
        maximum = fmax(maximum, fabs((double)i / n - (double)j / m));
    }
    return maximum * sqrt(n * m / (n + m));
}

double test_flights_limit(double budget, double checks)
{
    const double each = -expm1(log1p(-budget) / checks);
    return sqrt(-log(each / 2) / 2);
}
