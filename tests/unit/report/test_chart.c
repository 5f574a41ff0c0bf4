/* Plots as drawn: where axes put values and ticks, gaps, whiskers, bars as long
 * as their values, fields of which each cell is drawn once. Nothing here is
 * random. */
#include "check.h"
#include "report/chart.h"
#include "report/chart_bars.h"
#include "report/chart_heat.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static char kept[1 << 18];

#define WRITTEN(call)                                         \
    do {                                                      \
        FILE *to = tmpfile();                                 \
        CHECK(to != NULL);                                    \
        if (to) {                                             \
            call;                                             \
            rewind(to);                                       \
            kept[fread(kept, 1, sizeof kept - 1, to)] = '\0'; \
            fclose(to);                                       \
        }                                                     \
    } while (0)

static size_t count(const char *what)
{
    size_t n = 0;
    for (const char *at = strstr(kept, what); at; at = strstr(at + 1, what)) {
        ++n;
    }
    return n;
}

/* The number behind the first `what`. */
static double after(const char *what)
{
    const char *at = strstr(kept, what);
    return at ? strtod(at + strlen(what), NULL) : NAN;
}

/* ---- axes ---- */

static murk_axis axis_over(double low, double high, murk_axis_scale scale)
{
    murk_axis a = murk_axis_of(0, 100, scale);
    murk_axis_widen(&a, low);
    murk_axis_widen(&a, high);
    murk_axis_close(&a, 0);
    return a;
}

static void check_ticks(double low, double high, murk_axis_scale scale,
                        const char *want)
{
    double tick[MURK_TICKS_MAX], step;
    const murk_axis a = axis_over(low, high, scale);
    const size_t n = murk_axis_ticks(tick, &step, &a);
    WRITTEN(for (size_t i = 0; i < n; ++i) {
        fputs(i > 0 ? " " : "", to);
        murk_axis_write(to, &a, tick[i], step);
    });
    CHECK_TEXT(kept, want);
}

static void test_ticks_are_round(void)
{
    check_ticks(0, 1, MURK_SCALE_EVEN, "0.0 0.2 0.4 0.6 0.8 1.0");
    check_ticks(-3, 3, MURK_SCALE_EVEN, "-3 -2 -1 0 1 2 3");
    check_ticks(0.00012, 0.00031, MURK_SCALE_EVEN,
                "0.00015 0.00020 0.00025 0.00030");
    check_ticks(0, 4e20, MURK_SCALE_EVEN,
                "0 10\xc2\xb2\xe2\x81\xb0 2\xc2\xb7"
                "10\xc2\xb2\xe2\x81\xb0 3\xc2\xb7"
                "10\xc2\xb2\xe2\x81\xb0 4\xc2\xb7"
                "10\xc2\xb2\xe2\x81\xb0");
    check_ticks(1, 3, MURK_SCALE_WHOLE, "1 2 3");
    check_ticks(0.25, 0.5, MURK_SCALE_SHARE, "25 % 30 % 35 % 40 % 45 % 50 %");
    check_ticks(0, 23, MURK_SCALE_CLOCK,
                "00:00 03:00 06:00 09:00 12:00 15:00 18:00 21:00");
    check_ticks(8.5, 10, MURK_SCALE_CLOCK,
                "08:30 08:45 09:00 09:15 09:30 09:45 10:00");
    check_ticks(30, 10000, MURK_SCALE_LOG,
                "50 100 200 500 1000 2000 5000 10000");
    check_ticks(1, 1e6, MURK_SCALE_LOG,
                "1 10 100 1000 10000 10\xe2\x81\xb5 10\xe2\x81\xb6");
    check_ticks(110, 190, MURK_SCALE_LOG, "120 140 160 180");
}

static void test_places(void)
{
    const murk_axis even = axis_over(2, 4, MURK_SCALE_EVEN);
    CHECK(fabs(murk_axis_place(&even, 2.5) - 25) < 1e-9);
    CHECK(murk_axis_place(&even, 9) == 100 && murk_axis_place(&even, -9) == 0);
    const murk_axis log = axis_over(1, 100, MURK_SCALE_LOG);
    CHECK(fabs(murk_axis_place(&log, 10) - 50) < 1e-9);
    CHECK(murk_axis_place(&log, -1) == 0); /* a band's lower edge */
    const murk_axis vast = axis_over(-1e300, 1e300, MURK_SCALE_EVEN);
    CHECK(fabs(murk_axis_place(&vast, 0) - 50) < 1e-9);
    const murk_axis one = axis_over(7, 7, MURK_SCALE_EVEN);
    CHECK(fabs(murk_axis_place(&one, 7) - 50) < 1e-9);
    const murk_axis min = axis_over(0, 5e-324, MURK_SCALE_EVEN);
    CHECK(isfinite(murk_axis_place(&min, 0)));
}

/* ---- lines and points ---- */

static void test_a_gap_breaks_a_line_and_its_band(void)
{
    const double x[] = {0, 1, 2, 3, 4, 5};
    const double y[] = {1, 2, NAN, 4, INFINITY, 3};
    const double low[] = {0, 1, 2, 3, 4, 2}, high[] = {2, 3, 4, 5, 6, 4};
    const murk_chart_series s = {.name = "<a>",
                                 .n = 6,
                                 .x = x,
                                 .y = y,
                                 .low = low,
                                 .high = high,
                                 .is_line = true};
    const murk_chart c = {.title = "t\"", .x_title = "x", .y_title = "y"};
    WRITTEN(murk_chart_draw(to, &c, &s, 1));
    CHECK(count("<path class=\"line s0\"") == 3);
    CHECK(count("<path class=\"band s0\"") == 3);
    CHECK(count("<path class=\"point s0\"") == 4);
    CHECK(count("whisker") == 0);
    CHECK(count("nan") == 0 && count("inf") == 0);
    CHECK(count("<a>") == 0 && count("&lt;a&gt;: 4 points, from 1 to 4") == 1);
    CHECK(count("aria-label=\"t&quot;\"") == 1);
    CHECK(count("<title>&lt;a&gt;: 0, 1 (0 to 2)</title>") == 1);
}

static void test_whiskers_where_there_is_a_range(void)
{
    const double x[] = {0, 1}, y[] = {0.5, 0.6};
    const double low[] = {0.4, NAN}, high[] = {0.6, NAN};
    const murk_chart_series s = {
        .name = "a", .n = 2, .x = x, .y = y, .low = low, .high = high};
    const char *const names[] = {"clear", "fog"};
    const murk_chart c = {.title = "t",
                          .x_title = "x",
                          .y_title = "y",
                          .x_name = names,
                          .x_names = 2,
                          .y = MURK_SCALE_SHARE};
    WRITTEN(murk_chart_draw(to, &c, &s, 1));
    CHECK(count("whisker") == 1 && count("<path class=\"point") == 2);
    CHECK(count(">fog</text>") == 1);
    CHECK(count("<title>a: clear, 50 % (40 % to 60 %)</title>") == 1);
}

static void test_nothing_is_drawn_of_nothing(void)
{
    const double none[] = {NAN, NAN}, x[] = {1, 2}, below[] = {-1, 0};
    const murk_chart_series s = {.name = "a", .n = 2, .x = x, .y = none};
    const murk_chart_series b = {.name = "a", .n = 2, .x = x, .y = below};
    const murk_chart c = {.title = "t", .x_title = "x", .y_title = "y"};
    const murk_chart log = {
        .title = "t", .x_title = "x", .y_title = "y", .y = MURK_SCALE_LOG};
    WRITTEN(murk_chart_draw(to, &c, &s, 1));
    CHECK_TEXT(kept, "");
    WRITTEN(murk_chart_draw(to, &c, NULL, 0));
    CHECK_TEXT(kept, "");
    WRITTEN(murk_chart_draw(to, &log, &b, 1));
    CHECK_TEXT(kept, "");
}

/* ---- bars ---- */

static void test_bars_are_as_long_as_their_values(void)
{
    static const char *const name[] = {"one", "two & more"};
    static const char *const part[] = {"a", "b"};
    const double value[] = {0.2, 0.1, 0.4, 0};
    const murk_bars bars = {.title = "t",
                            .axis_title = "x",
                            .rows = 2,
                            .parts = 2,
                            .name = name,
                            .part = part,
                            .value = value,
                            .scale = MURK_SCALE_SHARE};
    WRITTEN(murk_bars_draw(to, &bars));
    /* three parts and the legend's two */
    CHECK(count("<rect class=\"bar") == 5);
    const char *second = strstr(kept, "two &amp; more");
    CHECK(second != NULL);
    const double first_width = after("width=\"");
    const char *at = second ? strstr(second, "width=\"") : NULL;
    const double second_width = at ? strtod(at + 7, NULL) : NAN;
    CHECK(fabs(second_width / first_width - 2) < 0.01);
    CHECK(count("30.00 %") == 1 && count("40.00 %") == 1);
}

static void test_bars_of_either_sign_and_none(void)
{
    static const char *const name[] = {"a", "b", "c"};
    const double value[] = {-1, 2, NAN}, low[] = {-2, 1, 0}, high[] = {0, 3, 0};
    const murk_bars bars = {.title = "t",
                            .axis_title = "x",
                            .rows = 3,
                            .parts = 1,
                            .name = name,
                            .value = value,
                            .low = low,
                            .high = high};
    WRITTEN(murk_bars_draw(to, &bars));
    CHECK(count("<rect class=\"bar") == 2);
    CHECK(count("class=\"error\"") == 2);
    CHECK(count("nan") == 0 && count("width=\"-") == 0);
    const double none[] = {NAN, NAN, INFINITY};
    const murk_bars empty = {.title = "t",
                             .axis_title = "x",
                             .rows = 3,
                             .parts = 1,
                             .name = name,
                             .value = none};
    WRITTEN(murk_bars_draw(to, &empty));
    CHECK_TEXT(kept, "");
}

/* ---- fields ---- */

/* Cells of all runs of the field: "M0 0.5h3". */
static size_t cells_drawn(void)
{
    size_t n = 0;
    const char *at = strstr(kept, "<g transform");
    const char *end = at ? strstr(at, "</g>") : NULL;
    for (; at && at < end; ++at) {
        if (*at == 'h' && at[-1] == '5' && at[-2] == '.') {
            n += strtoul(at + 1, NULL, 10);
        }
    }
    return n;
}

static void test_each_cell_is_drawn_once(void)
{
    double value[12 * 7];
    for (size_t i = 0; i < 12 * 7; ++i) {
        value[i] = (double)(i * i % 31) + 1;
    }
    murk_heat heat = {.title = "t",
                      .x_title = "x, m",
                      .y_title = "y, m",
                      .value_title = "W",
                      .x = {0, 6},
                      .y = {-2, 2},
                      .size = {12, 7},
                      .value = value,
                      .min = NAN,
                      .max = NAN,
                      .is_equal = true};
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(cells_drawn() == 12 * 7);
    value[5] = NAN;
    value[6] = -1;
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(cells_drawn() == 12 * 7 - 1);
    heat.is_log = true;
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(cells_drawn() == 12 * 7 - 2);
    CHECK(count("2 of them blank") == 2 && count("nan") == 0);
}

/* The middle of the largest cell, and lowest and highest colour. */
static void test_a_field_says_where_its_max_is(void)
{
    const double value[] = {0, 1, 2, 9, 4, 5};
    const murk_heat heat = {.title = "t",
                            .x_title = "x",
                            .y_title = "y",
                            .value_title = "W",
                            .x = {10, 13},
                            .y = {0, 4},
                            .size = {3, 2},
                            .value = value,
                            .min = NAN,
                            .max = NAN};
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(count("from 0 to 9 W, which is at 10.5, 3.") == 2);
    CHECK(count("stroke=\"#440154\" d=\"M0 0.5h1\"") == 1);
    CHECK(count("stroke=\"#fde725\" d=\"M0 1.5h1\"") == 1);
}

/* A row of cells is drawn low, a column of them as high as any field. */
static void test_a_row_of_cells_is_low(void)
{
    const double value[] = {1, 2, 3};
    murk_heat heat = {.title = "t",
                      .x_title = "x",
                      .y_title = "y",
                      .value_title = "W",
                      .x = {0, 3},
                      .y = {0, 1},
                      .size = {3, 1},
                      .value = value,
                      .min = NAN,
                      .max = NAN};
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(cells_drawn() == 3);
    CHECK(count("scale(143.33 -40)") == 1);
    heat.size[0] = 1;
    heat.size[1] = 3;
    WRITTEN(murk_heat_draw(to, &heat));
    CHECK(cells_drawn() == 3);
    CHECK(count("scale(430 -107.5)") == 1);
}

int main(void)
{
    test_a_row_of_cells_is_low();
    test_ticks_are_round();
    test_places();
    test_a_gap_breaks_a_line_and_its_band();
    test_whiskers_where_there_is_a_range();
    test_nothing_is_drawn_of_nothing();
    test_bars_are_as_long_as_their_values();
    test_bars_of_either_sign_and_none();
    test_each_cell_is_drawn_once();
    test_a_field_says_where_its_max_is();
    return check_done();
}
