#include "app/chart.h"

#include "app/page.h"

#include <math.h>

/* The plot in user units, which the page scales. */
#define WIDTH  640.0
#define HEIGHT 360.0
#define LEFT   80.0
#define RIGHT  16.0
#define TOP    14.0
#define BOTTOM 52.0
#define LEGEND 20.0 /* height of a row of it */

#define TICKS_MAX 12

typedef struct axis {
    double low, high; /* of the data, in logarithms where is_log */
    double from, to;  /* on the plot */
    bool is_log;
} axis;

/* What is beyond the axis lies at its end: a band's lower edge may be below 0
 * where the axis is one of logarithms. */
static double place(const axis *a, double value)
{
    const double raw = a->is_log ? log10(value) : value;
    const double v = fmin(fmax(raw, a->low), a->high);
    return a->from + (v - a->low) / (a->high - a->low) * (a->to - a->from);
}

static void widen(axis *a, double value)
{
    const double v = a->is_log ? log10(value) : value;
    if (isfinite(v)) {
        a->low = fmin(a->low, v);
        a->high = fmax(a->high, v);
    }
}

static bool is_drawn(const murk_chart *c, const murk_chart_series *s, size_t i)
{
    return isfinite(s->x[i]) && isfinite(s->y[i]) &&
           !(c->log_x && !(s->x[i] > 0)) && !(c->log_y && !(s->y[i] > 0));
}

static size_t step_of(const murk_chart_series *s)
{
    return s->n / MURK_CHART_POINTS_MAX + 1;
}

static void fit_axes(axis *x, axis *y, const murk_chart *c,
                     const murk_chart_series *series, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        const murk_chart_series *s = &series[k];
        for (size_t i = 0; i < s->n; ++i) {
            if (!is_drawn(c, s, i)) {
                continue;
            }
            widen(x, s->x[i]);
            widen(y, s->y[i]);
            if (s->low && s->high && !c->log_y) {
                widen(y, s->low[i]);
                widen(y, s->high[i]);
            }
        }
    }
    for (size_t i = 0; i < c->y_lines; ++i) {
        widen(y, c->y_line[i]);
    }
    if (c->x_names > 0) {
        x->low = -0.5;
        x->high = (double)c->x_names - 0.5;
    }
    /* room about a single value, and about the ends */
    if (!(x->high > x->low)) {
        x->low -= 0.5;
        x->high += 0.5;
    }
    if (!(y->high > y->low)) {
        const double room = y->high != 0 ? 0.1 * fabs(y->high) : 1;
        y->low -= room;
        y->high += room;
    }
    const double room = 0.06 * (y->high - y->low);
    const bool is_from_0 = !c->log_y && y->low >= 0 && y->low < 0.5 * y->high;
    y->low = is_from_0 ? 0 : y->low - room;
    y->high += room;
    if (c->is_share && y->high > 1) {
        y->high = 1.005;
    }
}

/* A step of 1, 2 or 5 times a power of ten, for some 6 of them. */
static double tick_step(double range)
{
    const double rough = range / 6;
    const double ten = pow(10, floor(log10(rough)));
    const double m = rough / ten;
    return ten * (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10);
}

/* Powers of ten, and over less than three of them 2 and 5 times those. */
static size_t log_ticks(double out[TICKS_MAX], const axis *a)
{
    static const double within[] = {1, 2, 5};
    const double decades = a->high - a->low;
    const double stride = fmax(1, ceil(decades / 8));
    size_t n = 0;
    for (double e = floor(a->low / stride) * stride; e <= a->high;
         e += stride) {
        for (int k = 0; k < (decades > 3 ? 1 : 3) && n < TICKS_MAX; ++k) {
            const double value = within[k] * pow(10, e);
            if (log10(value) >= a->low && log10(value) <= a->high) {
                out[n++] = value;
            }
        }
    }
    return n;
}

static size_t find_ticks(double out[TICKS_MAX], const axis *a, bool is_whole)
{
    if (a->is_log) {
        return log_ticks(out, a);
    }
    double step = tick_step(a->high - a->low);
    step = is_whole ? fmax(1, step) : step;
    const double first = ceil(a->low / step);
    size_t n = 0;
    while (n < TICKS_MAX && (first + (double)n) * step <= a->high) {
        out[n] = (first + (double)n) * step;
        ++n;
    }
    return n;
}

static void tick_text(FILE *to, double value, bool is_share)
{
    if (is_share) {
        fprintf(to, "%.4g %%", 100 * value);
    } else {
        fprintf(to, "%.5g", value);
    }
}

static void y_tick(FILE *to, const axis *y, double value, bool is_share)
{
    const double at = place(y, value);
    fprintf(to,
            "<line class=\"grid\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" "
            "y2=\"%.1f\"/><text class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"end\">",
            LEFT, at, WIDTH - RIGHT, at, LEFT - 6, at + 4);
    tick_text(to, value, is_share);
    fputs("</text>\n", to);
}

static void x_tick(FILE *to, double at)
{
    fprintf(to,
            "<line class=\"axis\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" "
            "y2=\"%.1f\"/><text class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"middle\">",
            at, HEIGHT - BOTTOM, at, HEIGHT - BOTTOM + 5, at,
            HEIGHT - BOTTOM + 18);
}

static void draw_x_ticks(FILE *to, const axis *x, const murk_chart *c)
{
    double tick[TICKS_MAX];
    const size_t step = (c->x_names + TICKS_MAX - 1) / TICKS_MAX;
    for (size_t i = 0; i < c->x_names; i += step) {
        x_tick(to, place(x, (double)i));
        murk_page_text(to, c->x_name[i]);
        fputs("</text>\n", to);
    }
    const size_t n = c->x_names > 0 ? 0 : find_ticks(tick, x, c->whole_x);
    for (size_t i = 0; i < n; ++i) {
        x_tick(to, place(x, tick[i]));
        tick_text(to, tick[i], false);
        fputs("</text>\n", to);
    }
}

static void draw_axes(FILE *to, const axis *x, const axis *y,
                      const murk_chart *c)
{
    double tick[TICKS_MAX];
    const size_t n = find_ticks(tick, y, false);
    for (size_t i = 0; i < n; ++i) {
        y_tick(to, y, tick[i], c->is_share);
    }
    draw_x_ticks(to, x, c);
    fprintf(to,
            "<path class=\"axis\" d=\"M%.1f %.1fV%.1fH%.1f\"/>"
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"middle\">",
            LEFT, TOP, HEIGHT - BOTTOM, WIDTH - RIGHT,
            (LEFT + WIDTH - RIGHT) / 2, HEIGHT - BOTTOM + 40);
    murk_page_text(to, c->x_title);
    fprintf(to,
            "</text><text class=\"name\" transform=\"translate(14 %.1f) "
            "rotate(-90)\" text-anchor=\"middle\">",
            (TOP + HEIGHT - BOTTOM) / 2);
    murk_page_text(to, c->y_title);
    fputs("</text>\n", to);
    for (size_t i = 0; i < c->y_lines; ++i) {
        fprintf(to,
                "<line class=\"across\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" "
                "y2=\"%.1f\"/>\n",
                LEFT, place(y, c->y_line[i]), WIDTH - RIGHT,
                place(y, c->y_line[i]));
    }
}

static void draw_band(FILE *to, const axis *x, const axis *y,
                      const murk_chart *c, const murk_chart_series *s,
                      size_t number)
{
    const size_t step = step_of(s);
    bool is_first = true;
    for (size_t i = 0; i < s->n; i += step) {
        if (is_drawn(c, s, i) && isfinite(s->high[i])) {
            fprintf(to, is_first ? "<path class=\"band s%zu\" d=\"M" : "L",
                    number);
            fprintf(to, "%.1f %.1f", place(x, s->x[i]), place(y, s->high[i]));
            is_first = false;
        }
    }
    if (is_first) {
        return;
    }
    for (size_t i = (s->n - 1) / step * step + step; i >= step; i -= step) {
        const size_t at = i - step;
        if (is_drawn(c, s, at) && isfinite(s->low[at])) {
            fprintf(to, "L%.1f %.1f", place(x, s->x[at]), place(y, s->low[at]));
        }
    }
    fputs("Z\"/>\n", to);
}

static void draw_line(FILE *to, const axis *x, const axis *y,
                      const murk_chart *c, const murk_chart_series *s,
                      size_t number)
{
    bool is_first = true;
    for (size_t i = 0; i < s->n; i += step_of(s)) {
        if (is_drawn(c, s, i)) {
            if (is_first) {
                fprintf(to, "<path class=\"line s%zu\" d=\"M", number);
            } else {
                fputc('L', to);
            }
            fprintf(to, "%.1f %.1f", place(x, s->x[i]), place(y, s->y[i]));
            is_first = false;
        }
    }
    fputs(is_first ? "" : "\"/>\n", to);
}

static void draw_points(FILE *to, const axis *x, const axis *y,
                        const murk_chart *c, const murk_chart_series *s,
                        size_t number)
{
    for (size_t i = 0; i < s->n; i += step_of(s)) {
        if (!is_drawn(c, s, i)) {
            continue;
        }
        const double at = place(x, s->x[i]);
        if (!s->is_line && s->low && isfinite(s->low[i]) &&
            isfinite(s->high[i])) {
            fprintf(to, "<path class=\"whisker s%zu\" d=\"M%.1f %.1fV%.1f\"/>",
                    number, at, place(y, s->low[i]), place(y, s->high[i]));
        }
        fprintf(to,
                "<circle class=\"point s%zu\" cx=\"%.1f\" cy=\"%.1f\" "
                "r=\"3\"/>\n",
                number, at, place(y, s->y[i]));
    }
}

/* Two columns under the plot. */
static void draw_legend(FILE *to, const murk_chart_series *series, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        const double x = LEFT + (k % 2 == 0 ? 0 : (WIDTH - LEFT) / 2);
        const double y = HEIGHT + LEGEND * (double)(k / 2) + 8;
        if (series[k].is_line) {
            fprintf(to, "<path class=\"line s%zu\" d=\"M%.1f %.1fh22\"/>", k, x,
                    y - 4);
        }
        fprintf(to,
                "<circle class=\"point s%zu\" cx=\"%.1f\" cy=\"%.1f\" "
                "r=\"3\"/><text class=\"tick\" x=\"%.1f\" y=\"%.1f\">",
                k, x + 11, y - 4, x + 28, y);
        murk_page_text(to, series[k].name);
        fputs("</text>\n", to);
    }
}

void murk_chart_draw(FILE *to, const murk_chart *chart,
                     const murk_chart_series *series, size_t n)
{
    n = n > MURK_CHART_SERIES_MAX ? MURK_CHART_SERIES_MAX : n;
    axis x = {INFINITY, -INFINITY, LEFT + 8, WIDTH - RIGHT - 8, chart->log_x};
    axis y = {INFINITY, -INFINITY, HEIGHT - BOTTOM, TOP, chart->log_y};
    fit_axes(&x, &y, chart, series, n);
    if (!(y.high - y.low < INFINITY && x.high - x.low < INFINITY)) {
        return;
    }
    const double height = HEIGHT + (n > 1 ? LEGEND * (double)((n + 1) / 2) : 0);
    fprintf(to,
            "<figure>\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "aria-label=\"",
            WIDTH, height);
    murk_page_text(to, chart->title);
    fputs("\">\n", to);
    draw_axes(to, &x, &y, chart);
    for (size_t k = 0; k < n; ++k) {
        if (series[k].is_line && series[k].low && series[k].high) {
            draw_band(to, &x, &y, chart, &series[k], k);
        }
    }
    /* the first one lies on top */
    for (size_t k = n; k-- > 0;) {
        if (series[k].is_line) {
            draw_line(to, &x, &y, chart, &series[k], k);
        }
        draw_points(to, &x, &y, chart, &series[k], k);
    }
    if (n > 1) {
        draw_legend(to, series, n);
    }
    fputs("</svg>\n<figcaption>", to);
    murk_page_text(to, chart->title);
    fputs("</figcaption>\n</figure>\n", to);
}
