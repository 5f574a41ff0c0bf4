/* Fills error messages and translates status codes to words and exit codes. An
 * error holds at most one message, the first one. */
#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

murk_status murk_fail(murk_error *err, murk_status status, const char *where,
                      const char *format, ...)
{
    if (err && err->code == MURK_OK) {
        err->code = status;
        snprintf(err->where, sizeof err->where, "%s", where ? where : "");
        va_list args;
        va_start(args, format);
        vsnprintf(err->text, sizeof err->text, format, args);
        va_end(args);
    }
    return status;
}

murk_status murk_no_memory(murk_error *err, const char *where,
                           const char *purpose, ...)
{
    char text[sizeof((murk_error){0}.text)];
    va_list args;
    va_start(args, purpose);
    vsnprintf(text, sizeof text, purpose, args);
    va_end(args);
    return murk_fail(err, MURK_NO_MEMORY, where, "no memory %s", text);
}

const char *murk_status_text(murk_status status)
{
    static const char *const texts[] = {
        [MURK_OK] = "ok",
        [MURK_BAD_VALUE] = "a key, a value or an argument is not allowed",
        [MURK_BAD_FILE] = "a file is missing or malformed",
        [MURK_UNSUPPORTED] = "not supported yet",
        [MURK_NO_MEMORY] = "out of memory",
        [MURK_RUN_FAILED] = "the run failed",
        [MURK_INTERRUPTED] = "interrupted"};
    return (unsigned)status < sizeof texts / sizeof *texts ? texts[status]
                                                           : "unknown status";
}

int murk_status_exit_code(murk_status status)
{
    switch (status) {
    case MURK_OK:
        return 0;
    case MURK_BAD_VALUE:
    case MURK_BAD_FILE:
    case MURK_UNSUPPORTED:
        return 2;
    case MURK_INTERRUPTED:
        return 130;
    case MURK_NO_MEMORY:
    case MURK_RUN_FAILED:
        break;
    }
    return 1;
}
