/* Shows each note once, apart from the numbers in it: of a hundred rows in
 * which the sun is so many degrees below the horizon, one says so. */
#ifndef MURK_API_LOG_ONCE_H
#define MURK_API_LOG_ONCE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes to out[size] those of `notes`, parted by "; ", that are not among
 * *seen, and adds them there: lines without their numbers, NULL at first, for
 * free(). False if there are none. Out of memory, every note is new. */
bool murk_log_once_news(char **seen, const char *notes, char *out, size_t size);

#endif
