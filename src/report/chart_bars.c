#include "report/chart_bars.h"

#include "base/utf8.h"
#include "report/html.h"

#include <math.h>
#include <string.h>

#define SHOWN_SIZE (4 * NAME_MAX + 8)

/* In user units, which the page scales. */
#define WIDTH     640.0
#define RIGHT     92.0 /* room for the values */
#define TOP       6.0
#define ROW       24.0
#define BAR       15.0
#define BELOW     48.0
#define LEGEND    20.0
#define CHARACTER 7.8
#define NAME_MAX  30 /* characters of a name that are shown */

#define MAX 1e300 /* so that a range of two values is finite */

typedef struct frame {
    const murk_bars *bars;
    size_t rows;
    murk_axis axis;
    double left, base;
} frame;

static double whole_of(const murk_bars *b, size_t row)
{
    double sum = 0;
    for (size_t k = 0; k < b->parts; ++k) {
        const double value = b->value[row * b->parts + k];
        sum += b->parts == 1 || value > 0 ? value : 0;
    }
    return fabs(sum) <= MAX ? sum : NAN;
}

static bool has_range(const murk_bars *b, size_t row)
{
    return b->low && b->high && fabs(b->low[row]) <= MAX &&
           fabs(b->high[row]) <= MAX && isfinite(whole_of(b, row));
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

/* The name, with dots for what is too long. */
static void write_name(FILE *to, const char *name)
{
    char shown[SHOWN_SIZE];
    size_t at = 0, n = 0;
    const size_t all = characters_of(name);
    const size_t max = all > NAME_MAX ? NAME_MAX - 1 : NAME_MAX;
    for (; *name && n < max; ++n) {
        const size_t length = murk_utf8_length(name);
        const size_t step = length > 0 ? length : 1;
        memcpy(shown + at, name, step);
        at += step;
        name += step;
    }
    strcpy(shown + at, all > NAME_MAX ? "\xe2\x80\xa6" : "");
    murk_page_text(to, shown);
}

static bool fit(frame *f)
{
    const murk_bars *b = f->bars;
    size_t longest = 4;
    bool has_any = false;
    for (size_t i = 0; i < f->rows; ++i) {
        const size_t length = characters_of(b->name[i]);
        longest = length > longest ? length : longest;
        has_any = has_any || isfinite(whole_of(b, i));
    }
    longest = longest > NAME_MAX ? NAME_MAX : longest;
    f->left = 14 + CHARACTER * (double)longest;
    f->base = TOP + ROW * (double)f->rows;
    f->axis = murk_axis_of(f->left, WIDTH - RIGHT, b->scale);
    murk_axis_widen(&f->axis, 0);
    for (size_t i = 0; i < f->rows; ++i) {
        murk_axis_widen(&f->axis, whole_of(b, i));
        if (has_range(b, i)) {
            murk_axis_widen(&f->axis, b->low[i]);
            murk_axis_widen(&f->axis, b->high[i]);
        }
    }
    murk_axis_close(&f->axis, 0);
    return has_any;
}

static void draw_axis(FILE *to, const frame *f)
{
    double tick[MURK_TICKS_MAX], step;
    const size_t n = murk_axis_ticks(tick, &step, &f->axis);
    for (size_t i = 0; i < n; ++i) {
        const double at = murk_axis_place(&f->axis, tick[i]);
        fprintf(to,
                "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/>"
                "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\" "
                "text-anchor=\"middle\">",
                at, TOP, f->base, at, f->base + 17);
        murk_axis_write(to, &f->axis, tick[i], step);
        fputs("</text>\n", to);
    }
    const double zero = murk_axis_place(&f->axis, 0);
    fprintf(to,
            "<path class=\"axis\" d=\"M%.1f %.1fV%.1f\"/>"
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"middle\">",
            zero, TOP, f->base, (f->left + WIDTH - RIGHT) / 2, f->base + 38);
    murk_page_text(to, f->bars->axis_title);
    fputs("</text>\n", to);
}

static void draw_row(FILE *to, const frame *f, size_t row)
{
    const murk_bars *b = f->bars;
    const double y = TOP + ROW * (double)row + (ROW - BAR) / 2;
    const double whole = whole_of(b, row);
    double begin = 0;
    fprintf(to,
            "<text class=\"name\" x=\"%.1f\" y=\"%.1f\" "
            "text-anchor=\"end\">",
            f->left - 8, y + 12);
    write_name(to, b->name[row]);
    fputs("</text>", to);
    for (size_t k = 0; k < b->parts && isfinite(whole); ++k) {
        const double value = b->value[row * b->parts + k];
        if (b->parts > 1 && !(value > 0)) {
            continue;
        }
        const double from = murk_axis_place(&f->axis, begin);
        const double end = murk_axis_place(&f->axis, begin + value);
        fprintf(to,
                "<rect class=\"bar s%zu\" x=\"%.1f\" y=\"%.1f\" "
                "width=\"%.1f\" height=\"%.0f\"/>",
                k, fmin(from, end), y, fabs(end - from), BAR);
        begin += value;
    }
    double after = fmax(murk_axis_place(&f->axis, begin), f->left);
    if (has_range(b, row)) {
        const double high = murk_axis_place(&f->axis, b->high[row]);
        fprintf(to, "<path class=\"error\" d=\"M%.1f %.1fH%.1f\"/>",
                murk_axis_place(&f->axis, b->low[row]), y + BAR / 2, high);
        after = fmax(after, high);
    }
    fprintf(to, "<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">", after + 6,
            y + 12);
    if (isfinite(whole) && b->scale == MURK_SCALE_SHARE) {
        murk_page_share(to, whole, NAN);
    } else {
        murk_page_number(to, whole);
    }
    fputs("</text>\n", to);
}

static void draw_legend(FILE *to, const frame *f)
{
    for (size_t k = 0; k < f->bars->parts; ++k) {
        const double x = 14 + (double)(k % 2) * WIDTH / 2;
        const double y = f->base + BELOW + LEGEND * (double)(k / 2);
        fprintf(to,
                "<rect class=\"bar s%zu\" x=\"%.1f\" y=\"%.1f\" width=\"14\" "
                "height=\"12\"/><text class=\"tick\" x=\"%.1f\" y=\"%.1f\">",
                k, x, y, x + 20, y + 11);
        murk_page_text(to, f->bars->part[k]);
        fputs("</text>\n", to);
    }
}

void murk_bars_draw(FILE *to, const murk_bars *bars)
{
    frame f = {.bars = bars,
               .rows = bars->rows < MURK_BARS_MAX ? bars->rows : MURK_BARS_MAX};
    if (!fit(&f)) {
        return;
    }
    const size_t legend = bars->part ? (bars->parts + 1) / 2 : 0;
    fprintf(to,
            "<figure>\n<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
            "aria-label=\"",
            WIDTH, f.base + BELOW + LEGEND * (double)legend);
    murk_page_text(to, bars->title);
    fputs("\">\n", to);
    draw_axis(to, &f);
    for (size_t i = 0; i < f.rows; ++i) {
        draw_row(to, &f, i);
    }
    if (legend > 0) {
        draw_legend(to, &f);
    }
    fputs("</svg>\n<figcaption>", to);
    murk_page_text(to, bars->title);
    if (f.rows < bars->rows) {
        fprintf(to, " (the first %zu of %zu)", f.rows, bars->rows);
    }
    fputs("</figcaption>\n</figure>\n", to);
}
