/* Weather years: rows by time, missing values, limits of visibility, leap
 * years, parts of an hour, and files that are refused by line. Also the classes
 * of clearness. */
#include "check.h"
#include "weather/year.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

#define HEAD                                                        \
    "LOCATION,Some Place,XX,YYY,TMY3,1,39.74,-105.18,-7.0,1829.0\n" \
    "DESIGN CONDITIONS,0\nHOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0\n"     \
    "COMMENTS 1,a \"quoted word\n"
/* Without an end of the last period. */
#define PERIODS(periods, n) "DATA PERIODS," #periods "," #n ",Data,Sunday\n"

/* A row: the time, then temperature and dew point, then irradiances, then total
 * and opaque sky cover, visibility, ceiling, indicator and codes, then rain. */
#define ROW(time, light, seen, rain)                                      \
    time ",?9?9,-3.0,-4.0,92,80600,0,0,257," light ",0,0,0,0,0,0.0," seen \
         ",89,0.0310,0,88,0.330," rain "\n"

static murk_weather_year *parse(const char *text, murk_error *err)
{
    murk_weather_year *out = NULL;
    char *copy = strdup(text);
    murk_weather_year_parse(&out, "w.epw", copy, strlen(copy), err);
    free(copy);
    return out;
}

static double utc(const char *time)
{
    double local_s = 0;
    bool has_zone;
    int zone_min;
    CHECK(murk_time_read(time, &local_s, &has_zone, &zone_min));
    return local_s - 60.0 * zone_min;
}

static void test_rows(void)
{
    murk_error err = {0};
    murk_weather_year *year = parse(
        HEAD PERIODS(3, 1) ROW("1999,1,1,1,0", "0,0,0",
                               "8,8,16.1,3300,9,999999999", "999.0,99.0")
            ROW("1999,1,1,12,0", "500,600,90", "4,4,777.7,3300,0,919999999",
                "3.0,1.0") ROW("2004,2,29,24,60", "9999,9999,9999",
                               "99,9,9999,3300,0,999999059", "6.0,3.0")
                ROW("2003,3,1,1,0", "1,0,1", "10,8,0.0,3300,0,999199999",
                    "999,99"),
        &err);
    CHECK_TEXT(err.text, "");
    CHECK(year && year->n == 4);
    if (!year) {
        return;
    }
    CHECK_NEAR(year->latitude_deg, 39.74, 0);
    CHECK_NEAR(year->longitude_deg, -105.18, 0);
    CHECK_NEAR(year->altitude_m, 1829, 0);
    CHECK(year->zone_min == -420 && year->interval_min == 60);
    /* The first hour begins at midnight, local time, of any year. */
    const murk_weather_row *row =
        murk_weather_year_at(year, utc("2026-01-01T00:00:00-07:00"));
    CHECK(row == &year->row[0]);
    CHECK(murk_weather_year_at(year, utc("2026-01-01T00:59:59-07:00")) == row);
    CHECK(!murk_weather_year_at(year, utc("2026-01-01T01:00:00-07:00")));
    CHECK(row && row->seen.visibility_limit == MURK_VISIBILITY_AT_LEAST);
    CHECK(row && row->seen.rain_mm_per_h == 0);
    /* Noon ends the twelfth hour; its middle is half past eleven. */
    row = murk_weather_year_at(year, utc("2026-01-01T18:30:00Z"));
    CHECK(row == &year->row[1]);
    if (row) {
        CHECK_NEAR(murk_weather_row_middle(year, row),
                   utc("1999-01-01T11:30:00-07:00"), 1e-6);
        CHECK_NEAR(row->seen.direct_w_per_m2, 600, 0);
        CHECK_NEAR(row->seen.diffuse_w_per_m2, 90, 0);
        CHECK_NEAR(row->seen.global_w_per_m2, 500, 0);
        CHECK_NEAR(row->seen.pressure_hpa, 806, 1e-9);
        CHECK_NEAR(row->seen.visibility_m, 160900, 1e-6);
        CHECK_NEAR(row->seen.rain_mm_per_h, 3, 0);
        CHECK_NEAR(row->seen.sky_cover, .4, 1e-12);
        CHECK(row->seen.kind == MURK_WEATHER_NONE);
    }
    /* The leap day; missing values are NAN, fog is the seventh digit. */
    row = murk_weather_year_at(year, utc("2004-02-29T23:30:00-07:00"));
    CHECK(row == &year->row[2]);
    if (row) {
        CHECK(isnan(row->seen.global_w_per_m2 + row->seen.direct_w_per_m2) &&
              isnan(row->seen.diffuse_w_per_m2) &&
              isnan(row->seen.visibility_m) && isnan(row->seen.sky_cover));
        CHECK_NEAR(row->seen.rain_mm_per_h, 2, 0);
        CHECK(row->seen.kind == MURK_WEATHER_FOG);
    }
    row = &year->row[3];
    CHECK(row->seen.kind == MURK_WEATHER_SNOW);
    CHECK_NEAR(row->seen.visibility_m, 50, 0);
    CHECK(row->seen.visibility_limit == MURK_VISIBILITY_LESS_THAN);
    murk_weather_year_release(year);
}

/* Weather codes: rain by its class where no amount is stated; codes that are
 * not nine digits, or that are said to be missing, state nothing. */
static void test_codes(void)
{
    static const struct {
        const char *seen, *rain;
        murk_weather_kind kind;
        double mm_per_h;
    } cases[] = {
        {"8,8,9,3,0,909999999", "999,99", MURK_WEATHER_NONE, 1.25},
        {"8,8,9,3,0,929999999", "0,1", MURK_WEATHER_NONE, 15},
        {"8,8,9,3,0,949999999", "2,1", MURK_WEATHER_NONE, 2},
        {"8,8,9,3,0,994999999", "999,99", MURK_WEATHER_NONE, .37},
        {"8,8,9,3,0,999099999", "999,99", MURK_WEATHER_SNOW, 0},
        {"8,8,9,3,0,999999919", "999,99", MURK_WEATHER_HAZE, 0},
        /* Snow crystals, hail, ice pellets, blowing snow, spray. */
        {"8,8,9,3,0,999899999", "999,99", MURK_WEATHER_SNOW, 0},
        {"8,8,9,3,0,999994999", "999,99", MURK_WEATHER_NONE, 0},
        {"8,8,9,3,0,999991999", "999,99", MURK_WEATHER_SNOW, 0},
        {"8,8,9,3,0,999999949", "999,99", MURK_WEATHER_SNOW, 0},
        {"8,8,9,3,0,999999959", "999,99", MURK_WEATHER_NONE, 0},
        {"8,8,9,3,0,999999991", "999,99", MURK_WEATHER_SNOW, 0},
        /* Fog, ice fog, dust, sand, heavy fog, glaze, heavy ground fog. */
        {"8,8,9,3,0,999999099", "999,99", MURK_WEATHER_FOG, 0},
        {"8,8,9,3,0,999999199", "999,99", MURK_WEATHER_FOG, 0},
        {"8,8,9,3,0,999999399", "999,99", MURK_WEATHER_HAZE, 0},
        {"8,8,9,3,0,999999499", "999,99", MURK_WEATHER_HAZE, 0},
        {"8,8,9,3,0,999999599", "999,99", MURK_WEATHER_FOG, 0},
        {"8,8,9,3,0,999999699", "999,99", MURK_WEATHER_NONE, 0},
        {"8,8,9,3,0,999999899", "999,99", MURK_WEATHER_FOG, 0},
        {"8,8,9,3,0,0", "999,99", MURK_WEATHER_NONE, 0},
        {"8,8,9,3,9,929999999", "999,99", MURK_WEATHER_NONE, 0},
        {"8,8,9,3,9,929999999", "0.5,1", MURK_WEATHER_NONE, .5},
    };
    /* Each in a file of one row. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[1000];
        murk_error err = {0};
        snprintf(text, sizeof text,
                 HEAD PERIODS(1, 1) ROW("1999,1,1,1,0", "0,0,0", "%s", "%s"),
                 cases[i].seen, cases[i].rain);
        murk_weather_year *year = parse(text, &err);
        CHECK_TEXT(err.text, "");
        CHECK(year && year->row[0].seen.kind == cases[i].kind);
        CHECK_NEAR(year ? year->row[0].seen.rain_mm_per_h : NAN,
                   cases[i].mm_per_h, 1e-12);
        murk_weather_year_release(year);
    }
}

/* Nines of another number than in the dictionary are missing, too, and the
 * reading of a pyranometer at night is 0. */
static void test_other_programs(void)
{
    murk_error err = {0};
    murk_weather_year *year = parse(
        HEAD PERIODS(1, 1) ROW("1999,1,1,1,0", "99999,9999.9,-2.5",
                               "99,9,99999.9,3300,9,999999999", "9999,99"),
        &err);
    CHECK_TEXT(err.text, "");
    if (year) {
        const murk_observation *seen = &year->row[0].seen;
        CHECK(isnan(seen->global_w_per_m2) && isnan(seen->direct_w_per_m2));
        CHECK(isnan(seen->visibility_m) && seen->diffuse_w_per_m2 == 0);
        CHECK(seen->rain_mm_per_h == 0);
    }
    free(year);
}

/* Rows of a quarter of an hour, of two years: that of the same year counts. */
static void test_quarters(void)
{
    murk_error err = {0};
#define Q(time) ROW(time, "0,0,0", "8,8,9,3300,9,999999999", "999,99")
    murk_weather_year *year =
        parse(HEAD PERIODS(2, 4) Q("2010,6,1,10,15") Q("2010,6,1,10,30")
                  Q("2010,6,1,10,45") Q("2010,6,1,10,60") Q("2011,6,1,10,15"),
              &err);
    CHECK_TEXT(err.text, "");
    if (!year) {
        return;
    }
    CHECK(year->interval_min == 15);
    CHECK(murk_weather_year_at(year, utc("2012-06-01T09:14:59-07:00")) ==
          &year->row[0]);
    CHECK(murk_weather_year_at(year, utc("2012-06-01T09:50:00-07:00")) ==
          &year->row[3]);
    CHECK(murk_weather_year_at(year, utc("2011-06-01T09:10:00-07:00")) ==
          &year->row[4]);
    murk_weather_year_release(year);
}

static void test_refused(void)
{
    static const struct {
        const char *text, *where, *part;
    } cases[] = {
        {"", "w.epw:1", "LOCATION"},
        {"LOCATION,a,b,c,d,1,91,0,0,0\n", "w.epw:1", "latitude"},
        {"LOCATION,a,b,c,d,1,,0,0,0\n", "w.epw:1", "lacks a number"},
        {HEAD, "w.epw:5", "DATA PERIODS"},
        {HEAD PERIODS(1, 7), "w.epw:5", "divide 60"},
        {HEAD PERIODS(1, 1), "w.epw:6", "no rows"},
        {HEAD PERIODS(1, 1) "1999,1,1\n", "w.epw:6", "3 cells"},
        {HEAD PERIODS(1, 1) Q("1999,2,30,1,0"), "w.epw:6", "the day is '30'"},
        {HEAD PERIODS(1, 1) Q("1999,13,1,1,0"), "w.epw:6", "the month is '13'"},
        {HEAD PERIODS(1, 1) Q("1999,1,1,25,0"), "w.epw:6", "the hour is '25'"},
        {HEAD PERIODS(1, 1) Q("1999,1,1,2,0") Q("1999,1,1,1,0"), "w.epw:7",
         "does not follow"},
        {HEAD PERIODS(1, 1) Q("1999,1,1,1,0") Q("1999,1,1,3,0"), "w.epw:7",
         "does not follow"},
        {HEAD "DATA PERIODS,1,1,Data,Sunday, 1/ 1, 1/ 2\n" Q("1999,1,1,1,0"),
         "w.epw:6", "must end with the last of 01-02"},
        {HEAD "DATA PERIODS,1,1,Data,Sunday, 1/ 1, 1/ 1\n" Q("1999,1,1,2,0"),
         "w.epw:6", "must begin with the first of 01-01"},
        {HEAD PERIODS(1, 1) Q("1999,2,29,1,0"), "w.epw:6",
         "a day of that year"},
        {HEAD PERIODS(1, 4) Q("1999,1,1,1,0"), "w.epw:6",
         "the minute is '0', must be the end of a row's part of the hour, "
         "15..60 in steps of 15"},
        {HEAD PERIODS(1, 1) Q("1999,1,1,1,0") Q("1998,1,1,2,0"), "w.epw:7",
         "does not follow"},
        {HEAD PERIODS(1, 1) Q("2000,2,28,12,0") Q("2000,3,1,13,0"), "w.epw:7",
         "does not follow"},
        {HEAD PERIODS(1, 1) ROW("1999,1,1,1,0", "5x,0,0", "8,8,9,3,9,9", "9,9"),
         "w.epw:6", "the global irradiance is '5x'"},
        {HEAD PERIODS(1, 1) ROW("1999,1,1,1,0", "0,-8,0", "8,8,9,3,9,9", "9,9"),
         "w.epw:6", "the direct irradiance is '-8'"},
        {HEAD PERIODS(1, 1)
             ROW("1999,1,1,1,0", "9990,0,0", "8,8,9,3,9,9", "9,9"),
         "w.epw:6", "the global irradiance is '9990'"},
        {HEAD PERIODS(1, 1)
             ROW("1999,1,1,1,0", "0,0,0", "8,8,900,3,9,9", "9,9"),
         "w.epw:6", "the visibility is '900'"},
    };
    /* Each file is refused at its line. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_error err = {0};
        murk_weather_year *year = parse(cases[i].text, &err);
        CHECK(!year && err.code == MURK_BAD_FILE);
        CHECK_TEXT(err.where, cases[i].where);
        CHECK(strstr(err.text, cases[i].part) != NULL);
        murk_weather_year_release(year);
    }
}

static void test_clearness(void)
{
    const double high = .5, low = 1.5; /* zenith angles */
    CHECK(murk_sky_clearness(0, 100, high) == 1);
    CHECK(murk_sky_clearness(0, 0, high) == 1);
    CHECK(murk_sky_clearness(900, 0, high) == 8);
    CHECK(murk_sky_clearness(900, 80, high) == 8);
    /* (diffuse + direct) / diffuse of 3 is class 5 at the zenith, and lower
     * with a low sun: (3 + 3.51) / 4.51 = 1.44. */
    CHECK(murk_sky_clearness(200, 100, 0) == 6);
    CHECK(murk_sky_clearness(179, 100, 0) == 5);
    CHECK(murk_sky_clearness(200, 100, low) == 3);
    CHECK(murk_sky_clearness(200, 100, 2) ==
          murk_sky_clearness(200, 100, 1.571));
    for (int class = 1; class <= 8; ++class) {
        const int type = murk_sky_cie_type(class);
        CHECK(type >= 1 && type <= 15);
    }
    CHECK(murk_sky_cie_type(1) == 1 && murk_sky_cie_type(8) == 12);
}

/* A year of quarters of an hour, which needs more memory than one of hours. */
static void test_long(void)
{
    enum { ROWS = 365 * 24 * 4 };
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const size_t size = 1000 + (size_t)ROWS * 128;
    char *text = malloc(size);
    size_t n =
        (size_t)snprintf(text, size, "%s", HEAD PERIODS(1, 4) /* then rows */);
    for (int month = 1; month <= 12; ++month) {
        for (int i = 0; i < 96 * days[month - 1]; ++i) {
            n += (size_t)snprintf(text + n, size - n,
                                  ROW("2010,%d,%d,%d,%d", "0,0,%d",
                                      "8,8,9,3300,9,999999999", "999,99"),
                                  month, i / 96 + 1, i / 4 % 24 + 1,
                                  15 * (i % 4 + 1), i % 1000);
        }
    }
    murk_error err = {0};
    murk_weather_year *year = parse(text, &err);
    CHECK_TEXT(err.text, "");
    CHECK(year && year->n == ROWS && year->interval_min == 15);
    const murk_weather_row *row =
        year ? murk_weather_year_at(year, utc("2010-12-31T23:50:00-07:00"))
             : NULL;
    CHECK(row && row->seen.diffuse_w_per_m2 == (96 * 31 - 1) % 1000);
    CHECK(row && row->ends_min == 1440 && row->line == 5 + ROWS);
    murk_weather_year_release(year);
    free(text);
}

static murk_weather_year *read_year(const char *path, double altitude_m)
{
    murk_weather_year *year = NULL;
    CHECK(!murk_weather_year_read(&year, path, NULL));
    CHECK(year && year->altitude_m == altitude_m && year->n == 1);
    return year;
}

/* A file is read once, as long as it is the same and not too many others came
 * between; a year lives as long as its last owner. */
static void test_shared(void)
{
    char name[6][32];
    murk_weather_year *year[6];
    static const char *const row =
        ROW("1999,1,1,1,0", "0,0,0", "8,8,16.1,3300,9,999999999", "999.0,99.0");
    for (int i = 0; i < 6; ++i) {
        char text[1024];
        snprintf(name[i], sizeof name[i], "/tmp/murk-year-%d-%d.epw",
                 (int)getpid(), i);
        snprintf(
            text, sizeof text,
            "LOCATION,P,X,Y,TMY3,1,39.7,-105.1,-7.0,%d.0\n" PERIODS(1, 1) "%s",
            100 + i, row);
        write_text(name[i], text);
        year[i] = read_year(name[i], 100 + i);
        murk_weather_year *again = read_year(name[i], 100 + i);
        CHECK(again == year[i]);
        murk_weather_year_release(again);
    }
    /* The last four are remembered, and the first ones read anew. */
    murk_weather_year *const last = read_year(name[2], 102), *const first =
                                                                 read_year(
                                                                     name[0],
                                                                     100);
    CHECK(last == year[2] && first != year[0]);
    murk_weather_year_release(last);
    murk_weather_year_release(first);
    /* Another file of that name. */
    char text[1024];
    snprintf(
        text, sizeof text,
        "LOCATION,P,X,Y,TMY3,1,39.7,-105.1,-7.0,17.0\n" PERIODS(1, 1) "%s\n",
        row);
    write_text(name[5], text);
    murk_weather_year *const changed = read_year(name[5], 17);
    CHECK(year[5]->altitude_m == 105);
    murk_weather_year_release(changed);
    for (int i = 0; i < 6; ++i) {
        murk_weather_year_release(year[i]);
        unlink(name[i]);
    }
    murk_weather_year_release(NULL);
    /* A file that is gone is not remembered. */
    murk_error err = {0};
    murk_weather_year *none = NULL;
    CHECK(murk_weather_year_read(&none, name[5], &err) == MURK_BAD_FILE);
    CHECK(none == NULL && strstr(err.text, "cannot read"));
}

int main(void)
{
    test_rows();
    test_codes();
    test_other_programs();
    test_quarters();
    test_refused();
    test_clearness();
    test_shared();
    test_long();
    return check_done();
}
