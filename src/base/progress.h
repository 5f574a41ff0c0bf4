/* One line for long steps, on standard error.
 *
 *   trace [##########..........] 51 %  51000 of 100000 photons  12 s, 11 s left
 *
 * On a terminal it is drawn over and over, as wide as the window allows, and
 * wiped when the step ends. A thread of its own draws it, so it moves while
 * nothing is added, too. Elsewhere (only when asked), and on terminals that
 * cannot wipe (TERM is dumb), whole lines tell the outermost step that knows
 * how far it is, ever more seldom: some forty in ten hours. Steps shorter than
 * half a second draw nothing. */
#ifndef MURK_BASE_PROGRESS_H
#define MURK_BASE_PROGRESS_H

#include <stdint.h>

typedef enum murk_progress_mode {
    MURK_PROGRESS_NEVER,
    MURK_PROGRESS_AUTO, /* where standard error is a terminal */
    MURK_PROGRESS_ALWAYS
} murk_progress_mode;

/* NEVER is where a process starts. Set it before any thread starts. */
void murk_progress_set(murk_progress_mode mode);

/* A step, within the one that is open if there is one: begun and ended by the
 * same thread. total 0: unknown. `step` and `unit` ("photons"; "": nothing is
 * counted) must outlive it. */
void murk_progress_begin(const char *step, uint64_t total, const char *unit);
void murk_progress_end(void);

/* To the innermost step; safe from any thread. */
void murk_progress_add(uint64_t done);

/* A step that other steps make up, such as the rows of a study: what is added
 * to them, and to none, is not its own. */
void murk_progress_begin_over(const char *step, uint64_t total,
                              const char *unit);
void murk_progress_add_over(uint64_t done);

/* Where a search stands, behind the innermost step's numbers from now on. */
void murk_progress_text(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

/* Steps from here on belong to part `number`, from 1, of so many, of which
 * `done` are done: shown before them, with the time that all parts will take.
 * The first call begins to measure it. 0 of 0: of no part, as at first. */
void murk_progress_part(uint64_t number, uint64_t parts, uint64_t done);

/* Around fork(), which no other thread may be alive at. A child that lives on
 * calls apart(): it draws the steps that are open and its own, while its parent
 * stays paused; whole lines are the parent's. */
void murk_progress_pause(void);
void murk_progress_resume(void);
void murk_progress_apart(void);

/* Around other lines on standard error: wipes the line and holds it back. */
void murk_progress_hide(void);
void murk_progress_show(void);

/* Monotonic clock [s], for the run's own timings; never for results. */
double murk_clock_s(void);

#endif
