/* Haze-L and Cloud C.1 by their Legendre moments: the series, integrated again,
 * gives its moments back, and no negative lobe is cut off. Deterministic. */
#include "check.h"
#include "moments.h"

#define REFERENCE "tests/physics/reference/cloud_c1_haze_l_moments.csv"

typedef struct series {
    double chi[MOMENTS_MAX];
    size_t n;
} series;

static double density_of(const void *context, double mu)
{
    const series *s = context;
    return moments_density(s->chi, s->n, mu);
}

static void test_series_gives_its_moments_back(const char *column,
                                               size_t moments)
{
    static double angle_deg[MOMENTS_ROWS], phase_per_sr[MOMENTS_ROWS];
    series s = {.n = 0};
    s.n = moments_read(REFERENCE, column, s.chi);
    CHECK(s.n == moments && s.chi[0] == 1);
    double again[MOMENTS_MAX];
    moments_of(density_of, &s, 0, again, s.n);
    for (size_t l = 0; l < s.n; ++l) {
        CHECK_NEAR(again[l], s.chi[l], 1e-12);
    }
    CHECK(moments_tabulate(s.chi, s.n, angle_deg, phase_per_sr) == 0);
    CHECK(angle_deg[0] == 0 && angle_deg[MOMENTS_ROWS - 1] == 180);
    s.chi[s.n / 2] += 1e-6; /* teeth: a moment that is off is seen */
    moments_of(density_of, &s, 0, again, s.n);
    CHECK(fabs(again[s.n / 2] - s.chi[s.n / 2] + 1e-6) > 1e-7);
}

int main(void)
{
    test_series_gives_its_moments_back("haze_L", 83);
    test_series_gives_its_moments_back("cloud_C1", 300);
    return check_done();
}
