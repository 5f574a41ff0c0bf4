/* Weather years and reports with cells, rows or groups lost, doubled or
 * swapped, cut off, with bytes changed, and noise. A row or a cell of a weather
 * year that is lost or doubled is refused; whatever is read has numbers in
 * their ranges. Deterministic. Argument: the number of texts of each kind with
 * changed bytes (1,000; at night 100,000). */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "broken.h"
#include "check.h"
#include "weather/report.h"
#include "weather/year.h"

#include <stdlib.h>

#define TEXT_MAX 8000
#define ROWS     24

static const char METAR[] =
    "METAR KLAX 131253Z 08005KT 1 1/4SM R25L/0800V1000FT -DZ BR FEW005 OVC008 "
    "18/M07 A2986 RMK AO2 SLP108 P0013 T01781067 $";
static const char SYNOP[] = "AAXX 15061 10384 11/05 80302 10052 21050 30111 "
                            "40123 60025 74544 8807/ 333 10178=";

static char epw[TEXT_MAX];
static int read_well, refused;

/* A day of hours. */
static void make_epw(void)
{
    size_t n = (size_t)snprintf(
        epw, sizeof epw,
        "LOCATION,Place,XX,YYY,TMY3,1,39.74,-105.18,-7.0,1829.0\n"
        "COMMENTS 1,none\nDATA PERIODS,1,1,Data,Sunday, 6/ 1, 6/ 1\n");
    for (int h = 1; h <= ROWS; ++h) {
        n += (size_t)snprintf(
            epw + n, sizeof epw - n,
            "1999,6,1,%d,0,?9,%d.0,-4.0,92,80600,0,0,257,%d,%d,%d,0,0,0,0,0,"
            "0.0,8,8,%d.1,3300,9,999999999,89,0.0310,0,88,0.330,999.0,99.0\n",
            h, h - 12, h * 20, h * 10, h * 12, h);
    }
}

static bool is_in(double value, double min, double max)
{
    return isnan(value) || (value >= min && value <= max);
}

static void check_observation(const murk_observation *seen)
{
    CHECK(is_in(seen->direct_w_per_m2, 0, 2000) &&
          is_in(seen->diffuse_w_per_m2, 0, 2000) &&
          is_in(seen->global_w_per_m2, 0, 2000));
    CHECK(is_in(seen->sky_cover, 0, 1));
    CHECK(is_in(seen->visibility_m, 1e-9, 1e6));
    CHECK(seen->rain_mm_per_h >= 0 && seen->rain_mm_per_h <= 1000);
    CHECK(is_in(seen->temperature_c, -100, 100) &&
          is_in(seen->dew_point_c, -100, 100));
    CHECK(is_in(seen->pressure_hpa, 0, 3500));
    CHECK(strlen(seen->weather) < sizeof seen->weather);
}

/* ---- one text ---- */

static murk_status try_epw(const char *bytes, size_t size)
{
    char text[TEXT_MAX + 1];
    murk_weather_year *year = NULL;
    murk_error err = {0};
    memcpy(text, bytes, size);
    text[size] = '\0';
    const murk_status status =
        murk_weather_year_parse(&year, "w.epw", text, size, &err);
    if (status) {
        ++refused;
        CHECK(!year && status == MURK_BAD_FILE);
        CHECK(strncmp(err.where, "w.epw:", 6) == 0);
        broken_check_refusal(&err);
        return status;
    }
    ++read_well;
    for (size_t i = 0; i < year->n; ++i) {
        check_observation(&year->row[i].seen);
        const murk_weather_row *row = &year->row[i];
        CHECK(row->ends_min > 0 && row->ends_min <= 24 * 60);
    }
    murk_weather_year_release(year);
    return status;
}

static murk_status try_report(const char *text, bool is_synop)
{
    murk_observation seen;
    murk_error err = {0};
    const murk_status status =
        (is_synop ? murk_synop_read : murk_metar_read)(&seen, text, "w", &err);
    if (status) {
        ++refused;
        CHECK(status == MURK_BAD_VALUE);
        broken_check_refusal(&err);
    } else {
        ++read_well;
        check_observation(&seen);
    }
    return status;
}

static murk_status try_text(int kind, const char *text, size_t size)
{
    char copy[TEXT_MAX + 1];
    if (kind == 0) {
        return try_epw(text, size);
    }
    memcpy(copy, text, size);
    copy[size] = '\0';
    return try_report(copy, kind == 2);
}

/* ---- whole rows and cells ---- */

/* The text of a row that begins at `at`, with its line end. */
static size_t row_length(const char *at)
{
    return strcspn(at, "\n") + 1;
}

/* Each row lost, doubled, swapped with the next, or cut off with all behind. */
static void test_rows(void)
{
    char text[TEXT_MAX];
    const char *at = strstr(epw, "1999,");
    for (int i = 0; i < ROWS; ++i, at += row_length(at)) {
        const int head = (int)(at - epw), length = (int)row_length(at);
        const char *behind = at + length;
        snprintf(text, sizeof text, "%.*s%s", head, epw, behind);
        CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        snprintf(text, sizeof text, "%.*s%.*s%s", head, epw, length, at, at);
        CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        snprintf(text, sizeof text, "%.*s", head, epw);
        CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        if (i < ROWS - 1) {
            snprintf(text, sizeof text, "%.*s%.*s%.*s%s", head, epw,
                     (int)row_length(behind), behind, length, at,
                     behind + row_length(behind));
            CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        }
    }
}

/* Each cell of a row lost or doubled. */
static void test_cells(void)
{
    char text[TEXT_MAX];
    const char *row = strstr(epw, "1999,6,1,12,");
    int cells = 0;
    for (const char *at = row; at < row + row_length(row);
         at += strcspn(at, ",\n") + 1) {
        const int head = (int)(at - epw), length = (int)strcspn(at, ",\n") + 1;
        snprintf(text, sizeof text, "%.*s%s", head, epw, at + length);
        CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        snprintf(text, sizeof text, "%.*s%.*s,%s", head, epw, length - 1, at,
                 at);
        CHECK(try_epw(text, strlen(text)) == MURK_BAD_FILE);
        ++cells;
    }
    CHECK(cells == 35);
}

/* ---- groups ---- */

/* Reports without one of their groups, or with one twice, are read or refused
 * in one line; a lost group of the first ones, up to the visibility of a SYNOP,
 * is refused. */
static void test_groups(void)
{
    const char *const all[] = {METAR, SYNOP};
    for (int kind = 0; kind < 2; ++kind) {
        int number = 0;
        for (const char *at = all[kind]; *at; ++number) {
            char text[TEXT_MAX];
            const int head = (int)(at - all[kind]);
            const size_t length = strcspn(at, " ");
            const char *next = at + length + (at[length] == ' ');
            snprintf(text, sizeof text, "%.*s%s", head, all[kind], next);
            const murk_status lost = try_report(text, kind == 1);
            CHECK(lost || number > (kind == 1 ? 3 : 2) ||
                  (kind == 0 && number == 0)); /* METAR itself may miss */
            snprintf(text, sizeof text, "%.*s%.*s %s", head, all[kind],
                     (int)length, at, at);
            try_report(text, kind == 1);
            at = next;
        }
        CHECK(number > 10);
    }
}

/* ---- changed bytes ---- */

static void test_changed_bytes(uint64_t texts)
{
    static const char bytes[] = " \n\r\t,.-+0123456789eE=/\"SMKQARCTZ#";
    const char *const all[] = {epw, METAR, SYNOP};
    double slowest_s = 0;
    for (uint64_t i = 0; i < 3 * texts; ++i) {
        char text[TEXT_MAX];
        const char *from = all[i % 3];
        size_t size = strlen(from);
        memcpy(text, from, size);
        /* One to four bytes replaced, inserted, or removed with those behind.
         */
        for (uint32_t k = 0; k <= i / 3 % 4; ++k) {
            uint32_t word[4];
            murk_random_words(19, MURK_TEST, i, k, 0, word);
            const size_t at = murk_random_below(word[0], (uint32_t)size);
            const char by =
                word[3] % 8
                    ? bytes[murk_random_below(word[1], sizeof bytes - 1)]
                    : (char)(word[1] % 255 + 1);
            const size_t gone = word[2] % 4 == 3 ? word[2] / 4 % 30 : 1;
            if (word[2] % 4 == 1) { /* insert */
                memmove(text + at + 1, text + at, size - at);
                ++size;
            }
            if (word[2] % 4 < 2 || at + gone >= size) {
                text[at] = by;
            } else {
                memmove(text + at, text + at + gone, size - at - gone);
                size -= gone;
            }
        }
        const double start_s = murk_clock_s();
        try_text((int)(i % 3), text, size);
        slowest_s = fmax(slowest_s, murk_clock_s() - start_s);
    }
    printf(
        "%llu texts of each kind: %d read, %d refused so far; slowest %.3g s\n",
        (unsigned long long)texts, read_well, refused, slowest_s);
    CHECK(slowest_s < BROKEN_SLOWEST_S);
    CHECK(read_well > 0 && refused > 0);
}

static void test_noise(void)
{
    char noise[2001];
    for (uint64_t i = 0; i < 60; ++i) {
        broken_noise(noise, 2000, 20, i);
        CHECK(try_text((int)(i % 3), noise, 2000) != MURK_OK);
    }
    for (int kind = 0; kind < 3; ++kind) {
        CHECK(try_text(kind, "", 0) != MURK_OK);
        CHECK(try_text(kind, "\n\n", 2) != MURK_OK);
    }
}

/* A report of many groups, and of one long group. */
static void test_long_reports(void)
{
    char text[3 * MURK_REPORT_MAX];
    for (int kind = 1; kind < 3; ++kind) {
        for (size_t length = 1; length < sizeof text; length += 97) {
            const char *begin = kind == 1 ? "EGHI 150650Z " : "AAXX 15061 ";
            const size_t n = strlen(begin);
            memcpy(text, begin, n);
            for (size_t k = n; k < length + n && k < sizeof text - 1; ++k) {
                text[k] = length % 2 ? '9' : k % 2 ? 'A' : ' ';
                text[k + 1] = '\0';
            }
            try_report(text, kind == 2);
        }
    }
}

int main(int argc, char **argv)
{
    murk_warn_to(NULL);
    make_epw();
    CHECK(try_text(0, epw, strlen(epw)) == MURK_OK);
    CHECK(try_text(1, METAR, strlen(METAR)) == MURK_OK);
    CHECK(try_text(2, SYNOP, strlen(SYNOP)) == MURK_OK);
    test_rows();
    test_cells();
    test_groups();
    test_changed_bytes(argc > 1 ? strtoull(argv[1], NULL, 10) : 1000);
    test_noise();
    test_long_reports();
    CHECK(broken_peak_kb() < BROKEN_MAX_KB);
    return check_done();
}
