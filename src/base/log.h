/* Warnings and notes: information for the user that does not stop the run. A
 * note concerns a correct input with an effect that may surprise, such as a
 * lamp that is switched off. */
#ifndef MURK_BASE_LOG_H
#define MURK_BASE_LOG_H

#include <stdbool.h>

/* Prints one line, "murk: warning: WHERE: TEXT", on standard error, or passes
 * place and text to the sink of the host (murk_warn_to(), murk_log_to()), if
 * one was set. `where` may be NULL or empty. On standard error a line that was
 * printed before is not repeated, unless 256 other lines were printed since. */
void murk_warn(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Like murk_warn(), with "murk: note: ". */
void murk_note(const char *where, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Redirects the warnings and notes of the host of the calling thread
 * (base/host.h) to `sink`; NULL silences them. Returns the previous sink. Call
 * it while no thread of the host runs that might warn. murk_warn_to_stderr() is
 * the sink at first; it prints as murk_warn() describes. */
typedef void (*murk_warn_sink)(const char *where, const char *text);
murk_warn_sink murk_warn_to(murk_warn_sink sink);
void murk_warn_to_stderr(const char *where, const char *text);

/* A sink that also receives the argument `user` and the kind of the message.
 * murk_log_to() redirects the warnings and notes of the host of the calling
 * thread (base/host.h) to `log`; NULL silences them. */
typedef void (*murk_log_sink)(void *user, bool is_warning, const char *where,
                              const char *text);
void murk_log_to(murk_log_sink log, void *user);

/* The receiver of the warnings and notes of the host of the calling thread, as
 * the functions above have set it, and the way back to that receiver. */
typedef struct murk_log_receiver {
    bool has_warn;
    murk_warn_sink warn;
    murk_log_sink log;
    void *user;
} murk_log_receiver;
murk_log_receiver murk_log_receiver_now(void);
void murk_log_restore(const murk_log_receiver *receiver);

/* Prints "murk: ", kind, where, ": " and text as one line on standard error,
 * without ": " if `where` is empty. Warnings, notes and the error of the
 * program are printed by this function. `where` and `text` may come from a file
 * or an option, so control characters in them are shown escaped (base/utf8.h).
 * With ranks (base/ranks.h) rank 0 alone prints. */
void murk_message(const char *kind, const char *where, const char *text);

/* True if the same message is not among the last 256 messages that were
 * recorded here. The function records a message for which it returns true; the
 * caller then prints the message. */
bool murk_message_is_new(const char *kind, const char *where, const char *text);

/* Silences the warnings and notes of the calling thread (true) or ends the
 * silence (false). Returns the previous state. Used where a file is read a
 * second time, because the first reading has given all warnings about the file.
 */
bool murk_warn_quiet(bool is_silent);

#endif
