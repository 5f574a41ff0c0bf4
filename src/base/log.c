/* Prints warnings and notes on standard error or passes them to another sink.
 * On standard error a message with the same words for the same place is not
 * repeated, because scenes are read, and worlds built, for each condition,
 * start and seed. The last SAID_MAX printed messages are recognised by a
 * 128-bit checksum. */
#include "base/log.h"

#include "base/file.h"
#include "base/host.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/utf8.h"

#include <pthread.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define WHOLE_SIZE (3 * TEXT_SIZE) /* kind, place and text */

#define TEXT_SIZE 640 /* as in murk_error (base/status.h) */
/* An escaped byte takes at most four bytes (base/utf8.h). */
#define SHOWN_SIZE (4 * TEXT_SIZE + 1)
/* The number of printed messages that are remembered; the oldest is forgotten
 * first. */
#define SAID_MAX 256

void murk_message(const char *kind, const char *where, const char *text)
{
    char shown_where[SHOWN_SIZE], shown_text[SHOWN_SIZE];
    if (murk_ranks_number() > 0) {
        return;
    }
    murk_utf8_escape(shown_where, sizeof shown_where, where);
    murk_utf8_escape(shown_text, sizeof shown_text, text);
    murk_progress_hide(); /* an unfinished step may have left a progress line */
    fprintf(stderr, "murk: %s%s%s%s\n", kind, shown_where, *where ? ": " : "",
            shown_text);
    murk_progress_show();
}

bool murk_message_is_new(const char *kind, const char *where, const char *text)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static uint64_t said[SAID_MAX][2];
    static size_t count;
    char whole[WHOLE_SIZE];
    (void)snprintf(whole, sizeof whole, "%s%s: %s", kind, where, text);
    uint64_t sum[2];
    murk_checksum(whole, strlen(whole), sum);
    bool found = false;
    (void)pthread_mutex_lock(&lock);
    for (size_t i = 0; i < count && i < SAID_MAX; ++i) {
        found = found || memcmp(said[i], sum, sizeof sum) == 0;
    }
    if (!found) {
        memcpy(said[count++ % SAID_MAX], sum, sizeof sum);
    }
    (void)pthread_mutex_unlock(&lock);
    return !found;
}

static _Thread_local bool is_quiet;

/* The sink of a host for which murk_log_to() has set a receiver. report()
 * recognises this sink and calls the receiver itself, because only report()
 * knows whether a message is a warning. */
static void to_log(const char *where, const char *text)
{
    const murk_host *host = murk_host_now();
    host->log(host->user, true, where, text);
}

static murk_warn_sink sink_of(const murk_host *host)
{
    return host->has_warn ? host->warn : murk_warn_to_stderr;
}

/* Passes a message to the sink, unless there is no sink or the thread is quiet.
 * On standard error a repeated message is left out. */
static void report(bool is_warning, const char *where, const char *format,
                   va_list args)
{
    const murk_host *host = murk_host_now();
    const murk_warn_sink sink = sink_of(host);
    const char *kind = is_warning ? "warning: " : "note: ";
    if (!sink || is_quiet) {
        return;
    }
    char text[TEXT_SIZE];
    vsnprintf(text, sizeof text, format, args);
    where = where ? where : "";
    if (sink == to_log) {
        host->log(host->user, is_warning, where, text);
    } else if (sink != murk_warn_to_stderr) {
        sink(where, text);
    } else if (murk_message_is_new(kind, where, text)) {
        murk_message(kind, where, text);
    }
}

void murk_warn(const char *where, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    report(true, where, format, args);
    va_end(args);
}

void murk_note(const char *where, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    report(false, where, format, args);
    va_end(args);
}

murk_warn_sink murk_warn_to(murk_warn_sink sink)
{
    murk_host *host = murk_host_now();
    const murk_warn_sink before = sink_of(host);
    host->has_warn = true;
    host->warn = sink;
    return before;
}

void murk_log_to(murk_log_sink log, void *user)
{
    murk_host *host = murk_host_now();
    host->log = log;
    host->user = user;
    host->has_warn = true;
    host->warn = log ? to_log : NULL;
}

murk_log_receiver murk_log_receiver_now(void)
{
    const murk_host *host = murk_host_now();
    return (murk_log_receiver){host->has_warn, host->warn, host->log,
                               host->user};
}

void murk_log_restore(const murk_log_receiver *receiver)
{
    murk_host *host = murk_host_now();
    host->has_warn = receiver->has_warn;
    host->warn = receiver->warn;
    host->log = receiver->log;
    host->user = receiver->user;
}

bool murk_warn_quiet(bool is_silent)
{
    const bool before = is_quiet;
    is_quiet = is_silent;
    return before;
}

void murk_warn_to_stderr(const char *where, const char *text)
{
    if (murk_message_is_new("warning: ", where, text)) {
        murk_message("warning: ", where, text);
    }
}
