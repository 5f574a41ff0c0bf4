/* Formats a progress line, or the same facts as a sentence: the name of the
 * step, bar, percentage, count, times and text are separate pieces, which are
 * then joined. */
#include "base/progress_line.h"

#include "base/utf8.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BAR_SIZE (BAR_CELLS + 3) /* cells, brackets and '\0' */

#define BAR_CELLS  20                             /* 5 % each */
#define PIECE_SIZE (MURK_PROGRESS_TEXT_SIZE + 64) /* text, two numbers */

/* Formats a count: all digits below a million, else three significant digits.
 */
static void format_count(char *out, size_t size, uint64_t n)
{
    if (n < 1000000) {
        snprintf(out, size, "%llu", (unsigned long long)n);
        return;
    }
    /* 9.995 and more would be rounded to 10.00. */
    const int floored = (int)floor(log10((double)n));
    const int exponent = floored + ((double)n >= 9.995 * pow(10, floored));
    snprintf(out, size, "%.2fe%d", (double)n / pow(10, exponent), exponent);
}

static void format_time(char *out, size_t size, double seconds)
{
    /* Limits: 100 hours, 90 s and 90 min. */
    if (!(seconds < 360000)) {
        snprintf(out, size, "%.0f days", seconds / 86400);
    } else if (seconds < 90) {
        snprintf(out, size, "%.0f s", seconds);
    } else if (seconds < 5400) {
        snprintf(out, size, "%.0f min", seconds / 60);
    } else {
        snprintf(out, size, "%.1f h", seconds / 3600);
    }
}

/* The pieces of a line; "" if a piece is empty. */
typedef struct pieces {
    char head[PIECE_SIZE], percent[16], count[PIECE_SIZE], time[64];
    char all[64], text[PIECE_SIZE];
} pieces;

static void make_pieces(pieces *p, const murk_progress_facts *f)
{
    char done[24], total[24], elapsed[24], left[24];
    *p = (pieces){0};
    /* The name of the step, with the number of the part. */
    if (f->part > 0) {
        snprintf(p->head, sizeof p->head, "%llu/%llu %s",
                 (unsigned long long)f->part, (unsigned long long)f->parts,
                 f->step);
    } else {
        snprintf(p->head, sizeof p->head, "%s", f->step);
    }
    /* Share and count. The share of a count beyond the total is 100 %. */
    format_count(done, sizeof done, f->done);
    format_count(total, sizeof total, f->total);
    format_time(elapsed, sizeof elapsed, f->elapsed_s);
    const uint64_t max = f->done < f->total ? f->done : f->total;
    if (f->total > 0) {
        snprintf(p->percent, sizeof p->percent, "%3.0f %%",
                 floor(100 * (double)max / (double)f->total));
    }
    if (*f->unit && f->total > 0) {
        snprintf(p->count, sizeof p->count, "%s of %s %s", done, total,
                 f->unit);
    } else if (*f->unit) {
        snprintf(p->count, sizeof p->count, "%s %s", done, f->unit);
    }
    /* Elapsed time, and time left in proportion to the count. */
    if (max > 0 && max < f->total) {
        format_time(left, sizeof left,
                    f->elapsed_s * ((double)f->total / (double)max - 1));
        snprintf(p->time, sizeof p->time, "%s, %s left", elapsed, left);
    } else {
        snprintf(p->time, sizeof p->time, "%s", elapsed);
    }
    if (f->parts > 0 && isfinite(f->parts_left_s)) {
        format_time(left, sizeof left, f->parts_left_s);
        snprintf(p->all, sizeof p->all, "all: %s left", left);
    }
    murk_utf8_escape(p->text, sizeof p->text, f->text);
}

/* Joins the non-empty pieces in order. Returns the length, which is size or
 * more if the text was cut. */
static size_t join(char *out, size_t size, const char *const *piece, size_t n,
                   const char *between)
{
    size_t at = 0;
    out[0] = '\0';
    for (size_t i = 0; i < n; ++i) {
        if (*piece[i] && at < size) {
            at += (size_t)snprintf(out + at, size - at, "%s%s",
                                   at ? between : "", piece[i]);
        }
    }
    return at;
}

void murk_progress_line(char *out, size_t size, const murk_progress_facts *f,
                        size_t columns)
{
    pieces p;
    make_pieces(&p, f);
    const char *piece[] = {p.head, "",    p.percent, p.count,
                           p.time, p.all, p.text};
    const size_t n = sizeof piece / sizeof *piece;
    /* Draw the bar. */
    char bar[BAR_SIZE] = "";
    if (f->total > 0) {
        const double share = fmin(1, (double)f->done / (double)f->total);
        const size_t full = (size_t)(share * BAR_CELLS);
        bar[0] = '[';
        memset(bar + 1, '.', BAR_CELLS);
        memset(bar + 1, '#', full);
        bar[BAR_CELLS + 1] = ']';
        piece[1] = bar;
    }
    /* Leave out pieces until the line fits: bar, time of all parts, text
     * (indices into `piece`). */
    static const size_t min_needed[] = {1, 5, 6};
    size_t length = join(out, size, piece, n, "  ");
    for (size_t k = 0; k < 3 && length > columns; ++k) {
        piece[min_needed[k]] = "";
        length = join(out, size, piece, n, "  ");
    }
    if (columns < size && length > columns) {
        out[columns] = '\0';
    }
}

void murk_progress_sentence(char *out, size_t size,
                            const murk_progress_facts *f)
{
    pieces p;
    make_pieces(&p, f);
    const char *percent = p.percent + strspn(p.percent, " ");
    const char *const piece[] = {percent, p.count, p.time, p.all, p.text};
    const int n = snprintf(out, size, "murk: %s: ", p.head);
    if (n > 0 && (size_t)n < size) {
        (void)join(out + n, size - (size_t)n, piece,
                   sizeof piece / sizeof *piece, ", ");
    }
}
