/* A photon map finds what looking at every photon finds, to the bit. Nothing
 * here is statistical: it never cries wolf. */
#include "check.h"
#include "sets.h"

static const double radii[] = {0, 1e-30, 0.01, 0.25, 0.5, 1, 2.5, 7, 20, 1e30};

#define RADII (sizeof radii / sizeof radii[0])

/* The twin. */
static size_t within_by_looking(const murk_photon_map *map, murk_vec3 center,
                                double radius_m, uint32_t *found)
{
    const murk_photon *photons = murk_photon_map_photons(map);
    const float radius = (float)radius_m;
    size_t n = 0;
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        if (distance2_to(&photons[i], center) <= radius * radius) {
            found[n++] = (uint32_t)i;
        }
    }
    return n;
}

static size_t nearest_by_looking(const murk_photon_map *map, murk_vec3 center,
                                 size_t k, uint32_t *found, double *distance2)
{
    const murk_photon *photons = murk_photon_map_photons(map);
    size_t n = 0;
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        const double d = (double)distance2_to(&photons[i], center);
        size_t j = n < k ? n++ : k;
        if (j == k && (k == 0 || !(d < distance2[k - 1]))) {
            continue;
        }
        for (j = j < k ? j : k - 1; j > 0 && d < distance2[j - 1]; --j) {
            distance2[j] = distance2[j - 1];
            found[j] = found[j - 1];
        }
        distance2[j] = d;
        found[j] = (uint32_t)i;
    }
    return n;
}

/* At photons, on a lattice, and outside of all. */
static murk_vec3 center_of(const murk_photon_map *map, uint32_t query)
{
    const murk_random4 r = murk_random(7, MURK_TEST, query, 2, 0);
    const size_t n = murk_photon_map_count(map);
    if (query % 3 == 0 && n > 0) {
        const float *p =
            murk_photon_map_photons(map)[(size_t)(r.u[0] * (double)n)]
                .position_m;
        return murk_vec((double)p[0], (double)p[1], (double)p[2]);
    }
    if (query % 3 == 1) {
        return murk_vec(floor(32 * r.u[0]) / 4, floor(20 * r.u[1]) / 4,
                        floor(12 * r.u[2]) / 4);
    }
    return murk_vec(20 * r.u[0] - 6, 20 * r.u[1] - 6, 20 * r.u[2] - 6);
}

static size_t compare_within(const murk_photon_map *map, murk_vec3 center,
                             double radius_m, uint32_t *found, uint32_t *want)
{
    const size_t n = murk_photon_map_within(map, center, radius_m, found);
    const size_t wanted = within_by_looking(map, center, radius_m, want);
    const bool same = n == wanted && memcmp(found, want, n * sizeof *want) == 0;
    CHECK(same);
    CHECK(murk_photon_map_count_within(map, center, radius_m) == wanted);
    /* The records of the map as a list. */
    CHECK(murk_photons_within(murk_photon_map_photons(map),
                              murk_photon_map_count(map), center, radius_m,
                              found) == wanted &&
          memcmp(found, want, wanted * sizeof *want) == 0);
    /* And chosen from all of them. */
    const size_t count = murk_photon_map_count(map);
    for (size_t i = 0; i < count; ++i) {
        found[i] = (uint32_t)i;
    }
    CHECK(murk_photons_chosen_within(murk_photon_map_photons(map), found, count,
                                     center, radius_m) == wanted &&
          memcmp(found, want, wanted * sizeof *want) == 0);
    return n;
}

static void compare_nearest(const murk_photon_map *map, murk_vec3 center,
                            size_t k, uint32_t *found, uint32_t *want)
{
    double distance2[200], wanted2[200];
    const size_t n = murk_photon_map_nearest(map, center, k, found, distance2);
    const size_t wanted = nearest_by_looking(map, center, k, want, wanted2);
    CHECK(n == wanted);
    CHECK(memcmp(found, want, n * sizeof *want) == 0);
    CHECK(memcmp(distance2, wanted2, n * sizeof *wanted2) == 0);
}

/* Returns how many photons the ball queries found in all. */
static size_t compare_set(photon_set set, size_t n, uint32_t queries)
{
    murk_photon *photons = make_photons(set, n, (uint32_t)(n + 1));
    murk_photon_map *map = make_map(photons, n, 1);
    uint32_t *found = malloc((n + 1) * sizeof *found);
    uint32_t *want = malloc((n + 1) * sizeof *want);
    size_t all = 0;
    for (uint32_t i = 0; found && want && i < queries; ++i) {
        const murk_vec3 center = center_of(map, i);
        for (size_t j = 0; j < RADII; ++j) {
            all += compare_within(map, center, radii[j], found, want);
        }
        const size_t k[] = {0, 1, 2, 10, 77, 200};
        for (size_t j = 0; j < sizeof k / sizeof k[0]; ++j) {
            compare_nearest(map, center, k[j] < n + 3 ? k[j] : n + 3, found,
                            want);
        }
    }
    free(found);
    free(want);
    murk_photon_map_destroy(map);
    free(photons);
    return all;
}

static void test_small_sets_agree_with_looking(void)
{
    for (size_t n = 0; n <= 200; n += n < 70 ? 1 : 13) {
        for (int set = 0; set < PHOTON_SETS; ++set) {
            const size_t found = compare_set((photon_set)set, n, 6);
            CHECK(found >= 6 * n); /* the last radius finds all */
        }
    }
}

static void test_large_sets_agree_with_looking(void)
{
    for (int set = 0; set < PHOTON_SETS; ++set) {
        CHECK(compare_set((photon_set)set, 20011, 12) > 0);
    }
    CHECK(compare_set(LATTICE_SET, 100000, 6) > 0);
}

static void test_odd_queries_find_nothing(void)
{
    murk_photon *photons = make_photons(RANDOM_SET, 500, 1);
    murk_photon_map *map = make_map(photons, 500, 1);
    uint32_t found[500];
    double distance2[500];
    const murk_vec3 middle = {4, 2.5, 1.5};
    const double odd[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 off = {odd[i], 0, 0};
        CHECK(murk_photon_map_within(map, off, 1, found) == 0);
        CHECK(murk_photon_map_within(map, off, INFINITY, found) == 0);
        CHECK(murk_photon_map_nearest(map, off, 3, found, distance2) == 0);
    }
    /* Odd radii. */
    CHECK(murk_photon_map_within(map, middle, NAN, found) == 0);
    CHECK(murk_photon_map_within(map, middle, -1, found) == 0);
    CHECK(murk_photon_map_count_within(map, middle, -INFINITY) == 0);
    CHECK(murk_photon_map_within(map, middle, INFINITY, found) == 500);
    CHECK(murk_photon_map_within(map, middle, 1e300, found) == 500);
    CHECK(murk_photons_within(photons, 500, middle, 1e300, found) == 500);
    CHECK(murk_photons_within(photons, 500, middle, NAN, found) == 0);
    CHECK(murk_photon_map_within(map, murk_vec(1e38, 0, 0), 1, found) == 0);
    CHECK(murk_photon_map_within(map, murk_vec(1e300, 0, 0), 1, found) == 0);
    murk_photon_map_destroy(map);
    free(photons);
}

/* Photons so far apart that squared distances overflow are still met by
 * infinite balls only. */
static void test_huge_positions_are_fine(void)
{
    murk_photon *photons = make_photons(RANDOM_SET, 100, 1);
    for (size_t i = 0; i < 100; ++i) {
        photons[i].position_m[i % 3] *= i % 2 ? 1e37f : -1e37f;
    }
    murk_photon_map *map = make_map(photons, 100, 1);
    uint32_t found[100], want[100];
    double distance2[100];
    for (size_t j = 0; j < RADII; ++j) {
        compare_within(map, murk_vec(0, 0, 0), radii[j], found, want);
    }
    CHECK(murk_photon_map_nearest(map, murk_vec(1, 1, 1), 100, found,
                                  distance2) == 100);
    murk_photon_map_destroy(map);
    free(photons);
}

static int compare_bytes(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(murk_photon));
}

static void test_no_record_is_lost(void)
{
    const size_t n = 10007;
    murk_photon *photons = make_photons(LATTICE_SET, n, 4);
    murk_photon_map *map = make_map(photons, n, 2);
    murk_photon *ordered = malloc(n * sizeof *ordered);
    if (ordered) {
        memcpy(ordered, murk_photon_map_photons(map), n * sizeof *ordered);
        qsort(ordered, n, sizeof *ordered, compare_bytes);
        qsort(photons, n, sizeof *photons, compare_bytes);
        CHECK(memcmp(ordered, photons, n * sizeof *photons) == 0);
    }
    free(ordered);
    murk_photon_map_destroy(map);
    free(photons);
}

static void test_memory_is_forecast(void)
{
    const size_t n[] = {0, 1, 31, 32, 33, 512, 513, 8192, 8193, 100000};
    for (size_t i = 0; i < sizeof n / sizeof n[0]; ++i) {
        murk_photon *photons = make_photons(RANDOM_SET, n[i], 1);
        murk_photon_map *map = make_map(photons, n[i], 1);
        CHECK(murk_photon_map_memory_for((double)n[i]) ==
              (double)murk_photon_map_memory_bytes(map));
        CHECK(murk_photon_map_count(map) == n[i]);
        murk_photon_map_destroy(map);
        free(photons);
    }
    /* 32 bytes of record, 24 bytes of box for 32 of them and for each 16
     * boxes, and no more. */
    const double tree = murk_photon_map_memory_for(1e8) / 1e8 - 32;
    CHECK_NEAR(tree, 0.75 / (1 - 1.0 / 16), 1e-4);
    CHECK(murk_photon_map_memory_for(NAN) == murk_photon_map_memory_for(0));
    CHECK(murk_photon_map_memory_for(INFINITY) == INFINITY);
}

static void test_photons_nowhere_are_refused(void)
{
    const float nowhere[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 9; ++i) {
        murk_photon *photons = make_photons(RANDOM_SET, 100, 1);
        photons[17].position_m[i / 3] = nowhere[i % 3];
        murk_photon_map *map = NULL;
        murk_error err = {0};
        CHECK(murk_photon_map_create(&map, photons, 100, 1, &err) ==
              MURK_BAD_VALUE);
        CHECK(map == NULL);
        CHECK_TEXT(err.where, "photon map");
        CHECK_MENTIONS(err.text, "photon 17 lies at (");
        CHECK_MENTIONS(err.text, "must be finite");
    }
}

static void test_an_empty_map_is_a_map(void)
{
    murk_photon_map *map = NULL;
    CHECK(murk_photon_map_create(&map, NULL, 0, 2, NULL) == MURK_OK);
    CHECK(map && murk_photon_map_count(map) == 0);
    CHECK(murk_photon_map_within(map, murk_vec(0, 0, 0), 1, NULL) == 0);
    CHECK(murk_photon_map_nearest(map, murk_vec(0, 0, 0), 1, NULL, NULL) == 0);
    murk_photon_map_destroy(map);
    murk_photon_map_destroy(NULL);
}

int main(void)
{
    test_small_sets_agree_with_looking();
    test_large_sets_agree_with_looking();
    test_odd_queries_find_nothing();
    test_huge_positions_are_fine();
    test_no_record_is_lost();
    test_memory_is_forecast();
    test_photons_nowhere_are_refused();
    test_an_empty_map_is_a_map();
    return check_done();
}
