/* Every instruction set that this machine has gives the bits of plain C. */
#include "check.h"
#include "sets.h"

#include "photonmap/range_test.h"

/* From far apart to far below and above what single precision can square. */
static murk_query_sphere ball_of(uint64_t i)
{
    const murk_random4 r = murk_random(5, MURK_TEST, i, 0, 0);
    const float scale = i % 50 == 0 ? 1e-25f : i % 50 == 1 ? 1e20f : 1;
    return (murk_query_sphere){{scale * (float)(8 * r.u[0]),
                                scale * (float)(5 * r.u[1]),
                                scale * (float)(3 * r.u[2])},
                               scale * (float)(9 * r.u[3] * r.u[3])};
}

static void fill_bounds(murk_bounds *bounds, const murk_photon *photons,
                        uint32_t used)
{
    for (uint32_t i = 0; i < MURK_WIDE; ++i) {
        for (int a = 0; a < 3; ++a) {
            const float p = photons[i].position_m[a];
            const float q = photons[i + MURK_WIDE].position_m[a];
            bounds->min[a][i] = i < used ? (p < q ? p : q) : INFINITY;
            bounds->max[a][i] = i < used ? (p < q ? q : p) : -INFINITY;
        }
    }
}

static void compare_tests(const murk_range_test *plain,
                          const murk_range_test *wide,
                          const murk_photon *photons, uint64_t i)
{
    _Alignas(64) murk_bounds bounds;
    const murk_query_sphere ball = ball_of(i);
    const uint32_t n = i % 3 ? MURK_LEAF : (uint32_t)(i / 3 % (MURK_LEAF + 1));
    float a[MURK_LEAF] = {0}, b[MURK_LEAF] = {0};

    CHECK(plain->leaf(photons, n, &ball) == wide->leaf(photons, n, &ball));
    plain->leaf_distance2(photons, n, ball.center, a);
    wide->leaf_distance2(photons, n, ball.center, b);
    CHECK(memcmp(a, b, n * sizeof *a) == 0);

    fill_bounds(&bounds, photons, n < MURK_WIDE ? n : MURK_WIDE);
    uint32_t whole_a, whole_b;
    CHECK(plain->bounds(&bounds, &ball, &whole_a) ==
          wide->bounds(&bounds, &ball, &whole_b));
    CHECK(whole_a == whole_b);
    plain->bounds_distance2(&bounds, ball.center, a);
    wide->bounds_distance2(&bounds, ball.center, b);
    CHECK(memcmp(a, b, MURK_WIDE * sizeof *a) == 0);
}

static void test_all_instruction_sets_give_the_same_bits(void)
{
    unsigned n_tests;
    const murk_range_test *const *tests = murk_range_tests(&n_tests);
    CHECK_TEXT(tests[0]->name, "plain");
    const size_t n = 4000;
    for (int set = 0; set < PHOTON_SETS; ++set) {
        murk_photon *photons = make_photons((photon_set)set, n, 9);
        for (size_t i = 0; i < n; ++i) { /* a float of what follows: NaN */
            photons[i].direction = 0xffffffffu;
        }
        for (size_t i = 0; i + MURK_LEAF <= n; ++i) {
            for (unsigned j = 0; j < n_tests; ++j) {
                compare_tests(tests[0], tests[j], photons + i, i);
            }
        }
        free(photons);
    }
}

/* A leaf at the very end of its memory is not read beyond (the sanitizer
 * watches), and a box bounds what it holds exactly. */
static void test_leaf_bounds_hold_their_photons(void)
{
    unsigned n_tests;
    const murk_range_test *const *tests = murk_range_tests(&n_tests);
    const murk_range_test *best = tests[n_tests - 1];
    murk_photon *photons = make_photons(RANDOM_SET, MURK_LEAF, 3);
    _Alignas(64) murk_bounds bounds;
    fill_bounds(&bounds, photons, MURK_WIDE);
    int met_all = 0, whole_all = 0;
    for (uint64_t i = 2; i < 20000; ++i) {
        const murk_query_sphere ball = ball_of(i);
        uint32_t whole;
        const uint32_t met = best->bounds(&bounds, &ball, &whole);
        const uint32_t in = best->leaf(photons, MURK_LEAF, &ball);
        for (uint32_t j = 0; j < MURK_WIDE; ++j) {
            const uint32_t both = (in >> j & 1) + (in >> (j + 16) & 1);
            met_all += (int)(met >> j & 1);
            whole_all += (int)(whole >> j & 1);
            CHECK((met >> j & 1) || both == 0);
            CHECK(!(whole >> j & 1) || both == 2);
        }
    }
    CHECK(met_all > 1000 && whole_all > 100);
    free(photons);
}

int main(void)
{
    test_all_instruction_sets_give_the_same_bits();
    test_leaf_bounds_hold_their_photons();
    return check_done();
}
