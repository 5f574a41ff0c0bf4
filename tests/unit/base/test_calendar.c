/* Dates and times: what is read, what is refused, and Julian dates of Meeus,
 * Astronomical Algorithms, 2nd ed. 1998, ch. 7. Exact: never cries wolf. */
#include "base/calendar.h"
#include "check.h"

static void test_julian_dates(void)
{
    static const struct {
        const char *text;
        double julian;
    } cases[] = {
        {"1957-10-04T19:26:24Z", 2436116.31},
        {"2000-01-01T12:00:00Z", 2451545.0},
        {"1987-01-27T00:00:00Z", 2446822.5},
        {"1900-01-01T00:00:00Z", 2415020.5},
        {"1600-12-31T00:00:00Z", 2305812.5},
        {"2003-10-17T12:30:30-07:00", 2452930.312847},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        double local;
        bool has_zone;
        int zone;
        CHECK(murk_time_read(cases[i].text, &local, &has_zone, &zone));
        CHECK(has_zone);
        CHECK_NEAR(murk_julian_date(local - 60.0 * zone), cases[i].julian,
                   5e-7);
    }
}

static void test_days_convert_in_both_directions(void)
{
    for (double days = -730000; days < 2930000; days += 97) {
        const murk_date d = murk_date_of_days(days);
        CHECK(murk_date_days(d) == days);
    }
    const murk_date leap =
        murk_date_of_days(murk_date_days((murk_date){2024, 2, 28}) + 1);
    CHECK(leap.month == 2 && leap.day == 29);
    const murk_date none =
        murk_date_of_days(murk_date_days((murk_date){2100, 2, 28}) + 1);
    CHECK(none.month == 3 && none.day == 1);
}

static void test_reading(void)
{
    /* Times of day, with and without seconds; 24:00 is allowed. */
    double s;
    int zone;
    bool has_zone;
    murk_date d;
    CHECK(murk_clock_read("06:30", &s) && s == 23400);
    CHECK(murk_clock_read("23:59:59.25", &s) && s == 86399.25);
    CHECK(murk_clock_read("24:00", &s) && s == 86400);
    CHECK(murk_clock_read("00:00", &s) && s == 0);
    CHECK(murk_clock_read("00:59:59.5", &s) && s == 3599.5);
    CHECK(murk_clock_read("24:00:00", &s) && s == 86400);
    /* Time zones, in minutes, and a time with a zone. */
    CHECK(murk_zone_read("z", &zone) && zone == 0);
    CHECK(murk_zone_read("+18:59", &zone) && zone == 1139);
    CHECK(murk_zone_read("-18", &zone) && zone == -1080);
    CHECK(murk_time_read("2024-02-29T00:00:00z", &s, &has_zone, &zone) &&
          has_zone && zone == 0);
    /* Dates, with a leap day of a year that is a multiple of 400. */
    CHECK(murk_date_read("2000-02-29", &d) && d.month == 2 && d.day == 29);
    CHECK(murk_date_read("2026-12-31", &d) && d.month == 12 && d.day == 31);
    CHECK(murk_date_read("0001-01-01", &d) && d.year == 1);
    /* Other forms of a zone, a time without a zone, and the last day of a
     * short month. */
    CHECK(murk_zone_read("Z", &zone) && zone == 0);
    CHECK(murk_zone_read("+02:00", &zone) && zone == 120);
    CHECK(murk_zone_read("-0330", &zone) && zone == -210);
    CHECK(murk_zone_read("+5", &zone) && zone == 300);
    CHECK(murk_time_read("2026-06-21 12:00", &s, &has_zone, &zone));
    CHECK(!has_zone);
    CHECK(murk_date_read("2026-02-28", &d) && d.year == 2026 && d.day == 28);
}

static void test_refusals(void)
{
    /* Times with parts that are missing, out of range or too long. */
    static const char *const times[] = {
        "",
        "2026",
        "2026-06-21",
        "2026-06-21T",
        "2026-13-01T00:00Z",
        "2026-02-29T00:00Z",
        "2026-06-21T24:01Z",
        "2026-06-21T12:60Z",
        "2026-06-21T12:00:60Z",
        "2026-06-21T12:00Zz",
        "2026-06-21T12:00+19:00",
        "2026-06-21T12:00:00.Z",
        " 2026-06-21T12:00Z",
        "2026-6-21T12:00Z",
    };
    double s = -1;
    int zone;
    bool has_zone;
    for (size_t i = 0; i < sizeof times / sizeof *times; ++i) {
        CHECK(!murk_time_read(times[i], &s, &has_zone, &zone));
    }
    /* A refused date leaves the result as it was. */
    static const char *const dates[] = {
        "1900-02-29", "2026-04-31", "2026-00-01",  "2026-01-00",
        "2026-13-01", "2026-01-32", "2026/01-01",  "2026-01/01",
        "2026-01-1",  "26-01-01",   "2026-01-01 ", "2026-1-01"};
    for (size_t i = 0; i < sizeof dates / sizeof *dates; ++i) {
        murk_date d = {-1, -1, -1};
        CHECK(!murk_date_read(dates[i], &d) && d.year == -1);
    }
    /* Times of day. */
    static const char *const clocks[] = {
        "",         "06",     "06:",      "06.30",     "06:3",
        "06:60",    "06:30:", "06:30:60", "06:30:5",   "06:30:05.",
        "24:00:01", "24:01",  "25:00",    "06:30:05.x"};
    for (size_t i = 0; i < sizeof clocks / sizeof *clocks; ++i) {
        CHECK(!murk_clock_read(clocks[i], &s));
    }
    /* Time zones. */
    static const char *const zones[] = {
        "",       "ZZ",    "+19", "+02:",    "+02:6",
        "+02:60", "+0260", "2",   "+02:000", "-x"};
    for (size_t i = 0; i < sizeof zones / sizeof *zones; ++i) {
        CHECK(!murk_zone_read(zones[i], &zone));
    }
    /* Single cases; no refused time has changed the result. */
    CHECK(!murk_time_read("2026-06-21x12:00", &s, &has_zone, &zone));
    CHECK(!murk_clock_read("6:00", &s));
    CHECK(!murk_clock_read("06:00 ", &s));
    CHECK(!murk_zone_read("02:00", &zone));
    CHECK(!murk_zone_read("+", &zone));
    CHECK(s == -1);
}

static void test_printing(void)
{
    char text[MURK_TIME_SIZE];
    double local;
    bool has_zone;
    int zone;
    CHECK(
        murk_time_read("2026-06-21T14:00:05+02:00", &local, &has_zone, &zone));
    murk_time_print(text, local - 60.0 * zone, zone);
    CHECK_TEXT(text, "2026-06-21T14:00:05+02:00");
    murk_time_print(text, local - 60.0 * zone, 0);
    CHECK_TEXT(text, "2026-06-21T12:00:05Z");
    murk_time_print(text, -1, -210);
    CHECK_TEXT(text, "1969-12-31T20:29:59-03:30");
}

int main(void)
{
    test_julian_dates();
    test_days_convert_in_both_directions();
    test_reading();
    test_refusals();
    test_printing();
    return check_done();
}
