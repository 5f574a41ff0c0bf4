/* A bar with rate and time left, on standard error, for long steps.
 *
 *   trace   [##########..........]  51 %  1.2e6 photons  3.4e5/s  3 s left
 *
 * Drawn only on a terminal unless asked; steps shorter than half a second
 * draw nothing. Adding is safe from any thread. */
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

/* One step at a time. `step` and `unit` ("photons") must outlive it. */
void murk_progress_begin(const char *step, uint64_t total, const char *unit);
void murk_progress_add(uint64_t done);
void murk_progress_end(void);

/* Steps from here on belong to part `number`, from 1, of so many: shown before
 * the bar. 0 of 0: of no part, as at first. */
void murk_progress_part(uint64_t number, uint64_t parts);

/* Monotonic clock [s], for the run's own timings; never for results. */
double murk_clock_s(void);

#endif
