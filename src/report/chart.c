#include "report/chart.h"

#include "base/utf8.h"
#include "report/html.h"

#include <math.h>
#include <string.h>

/* The plot in user units, which the page scales. */
#define WIDTH     640.0
#define BASE      308.0 /* where the axis of x lies */
#define LEFT      80.0
#define RIGHT     16.0
#define TOP       14.0
#define BELOW     52.0 /* room for ticks and name of that axis */
#define SLANTED   20   /* characters of a name on a slant: what fits */
#define LEGEND    20.0 /* height of a row of it */
#define CHARACTER 7.0  /* width of one, about */
#define MAX       1e300
#define ROOM      0.06 /* above and below the data, in shares */

/* Points of a plot beyond which none says its own values. */
#define TOLD_MAX 300

typedef struct plot {
    const murk_chart *chart;
    murk_axis x, y;
    double below;    /* height under the axis of x */
    bool is_slanted; /* its names */
    bool is_telling;
} plot;

/* ---- what is drawn ---- */

/* Finite, and so that a range of two of them is. */
static bool is_known(double value)
{
    return fabs(value) <= MAX;
}

static bool is_drawn(const murk_chart *c, const murk_chart_series *s, size_t i)
{
    return is_known(s->x[i]) && is_known(s->y[i]) &&
           !(c->x == MURK_SCALE_LOG && !(s->x[i] > 0)) &&
           !(c->y == MURK_SCALE_LOG && !(s->y[i] > 0));
}

static bool has_range(const murk_chart_series *s, size_t i)
{
    return s->low && s->high && is_known(s->low[i]) && is_known(s->high[i]);
}

static size_t step_of(const murk_chart_series *s)
{
    return s->n / MURK_CHART_POINTS_MAX + 1;
}

static void fit_y(murk_axis *y, const murk_chart *c)
{
    for (size_t i = 0; i < c->y_lines; ++i) {
        murk_axis_widen(y, c->y_line[i]);
    }
    const double low = y->low, high = y->high;
    const bool is_log = c->y == MURK_SCALE_LOG;
    murk_axis_close(y, ROOM);
    if (!is_log && low >= 0 && (low < 0.5 * high || y->low < 0)) {
        y->low = 0;
    }
    if (c->y == MURK_SCALE_SHARE && high <= 1 && y->high > 1) {
        y->high = 1.005;
    }
}

/* Of all that is drawn; false where that is nothing. */
static bool fit_axes(plot *p, const murk_chart_series *series, size_t n)
{
    const murk_chart *c = p->chart;
    size_t points = 0;
    for (size_t k = 0; k < n; ++k) {
        const murk_chart_series *s = &series[k];
        for (size_t i = 0; i < s->n; ++i) {
            if (!is_drawn(c, s, i)) {
                continue;
            }
            ++points;
            murk_axis_widen(&p->x, s->x[i]);
            murk_axis_widen(&p->y, s->y[i]);
            if (has_range(s, i) && c->y != MURK_SCALE_LOG) {
                murk_axis_widen(&p->y, s->low[i]);
                murk_axis_widen(&p->y, s->high[i]);
            }
        }
    }
    if (points == 0) {
        return false;
    }
    p->is_telling = points <= TOLD_MAX;
    fit_y(&p->y, c);
    murk_axis_close(&p->x, 0);
    if (c->x_names > 0) {
        p->x.low = -0.5;
        p->x.high = (double)c->x_names - 0.5;
    }
    return true;
}

static size_t characters_of(const char *text)
{
    size_t n = 0;
    for (; *text; ++n) {
        const size_t length = murk_utf8_length(text);
        text += length > 0 ? length : 1;
    }
    return n;
}

/* On a slant where they would run into each other. */
static void fit_names(plot *p)
{
    const murk_chart *c = p->chart;
    size_t max = 0;
    for (size_t i = 0; i < c->x_names; ++i) {
        const size_t length = characters_of(c->x_name[i]);
        max = length > max ? length : max;
    }
    const double width = CHARACTER * (double)max;
    const double room = (p->x.to - p->x.from) / fmax((double)c->x_names, 1);
    const size_t shown = max < SLANTED ? max : SLANTED;
    p->is_slanted = c->x_names > 0 && width > room - 4;
    p->below = BELOW + (p->is_slanted ? 0.7 * CHARACTER * (double)shown : 0);
}

/* On a slant the end of a name, which tells more than its beginning. */
static void write_name(FILE *to, const plot *p, const char *name)
{
    size_t n = characters_of(name);
    if (p->is_slanted && n > SLANTED) {
        for (; n > SLANTED - 1; --n) {
            const size_t length = murk_utf8_length(name);
            name += length > 0 ? length : 1;
        }
        fputs("…", to);
    }
    murk_page_text(to, name);
}

/* ---- axes ---- */

static void draw_y_ticks(FILE *to, const plot *p)
{
    double tick[MURK_TICKS_MAX], step;
    const size_t n = murk_axis_ticks(tick, &step, &p->y);
    for (size_t i = 0; i < n; ++i) {
        const double at = murk_axis_place(&p->y, tick[i]);
        fprintf(to,
                "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/>"
                "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
                "text-anchor=\"end\">",
                LEFT, at, WIDTH - RIGHT, LEFT - 6, at + 4);
        murk_axis_write(to, &p->y, tick[i], step);
        fputs("</text>\n", to);
    }
}

static void begin_x_tick(FILE *to, const plot *p, double at)
{
    fprintf(to, "<path class=\"axis\" d=\"M%.1f %.1fv5\"/>", at, BASE);
    if (p->is_slanted) {
        fprintf(to,
                "<text class=\"tick\" transform=\"translate(%.1f %.1f) "
                "rotate(-40)\" text-anchor=\"end\">",
                at + 4, BASE + 16);
    } else {
        fprintf(to,
                "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
                "text-anchor=\"middle\">",
                at, BASE + 19);
    }
}

/* Of names as many as there is room for. */
static void draw_x_ticks(FILE *to, const plot *p)
{
    const murk_chart *c = p->chart;
    double tick[MURK_TICKS_MAX], step;
    const size_t n = c->x_names > 0 ? 0 : murk_axis_ticks(tick, &step, &p->x);
    for (size_t i = 0; i < n; ++i) {
        begin_x_tick(to, p, murk_axis_place(&p->x, tick[i]));
        murk_axis_write(to, &p->x, tick[i], step);
        fputs("</text>\n", to);
    }
    const double room = (p->x.to - p->x.from) / fmax((double)c->x_names, 1);
    const size_t stride = room < 18 ? (size_t)ceil(18 / room) : 1;
    for (size_t i = 0; i < c->x_names; i += stride) {
        begin_x_tick(to, p, murk_axis_place(&p->x, (double)i));
        write_name(to, p, c->x_name[i]);
        fputs("</text>\n", to);
    }
}

static void draw_axes(FILE *to, const plot *p)
{
    const murk_chart *c = p->chart;
    draw_y_ticks(to, p);
    draw_x_ticks(to, p);
    fprintf(to,
            "<path class=\"axis\" d=\"M%.1f %.1fV%.1fH%.1f\"/>"
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"middle\">",
            LEFT, TOP, BASE, WIDTH - RIGHT, (LEFT + WIDTH - RIGHT) / 2,
            BASE + p->below - 12);
    murk_page_text(to, c->x_title);
    fprintf(to,
            "</text><text class=\"name\" transform=\"translate(14 %.1f) "
            "rotate(-90)\" text-anchor=\"middle\">",
            (TOP + BASE) / 2);
    murk_page_text(to, c->y_title);
    fputs("</text>\n", to);
    for (size_t i = 0; i < c->y_lines; ++i) {
        fprintf(to, "<path class=\"across\" d=\"M%.1f %.1fH%.1f\"/>\n", LEFT,
                murk_axis_place(&p->y, c->y_line[i]), WIDTH - RIGHT);
    }
}

/* ---- series ---- */

static double x_of(const plot *p, const murk_chart_series *s, size_t i)
{
    return murk_axis_place(&p->x, s->x[i]);
}

/* From point `begin`, which is drawn, to the last before a gap; what follows
 * that. */
static size_t end_of_run(const plot *p, const murk_chart_series *s,
                         size_t begin, bool needs_range)
{
    size_t i = begin;
    while (i < s->n && is_drawn(p->chart, s, i) &&
           (!needs_range || has_range(s, i))) {
        i += step_of(s);
    }
    return i;
}

static void draw_band(FILE *to, const plot *p, const murk_chart_series *s,
                      size_t number)
{
    const size_t step = step_of(s);
    for (size_t begin = 0; begin < s->n; begin += step) {
        const size_t end = end_of_run(p, s, begin, true);
        if (end == begin) {
            continue;
        }
        for (size_t i = begin; i < end; i += step) {
            fprintf(to, i == begin ? "<path class=\"band s%zu\" d=\"M" : "L",
                    number);
            fprintf(to, "%.1f %.1f", x_of(p, s, i),
                    murk_axis_place(&p->y, s->high[i]));
        }
        for (size_t i = end; i > begin; i -= step) {
            fprintf(to, "L%.1f %.1f", x_of(p, s, i - step),
                    murk_axis_place(&p->y, s->low[i - step]));
        }
        fputs("Z\"/>\n", to);
        begin = end;
    }
}

static void draw_line(FILE *to, const plot *p, const murk_chart_series *s,
                      size_t number)
{
    const size_t step = step_of(s);
    for (size_t begin = 0; begin < s->n; begin += step) {
        const size_t end = end_of_run(p, s, begin, false);
        for (size_t i = begin; i < end; i += step) {
            fprintf(to, i == begin ? "<path class=\"line s%zu\" d=\"M" : "L",
                    number);
            fprintf(to, "%.1f %.1f", x_of(p, s, i),
                    murk_axis_place(&p->y, s->y[i]));
        }
        fputs(end > begin ? "\"/>\n" : "", to);
        begin = end;
    }
}

/* Shapes, so that series are told apart without colours. */
static void draw_mark(FILE *to, size_t number, double x, double y)
{
    static const char *const shape[] = {
        "m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0-6.4 0z", "m-3-3h6v6h-6z",
        "m0-4.2l4 7h-8z", "m0-4.4l4.4 4.4l-4.4 4.4l-4.4-4.4z"};
    fprintf(to, "<path class=\"point s%zu\" d=\"M%.1f %.1f%s\"", number, x, y,
            shape[number % 4]);
}

/* "held out: 12:00, 3.2 (3.1 to 3.3)" */
static void tell_point(FILE *to, const plot *p, const murk_chart_series *s,
                       size_t i)
{
    const murk_chart *c = p->chart;
    const size_t name = (size_t)fmax(0, floor(s->x[i] + 0.5));
    fputs("><title>", to);
    murk_page_text(to, s->name);
    fputs(": ", to);
    if (c->x_names > 0) {
        murk_page_text(to, name < c->x_names ? c->x_name[name] : "");
    } else {
        murk_axis_write(to, &p->x, s->x[i], 0);
    }
    fputs(", ", to);
    murk_axis_write(to, &p->y, s->y[i], 0);
    if (has_range(s, i) && s->low[i] < s->high[i]) {
        fputs(" (", to);
        murk_axis_write(to, &p->y, s->low[i], 0);
        fputs(" to ", to);
        murk_axis_write(to, &p->y, s->high[i], 0);
        fputc(')', to);
    }
    fputs("</title></path>\n", to);
}

static void draw_points(FILE *to, const plot *p, const murk_chart_series *s,
                        size_t number)
{
    for (size_t i = 0; i < s->n; i += step_of(s)) {
        if (!is_drawn(p->chart, s, i)) {
            continue;
        }
        const double at = x_of(p, s, i);
        if (!s->is_line && has_range(s, i)) {
            fprintf(to, "<path class=\"whisker s%zu\" d=\"M%.1f %.1fV%.1f\"/>",
                    number, at, murk_axis_place(&p->y, s->low[i]),
                    murk_axis_place(&p->y, s->high[i]));
        }
        draw_mark(to, number, at, murk_axis_place(&p->y, s->y[i]));
        if (p->is_telling) {
            tell_point(to, p, s, i);
        } else {
            fputs("/>\n", to);
        }
    }
}

/* ---- legend and words ---- */

static size_t legend_columns(const murk_chart_series *series, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        if (CHARACTER * (double)strlen(series[k].name) > 240) {
            return 1;
        }
    }
    return 2;
}

static void draw_legend(FILE *to, const plot *p,
                        const murk_chart_series *series, size_t n,
                        size_t columns)
{
    for (size_t k = 0; k < n; ++k) {
        const double x =
            LEFT + (double)(k % columns) * (WIDTH - LEFT) / (double)columns;
        const double y = BASE + p->below + LEGEND * (double)(k / columns) + 8;
        if (series[k].is_line) {
            fprintf(to, "<path class=\"line s%zu\" d=\"M%.1f %.1fh22\"/>", k, x,
                    y - 4);
        }
        draw_mark(to, k, x + 11, y - 4);
        fprintf(to, "/><text class=\"tick\" x=\"%.1f\" y=\"%.1f\">", x + 28, y);
        murk_page_text(to, series[k].name);
        fputs("</text>\n", to);
    }
}

/* Of each series where it begins and ends, and its extremes. */
static void describe(FILE *to, const plot *p, const murk_chart_series *series,
                     size_t n)
{
    fputs("<desc>", to);
    murk_page_text(to, p->chart->y_title);
    fputs(" against ", to);
    murk_page_text(to, p->chart->x_title);
    for (size_t k = 0; k < n; ++k) {
        const murk_chart_series *s = &series[k];
        double min = INFINITY, max = -INFINITY;
        size_t points = 0;
        for (size_t i = 0; i < s->n; ++i) {
            if (is_drawn(p->chart, s, i)) {
                min = fmin(min, s->y[i]);
                max = fmax(max, s->y[i]);
                ++points;
            }
        }
        fputs("; ", to);
        murk_page_text(to, s->name);
        fprintf(to, ": %zu point%s", points, points == 1 ? "" : "s");
        if (points > 0) {
            fputs(", from ", to);
            murk_axis_write(to, &p->y, min, 0);
            fputs(" to ", to);
            murk_axis_write(to, &p->y, max, 0);
        }
    }
    fputs(".</desc>\n", to);
}

void murk_chart_draw(FILE *to, const murk_chart *chart,
                     const murk_chart_series *series, size_t n)
{
    n = n > MURK_CHART_SERIES_MAX ? MURK_CHART_SERIES_MAX : n;
    plot p = {.chart = chart,
              .x = murk_axis_of(LEFT + 8, WIDTH - RIGHT - 8, chart->x),
              .y = murk_axis_of(BASE, TOP, chart->y)};
    if (!fit_axes(&p, series, n)) {
        return;
    }
    fit_names(&p);
    const size_t columns = legend_columns(series, n);
    const size_t rows = n > 1 ? (n + columns - 1) / columns : 0;
    fprintf(to,
            "<figure>\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "aria-label=\"",
            WIDTH, BASE + p.below + LEGEND * (double)rows);
    murk_page_text(to, chart->title);
    fputs("\">\n", to);
    describe(to, &p, series, n);
    draw_axes(to, &p);
    for (size_t k = 0; k < n; ++k) {
        if (series[k].is_line) {
            draw_band(to, &p, &series[k], k);
        }
    }
    /* the first one lies on top */
    for (size_t k = n; k-- > 0;) {
        if (series[k].is_line) {
            draw_line(to, &p, &series[k], k);
        }
        draw_points(to, &p, &series[k], k);
    }
    if (rows > 0) {
        draw_legend(to, &p, series, n, columns);
    }
    fputs("</svg>\n<figcaption>", to);
    murk_page_text(to, chart->title);
    fputs("</figcaption>\n</figure>\n", to);
}
