/* Weather files against other programs (../shared/data/frontier/weather, whose
 * tables say which): a year of hours against sums and single hours, METAR and
 * SYNOP reports against decoders. */
#include "check.h"
#include "scene/table.h"
#include "weather/report.h"
#include "weather/year.h"

#include <stdlib.h>
#include <unistd.h>

#define DATA "../shared/data/frontier/weather/"
#define EPW  DATA "USA_CO_Golden-NREL.724666_TMY3.epw"

static murk_table *table_of(const char *name)
{
    murk_table *t = NULL;
    murk_error err = {0};
    CHECK(!murk_table_read(&t, name, &err));
    CHECK_TEXT(err.text, "");
    return t;
}

static const char *cell(const murk_table *t, size_t row, const char *column)
{
    return t->cell[row * t->columns + (size_t)murk_table_column(t, column)];
}

/* A number of a cell; NAN if it is empty. */
static double number(const murk_table *t, size_t row, const char *column)
{
    const char *text = cell(t, row, column);
    return text[0] ? strtod(text, NULL) : NAN;
}

static bool are_equal(double a, double b, double tolerance)
{
    return isnan(a) ? isnan(b) : fabs(a - b) <= tolerance;
}

/* The reference is rounded to .01 hPa, and its inch of mercury differs from
 * murk's in the sixth digit. */
#define PRESSURE_HPA .009

/* The reference has 6 digits. */
#define VISIBILITY_M .05

/* ---- the year ---- */

typedef double of_row(const murk_observation *seen);

static double global(const murk_observation *seen)
{
    return seen->global_w_per_m2;
}
static double direct(const murk_observation *seen)
{
    return seen->direct_w_per_m2;
}
static double diffuse(const murk_observation *seen)
{
    return seen->diffuse_w_per_m2;
}
static double temperature(const murk_observation *seen)
{
    return seen->temperature_c;
}
static double dew_point(const murk_observation *seen)
{
    return seen->dew_point_c;
}
static double pressure(const murk_observation *seen)
{
    return 100 * seen->pressure_hpa;
}
static double cover(const murk_observation *seen)
{
    return 10 * seen->sky_cover;
}
static double visibility(const murk_observation *seen)
{
    /* A visibility that is stated as 0 is read as less than 50 m. */
    return seen->visibility_limit == MURK_VISIBILITY_LESS_THAN
               ? 0
               : seen->visibility_m / 1000;
}

static const struct {
    const char *name, *hour;
    of_row *of;
} COLUMNS[] = {
    {"global_horizontal_Wh_m2", "global_horizontal_Wh_m2", global},
    {"direct_normal_Wh_m2", "direct_normal_Wh_m2", direct},
    {"diffuse_horizontal_Wh_m2", "diffuse_horizontal_Wh_m2", diffuse},
    {"dry_bulb_C", "dry_bulb_C", temperature},
    {"dew_point_C", "dew_point_C", dew_point},
    {"pressure_Pa", "pressure_Pa", pressure},
    {"total_sky_tenths", "total_sky_tenths", cover},
    {"visibility_km", "visibility_km", visibility},
};
enum { N_COLUMNS = sizeof COLUMNS / sizeof *COLUMNS };

static size_t find_row(const murk_table *t, const char *name)
{
    size_t row = 0;
    while (row < t->rows && strcmp(t->cell[row * t->columns], name) != 0) {
        ++row;
    }
    CHECK(row < t->rows);
    return row < t->rows ? row : 0;
}

static void test_sums(const murk_weather_year *year)
{
    murk_table *t = table_of(DATA "golden_reference.csv");
    for (int k = 0; k < N_COLUMNS; ++k) {
        double sum = 0, missing = 0;
        const size_t row = find_row(t, COLUMNS[k].name);
        for (size_t i = 0; i < year->n; ++i) {
            const double value = COLUMNS[k].of(&year->row[i].seen);
            missing += isnan(value);
            sum += isnan(value) ? 0 : value;
        }
        CHECK_NEAR(missing, number(t, row, "n_missing"), 0);
        CHECK_NEAR(sum, number(t, row, "sum"),
                   1e-7 * fabs(number(t, row, "sum")));
    }
    /* Counts of hours. */
    double below_1 = 0, below_5 = 0, rainy = 0, up = 0;
    for (size_t i = 0; i < year->n; ++i) {
        const murk_observation *seen = &year->row[i].seen;
        below_1 += seen->visibility_m < 1000;
        below_5 += seen->visibility_m < 5000;
        rainy += seen->rain_mm_per_h > 0;
        up += seen->global_w_per_m2 > 0;
    }
    const size_t column = (size_t)murk_table_column(t, "n");
#define COUNT(name) \
    strtod(t->cell[find_row(t, name) * t->columns + column], NULL)
    CHECK_NEAR(below_1, COUNT("hours_visibility_below_1km"), 0);
    CHECK_NEAR(below_5, COUNT("hours_visibility_below_5km"), 0);
    CHECK_NEAR(rainy, COUNT("hours_with_rain_column"), 0);
    CHECK_NEAR(up, COUNT("hours_sun_up_global_gt_0"), 0);
    murk_table_destroy(t);
}

static void test_hours(const murk_weather_year *year)
{
    murk_table *t = table_of(DATA "golden_hours.csv");
    for (size_t i = 0; i < t->rows; ++i) {
        const size_t k = (size_t)number(t, i, "row") - 1;
        const murk_weather_row *row = &year->row[k < year->n ? k : 0];
        CHECK(row->month == (int)number(t, i, "month") &&
              row->day == (int)number(t, i, "day") &&
              row->ends_min == 60 * (int)number(t, i, "hour"));
        CHECK(murk_weather_year_at(year, murk_weather_row_middle(year, row)) ==
              row);
        for (int c = 0; c < N_COLUMNS; ++c) {
            CHECK_NEAR(COLUMNS[c].of(&row->seen), number(t, i, COLUMNS[c].hour),
                       1e-9);
        }
    }
    CHECK(t->rows > 20);
    murk_table_destroy(t);
}

static void test_year(void)
{
    murk_weather_year *year = NULL;
    murk_error err = {0};
    CHECK(!murk_weather_year_read(&year, EPW, &err));
    CHECK_TEXT(err.text, "");
    if (year) {
        CHECK(year->n == 8760);
        test_sums(year);
        test_hours(year);
    }
    murk_weather_year_release(year);
}

/* ---- reports ---- */

/* What the decoder of the reference reads from slashes, and from a report with
 * neither group: both are missing (PROVENANCE.md). */
static bool is_missing(const murk_table *t, size_t row)
{
    return strcmp(cell(t, row, "expected_visibility"), "unknown") == 0;
}

static void test_metar(void)
{
    murk_table *t = table_of(DATA "metar.csv");
    int groups = 0;
    /* Each report of the table. */
    for (size_t i = 0; i < t->rows; ++i) {
        murk_observation seen;
        murk_error err = {0};
        CHECK(!murk_metar_read(&seen, cell(t, i, "line"), "m", &err));
        CHECK_TEXT(err.text, "");
        CHECK_TEXT(seen.unknown, "");
        const double visibility_m =
            is_missing(t, i) ? NAN : number(t, i, "decoded_vis_m");
        const bool is_good =
            are_equal(seen.visibility_m, visibility_m, VISIBILITY_M) &&
            are_equal(seen.temperature_c, number(t, i, "decoded_temp_C"),
                      1e-9) &&
            are_equal(seen.dew_point_c, number(t, i, "decoded_dewpoint_C"),
                      1e-9) &&
            are_equal(seen.pressure_hpa, number(t, i, "decoded_pressure_hPa"),
                      PRESSURE_HPA);
        CHECK(is_good);
        CHECK_TEXT(seen.weather, cell(t, i, "decoded_weather"));
        if (!is_good) {
            printf("%s\n", cell(t, i, "line"));
        }
        groups += seen.weather[0] != '\0';
    }
    CHECK(t->rows == 22 && groups > 8);
    murk_table_destroy(t);
}

static void test_synop(void)
{
    murk_table *t = table_of(DATA "synop.csv");
    for (size_t i = 0; i < t->rows; ++i) {
        murk_observation seen;
        murk_error err = {0};
        CHECK(!murk_synop_read(&seen, cell(t, i, "line"), "s", &err));
        CHECK_TEXT(err.text, "");
        const double ww = number(t, i, "ww");
        const bool is_less = strcmp(cell(t, i, "quantifier"), "isLess") == 0;
        CHECK(are_equal(seen.visibility_m, number(t, i, "visibility"), 1e-9));
        CHECK(are_equal(seen.temperature_c, number(t, i, "air_temp_C"), 1e-9));
        CHECK((seen.visibility_limit == MURK_VISIBILITY_LESS_THAN) == is_less);
        CHECK(are_equal(seen.weather[0] ? strtod(seen.weather, NULL) : NAN, ww,
                        0));
        CHECK((seen.kind == MURK_WEATHER_FOG) == (ww > 40 && ww < 50));
        CHECK((seen.rain_mm_per_h > 0) ==
              ((ww >= 50 && ww < 68) || (ww >= 80 && ww < 83)));
    }
    CHECK(t->rows == 14);
    murk_table_destroy(t);
}

int main(void)
{
    if (access(EPW, R_OK) != 0) {
        check_skip(DATA " is not here");
    }
    test_year();
    test_metar();
    test_synop();
    return check_done();
}
