/* Haze-L and Cloud C.1 by their Legendre moments: the series, integrated again,
 * gives its moments back, no negative lobe is cut off, and so does the phase
 * table that murk makes of it. Deterministic. */
#include "check.h"
#include "medium/phase_table.h"
#include "moments.h"
#include "scene/table.h"

#include <stdlib.h>
#include <unistd.h>

#define REFERENCE "tests/physics/reference/cloud_c1_haze_l_moments.csv"

typedef struct series {
    double chi[MOMENTS_MAX];
    size_t n;
} series;

static double series_density(const void *context, double mu)
{
    const series *s = context;
    return moments_density(s->chi, s->n, mu);
}

static double table_density(const void *context, double mu)
{
    return murk_phase_table_density(context, mu);
}

static void test_series_gives_its_moments_back(series s)
{
    double again[MOMENTS_MAX];
    CHECK(s.chi[0] == 1);
    moments_of(series_density, &s, 0, again, s.n);
    for (size_t l = 0; l < s.n; ++l) {
        CHECK_NEAR(again[l], s.chi[l], 1e-12);
    }
    s.chi[s.n / 2] += 1e-6; /* teeth: a moment that is off is seen */
    moments_of(series_density, &s, 0, again, s.n);
    CHECK(fabs(again[s.n / 2] - s.chi[s.n / 2] + 1e-6) > 1e-7);
}

/* Rows and nodes cost 1.5e-6 of a moment for Cloud C.1, whose peak is the
 * sharper one, 3e-7 for Haze-L. */
static void test_table_gives_them_back(const series *s, double cost)
{
    static double angle_deg[MOMENTS_ROWS], phase_per_sr[MOMENTS_ROWS];
    double again[MOMENTS_MAX];
    murk_phase_table *table = NULL;
    murk_error err = {0};
    CHECK(moments_tabulate(s->chi, s->n, angle_deg, phase_per_sr) == 0);
    CHECK(angle_deg[0] == 0 && angle_deg[MOMENTS_ROWS - 1] == 180);
    const murk_phase_rows rows = {.rows = MOMENTS_ROWS,
                                  .angle_deg = angle_deg,
                                  .phase_per_sr = phase_per_sr,
                                  .where = "series"};
    CHECK(murk_phase_table_create(&table, &rows, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (!table) {
        return;
    }
    moments_of(table_density, table, 0, again, s->n);
    for (size_t l = 0; l < s->n; ++l) {
        CHECK_NEAR(again[l], s->chi[l], cost);
    }
    CHECK_NEAR(murk_phase_table_facts(table)->mean_cosine, again[1], 1e-7);
    murk_phase_table_destroy(table);
}

/* What is written for a scene reads back as it was. */
static void test_file(const series *s)
{
    static double angle_deg[MOMENTS_ROWS], phase_per_sr[MOMENTS_ROWS];
    char path[] = "/tmp/murk_moments_XXXXXX";
    const int fd = mkstemp(path);
    murk_table *csv = NULL;
    murk_error err = {0};
    CHECK(fd >= 0);
    close(fd);
    moments_write(path, s->chi, s->n);
    moments_tabulate(s->chi, s->n, angle_deg, phase_per_sr);
    CHECK(murk_table_read(&csv, path, &err) == MURK_OK);
    unlink(path);
    CHECK(csv && csv->rows == MOMENTS_ROWS && csv->columns == 2);
    for (size_t i = 0; csv && i < csv->rows; ++i) {
        double angle = -1, value = -1;
        murk_table_number(csv, i, murk_table_column(csv, "angle_deg"), NAN,
                          &angle, &err);
        murk_table_number(csv, i, murk_table_column(csv, "phase_per_sr"), NAN,
                          &value, &err);
        CHECK(angle == angle_deg[i]);
        CHECK_NEAR(value / phase_per_sr[i], 1, 1e-14);
    }
    murk_table_destroy(csv);
}

static void test_column(const char *column, size_t moments, double cost)
{
    series s = {.n = 0};
    s.n = moments_read(REFERENCE, column, s.chi);
    CHECK(s.n == moments);
    if (s.n == moments) {
        test_series_gives_its_moments_back(s);
        test_table_gives_them_back(&s, cost);
        test_file(&s);
    }
}

int main(void)
{
    test_column("haze_L", 83, 3e-7);
    test_column("cloud_C1", 300, 1.5e-6);
    return check_done();
}
