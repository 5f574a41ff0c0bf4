/* Filters notes so that each is shown once. Notes that differ only in digits,
 * '.' and '-', the characters of numbers, count as the same note. */
#include "api/log_once.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes for one note; those of a row are shorter (MURK_ROW_TEXT_SIZE). */
#define PART_SIZE 4100

/* Copies a note without the characters of numbers, between two line ends:
 * "\nnote\n". The copy is cut to PART_SIZE. */
static void strip_numbers(char out[PART_SIZE], const char *note, size_t length)
{
    size_t n = 0;
    out[n++] = '\n';
    for (size_t i = 0; i < length && n < PART_SIZE - 2; ++i) {
        if (!isdigit((unsigned char)note[i]) && !strchr(".-", note[i])) {
            out[n++] = note[i];
        }
    }
    strcpy(out + n, "\n");
}

static bool is_new(char **seen, const char *line)
{
    if (*seen && strstr(*seen, line)) {
        return false;
    }
    const size_t length = *seen ? strlen(*seen) : 0;
    char *grown = realloc(*seen, length + strlen(line) + 1);
    if (grown) {
        strcpy(grown + length, line);
        *seen = grown;
    }
    return true;
}

bool murk_log_once_news(char **seen, const char *notes, char *out, size_t size)
{
    size_t n = 0;
    out[0] = '\0';
    while (*notes) {
        char line[PART_SIZE];
        const char *end = strstr(notes, "; ");
        const size_t length = end ? (size_t)(end - notes) : strlen(notes);
        strip_numbers(line, notes, length);
        if (is_new(seen, line) && n < size) {
            n += (size_t)snprintf(out + n, size - n, "%s%.*s", n ? "; " : "",
                                  (int)length, notes);
        }
        notes += length + (end ? 2 : 0);
    }
    return out[0] != '\0';
}
