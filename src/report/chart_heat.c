/* Each of 32 colours is one path of level strokes, a run of equal cells each:
 * a few bytes a cell. */
#include "report/chart_heat.h"

#include "report/html.h"

#include <math.h>

#define WIDTH    640.0
#define LEFT     80.0
#define TOP      12.0
#define BELOW    52.0
#define LEGEND_X 540.0
#define LEGEND   16.0 /* its width */
#define WIDEST   430.0
#define TALLEST  380.0
#define MIN      40.0
#define LEVELS   32
#define MAX      1e300

typedef struct frame {
    const murk_heat *heat;
    murk_axis x, y, value;
    double width, height;
} frame;

/* Viridis at eighths (Smith and van der Walt, matplotlib, 2015; public domain
 * by CC0), even in lightness, also for who sees few colours. */
static void write_color(FILE *to, size_t level)
{
    static const double anchor[][3] = {
        {68, 1, 84},    {71, 44, 122},  {59, 81, 139},
        {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
        {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
    const double at = 8.0 * (double)level / (LEVELS - 1);
    const size_t i = at < 8 ? (size_t)at : 7;
    const double part = at - (double)i;
    fputc('#', to);
    for (int k = 0; k < 3; ++k) {
        const double mixed =
            anchor[i][k] + part * (anchor[i + 1][k] - anchor[i][k]);
        fprintf(to, "%02x", (unsigned)lround(mixed));
    }
}

static bool is_shown(const murk_heat *h, double value)
{
    return fabs(value) <= MAX && !(h->is_log && !(value > 0));
}

static bool fit(frame *f)
{
    const murk_heat *h = f->heat;
    f->value =
        murk_axis_of(0, LEVELS, h->is_log ? MURK_SCALE_LOG : MURK_SCALE_EVEN);
    bool has_any = false;
    for (size_t i = 0; i < h->size[0] * h->size[1]; ++i) {
        if (is_shown(h, h->value[i])) {
            has_any = true;
            murk_axis_widen(&f->value, h->value[i]);
        }
    }
    const double wide = fabs(h->x[1] - h->x[0]), tall = fabs(h->y[1] - h->y[0]);
    if (!has_any || !(wide > 0 && wide <= MAX && tall > 0 && tall <= MAX)) {
        return false;
    }
    murk_axis_widen(&f->value, h->min);
    murk_axis_widen(&f->value, h->max);
    murk_axis_close(&f->value, 0);
    f->width = WIDEST;
    f->height = h->size[1] == 1 ? MIN : 0.75 * WIDEST;
    if (h->is_equal) {
        const double scale = fmin(WIDEST / wide, TALLEST / tall);
        f->width = fmax(scale * wide, MIN);
        f->height = fmax(scale * tall, MIN);
    }
    f->x = murk_axis_of(LEFT, LEFT + f->width, MURK_SCALE_EVEN);
    f->y = murk_axis_of(TOP + f->height, TOP, MURK_SCALE_EVEN);
    for (int k = 0; k < 2; ++k) {
        murk_axis_widen(&f->x, h->x[k]);
        murk_axis_widen(&f->y, h->y[k]);
    }
    return true;
}

/* LEVELS where nothing is shown. */
static size_t level_of(const frame *f, size_t i, size_t j)
{
    const double value = f->heat->value[j * f->heat->size[0] + i];
    if (!is_shown(f->heat, value)) {
        return LEVELS;
    }
    const double at = murk_axis_place(&f->value, value);
    return at < LEVELS - 1 ? (size_t)fmax(at, 0) : LEVELS - 1;
}

static void draw_level(FILE *to, const frame *f, size_t level)
{
    const murk_heat *h = f->heat;
    bool is_first = true;
    for (size_t j = 0; j < h->size[1]; ++j) {
        for (size_t i = 0; i < h->size[0];) {
            size_t end = i;
            while (end < h->size[0] && level_of(f, end, j) == level) {
                ++end;
            }
            if (end > i) {
                if (is_first) {
                    fputs("<path stroke=\"", to);
                    write_color(to, level);
                    fputs("\" d=\"", to);
                }
                fprintf(to, "M%zu %zu.5h%zu", i, j, end - i);
                is_first = false;
            }
            i = end > i ? end : i + 1;
        }
    }
    fputs(is_first ? "" : "\"/>\n", to);
}

static void draw_cells(FILE *to, const frame *f)
{
    const murk_heat *h = f->heat;
    fprintf(to,
            "<rect class=\"blank\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" "
            "height=\"%.1f\"/>\n<g transform=\"translate(%.1f %.1f) "
            "scale(%.5g %.5g)\" shape-rendering=\"crispEdges\">\n",
            LEFT, TOP, f->width, f->height, LEFT, TOP + f->height,
            f->width / (double)h->size[0], -f->height / (double)h->size[1]);
    for (size_t level = 0; level < LEVELS; ++level) {
        draw_level(to, f, level);
    }
    fputs("</g>\n", to);
}

static void draw_x(FILE *to, const frame *f)
{
    double tick[MURK_TICKS_MAX], step;
    const size_t n = murk_axis_ticks(tick, &step, &f->x);
    const double base = TOP + f->height;
    /* along a narrow field every tick has its neighbour's room, too */
    const size_t stride = f->width < 40 * (double)n ? 2 : 1;
    for (size_t i = 0; i < n; i += stride) {
        const double at = murk_axis_place(&f->x, tick[i]);
        fprintf(to,
                "<path class=\"axis\" d=\"M%.1f %.1fv5\"/><text "
                "class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
                "text-anchor=\"middle\">",
                at, base, at, base + 19);
        murk_axis_write(to, &f->x, tick[i], step);
        fputs("</text>\n", to);
    }
    fprintf(to,
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"middle\">",
            fmax(LEFT + f->width / 2, LEFT + 40), base + 40);
    murk_page_text(to, f->heat->x_title);
    fputs("</text>\n", to);
}

static void draw_y(FILE *to, const frame *f)
{
    double tick[MURK_TICKS_MAX], step;
    const size_t n = murk_axis_ticks(tick, &step, &f->y);
    const size_t stride = f->height < 18 * (double)n ? 3 : 1;
    for (size_t i = 0; i < n; i += stride) {
        const double at = murk_axis_place(&f->y, tick[i]);
        fprintf(to,
                "<path class=\"axis\" d=\"M%.1f %.1fh-5\"/><text "
                "class=\"tick\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">",
                LEFT, at, LEFT - 8, at + 4);
        murk_axis_write(to, &f->y, tick[i], step);
        fputs("</text>\n", to);
    }
    fprintf(to,
            "<text class=\"name\" transform=\"translate(14 %.1f) "
            "rotate(-90)\" text-anchor=\"middle\">",
            TOP + f->height / 2);
    murk_page_text(to, f->heat->y_title);
    fputs("</text>\n", to);
}

/* Beside the field, as tall as it, or as a word needs. */
static void draw_legend(FILE *to, const frame *f)
{
    double tick[MURK_TICKS_MAX], step;
    const double tall = fmax(f->height, 120);
    murk_axis axis = f->value;
    axis.from = TOP + tall;
    axis.to = TOP;
    for (size_t level = 0; level < LEVELS; ++level) {
        fprintf(to,
                "<rect x=\"%.1f\" y=\"%.2f\" width=\"%.1f\" height=\"%.2f\" "
                "shape-rendering=\"crispEdges\" fill=\"",
                LEGEND_X, TOP + tall * (double)(LEVELS - 1 - level) / LEVELS,
                LEGEND, tall / LEVELS + 0.3);
        write_color(to, level);
        fputs("\"/>", to);
    }
    const size_t n = murk_axis_ticks(tick, &step, &axis);
    for (size_t i = 0; i < n; ++i) {
        const double at = murk_axis_place(&axis, tick[i]);
        fprintf(to, "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">",
                LEGEND_X + LEGEND + 5, at + 4);
        murk_axis_write(to, &axis, tick[i], step);
        fputs("</text>\n", to);
    }
    fprintf(to,
            "<text class=\"name\" transform=\"translate(%.1f %.1f) "
            "rotate(-90)\" text-anchor=\"middle\">",
            LEGEND_X - 8, TOP + tall / 2);
    murk_page_text(to, f->heat->value_title);
    fputs("</text>\n", to);
}

/* The least and the most, and where that is. */
static void describe(FILE *to, const frame *f)
{
    const murk_heat *h = f->heat;
    double min = INFINITY, max = -INFINITY;
    size_t cell = 0, blank = 0;
    for (size_t i = 0; i < h->size[0] * h->size[1]; ++i) {
        if (!is_shown(h, h->value[i])) {
            ++blank;
            continue;
        }
        min = fmin(min, h->value[i]);
        if (h->value[i] > max) {
            max = h->value[i];
            cell = i;
        }
    }
    const double x = (double)(cell % h->size[0]) + 0.5;
    const double y = (double)(cell / h->size[0]) + 0.5;
    fprintf(to, "%zu x %zu cells", h->size[0], h->size[1]);
    if (blank > 0) {
        fprintf(to, ", %zu of them blank: nothing there", blank);
    }
    fputs("; from ", to);
    murk_page_number(to, min);
    fputs(" to ", to);
    murk_page_number(to, max);
    fputc(' ', to);
    murk_page_text(to, h->value_title);
    fputs(", which is at ", to);
    murk_page_number(to,
                     h->x[0] + x / (double)h->size[0] * (h->x[1] - h->x[0]));
    fputs(", ", to);
    murk_page_number(to,
                     h->y[0] + y / (double)h->size[1] * (h->y[1] - h->y[0]));
    fputc('.', to);
}

void murk_heat_draw(FILE *to, const murk_heat *heat)
{
    frame f = {.heat = heat};
    if (!fit(&f)) {
        return;
    }
    fprintf(to,
            "<figure>\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "aria-label=\"",
            WIDTH, TOP + fmax(f.height + BELOW, 140));
    murk_page_text(to, heat->title);
    fputs("\">\n<desc>", to);
    describe(to, &f);
    fputs("</desc>\n", to);
    draw_cells(to, &f);
    draw_x(to, &f);
    draw_y(to, &f);
    draw_legend(to, &f);
    fputs("</svg>\n<figcaption>", to);
    murk_page_text(to, heat->title);
    fputs(": ", to);
    describe(to, &f);
    fputs("</figcaption>\n</figure>\n", to);
}
