/* Warnings and notes: information for the user that does not stop the run. A
 * note concerns a correct input with an effect that may surprise, such as a
 * lamp that is switched off. */
#ifndef MURK_BASE_LOG_H
#define MURK_BASE_LOG_H

#include <stdbool.h>

/* Prints one line, "murk: warning: WHERE: TEXT", on standard error by default.
 * The same line is printed once in a run of the program. */
void murk_warn(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Like murk_warn(), with "murk: note: ". */
void murk_note(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Redirects the warnings and notes of the host of the calling thread
 * (base/host.h) to `sink`; NULL silences them. Returns the previous sink. Call
 * it while no thread of the host runs that might warn. */
typedef void (*murk_warn_sink)(const char *where, const char *text);
murk_warn_sink murk_warn_to(murk_warn_sink sink);
void murk_warn_to_stderr(const char *where, const char *text);

/* A receiver with an argument. murk_log_to() redirects the warnings and notes
 * of the host of the calling thread to it (base/host.h). */
typedef void (*murk_log_sink)(void *user, bool is_warning, const char *where,
                              const char *text);
void murk_log_to(murk_log_sink log, void *user);

/* Prints "murk: KINDWHERE: TEXT" as one line on standard error. All messages to
 * a terminal are printed by this function. `where` may be empty. `where` and
 * `text` may come from a file or an option, so control characters in them are
 * shown escaped (base/utf8.h). */
void murk_message(const char *kind, const char *where, const char *text);

/* Silences warnings and notes of the calling thread, for reading a file a
 * second time: all its warnings were given at the first reading. Returns the
 * previous state. */
bool murk_warn_quiet(bool is_silent);

#endif
