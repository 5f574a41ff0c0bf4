/* Whole-number weights: in proportion to power, equal for equal powers, the
 * maps balanced, the sum in bounds.
 *
 * Deterministic: never cries wolf. */
#include "base/rng.h"
#include "sensing/weights.h"
#include "world.h"

static murk_photon_map *map_with(size_t n, double (*power)(size_t))
{
    murk_photon *photon = malloc(n * sizeof *photon + 1);
    for (size_t i = 0; i < n; ++i) {
        /* Along x, so that the map's order cannot matter to equal powers. */
        photon[i] =
            a_photon(murk_vec((double)i, 0, 0), murk_vec(0, 0, 1), (uint32_t)i);
        photon[i].power_w = (float)power(i);
    }
    murk_photon_map *map = map_of(photon, n);
    free(photon);
    return map;
}

static double equal(size_t i)
{
    (void)i;
    return 0.37;
}

static double nothing(size_t i)
{
    (void)i;
    return 0;
}

static double uneven(size_t i)
{
    return 1e-3 * pow(10, 3 * murk_random(1, MURK_TEST, i, 0, 0).u[0]);
}

/* The extremes that single precision can hold. */
static double extreme(size_t i)
{
    return i == 0 ? 3e38 : 1e-44;
}

typedef struct result {
    uint32_t *weight;
    size_t surface, volume;
    double sum_surface, sum_volume;
} result;

static result weigh(murk_photon_map *s, murk_photon_map *v,
                    murk_map_weights maps)
{
    result r = {.surface = murk_photon_map_count(s),
                .volume = murk_photon_map_count(v)};
    r.weight = malloc((r.surface + r.volume) * sizeof *r.weight + 1);
    murk_error err = {0};
    CHECK(murk_photon_weights(r.weight, s, v, &maps, NULL, NULL, 1, "", &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    for (size_t i = 0; i < r.surface + r.volume; ++i) {
        *(i < r.surface ? &r.sum_surface : &r.sum_volume) += r.weight[i];
    }
    CHECK(r.sum_surface + r.sum_volume < 0x1p47);
    CHECK(r.sum_surface + r.sum_volume > 0);
    murk_photon_map_destroy(s);
    murk_photon_map_destroy(v);
    return r;
}

static bool all_equal(const uint32_t *w, size_t n)
{
    for (size_t i = 1; i < n; ++i) {
        if (w[i] != w[0]) {
            return false;
        }
    }
    return true;
}

static const murk_map_weights balanced = {.balanced = true};

static void test_equal_powers_weigh_the_same(void)
{
    result r = weigh(map_with(1000, equal), map_with(37, equal), balanced);
    CHECK(all_equal(r.weight, 1000) && all_equal(r.weight + 1000, 37));
    CHECK_NEAR(r.sum_surface / r.sum_volume, 1, 0x1p-20);
    free(r.weight);

    /* The paper's plain count. */
    r = weigh(map_with(1000, equal), map_with(37, equal),
              (murk_map_weights){.surface = 1, .volume = 1});
    CHECK(all_equal(r.weight, 1037));
    free(r.weight);

    r = weigh(map_with(1000, equal), map_with(37, equal),
              (murk_map_weights){.surface = 3, .volume = 1});
    CHECK_NEAR((double)r.weight[0] / r.weight[1000], 3, 0x1p-20);
    free(r.weight);
}

static void test_weights_follow_power(void)
{
    const size_t n = 5000;
    murk_photon_map *s = map_with(n, uneven);
    murk_photon *photon = malloc(n * sizeof *photon);
    memcpy(photon, murk_photon_map_photons(s), n * sizeof *photon);
    double power = 0;
    for (size_t i = 0; i < n; ++i) {
        power += photon[i].power_w;
    }
    result r = weigh(s, map_with(10, equal), balanced);
    const double mean = r.sum_surface / (double)n;
    for (size_t i = 0; i < n; ++i) {
        const double want = photon[i].power_w / power * r.sum_surface;
        CHECK_NEAR(r.weight[i], want, mean * 0x1p-20);
    }
    CHECK_NEAR(r.sum_surface / r.sum_volume, 1, 0x1p-20);
    free(photon);
    free(r.weight);
}

static void test_an_empty_map_leaves_all_to_the_other(void)
{
    result r = weigh(map_with(0, equal), map_with(100, equal), balanced);
    CHECK(r.sum_surface == 0 && all_equal(r.weight, 100));
    free(r.weight);
    r = weigh(map_with(100, uneven), map_with(100, nothing), balanced);
    CHECK(r.sum_volume == 0);
    free(r.weight);
}

/* One record against many: its weight ends at 32 bits, theirs are small. */
static void test_a_lone_record_is_balanced(void)
{
    result r = weigh(map_with(300000, equal), map_with(1, equal), balanced);
    CHECK(all_equal(r.weight, 300000));
    CHECK_NEAR(r.sum_surface / r.sum_volume, 1, 0x1p-20);
    free(r.weight);
}

static void test_extremes_stay_in_bounds(void)
{
    result r = weigh(map_with(1000, extreme), map_with(1, equal), balanced);
    CHECK(r.sum_surface >= 4e9 && r.sum_volume >= 4e9);
    free(r.weight);
    r = weigh(map_with(1, equal), map_with(0, equal),
              (murk_map_weights){.surface = 1e-300, .volume = 1e-290});
    CHECK(r.weight[0] >= 4000000000u);
    free(r.weight);
}

int main(void)
{
    test_equal_powers_weigh_the_same();
    test_weights_follow_power();
    test_an_empty_map_leaves_all_to_the_other();
    test_a_lone_record_is_balanced();
    test_extremes_stay_in_bounds();
    return check_done();
}
