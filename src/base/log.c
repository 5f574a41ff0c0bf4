#include "base/log.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#define TEXT_SIZE 640

static void note_to_stderr(const char *where, const char *text)
{
    fprintf(stderr, "murk: note: %s%s%s\n", where, *where ? ": " : "", text);
}

static murk_warn_sink current = murk_warn_to_stderr;

void murk_warn(const char *where, const char *format, ...)
{
    if (!current) {
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
    if (!current) {
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

void murk_warn_to(murk_warn_sink sink)
{
    current = sink;
}

void murk_warn_to_stderr(const char *where, const char *text)
{
    fprintf(stderr, "murk: warning: %s%s%s\n", where, *where ? ": " : "", text);
}
