#include "base/log.h"

#include "base/progress.h"
#include "base/utf8.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#define TEXT_SIZE 640
/* Four bytes for each of a text and of a place as long. */
#define SHOWN_SIZE (4 * TEXT_SIZE + 1)

void murk_message(const char *kind, const char *where, const char *text)
{
    char shown_where[SHOWN_SIZE], shown_text[SHOWN_SIZE];
    murk_utf8_escape(shown_where, sizeof shown_where, where);
    murk_utf8_escape(shown_text, sizeof shown_text, text);
    murk_progress_hide(); /* a step that was cut short may have left a line */
    fprintf(stderr, "murk: %s%s%s%s\n", kind, shown_where, *where ? ": " : "",
            shown_text);
    murk_progress_show();
}

static void note_to_stderr(const char *where, const char *text)
{
    murk_message("note: ", where, text);
}

static murk_warn_sink current = murk_warn_to_stderr;
static _Thread_local bool is_hushed;

void murk_warn(const char *where, const char *format, ...)
{
    if (!current || is_hushed) {
        return;
    }
    char text[TEXT_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    current(where ? where : "", text);
}

void murk_note(const char *where, const char *format, ...)
{
    if (!current || is_hushed) {
        return;
    }
    char text[TEXT_SIZE];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    const bool to_stderr = current == murk_warn_to_stderr;
    (to_stderr ? note_to_stderr : current)(where ? where : "", text);
}

murk_warn_sink murk_warn_to(murk_warn_sink sink)
{
    const murk_warn_sink before = current;
    current = sink;
    return before;
}

bool murk_warn_hush(bool is_silent)
{
    const bool before = is_hushed;
    is_hushed = is_silent;
    return before;
}

void murk_warn_to_stderr(const char *where, const char *text)
{
    murk_message("warning: ", where, text);
}
