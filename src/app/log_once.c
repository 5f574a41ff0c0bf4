/* Filters texts so that each is shown once. Texts that differ only in their
 * numbers count as the same text. */
#include "app/log_once.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PART_SIZE 4100 /* a row's notes are shorter */

static void strip_numbers(char *text)
{
    char *to = text;
    for (const char *from = text; *from; ++from) {
        if (!isdigit((unsigned char)*from) && *from != '.' && *from != '-') {
            *to++ = *from;
        }
    }
    *to = '\0';
}

static bool is_told(murk_log_once *told, const char *part)
{
    char text[PART_SIZE];
    snprintf(text, sizeof text, "%s", part);
    strip_numbers(text);
    for (size_t i = 0; i < told->n; ++i) {
        if (strcmp(told->text[i], text) == 0) {
            return true;
        }
    }
    char **grown = realloc(told->text, (told->n + 1) * sizeof *grown);
    if (grown) {
        told->text = grown;
        grown[told->n] = strdup(text);
        told->n += grown[told->n] != NULL;
    }
    return false;
}

bool murk_log_once_news(murk_log_once *told, const char *notes, char *out,
                        size_t size)
{
    size_t n = 0;
    out[0] = '\0';
    while (*notes) {
        char part[PART_SIZE];
        const char *end = strstr(notes, "; ");
        const size_t length = end ? (size_t)(end - notes) : strlen(notes);
        snprintf(part, sizeof part, "%.*s", (int)length, notes);
        if (!is_told(told, part) && n < size) {
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? "; " : "",
                                  part);
        }
        notes += length + (end ? 2 : 0);
    }
    return out[0] != '\0';
}

void murk_log_once_release(murk_log_once *told)
{
    for (size_t i = 0; i < told->n; ++i) {
        free(told->text[i]);
    }
    free(told->text);
    *told = (murk_log_once){0};
}
