/* A progress line for long steps, on standard error.
 *
 *   trace [##########..........] 51 %  51000 of 100000 photons  12 s, 11 s left
 *
 * On a terminal the line is redrawn in place, at most as wide as the window
 * (but not below 20 columns), and wiped when the outermost step ends. A thread
 * of the module redraws it, so that the times advance while no progress is
 * reported, too. Elsewhere (only on request), and on terminals that cannot wipe
 * a line (TERM is dumb), whole lines are printed. They report the outermost
 * step with a known total or a text, at growing intervals: some forty lines in
 * ten hours. Steps shorter than half a second are not drawn, and whole lines
 * begin after two seconds. */
#ifndef MURK_BASE_PROGRESS_H
#define MURK_BASE_PROGRESS_H

#include "base/progress_line.h"
#include "murk.h"

#include <stdint.h>

/* The mode of a new process is NEVER. Set the mode before any thread starts. */
void murk_progress_set(murk_progress_mode mode);

/* Tells a receiver about the outermost step with a known total, or else about
 * the step that whole lines would report, and about the text of the outermost
 * step that has one, five times a second from a thread of murk, and from the
 * calling thread when the outermost step ends, in place of showing a line;
 * NULL: tells nobody. *facts is valid during the call. Call it while no step is
 * open. Subprocesses tell nothing. */
typedef void (*murk_progress_sink)(void *user,
                                   const murk_progress_facts *facts);
void murk_progress_to(murk_progress_sink sink, void *user);

/* Creates the line of a host (base/host.h), in the mode NEVER. NULL when out of
 * memory. */
typedef struct murk_progress_bar murk_progress_bar;
murk_progress_bar *murk_progress_create(void);
void murk_progress_destroy(murk_progress_bar *bar); /* NULL is fine */

/* Begins and ends a step, inside the open step if there is one; the same thread
 * begins and ends a step. Steps inside more than three others are not shown.
 * total 0: unknown. `step` and `unit` ("photons"; "": nothing is counted) must
 * stay valid until the step ends. */
void murk_progress_begin(const char *step, uint64_t total, const char *unit);
void murk_progress_end(void);

/* Adds to the count of the innermost open step; any thread of the host may call
 * it. */
void murk_progress_add(uint64_t done);

/* Begins a group: a step that consists of other steps, such as the rows of a
 * study. murk_progress_add() counts for an inner step only;
 * murk_progress_add_to_group() counts for the group, and must be called while
 * no inner step is open. */
void murk_progress_begin_group(const char *step, uint64_t total,
                               const char *unit);
void murk_progress_add_to_group(uint64_t done);

/* Sets a text about the state of the innermost step, such as a search. The line
 * shows the text behind the numbers of the step, cut to MURK_PROGRESS_TEXT_SIZE
 * bytes with the '\0'. */
void murk_progress_text(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

/* Declares that the following steps belong to part `number` (from 1) of
 * `parts`, of which `done` are complete. The line shows the number of the part
 * and the estimated time until all parts are complete, which follows from the
 * time per part since the first call. murk_progress_part(0, 0, ...) ends the
 * parts. */
void murk_progress_part(uint64_t number, uint64_t parts, uint64_t done);

/* pause and resume are called around fork(): they stop and start the thread
 * that draws the line of the host, because a subprocess has a copy of the
 * forking thread alone, and a lock that another thread held at fork() stays
 * locked there. No worker of the host may run at fork(), either.
 * base/isolated.h and base/subprocess.h say whether threads of other hosts may.
 * A subprocess that reports progress calls murk_progress_in_subprocess(): the
 * subprocess draws the open steps and its own steps, while the parent process
 * stays paused. Whole lines are printed, and receivers called, by the parent
 * process only. */
void murk_progress_pause(void);
void murk_progress_resume(void);
void murk_progress_in_subprocess(void);

/* Called around other output on standard error: hide wipes the line, which
 * stays wiped until show. Between the two calls the thread must call no
 * function of this header but murk_clock_s(), because a lock is held; other
 * threads may have to wait for the lock. */
void murk_progress_hide(void);
void murk_progress_show(void);

/* Monotonic clock [s], for timings of the run only, never for results. */
double murk_clock_s(void);

#endif
