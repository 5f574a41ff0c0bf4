/* Formats the path of a field, and reads the field. */
#include "app/field.h"

#include <stdarg.h>
#include <stdio.h>

/* Formats the path of the function that uses it, from `path` and the arguments
 * behind `path`. */
#define FORMAT_PATH(to)                       \
    do {                                      \
        va_list args;                         \
        va_start(args, path);                 \
        vsnprintf(to, sizeof to, path, args); \
        va_end(args);                         \
    } while (0)

double murk_field_number(const murk_fields *fields, const char *path, ...)
{
    char whole[MURK_FIELD_PATH_SIZE];
    double value = 0;
    FORMAT_PATH(whole);
    (void)murk_fields_double(fields, whole, &value, NULL);
    return value;
}

const char *murk_field_text(const murk_fields *fields, const char *path, ...)
{
    char whole[MURK_FIELD_PATH_SIZE];
    const char *text = NULL;
    FORMAT_PATH(whole);
    (void)murk_fields_string(fields, whole, &text, NULL);
    return text;
}

size_t murk_field_length(const murk_fields *fields, const char *path, ...)
{
    char whole[MURK_FIELD_PATH_SIZE];
    FORMAT_PATH(whole);
    return murk_fields_length(fields, whole);
}
