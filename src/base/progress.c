/* The progress line: a stack of open steps, a count of each that workers
 * increase atomically, and a thread that redraws the line, or tells a receiver,
 * every fifth of a second. The thread is stopped at every fork, because only
 * the forking thread survives in the subprocess. A host (base/host.h) whose
 * `bar` is NULL uses the line of the process, a static variable. */
#include "base/progress.h"

#include "base/host.h"
#include "base/progress_line.h"

#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

/* A line and the control sequences for the cursor. */
#define DRAWN_SIZE (LINE_SIZE + 16)

/* Times of the display: steps shorter than FIRST_DRAW_S show nothing, a line is
 * redrawn every DRAW_EVERY_S, and whole lines begin after FIRST_LINE_S. */
#define FIRST_DRAW_S 0.5
#define DRAW_EVERY_S 0.2
#define FIRST_LINE_S 2.0
/* The factor between the times of successive whole lines, which are at least
 * FIRST_LINE_S apart. */
#define LINE_GROWTH 1.25
#define STEPS_MAX   4   /* nested steps that are shown */
#define COLUMNS     80  /* if the terminal does not report its width */
#define COLUMNS_MIN 20  /* narrower windows wrap */
#define LINE_SIZE   512 /* all pieces of a line */

/* TO_RECEIVER: a receiver is called. */
typedef enum style { SILENT, REDRAWN_LINE, WHOLE_LINES, TO_RECEIVER } style;

typedef struct step {
    const char *name, *unit;
    uint64_t total;
    atomic_uint_fast64_t done;
    double begun_s;
    bool is_group; /* a group of other steps: their counts do not add to it */
    char text[MURK_PROGRESS_TEXT_SIZE];
} step;

/* The state of the display. The thread that draws holds `lock` while it reads
 * the state and changes is_drawn, next_s and has_printed. Workers increase
 * `done` without the lock. The other members are changed by the thread that
 * begins and ends the steps. */
struct murk_progress_bar {
    style style;
    murk_progress_sink sink; /* of style TO_RECEIVER */
    void *user;
    pthread_mutex_t lock;
    pthread_cond_t wakes;
    pthread_t drawer;
    bool has_drawer, is_ending, is_drawn;
    step step[STEPS_MAX];
    int steps;        /* open steps; those beyond STEPS_MAX are not shown */
    double next_s;    /* time of the next whole line */
    bool has_printed; /* a whole line was printed since the outermost step began
                       */
    uint64_t part, parts, parts_done, parts_done_first;
    double parts_begun_s;
};

/* The line of the host of the process. */
static murk_progress_bar process = {.lock = PTHREAD_MUTEX_INITIALIZER};

/* The line of the host of the calling thread. */
static murk_progress_bar *bar_now(void)
{
    murk_progress_bar *own = murk_host_now()->bar;
    return own ? own : &process;
}

murk_progress_bar *murk_progress_create(void)
{
    murk_progress_bar *bar = calloc(1, sizeof *bar);
    if (bar && pthread_mutex_init(&bar->lock, NULL) != 0) {
        free(bar);
        bar = NULL;
    }
    return bar;
}

void murk_progress_destroy(murk_progress_bar *bar)
{
    if (bar) {
        pthread_mutex_destroy(&bar->lock);
        free(bar);
    }
}

void murk_progress_to(murk_progress_sink sink, void *user)
{
    murk_progress_bar *bar = bar_now();
    bar->style = sink ? TO_RECEIVER : SILENT;
    bar->sink = sink;
    bar->user = user;
}

static size_t window_columns(void)
{
    struct winsize window;
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) {
        return COLUMNS;
    }
    /* some terminals wrap after the last column already */
    return window.ws_col > COLUMNS_MIN ? window.ws_col - 1u : COLUMNS_MIN;
}

static murk_progress_facts facts_of(const step *s, double now_s)
{
    murk_progress_bar *bar = bar_now();
    const uint64_t made = bar->parts_done - bar->parts_done_first;
    const double spent_s = now_s - bar->parts_begun_s;
    /* The step that counts the parts shows its own count instead of the number
     * of a part. Its own estimate covers all parts, unless parts were done
     * before it began. */
    const bool counts_parts = s->is_group && s->total == bar->parts;
    const bool knows_all =
        made > 0 && !(counts_parts && bar->parts_done_first == 0);
    return (murk_progress_facts){
        .step = s->name,
        .unit = s->unit,
        .text = s->text,
        .done = atomic_load(&s->done),
        .total = s->total,
        .elapsed_s = now_s - s->begun_s,
        .part = counts_parts ? 0 : bar->part,
        .parts = bar->parts,
        .parts_left_s = knows_all ? spent_s / (double)made *
                                        (double)(bar->parts - bar->parts_done)
                                  : NAN};
}

static void put(const char *text)
{
    fputs(text, stderr);
    fflush(stderr);
}

static void wipe(void)
{
    murk_progress_bar *bar = bar_now();
    if (bar->is_drawn) {
        put("\r\033[K");
        bar->is_drawn = false;
    }
}

/* Redraws the line of the innermost step that has lasted long enough. */
static void redraw_line(double now_s)
{
    murk_progress_bar *bar = bar_now();
    int top = bar->steps < STEPS_MAX ? bar->steps : STEPS_MAX;
    while (top > 0 && now_s - bar->step[top - 1].begun_s < FIRST_DRAW_S) {
        --top;
    }
    if (top == 0) {
        return;
    }
    const murk_progress_facts facts = facts_of(&bar->step[top - 1], now_s);
    char line[LINE_SIZE], both[DRAWN_SIZE];
    murk_progress_line(line, sizeof line, &facts, window_columns());
    snprintf(both, sizeof both, "\r%s\033[K", line);
    put(both);
    bar->is_drawn = true;
}

/* Returns the outermost step with a known total or a text, else the innermost
 * step. */
static const step *printed_step(void)
{
    murk_progress_bar *bar = bar_now();
    const int open = bar->steps < STEPS_MAX ? bar->steps : STEPS_MAX;
    for (int k = 0; k < open; ++k) {
        if (bar->step[k].total > 0 || bar->step[k].text[0]) {
            return &bar->step[k];
        }
    }
    return &bar->step[open - 1];
}

/* The facts for a receiver: those of the outermost step with a known total,
 * such as a trace inside of a search, else those of the printed step. A
 * receiver shows the text of the search beside them. */
static murk_progress_facts facts_for_receiver(double now_s)
{
    const murk_progress_bar *bar = bar_now();
    const int open = bar->steps < STEPS_MAX ? bar->steps : STEPS_MAX;
    const step *known = NULL, *with_text = NULL;
    for (int k = open - 1; k >= 0; --k) {
        known = bar->step[k].total > 0 ? &bar->step[k] : known;
        with_text = bar->step[k].text[0] ? &bar->step[k] : with_text;
    }
    murk_progress_facts facts = facts_of(known ? known : printed_step(), now_s);
    facts.text = with_text ? with_text->text : "";
    return facts;
}

static void print_line(double now_s)
{
    murk_progress_bar *bar = bar_now();
    const murk_progress_facts facts = facts_of(printed_step(), now_s);
    char line[LINE_SIZE], both[DRAWN_SIZE];
    murk_progress_sentence(line, sizeof line, &facts);
    snprintf(both, sizeof both, "%s\n", line);
    put(both);
    bar->has_printed = true;
    const double spent_s = now_s - bar->step[0].begun_s;
    bar->next_s = bar->step[0].begun_s +
                  fmax(LINE_GROWTH * spent_s, spent_s + FIRST_LINE_S);
}

/* Draws or prints the line if it is time to do so, or calls the receiver; the
 * caller holds the lock. */
static void draw(void)
{
    murk_progress_bar *bar = bar_now();
    const double now_s = murk_clock_s();
    if (bar->steps == 0) {
        return;
    }
    if (bar->style == REDRAWN_LINE) {
        redraw_line(now_s);
    } else if (bar->style == WHOLE_LINES && now_s >= bar->next_s) {
        print_line(now_s);
    } else if (bar->style == TO_RECEIVER) {
        const murk_progress_facts facts = facts_for_receiver(now_s);
        bar->sink(bar->user, &facts);
    }
}

static void *keep_drawing(void *host)
{
    (void)murk_host_enter(host);
    murk_progress_bar *bar = bar_now();
    pthread_mutex_lock(&bar->lock);
    while (!bar->is_ending) {
        draw();
        struct timespec until;
        clock_gettime(CLOCK_MONOTONIC, &until);
        until.tv_nsec += (long)(DRAW_EVERY_S * 1e9);
        if (until.tv_nsec >= 1000000000) {
            until.tv_nsec -= 1000000000;
            ++until.tv_sec;
        }
        pthread_cond_timedwait(&bar->wakes, &bar->lock, &until);
    }
    pthread_mutex_unlock(&bar->lock);
    return NULL;
}

static void start_drawer(void)
{
    murk_progress_bar *bar = bar_now();
    if (bar->has_drawer || bar->style == SILENT) {
        return;
    }
    pthread_condattr_t attributes;
    sigset_t all, before;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&bar->wakes, &attributes);
    pthread_condattr_destroy(&attributes);
    bar->is_ending = false;
    sigfillset(&all); /* signals go to other threads */
    pthread_sigmask(SIG_SETMASK, &all, &before);
    bar->has_drawer =
        pthread_create(&bar->drawer, NULL, keep_drawing, murk_host_now()) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

static void stop_drawer(void)
{
    murk_progress_bar *bar = bar_now();
    if (!bar->has_drawer) {
        return;
    }
    pthread_mutex_lock(&bar->lock);
    bar->is_ending = true;
    pthread_cond_signal(&bar->wakes);
    pthread_mutex_unlock(&bar->lock);
    pthread_join(bar->drawer, NULL);
    pthread_cond_destroy(&bar->wakes);
    bar->has_drawer = false;
}

void murk_progress_set(murk_progress_mode mode)
{
    murk_progress_bar *bar = bar_now();
    const char *terminal = getenv("TERM");
    const bool is_terminal = isatty(STDERR_FILENO);
    const bool can_wipe =
        is_terminal && terminal && *terminal && strcmp(terminal, "dumb") != 0;
    const bool speaks = mode == MURK_PROGRESS_ALWAYS ||
                        (mode == MURK_PROGRESS_AUTO && is_terminal);
    bar->style = !speaks ? SILENT : can_wipe ? REDRAWN_LINE : WHOLE_LINES;
}

static void begin(const char *name, uint64_t total, const char *unit,
                  bool is_group)
{
    murk_progress_bar *bar = bar_now();
    pthread_mutex_lock(&bar->lock);
    if (bar->steps < STEPS_MAX) {
        step *s = &bar->step[bar->steps];
        s->name = name;
        s->unit = unit;
        s->total = total;
        s->text[0] = '\0';
        s->is_group = is_group;
        s->begun_s = murk_clock_s();
        atomic_store(&s->done, 0);
    }
    if (bar->steps == 0) {
        bar->next_s = bar->step[0].begun_s + FIRST_LINE_S;
        bar->has_printed = false;
    }
    ++bar->steps;
    pthread_mutex_unlock(&bar->lock);
    start_drawer();
}

void murk_progress_begin(const char *name, uint64_t total, const char *unit)
{
    begin(name, total, unit, false);
}

void murk_progress_begin_group(const char *name, uint64_t total,
                               const char *unit)
{
    begin(name, total, unit, true);
}

void murk_progress_end(void)
{
    murk_progress_bar *bar = bar_now();
    if (bar->steps == 1) {
        stop_drawer();
    }
    pthread_mutex_lock(&bar->lock);
    if (bar->steps == 1 && bar->style == WHOLE_LINES && bar->has_printed) {
        print_line(murk_clock_s());
    }
    if (bar->steps == 1 && bar->style == TO_RECEIVER) {
        draw(); /* the end of the step */
    }
    if (bar->steps == 1) {
        wipe();
    }
    bar->steps -= bar->steps > 0;
    pthread_mutex_unlock(&bar->lock);
}

static void add(uint64_t done, bool to_group)
{
    murk_progress_bar *bar = bar_now();
    const int top = bar->steps < STEPS_MAX ? bar->steps : STEPS_MAX;
    if (top > 0 && bar->step[top - 1].is_group == to_group) {
        atomic_fetch_add(&bar->step[top - 1].done, done);
    }
}

void murk_progress_add(uint64_t done)
{
    add(done, false);
}

void murk_progress_add_to_group(uint64_t done)
{
    murk_progress_bar *bar = bar_now();
    add(done, true);
    if (!bar->has_drawer && bar->style == WHOLE_LINES) { /* the drawing thread
                                                          * is stopped */
        pthread_mutex_lock(&bar->lock);
        draw();
        pthread_mutex_unlock(&bar->lock);
    }
}

void murk_progress_text(const char *format, ...)
{
    murk_progress_bar *bar = bar_now();
    pthread_mutex_lock(&bar->lock);
    if (bar->steps > 0 && bar->steps <= STEPS_MAX) {
        char *text = bar->step[bar->steps - 1].text;
        va_list args;
        va_start(args, format);
        vsnprintf(text, MURK_PROGRESS_TEXT_SIZE, format, args);
        va_end(args);
    }
    pthread_mutex_unlock(&bar->lock);
}

void murk_progress_part(uint64_t number, uint64_t parts, uint64_t done)
{
    murk_progress_bar *bar = bar_now();
    pthread_mutex_lock(&bar->lock);
    if (bar->parts == 0) {
        bar->parts_begun_s = murk_clock_s();
        bar->parts_done_first = done;
    }
    bar->part = number;
    bar->parts = parts;
    bar->parts_done = done;
    pthread_mutex_unlock(&bar->lock);
}

void murk_progress_pause(void)
{
    murk_progress_bar *bar = bar_now();
    stop_drawer();
    bar->is_drawn |= bar->style == REDRAWN_LINE; /* a subprocess may have drawn
                                                  * a line */
}

void murk_progress_resume(void)
{
    murk_progress_bar *bar = bar_now();
    if (bar->steps > 0) {
        start_drawer();
    }
}

void murk_progress_in_subprocess(void)
{
    murk_progress_bar *bar = bar_now();
    if (bar->style == WHOLE_LINES || bar->style == TO_RECEIVER) {
        bar->style = SILENT;
    }
    murk_progress_resume();
}

void murk_progress_hide(void)
{
    murk_progress_bar *bar = bar_now();
    pthread_mutex_lock(&bar->lock);
    if (bar->style == REDRAWN_LINE) {
        bar->is_drawn = true; /* a subprocess may have drawn a line */
        wipe();
    }
}

void murk_progress_show(void)
{
    murk_progress_bar *bar = bar_now();
    pthread_mutex_unlock(&bar->lock);
}

double murk_clock_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
