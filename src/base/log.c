#include "base/log.h"

#include "base/progress.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#define TEXT_SIZE 640

static void note_to_stderr(const char *where, const char *text)
{
    murk_progress_hide();
    fprintf(stderr, "murk: note: %s%s%s\n", where, *where ? ": " : "", text);
    murk_progress_show();
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
    murk_progress_hide();
    fprintf(stderr, "murk: warning: %s%s%s\n", where, *where ? ": " : "", text);
    murk_progress_show();
}
