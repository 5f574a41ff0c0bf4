/* Light from facet to facet: sides, the limit of no waves, addresses. The
 * balance that it must keep, and reflectances, are tests/physics/test_waves.c.
 * Nothing here is compared by chance. */
#include "check.h"
#include "transport/facets.h"

#include <stdlib.h>

#define WATER   1.34
#define PHOTONS 20000

static const murk_vec3 up = {0, 0, 1};

static murk_address address_of(uint32_t seed, uint64_t photon)
{
    return (murk_address){seed, MURK_TEST, photon, 0};
}

/* Down at a cosine of mu, over x. */
static murk_vec3 down_at(double mu)
{
    return murk_vec(sqrt(1 - mu * mu), 0, -mu);
}

static void test_light_leaves_on_the_side_it_is_said_to(uint32_t seed)
{
    const double slope[] = {1e-12, .003, .05, 1};
    for (uint64_t i = 0; i < PHOTONS; ++i) {
        const double mu = pow(10, -12 * fmod((double)i * .618034, 1));
        const bool from_water = i % 2;
        const murk_vec3 in = down_at(mu);
        const murk_address address = address_of(seed, i);
        murk_bounce out = {0};
        CHECK(murk_meet_facets(&address, from_water ? WATER : 1,
                               from_water ? 1 : WATER, slope[i / 2 % 4], in, up,
                               &out));
        CHECK(out.outcome == MURK_MIRRORED
                  ? out.direction.z > 0
                  : out.outcome == MURK_TRANSMITTED && out.direction.z < 0);
        CHECK_NEAR(murk_length(out.direction), 1, 1e-12);
    }
}

/* Where waves are a millionth high, light goes as at a level surface. */
static void test_no_waves_are_level(uint32_t seed)
{
    for (int k = 1; k <= 20; ++k) {
        const murk_vec3 in = down_at(k / 20.);
        const murk_address address = address_of(seed, (uint64_t)k);
        murk_bounce out = {0};
        CHECK(murk_meet_facets(&address, WATER, 1, 1e-14, in, up, &out));
        const murk_bounce level = murk_refract(
            WATER, 1, in, up, out.outcome == MURK_MIRRORED ? 1e-12 : 1 - 1e-12);
        CHECK(out.outcome == level.outcome);
        CHECK_NEAR(murk_length(murk_sub(out.direction, level.direction)), 0,
                   1e-5);
    }
}

static void test_the_address_decides(uint32_t seed)
{
    murk_bounce one = {0}, two = {0};
    int same = 0;
    for (uint64_t i = 0; i < 100; ++i) {
        const murk_address address = address_of(seed, i);
        murk_meet_facets(&address, 1, WATER, .05, down_at(.5), up, &one);
        murk_meet_facets(&address, 1, WATER, .05, down_at(.5), up, &two);
        CHECK(memcmp(&one.direction, &two.direction, sizeof one.direction) ==
              0);
        const murk_address other = address_of(seed, i + 100);
        murk_meet_facets(&other, 1, WATER, .05, down_at(.5), up, &two);
        same += one.direction.x == two.direction.x;
    }
    CHECK(same == 0);
}

/* Without an index to change, facets bend nothing and reflect nothing. */
static void test_equal_indices_let_light_straight_through(void)
{
    for (uint64_t i = 0; i < 100; ++i) {
        const murk_address address = address_of(1, i);
        murk_bounce out = {0};
        CHECK(murk_meet_facets(&address, 1.2, 1.2, .05, down_at(.3), up, &out));
        CHECK(out.outcome == MURK_TRANSMITTED);
        CHECK_NEAR(murk_length(murk_sub(out.direction, down_at(.3))), 0, 1e-12);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_light_leaves_on_the_side_it_is_said_to(seed);
    test_no_waves_are_level(seed);
    test_the_address_decides(seed);
    test_equal_indices_let_light_straight_through();
    return check_done();
}
