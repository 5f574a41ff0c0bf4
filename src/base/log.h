/* Warnings and notes: things the user should know that stop nothing. A note is
 * of what is as it should be, and yet may surprise: a lamp that is off. */
#ifndef MURK_BASE_LOG_H
#define MURK_BASE_LOG_H

#include <stdbool.h>

/* One line: "murk: warning: WHERE: TEXT" on standard error by default, where
 * the same line is printed once in a run of the program. */
void murk_warn(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The same with "murk: note: ". */
void murk_note(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Sends both elsewhere; NULL silences them. Set it while no thread runs that
 * might warn. Returns where they went before. */
typedef void (*murk_warn_sink)(const char *where, const char *text);
murk_warn_sink murk_warn_to(murk_warn_sink sink);
void murk_warn_to_stderr(const char *where, const char *text);

/* Prints "murk: KINDWHERE: TEXT" as one line on standard error: the one way by
 * which messages reach a terminal. `where` may be empty. Control characters in
 * `where` and `text`, which may be of a file or an option, are shown escaped
 * (base/utf8.h). */
void murk_message(const char *kind, const char *where, const char *text);

/* Whether this thread keeps silent: of what is read a second time, all has been
 * said. Gives back what held before. */
bool murk_warn_quiet(bool is_silent);

#endif
