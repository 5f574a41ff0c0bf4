/* Philox4x32-10 gives the published answers, and the numbers are uniform.
 *
 * Known answers: Random123 1.14, kat_vectors (Salmon et al., 2011). The
 * statistical checks share a 1e-6 false-alarm budget; the seed is fixed. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"

static void check_words(uint32_t seed, uint32_t purpose, uint64_t photon,
                        uint32_t event, uint32_t slot, const uint32_t want[4])
{
    uint32_t got[4];
    murk_random_words(seed, purpose, photon, event, slot, got);
    for (int i = 0; i < 4; ++i) {
        CHECK(got[i] == want[i]);
    }
}

static void test_known_answers(void)
{
    const uint32_t zeros[4] = {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8};
    const uint32_t ones[4] = {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd};
    const uint32_t pi[4] = {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1};
    check_words(0, 0, 0, 0, 0, zeros);
    check_words(0xffffffff, 0xffffffff, UINT64_MAX, 0xffffffff, 0xffffffff,
                ones);
    check_words(0xa4093822, 0x299f31d0, 0x85a308d3243f6a88, 0x13198a2e,
                0x03707344, pi);
}

static double mean_of(uint32_t n, uint32_t seed, double offset)
{
    double sum = 0;
    for (uint32_t i = 0; i < n; ++i) {
        const murk_random4 r = murk_random(seed, MURK_TEST, i, 0, 0);
        sum += r.u[0] + r.u[1] + r.u[2] + r.u[3] + offset;
    }
    return sum / n;
}

static void test_mean_of_four_is_two(void)
{
    const uint32_t n = 100000;
    const double sigma = sqrt(4.0 / 12 / n);
    const double limit = murk_sidak_limit(1e-6, 1);
    CHECK_WITHIN(limit, mean_of(n, 1, 0), 2, sigma);
    CHECK(sigmas_off(mean_of(n, 1, 0.03), 2, sigma) > 2 * limit);
}

static void test_numbers_stay_inside(void)
{
    CHECK((0 + 0.5) * 0x1p-32 > 0);
    CHECK((0xffffffff + 0.5) * 0x1p-32 < 1);
    CHECK(murk_random_below(0, 7) == 0);
    CHECK(murk_random_below(0xffffffff, 7) == 6);
}

int main(void)
{
    test_known_answers();
    test_mean_of_four_is_two();
    test_numbers_stay_inside();
    return check_done();
}
