#include "base/progress.h"

#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define FIRST_DRAW_S 0.5
#define DRAW_EVERY_S 0.1
#define BAR_CELLS    20

static struct {
    bool draws;
    const char *step, *unit;
    uint64_t total;
    uint64_t part, parts; /* 0: the whole */
    double begun_s;
    atomic_uint_fast64_t done;
    _Atomic double next_draw_s;
    atomic_bool is_open, has_drawn;
    atomic_flag drawing;
} bar = {.drawing = ATOMIC_FLAG_INIT};

static void format_time(char *out, size_t size, double seconds)
{
    if (seconds < 90) {
        snprintf(out, size, "%.0f s", seconds);
    } else if (seconds < 5400) {
        snprintf(out, size, "%.0f min", seconds / 60);
    } else {
        snprintf(out, size, "%.1f h", seconds / 3600);
    }
}

static void draw(double now_s)
{
    const uint64_t done = atomic_load(&bar.done);
    const double share =
        bar.total ? fmin(1, (double)done / (double)bar.total) : 1;
    const double rate = (double)done / fmax(now_s - bar.begun_s, 1e-9);
    char cells[BAR_CELLS + 1];
    const int full = (int)(share * BAR_CELLS);
    memset(cells, '.', BAR_CELLS);
    memset(cells, '#', (size_t)full);
    cells[BAR_CELLS] = '\0';
    char left[32] = "?";
    if (rate > 0 && bar.total >= done) {
        format_time(left, sizeof left, (double)(bar.total - done) / rate);
    }
    char part[48] = "";
    if (bar.parts > 0) {
        snprintf(part, sizeof part, "%llu/%llu ", (unsigned long long)bar.part,
                 (unsigned long long)bar.parts);
    }
    fprintf(stderr, "\r%s%-8s[%s] %3.0f %%  %.3g %s  %.2g/s  %s left\033[K",
            part, bar.step, cells, floor(share * 100), (double)done, bar.unit,
            rate, left);
    fflush(stderr);
    atomic_store(&bar.has_drawn, true);
}

void murk_progress_set(murk_progress_mode mode)
{
    bar.draws = mode == MURK_PROGRESS_ALWAYS ||
                (mode == MURK_PROGRESS_AUTO && isatty(STDERR_FILENO));
}

void murk_progress_begin(const char *step, uint64_t total, const char *unit)
{
    bar.step = step;
    bar.unit = unit;
    bar.total = total;
    bar.begun_s = murk_clock_s();
    atomic_store(&bar.done, 0);
    atomic_store(&bar.next_draw_s, bar.begun_s + FIRST_DRAW_S);
    atomic_store(&bar.has_drawn, false);
    atomic_store(&bar.is_open, true);
}

void murk_progress_add(uint64_t done)
{
    atomic_fetch_add(&bar.done, done);
    if (!bar.draws || !atomic_load(&bar.is_open)) {
        return;
    }
    const double now_s = murk_clock_s();
    if (now_s < atomic_load(&bar.next_draw_s) ||
        atomic_flag_test_and_set(&bar.drawing)) {
        return;
    }
    atomic_store(&bar.next_draw_s, now_s + DRAW_EVERY_S);
    draw(now_s);
    atomic_flag_clear(&bar.drawing);
}

void murk_progress_end(void)
{
    atomic_store(&bar.is_open, false);
    if (bar.draws && atomic_load(&bar.has_drawn)) {
        draw(murk_clock_s());
        fputc('\n', stderr);
    }
}

void murk_progress_part(uint64_t number, uint64_t parts)
{
    bar.part = number;
    bar.parts = parts;
}

double murk_clock_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
