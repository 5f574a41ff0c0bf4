/* Reads and prints numbers with the C library under the locale "C".
 *
 * POSIX (2008) gives each thread a locale: newlocale() makes a locale,
 * uselocale() sets the locale of the thread and returns the previous one. The
 * locale "C" is made once in a process, so that a call here costs two calls of
 * uselocale(). */
#include "base/c_locale.h"

#include <locale.h>
#include <pthread.h>

static pthread_once_t once = PTHREAD_ONCE_INIT;
static locale_t plain; /* 0 if there was no memory: the locale of the host
                        * program stays */

static void make_plain(void)
{
    plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

/* Returns the previous locale. */
static locale_t enter(void)
{
    pthread_once(&once, make_plain);
    return uselocale(plain);
}

void *murk_c_locale_enter(void)
{
    return (void *)enter(); /* locale_t is a pointer */
}

void murk_c_locale_leave(void *before)
{
    uselocale((locale_t)before);
}

double murk_c_strtod(const char *text, char **end)
{
    const locale_t before = enter();
    const double value = strtod(text, end);
    uselocale(before);
    return value;
}

int murk_c_vsnprintf(char *out, size_t size, const char *format, va_list args)
{
    const locale_t before = enter();
    const int n = vsnprintf(out, size, format, args);
    uselocale(before);
    return n;
}

static int print_list(FILE *to, const char *format, va_list args)
{
    const locale_t before = enter();
    const int n = vfprintf(to, format, args);
    uselocale(before);
    return n;
}

int murk_c_printf(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = print_list(stdout, format, args);
    va_end(args);
    return n;
}

int murk_c_fprintf(FILE *to, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = print_list(to, format, args);
    va_end(args);
    return n;
}

int murk_c_snprintf(char *out, size_t size, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = murk_c_vsnprintf(out, size, format, args);
    va_end(args);
    return n;
}
