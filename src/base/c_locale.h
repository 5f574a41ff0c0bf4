/* Numbers are read and printed with a decimal point, whatever locale the host
 * program has set, and the locale of the host program is not changed.
 *
 * The build includes this file first in every C file of src/ (CMakeLists.txt),
 * so that no call can be forgotten: each function murk_c_NAME below replaces
 * the function NAME of the C library, and calls NAME while the locale of this
 * thread is "C". One switch where a program enters the library would not be
 * enough, because threads begin with the locale of the host program and every
 * murk_ function is an entry. */
#ifndef MURK_BASE_C_LOCALE_H
#define MURK_BASE_C_LOCALE_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

double murk_c_strtod(const char *text, char **end);
int murk_c_printf(const char *format, ...)
    __attribute__((format(printf, 1, 2)));
int murk_c_fprintf(FILE *to, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
int murk_c_snprintf(char *out, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
int murk_c_vsnprintf(char *out, size_t size, const char *format, va_list args)
    __attribute__((format(printf, 3, 0)));

/* murk_c_locale_enter() sets the locale "C" for the calling thread, around
 * calls of other libraries. murk_c_locale_leave() restores the previous locale,
 * which murk_c_locale_enter() returned. A subprocess that runs parsers of other
 * libraries enters the locale and never leaves it. */
void *murk_c_locale_enter(void);
void murk_c_locale_leave(void *before);

#ifndef MURK_C_LOCALE_ITSELF /* base/c_locale.c calls the C library itself */
#define strtod(...)    murk_c_strtod(__VA_ARGS__)
#define printf(...)    murk_c_printf(__VA_ARGS__)
#define fprintf(...)   murk_c_fprintf(__VA_ARGS__)
#define snprintf(...)  murk_c_snprintf(__VA_ARGS__)
#define vsnprintf(...) murk_c_vsnprintf(__VA_ARGS__)
#endif

#endif
