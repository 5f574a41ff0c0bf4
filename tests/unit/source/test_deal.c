/* Photons are dealt to channels exactly: counting fast equals dealing one by
 * one, and every prefix is close to its share. Nothing here is random. */
#include "check.h"
#include "source/deal.h"

#include <stdlib.h>

#define CHANNELS 7

static const double weights[CHANNELS] = {1, 0.001, 12.5, 3, 3, 1e-7, 4};

static void test_count_equals_dealing(void)
{
    uint64_t limit[CHANNELS], one_by_one[CHANNELS] = {0}, count[CHANNELS];
    murk_deal_limits(weights, CHANNELS, limit);
    bool same = true;
    uint64_t checked = 0;
    for (uint64_t n = 0; n <= 30000; ++n) {
        if (n < 40 || n % 997 == 0) {
            murk_deal_count(limit, CHANNELS, n, count);
            same = same && memcmp(count, one_by_one, sizeof count) == 0;
            ++checked;
        }
        ++one_by_one[murk_deal_one(limit, CHANNELS, n)];
    }
    CHECK(same);
    CHECK(checked > 60);
}

/* A prefix of n photons misses a channel's share by no more than n times the
 * golden-ratio sequence's discrepancy, 3 + (1 / ln 1.618 + 1 / ln 2) ln n
 * (Kuipers and Niederreiter, Uniform Distribution of Sequences, 1974, theorem
 * 2.3.4), and by the single photon that each channel starts with. */
static void test_every_prefix_is_fair(void)
{
    uint64_t limit[CHANNELS], dealt[CHANNELS] = {0};
    murk_deal_limits(weights, CHANNELS, limit);
    double all = 0, worst = 0;
    for (int i = 0; i < CHANNELS; ++i) {
        all += weights[i];
    }
    for (uint64_t n = 1; n <= 20000; ++n) {
        ++dealt[murk_deal_one(limit, CHANNELS, n - 1)];
        for (int i = 0; i < CHANNELS; ++i) {
            const double share = (double)n * weights[i] / all;
            worst = fmax(worst, fabs((double)dealt[i] - share) /
                                    (CHANNELS + 3 + 3.52 * log((double)n)));
        }
    }
    CHECK(worst < 1);
    CHECK(worst > 0);
}

static void test_first_photons_go_one_to_each(void)
{
    uint64_t limit[CHANNELS];
    murk_deal_limits(weights, CHANNELS, limit);
    for (size_t i = 0; i < CHANNELS; ++i) {
        CHECK(murk_deal_one(limit, CHANNELS, i) == i);
    }
}

/* Far out, where no loop reaches: the counts differ by what the photons
 * between go to, and add up. */
static void test_far_counts_are_exact(void)
{
    uint64_t limit[CHANNELS], a[CHANNELS], b[CHANNELS];
    murk_deal_limits(weights, CHANNELS, limit);
    const uint64_t starts[] = {(UINT64_C(1) << 32) - 5000, UINT64_C(1) << 33,
                               (UINT64_C(1) << 61) + 12345};
    for (int s = 0; s < 3; ++s) {
        murk_deal_count(limit, CHANNELS, starts[s], a);
        uint64_t sum = 0;
        for (int i = 0; i < CHANNELS; ++i) {
            sum += a[i];
        }
        CHECK(sum == starts[s]);
        for (uint64_t n = 0; n < 10000; ++n) {
            ++a[murk_deal_one(limit, CHANNELS, starts[s] + n)];
        }
        murk_deal_count(limit, CHANNELS, starts[s] + 10000, b);
        CHECK(memcmp(a, b, sizeof a) == 0);
    }
}

static void test_one_channel_gets_all(void)
{
    const double weight = 3;
    uint64_t limit = 0, count = 0;
    murk_deal_limits(&weight, 1, &limit);
    murk_deal_count(&limit, 1, 1000000, &count);
    CHECK(count == 1000000);
    CHECK(murk_deal_one(&limit, 1, 999) == 0);
}

/* Weights that differ by more than rounding can hold still get their one. */
static void test_tiny_weights(void)
{
    const double weight[3] = {1e-300, 1, 1e-300};
    uint64_t limit[3], count[3];
    murk_deal_limits(weight, 3, limit);
    murk_deal_count(limit, 3, 1000, count);
    CHECK(count[0] == 1 && count[1] == 998 && count[2] == 1);
}

int main(void)
{
    test_count_equals_dealing();
    test_every_prefix_is_fair();
    test_first_photons_go_one_to_each();
    test_far_counts_are_exact();
    test_one_channel_gets_all();
    test_tiny_weights();
    return check_done();
}
