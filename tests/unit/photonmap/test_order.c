/* Selecting records, and orders that are slow for careless selections. Work is
 * counted in seconds only against hanging: each case needs some milliseconds, a
 * quadratic one minutes, and ctest's limit ends those. */
#include "check.h"
#include "plain_order.h"
#include "sets.h"

#include "photonmap/order.h"

static bool is_sorted(const murk_photon *photons, size_t n, int axis)
{
    for (size_t i = 1; i < n; ++i) {
        if (plain_compare(&photons[i - 1], &photons[i], axis) > 0) {
            return false;
        }
    }
    return true;
}

/* Moves the set so that coordinates have both signs, and so have zeros. */
static void center(murk_photon *photons, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        for (int a = 0; a < 3; ++a) {
            float *x = &photons[i].position_m[a];
            *x -= 2;
            *x = *x == 0 && i % 2 ? -0.0F : *x;
        }
    }
}

/* Against the sorted order. */
static void test_select_puts_the_right_record_in_place(void)
{
    for (uint32_t i = 0; i < 600; ++i) {
        const photon_set set = (photon_set)(i % PHOTON_SETS);
        const int axis = (int)(i % 3);
        const murk_random4 r = murk_random(4, MURK_TEST, i, 0, 0);
        const size_t n = 1 + (size_t)(2000 * r.u[0] * r.u[0]);
        const size_t k = (size_t)(r.u[1] * (double)n);
        murk_photon *photons = make_photons(set, n, i);
        if (r.u[2] < 0.5) {
            center(photons, n);
        }
        murk_photon *sorted = malloc(n * sizeof *sorted);
        CHECK(sorted != NULL);
        memcpy(sorted, photons, n * sizeof *sorted);
        plain_sort(sorted, n, axis);
        murk_order_select(photons, n, k, axis);
        CHECK(memcmp(&photons[k], &sorted[k], sizeof *sorted) == 0);
        /* No later record before place k, and no earlier one after it. */
        bool is_split = true;
        for (size_t j = 0; j < n; ++j) {
            is_split =
                is_split &&
                (j < k ? plain_compare(&photons[j], &photons[k], axis) <= 0
                       : plain_compare(&photons[k], &photons[j], axis) <= 0);
        }
        CHECK(is_split);
        free(photons);
        free(sorted);
    }
}

/* A range of coordinates that begins at the float before 2, below 0: bins begin
 * at 0, and the last number before a bin is that of -0. */
static void test_zeros_at_the_edge_of_a_bin(void)
{
    enum { N = 200, LOW = 50 };
    murk_photon photons[N] = {{{0}, 0, 0, 0, 0, 0, 0, 0, 0}};
    for (size_t i = 0; i < N; ++i) {
        photons[i].position_m[0] = i % 4 == 3   ? -0x1.fffffep0F
                                   : i % 4 == 2 ? 1.5F
                                   : i % 4 == 1 ? -0.0F
                                                : 0;
        photons[i].emitted = (uint32_t)i;
    }
    murk_order_select(photons, N, N / 2, 0);
    for (size_t i = 0; i < N; ++i) {
        const float x = photons[i].position_m[0];
        CHECK(i < LOW ? x < 0 : i <= N / 2 ? x == 0 : x >= 0);
    }
}

/* Against the definition, for numbers of records around whole leaves and whole
 * trees, some below and some above the limit for several threads; directions
 * are any bits. */
static void test_order_is_the_defined_one(void)
{
    const size_t numbers[] = {1, 31, 32, 33, 65, 1000, 1025, 9000};
    for (int set = 0; set < PHOTON_SETS; ++set) {
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
            const size_t n = numbers[i];
            murk_photon *photons = make_photons((photon_set)set, n, 3);
            if (((size_t)set + i) % 2 == 0) {
                center(photons, n);
            }
            for (size_t k = 0; k < n; ++k) {
                photons[k].direction = (uint32_t)k * UINT32_C(2654435769);
            }
            /* Order a copy by the definition, and compare. */
            murk_photon *plain = malloc(n * sizeof *plain);
            CHECK(plain != NULL);
            memcpy(plain, photons, n * sizeof *plain);
            size_t leaves = 1;
            while (leaves * MURK_LEAF < n) {
                leaves *= 2;
            }
            plain_order(plain, n, leaves);
            CHECK(murk_order(photons, n, 2));
            CHECK(memcmp(photons, plain, n * sizeof *plain) == 0);
            free(plain);
            free(photons);
        }
    }
}

typedef enum arrangement {
    ALL_EQUAL,  /* every byte */
    SAME_PLACE, /* but other bytes differ */
    TWO_PLACES,
    INCREASING,
    DECREASING,
    PIPES, /* up and down again */
    SAWTOOTH,
    ARRANGEMENTS
} arrangement;

static murk_photon *arrange(arrangement how, size_t n)
{
    murk_photon *photons = calloc(n, sizeof *photons);
    if (!photons) {
        abort();
    }
    for (size_t i = 0; i < n; ++i) {
        const size_t x[ARRANGEMENTS] = {
            5, 5, i % 2, i, n - i, i < n / 2 ? i : n - i, i % 1000};
        for (int a = 0; a < 3; ++a) {
            photons[i].position_m[a] = (float)x[how];
        }
        photons[i].emitted = how == ALL_EQUAL ? 0 : (uint32_t)i;
    }
    return photons;
}

static void test_odd_arrangements_take_no_longer(void)
{
    const size_t n = 300000;
    for (int how = 0; how < ARRANGEMENTS; ++how) {
        murk_photon *photons = arrange((arrangement)how, n);
        CHECK(murk_order(photons, n, 2));
        for (size_t i = 0; i < n; i += 32) { /* leaves are sorted */
            CHECK(is_sorted(photons + i, n - i < 32 ? n - i : 32, 0));
        }
        free(photons);
    }
}

/* A million photons in one place make a map that answers. */
static void test_a_million_copies(void)
{
    const size_t n = 1000000;
    murk_photon *photons = arrange(SAME_PLACE, n);
    murk_photon_map *map = make_map(photons, n, 2);
    uint32_t found[5];
    double distance2[5];
    CHECK(murk_photon_map_count_within(map, murk_vec(5, 5, 5), 0) == n);
    CHECK(murk_photon_map_count_within(map, murk_vec(5, 5, 5.5), 0.4) == 0);
    CHECK(murk_photon_map_nearest(map, murk_vec(5, 5, 6), 5, found,
                                  distance2) == 5);
    for (uint32_t i = 0; i < 5; ++i) {
        CHECK(found[i] == i && distance2[i] == 1);
    }
    murk_photon_map_destroy(map);
    free(photons);
}

int main(void)
{
    test_select_puts_the_right_record_in_place();
    test_zeros_at_the_edge_of_a_bin();
    test_order_is_the_defined_one();
    test_odd_arrangements_take_no_longer();
    test_a_million_copies();
    return check_done();
}
