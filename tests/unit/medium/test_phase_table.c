/* Phase tables: the law that rows promise, Fournier-Forand, sampling by the
 * exact cdf, and what is refused.
 *
 * The chi-square tests of this file share a 1e-6 chance of a false alarm per
 * seed (Sidak); all else is deterministic. */
#include "base/stats.h"
#include "check.h"
#include "medium/fournier_forand.h"
#include "medium/phase_table.h"
#include "petzold.h"
#include "turns.h"

#include <stdlib.h>

#define PI         3.14159265358979324
#define SAMPLES    2000000
#define CHI_CHECKS 12

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHI_CHECKS);
}

static double density(const void *context, double mu)
{
    return murk_phase_table_density(context, mu);
}

static double sample(const void *context, double u)
{
    return murk_phase_table_sample(context, u);
}

#define ROWS_MAX 100

/* Rows [n][2] as a table; value `row` times factor. */
static murk_status made(murk_phase_table **out, const double (*row)[2],
                        size_t n, size_t changed, double factor,
                        murk_error *err)
{
    double angle[ROWS_MAX], value[ROWS_MAX];
    int line[ROWS_MAX];
    for (size_t i = 0; i < n; ++i) {
        angle[i] = row[i][0];
        value[i] = row[i][1] * (i == changed ? factor : 1);
        line[i] = 10 + (int)i;
    }
    const murk_phase_rows rows = {.rows = n,
                                  .angle_deg = angle,
                                  .phase_per_sr = value,
                                  .line = line,
                                  .where = "rows.csv"};
    *out = NULL;
    *err = (murk_error){0};
    return murk_phase_table_create(out, &rows, err);
}

static murk_phase_table *must(const double (*row)[2], size_t n, size_t changed,
                              double factor)
{
    murk_phase_table *table;
    murk_error err;
    if (made(&table, row, n, changed, factor, &err)) {
        printf("%s: %s\n", err.where, err.text);
        CHECK(table != NULL);
        exit(check_done());
    }
    return table;
}

static murk_phase_table *forand(double n, double slope)
{
    murk_phase_table *table = NULL;
    murk_error err = {0};
    CHECK(murk_phase_table_fournier_forand(&table, n, slope, "ff", &err) ==
          MURK_OK);
    if (!table) {
        exit(check_done());
    }
    return table;
}

/* Integral over the sphere when the density goes as angle^power up to 1e-5 rad:
 * quadrature beyond. */
static double integral(const murk_phase_table *table, double power)
{
    const double near = 1e-5;
    return turn_share(density, table, near, PI) +
           2 * PI * density(table, cos(near)) * near * near / (power + 2);
}

/* ---- rows ---- */

static void test_rows_are_stored(void)
{
    murk_phase_table *table = must(PETZOLD, PETZOLD_ROWS, 0, 1);
    const double all = murk_phase_table_facts(table)->integral;
    for (size_t i = 0; i + 1 < PETZOLD_ROWS; ++i) {
        const double *a = PETZOLD[i], *b = PETZOLD[i + 1];
        const double power = log(b[1] / a[1]) / log(b[0] / a[0]);
        for (double at = 0; at < 1; at += .13) {
            const double angle = a[0] + at * (b[0] - a[0]);
            const double want = a[1] * pow(angle / a[0], power) / all;
            const double got = density(table, cos(angle * PI / 180));
            CHECK_NEAR(got / want, 1, 1.2 * MURK_PHASE_TOLERANCE);
        }
    }
    const double power =
        log(PETZOLD[1][1] / PETZOLD[0][1]) / log(PETZOLD[1][0] / PETZOLD[0][0]);
    for (double angle = .1; angle > 1e-3; angle *= .7) { /* extended to 0 */
        const double want = PETZOLD[0][1] * pow(angle / .1, power) / all;
        CHECK_NEAR(density(table, cos(angle * PI / 180)) / want, 1,
                   1.2 * MURK_PHASE_TOLERANCE);
    }
    CHECK_NEAR(integral(table, power), 1, 1e-7);
    murk_phase_table_destroy(table);
}

/* Mobley et al. 1993 state bb/b = .0183 and a mean cosine of .924. The
 * published cumulative shares are integrals by trapezoids in angle above .1
 * degrees; integrated in the same way, the table gives them back. */
static void test_petzold(void)
{
    /* Published cumulative shares by angle. */
    static const double below[][2] = {
        {.1, .051653}, {.50119, .149389}, {1, .231176},   {10, .665573},
        {30, .881199}, {90, .981908},     {140, .996303}, {180, 1}};
    murk_phase_table *table = must(PETZOLD, PETZOLD_ROWS, 0, 1);
    /* Published mean cosine and backward share; the facts also agree with
     * quadrature of the density. */
    const murk_phase_facts *facts = murk_phase_table_facts(table);
    CHECK_NEAR(facts->mean_cosine, .924, .0005);
    CHECK_NEAR(facts->backward, .0183, .00005);
    CHECK_NEAR(facts->integral, 1, .008);
    CHECK_NEAR(facts->backward, turn_share(density, table, PI / 2, PI), 1e-9);
    CHECK_NEAR(facts->before_first,
               1 - turn_share(density, table, .1 * PI / 180, PI), 1e-6);
    CHECK(facts->behind_last == 0);
    /* Trapezoids from the first row on; the part before counts as a whole. */
    double sum[PETZOLD_ROWS] = {facts->before_first};
    for (size_t i = 1; i < PETZOLD_ROWS; ++i) {
        const double from = PETZOLD[i - 1][0] * PI / 180;
        const double to = PETZOLD[i][0] * PI / 180;
        sum[i] = sum[i - 1] + PI * (to - from) *
                                  (sin(from) * density(table, cos(from)) +
                                   sin(to) * density(table, cos(to)));
    }
    /* Compare at the published angles. */
    for (size_t i = 0, k = 0; i < PETZOLD_ROWS; ++i) {
        if (PETZOLD[i][0] == below[k][0]) {
            CHECK_NEAR(sum[i] / sum[PETZOLD_ROWS - 1], below[k++][1], 5e-6);
        }
    }
    murk_phase_table_destroy(table);
}

static void test_zeros_are_linear_in_the_cosine(void)
{
    static const double rows[][2] = {
        {0, 2}, {60, 0}, {90, 0}, {120, 0}, {160, 1}};
    murk_phase_table *table = must(rows, 5, 0, 1);
    const double all = murk_phase_table_facts(table)->integral;
    CHECK_NEAR(all,
               2 * PI *
                   (.5 * 2 * .5 +
                    .5 * 1 * (cos(PI / 3) * -1 - cos(160 * PI / 180)) + 1 +
                    cos(160 * PI / 180)),
               1e-12);
    CHECK_NEAR(density(table, 1) * all, 2, 1e-12);
    CHECK_NEAR(density(table, .75) * all, 1, 1e-12);
    CHECK(density(table, .3) == 0 && density(table, -.3) == 0);
    CHECK_NEAR(density(table, -1) * all, 1, 1e-12); /* goes on to 180 */
    for (uint32_t k = 0; k < 1000; ++k) {
        const double mu = sample(table, (k + .5) / 1000);
        CHECK(mu >= .5 || mu <= -.5);
    }
    murk_phase_table_destroy(table);
}

/* Scaling all values changes nothing; a rising start is flat. */
static void test_any_scale(void)
{
    static const double rows[][2] = {{1, 1}, {10, 3}, {180, 3}};
    static const double large[][2] = {{1, 1e29}, {10, 3e29}, {180, 3e29}};
    static const double small[][2] = {{1, 1e-30}, {10, 3e-30}, {180, 3e-30}};
    murk_phase_table *table = must(rows, 3, 0, 1);
    murk_phase_table *again = must(large, 3, 0, 1);
    murk_phase_table *third = must(small, 3, 0, 1);
    for (double mu = -1; mu <= 1; mu += .0625) {
        CHECK_NEAR(density(table, mu), density(again, mu), 1e-12);
        CHECK_NEAR(density(table, mu), density(third, mu), 1e-12);
    }
    CHECK_NEAR(density(table, 1) / density(table, cos(PI / 180)), 1, 1e-9);
    CHECK_NEAR(3 * density(table, 1) / density(table, -1), 1, 1e-9);
    murk_phase_table_destroy(table);
    murk_phase_table_destroy(again);
    murk_phase_table_destroy(third);
}

/* A peak of 1e6 within .01 degrees that holds nearly half of the light. */
static const double PEAK[][2] = {{0, 1e6},   {.01, 9e5}, {.02, 4e5},
                                 {.05, 1e4}, {1, 3},     {180, .01}};

static void test_sharp_peak(void)
{
    murk_phase_table *table = must(PEAK, 6, 0, 1);
    const double all = murk_phase_table_facts(table)->integral;
    CHECK_NEAR(density(table, cos(.01 * PI / 180)) * all / 9e5, 1, 1e-4);
    CHECK_NEAR(turn_share(density, table, 1e-8, PI), 1, 1e-6);
    murk_phase_table_destroy(table);
}

/* ---- Fournier-Forand ---- */

/* Computed apart from this code by the sources' formula, 7 digits. n, slope,
 * then the density at angles [deg], then bb/b (sources' closed form). */
static const double FORAND_ANGLE[] = {.1, 1, 10, 45, 90, 135, 165};
static const double FORAND[][10] = {
    {1.1, 3.5835, 2.075089e3, 7.278378e1, 1.096237, 2.519081e-2, 4.193319e-3,
     2.563695e-3, 2.803380e-3, .01831},
    {1.05, 3.259, 4.897583e3, 7.751962e1, 3.749513e-1, 4.057191e-3, 5.101954e-4,
     2.631267e-4, 2.770143e-4, .00200},
    {1.15, 3.7, 1.097655e3, 5.151342e1, 1.269274, 4.438913e-2, 8.594411e-3,
     5.721291e-3, 6.367504e-3, .03972},
    {1.03, 3.2, 5.248519e3, 6.534630e1, 1.777720e-1, 1.439359e-3, 1.662966e-4,
     8.195905e-5, 8.541744e-5, .00063},
    {1.2, 4.065, 1.962175e2, 2.067126e1, 1.180430, 8.015931e-2, 2.094605e-2,
     1.699905e-2, 1.970615e-2, .11085}};

static void test_forand_against_the_reference(void)
{
    for (size_t i = 0; i < sizeof FORAND / sizeof *FORAND; ++i) {
        const double *row = FORAND[i];
        murk_phase_table *table = forand(row[0], row[1]);
        const murk_phase_facts *facts = murk_phase_table_facts(table);
        for (size_t k = 0; k < 7; ++k) {
            const double angle = FORAND_ANGLE[k] * PI / 180;
            CHECK_NEAR(density(table, cos(angle)) / row[2 + k], 1,
                       2e-6 + 1.2 * MURK_PHASE_TOLERANCE);
        }
        CHECK_NEAR(facts->backward, row[9], 5e-6);
        /* the law has its integral at 1, before it is made so */
        CHECK_NEAR(facts->integral, 1, MURK_PHASE_TOLERANCE);
        CHECK_NEAR(integral(table, row[1] - 5), 1, 1e-5);
        murk_phase_table_destroy(table);
    }
}

/* Over the whole range: above 0, integral 1, near its law also where the
 * formula's brackets vanish. */
static void test_forand_everywhere(void)
{
    static const double n[] = {1.001, 1.01, 1.1, 1.3, 1.6, 2};
    static const double slope[] = {3.0001, 3.1, 3.5, 4, 4.5, 4.9999};
    for (int i = 0; i < 36; ++i) {
        murk_phase_table *table = forand(n[i / 6], slope[i % 6]);
        const double all = murk_phase_table_facts(table)->integral;
        CHECK_NEAR(all, 1, 1.2 * MURK_PHASE_TOLERANCE);
        for (double s = 2; s > 1e-12; s *= .83) {
            const double want = murk_fournier_forand(n[i / 6], slope[i % 6], s);
            CHECK(want > 0);
            if (s > 1e-7) { /* 1 - s loses digits below */
                CHECK_NEAR(density(table, 1 - s) * all / want, 1,
                           1.2 * MURK_PHASE_TOLERANCE);
            }
        }
        murk_phase_table_destroy(table);
    }
}

/* The series near d = 1 joins the closed form on both sides. */
static void test_forand_is_smooth(void)
{
    const double n = 1.1, slope = 3.5835, at = 1.5 * (n - 1) * (n - 1);
    for (double step = 1e-2; step > 1e-5; step *= .7) {
        const double left = murk_fournier_forand(n, slope, at * (1 - step));
        const double right = murk_fournier_forand(n, slope, at * (1 + step));
        const double middle = murk_fournier_forand(n, slope, at);
        CHECK_NEAR(sqrt(left * right) / middle, 1, 2 * step * step + 1e-9);
    }
}

/* ---- sampling ---- */

static double misfit(const murk_phase_table *sampled,
                     const murk_phase_table *expected, uint32_t seed)
{
    return turn_misfit(sample, sampled, density, expected, SAMPLES, seed);
}

static void check_sampling(murk_phase_table *table, murk_phase_table *wrong,
                           uint32_t seed)
{
    CHECK(fabs(misfit(table, table, seed)) < limit());
    CHECK(misfit(table, wrong, seed) > 2 * limit()); /* teeth */
    murk_phase_table_destroy(table);
    murk_phase_table_destroy(wrong);
}

static void test_sampling(uint32_t seed)
{
    check_sampling(must(PETZOLD, PETZOLD_ROWS, 0, 1),
                   must(PETZOLD, PETZOLD_ROWS, 20, 1.07), seed);
    check_sampling(must(PEAK, 6, 0, 1), must(PEAK, 6, 1, 1.07), seed);
    check_sampling(forand(1.1, 3.5835), forand(1.1, 3.5735), seed);
    check_sampling(forand(1.03, 3.2), forand(1.032, 3.2), seed);
    static const double rows[][2] = {{0, 2},   {60, 0},  {90, 0},
                                     {120, 0}, {160, 1}, {180, 1}};
    check_sampling(must(rows, 6, 0, 1), must(rows, 6, 0, 1.03), seed);
}

/* The mean of 1 - mu, told against quadrature. */
static void test_mean_cosine(void)
{
    murk_phase_table *table = must(PEAK, 6, 0, 1);
    double mean = 0;
    const int n = 500000;
    for (int i = 0; i < n; ++i) {
        mean += (1 - sample(table, (i + .5) / n)) / n;
    }
    CHECK_NEAR(1 - murk_phase_table_facts(table)->mean_cosine, mean, 1e-6);
    murk_phase_table_destroy(table);
}

static void test_samples_fall(void)
{
    murk_phase_table *table[] = {forand(1.001, 3.0001), forand(2, 4.99),
                                 must(PEAK, 6, 0, 1),
                                 must(PETZOLD, PETZOLD_ROWS, 0, 1)};
    for (size_t k = 0; k < 4; ++k) {
        double before = 2;
        for (double u = 0x1p-33; u < .001; u *= 1.7) {
            const double mu = sample(table[k], u);
            CHECK(mu <= 1 && mu <= before);
            before = mu;
        }
        for (int i = 2; i < 2000; ++i) {
            const double mu = sample(table[k], i / 2000.);
            CHECK(mu >= -1 && mu <= before);
            before = mu;
        }
        const double last = sample(table[k], 1 - 0x1p-33);
        CHECK(last >= -1 && last <= before);
        CHECK(isfinite(density(table[k], 1)) && density(table[k], -1) > 0);
        murk_phase_table_destroy(table[k]);
    }
}

/* ---- refusals ---- */

static void refused(const double (*row)[2], size_t n, const char *where,
                    const char *text)
{
    murk_phase_table *table;
    murk_error err;
    CHECK(made(&table, row, n, 0, 1, &err) == MURK_BAD_VALUE);
    CHECK(table == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_TEXT(err.text, text);
}

static void test_refusals(void)
{
    /* Too few rows, and angles that do not grow. */
    const double nan = NAN;
    refused((const double[][2]){{0, 1}}, 1, "rows.csv",
            "1 rows, must be 2..1000000");
    refused((const double[][2]){{0, 1}, {90, 1}, {80, 1}, {180, 1}}, 4,
            "rows.csv:12: angle_deg",
            "80, must be more than the 90 degrees before");
    refused((const double[][2]){{0, 1}, {90, 1}, {90, 1}, {180, 1}}, 4,
            "rows.csv:12: angle_deg",
            "90, must be more than the 90 degrees before");
    /* Angles out of range, and tables that begin or end too far from 0 or
     * 180 degrees. */
    refused((const double[][2]){{-1, 1}, {180, 1}}, 2, "rows.csv:10: angle_deg",
            "-1, must be 0 or 1e-06..180 degrees");
    refused((const double[][2]){{0, 1}, {181, 1}}, 2, "rows.csv:11: angle_deg",
            "181, must be 0 or 1e-06..180 degrees");
    refused((const double[][2]){{nan, 1}, {180, 1}}, 2,
            "rows.csv:10: angle_deg", "nan, must be 0 or 1e-06..180 degrees");
    refused((const double[][2]){{1e-7, 1}, {180, 1}}, 2,
            "rows.csv:10: angle_deg", "1e-07, must be 0 or 1e-06..180 degrees");
    refused((const double[][2]){{20, 1}, {180, 1}}, 2, "rows.csv:10: angle_deg",
            "begins at 20, must be 0..10 degrees");
    refused((const double[][2]){{0, 1}, {90, 1}}, 2, "rows.csv:11: angle_deg",
            "ends at 90, must be 150..180 degrees");
    /* Densities out of range, none above 0, or without an integral. */
    refused((const double[][2]){{0, 1}, {90, -1e-9}, {180, 1}}, 3,
            "rows.csv:11: phase_per_sr",
            "-1e-09, must be 0 or 1e-30..1e+30 per sr");
    refused((const double[][2]){{0, 1}, {180, nan}}, 2,
            "rows.csv:11: phase_per_sr",
            "nan, must be 0 or 1e-30..1e+30 per sr");
    refused((const double[][2]){{0, 1e31}, {180, 1}}, 2,
            "rows.csv:10: phase_per_sr",
            "1e+31, must be 0 or 1e-30..1e+30 per sr");
    refused((const double[][2]){{0, 0}, {180, 0}}, 2, "rows.csv",
            "no light anywhere, the integral over the sphere must be more "
            "than 0");
    refused((const double[][2]){{1, 1000}, {10, 1}, {180, 1}}, 3,
            "rows.csv:10: phase_per_sr",
            "the first two rows fall as angle^-3, which has no integral to "
            "angle 0: must be less steep than angle^-2, or begin with a row "
            "at angle 0");
}

/* Rows without a file, and a table that would take too much. */
static void test_hostile_rows(void)
{
    enum { N = 2000 };
    static double angle[N], value[N];
    for (int i = 0; i < N; ++i) {
        angle[i] = 180. * i / (N - 1);
        value[i] = i % 2 ? 1e-30 : 1e30;
    }
    const murk_phase_rows rows = {.rows = N,
                                  .angle_deg = angle,
                                  .phase_per_sr = value,
                                  .where = "medium"};
    murk_phase_table *table = NULL;
    murk_error err = {0};
    CHECK(murk_phase_table_create(&table, &rows, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.where, "medium: row ");
    CHECK_MENTIONS(err.text, "too many steep rows up to here");
    murk_phase_table_destroy(table);
}

static void test_forand_refusals(void)
{
    static const double bad[][2] = {{1, 3.5},   {.9, 3.5}, {2.1, 3.5},
                                    {NAN, 3.5}, {1.1, 3},  {1.1, 2.9},
                                    {1.1, 5},   {1.1, NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        murk_phase_table *table = NULL;
        murk_error err = {0};
        CHECK(murk_phase_table_fournier_forand(&table, bad[i][0], bad[i][1],
                                               "fog.yaml:3",
                                               &err) == MURK_BAD_VALUE);
        CHECK(table == NULL);
        CHECK_TEXT(err.where, "fog.yaml:3");
        CHECK_MENTIONS(err.text, i < 4 ? "1.001..2" : "3.0001..4.9999");
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_rows_are_stored();
    test_petzold();
    test_zeros_are_linear_in_the_cosine();
    test_any_scale();
    test_sharp_peak();
    test_forand_against_the_reference();
    test_forand_everywhere();
    test_forand_is_smooth();
    test_sampling(seed);
    test_mean_cosine();
    test_samples_fall();
    test_refusals();
    test_hostile_rows();
    test_forand_refusals();
    return check_done();
}
