/* Texts that have been told, apart from the numbers in them: of a hundred rows
 * in which the sun is so many degrees below the horizon, one says so. */
#ifndef MURK_APP_TOLD_H
#define MURK_APP_TOLD_H

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_told {
    char **text; /* [n] without their numbers */
    size_t n;
} murk_told;

/* Of `notes`, parted by "; ", what has not been told yet, to out[size]; false:
 * nothing. Out of memory, all is news. */
bool murk_told_news(murk_told *told, const char *notes, char *out, size_t size);
void murk_told_release(murk_told *told);

#endif
