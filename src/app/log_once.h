/* Texts that have been told, apart from the numbers in them: of a hundred rows
 * in which the sun is so many degrees below the horizon, one says so. */
#ifndef MURK_APP_LOG_ONCE_H
#define MURK_APP_LOG_ONCE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_log_once {
    char **text; /* [n] without their numbers */
    size_t n;
} murk_log_once;

/* Of `notes`, parted by "; ", what has not been told yet, to out[size]; false:
 * nothing. Out of memory, all is news. */
bool murk_log_once_news(murk_log_once *told, const char *notes, char *out,
                        size_t size);
void murk_log_once_release(murk_log_once *told);

#endif
