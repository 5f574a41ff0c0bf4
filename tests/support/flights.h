/* Many free flights through one murk_media, each measured against the exact
 * law: a flight that collides at distance d has y = 1 - exp(-tau(d)), one that
 * does not an even number above 1 - exp(-tau(length)). Then y is even in (0, 1)
 * along any rays, if and only if the flights follow the optical depth. */
#ifndef MURK_TESTS_FLIGHTS_H
#define MURK_TESTS_FLIGHTS_H

#include "medium/media.h"

#include <stddef.h>
#include <stdint.h>

typedef struct test_flights {
    size_t n;
    double *y;       /* [n], ascending; owned */
    double *partner; /* [MURK_MEDIA_MAX]: flights that met this medium; owned */
    double collided; /* flights */
    double tried, tried_squared; /* collisions, real and null: sums over flights
                                    of their number and its square */
    int wrong; /* collisions whose facts do not fit the place */
} test_flights;

/* n rays that start from around the box and inside it and go through it, the
 * same ones for the same seed. by_delta: needs a media prepared for it. */
test_flights test_fly(const murk_media *media, const murk_box *box, size_t n,
                      uint32_t seed, bool by_delta);
void test_flights_free(test_flights *flights);

/* Kolmogorov's distance times sqrt(n), between y and the even distribution, or
 * between the y of two. Above x with probability 2 exp(-2 x^2) at most
 * (Smirnov, Ann. Math. Stat. 19 (1948) 279, doi:10.1214/aoms/1177730256). */
double test_flights_off_law(const test_flights *flights);
double test_flights_distance(const test_flights *a, const test_flights *b);

/* The limit for those at which `checks` of them together raise a false alarm
 * with probability `budget`. */
double test_flights_limit(double budget, double checks);

#endif
