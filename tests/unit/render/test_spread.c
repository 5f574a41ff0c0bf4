/* Quantiles of a channel, and the variance between groups of photons: by
 * arithmetic. */
#include "check.h"
#include "render/gather.h"
#include "render/spread.h"

static void test_shares_are_nearest_ranks(void)
{
    float value[101];
    for (int i = 0; i <= 100; ++i) {
        value[i] = (float)(i * 37 % 101);
    }
    CHECK(murk_spread_share(value, 101, 0) == 0);
    CHECK(murk_spread_share(value, 101, 0.5) == 50);
    CHECK(murk_spread_share(value, 101, 0.496) == 50);
    CHECK(murk_spread_share(value, 101, 0.494) == 49);
    CHECK(murk_spread_share(value, 101, 0.4951) == 50);
    CHECK(murk_spread_share(value, 101, 0.4949) == 49);
    CHECK(murk_spread_share(value, 101, 1) == 100);
    CHECK(murk_spread_step(0) == 1 && murk_spread_step(MURK_SPREAD_MAX) == 1);
    CHECK(murk_spread_step(MURK_SPREAD_MAX + 1) == 3); /* odd */
}

/* Sums of independent groups: the variance of their sum is n / (n - 1) of the
 * squares about their mean. */
static void test_groups_tell_their_variance(void)
{
    const double n = MURK_GATHER_GROUPS;
    double group[MURK_GATHER_GROUPS];
    for (int g = 0; g < MURK_GATHER_GROUPS; ++g) {
        group[g] = 3;
    }
    CHECK_NEAR(murk_gather_variance(group), 0, 1e-9);
    group[5] = 3 + n; /* squares about the mean: (n - 1)^2 + n - 1 */
    CHECK_NEAR(murk_gather_variance(group), n * n, 1e-6);
}

int main(void)
{
    test_shares_are_nearest_ranks();
    test_groups_tell_their_variance();
    return check_done();
}
